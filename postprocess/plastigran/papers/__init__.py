# SPDX-License-Identifier: GPL-2.0-or-later
"""Reproductions of papers: one module or package per paper, see `plastigran.papers.base`."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from plastigran.papers.base import Paper


def paper_names() -> list[str]:
    """Return the short names of the papers that can be reproduced."""
    return sorted({module.name for module in iter_modules(__path__)} - {"base"})


def find_paper(name: str, folder: Path | None = None, **options: object) -> Paper:
    """Return a paper by its short name.

    Args:
        name: Short name of the paper.
        folder: Folder of the bulk runs of a benchmark; by default results/NAME.
        options: Options of a benchmark with cases; see `plastigran.papers.dosta24.paper`.

    Raises:
        ValueError: No paper has this name, or a paper without cases gets options.
    """
    if name not in paper_names():
        raise ValueError(f"no paper {name!r}. Available papers: {', '.join(paper_names())}")
    module = import_module(f"{__name__}.{name}")
    if hasattr(module, "paper"):
        return module.paper(folder=folder, **options)
    if options:
        raise ValueError(f"{name} has no --{min(options)}. Remove --{min(options)}")
    return module.PAPER
