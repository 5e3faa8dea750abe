# SPDX-License-Identifier: GPL-2.0-or-later
"""Papers reproduced: one module or package for each, of the paper's short name.

It defines `PAPER`, a `plastigran.papers.base.Paper`, and its page is docs/papers/NAME.md. Nothing
else is edited: the command and the tests find it.
"""

from __future__ import annotations

from importlib import import_module
from pkgutil import iter_modules
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from plastigran.papers.base import Paper

#: Modules here that are no paper.
SHARED = {"base"}


def paper_names() -> list[str]:
    """Short names of the papers that can be reproduced."""
    return sorted({module.name for module in iter_modules(__path__)} - SHARED)


def find_paper(name: str) -> Paper:
    """A paper by its short name.

    Raises:
        ValueError: There is none.
    """
    if name not in paper_names():
        raise ValueError(f"no paper {name!r}; there are {', '.join(paper_names())}")
    return import_module(f"{__name__}.{name}").PAPER
