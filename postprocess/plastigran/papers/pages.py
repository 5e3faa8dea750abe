# SPDX-License-Identifier: GPL-2.0-or-later
"""A paper's page, docs/papers/NAME.md, whose tables and pictures the command writes.

A table's place is between the lines `<!-- table NAME -->` and `<!-- end -->`. Pictures are files of
docs/figures/papers/NAME.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from numbers import Real
from pathlib import Path
from shutil import copy

import pandas as pd

from plastigran.papers.base import Paper, Reproduction

PLACE = re.compile(r"(<!-- table (\w+) -->\n)(.*?)(<!-- end -->)", re.DOTALL)


def read_page(paper: Paper, folder: Path) -> str:
    """The text of a paper's page.

    Args:
        paper: Whose.
        folder: Of the pages.

    Raises:
        ValueError: There is no page, or its places are not those of the paper's tables.
    """
    path = folder / f"{paper.name}.md"
    if not path.is_file():
        raise ValueError(f"{path} is missing; the page must be there before its tables are written")
    text = path.read_text()
    found = [place[1] for place in PLACE.findall(text)]
    if missing := set(paper.tables) - set(found):
        raise ValueError(f"{path} has no <!-- table {min(missing)} --> ... <!-- end -->")
    if unknown := set(found) - set(paper.tables):
        raise ValueError(f"{path} has a place for {min(unknown)}, which is no table of the paper's")
    if len(found) != len(set(found)):
        raise ValueError(f"{path} has two places for one table")
    return text


def fill(text: str, tables: Mapping[str, pd.DataFrame]) -> str:
    """A page's text with the tables in their places."""
    return PLACE.sub(lambda place: place[1] + to_markdown(tables[place[2]]) + place[4], text)


def publish(paper: Paper, made: Reproduction, written: list[Path], folder: Path) -> list[Path]:
    """Write tables into the paper's page and copy pictures beside it; returns the files.

    Args:
        paper: Whose.
        made: Its tables are written.
        written: Files that `made.write` wrote; its pictures are copied.
        folder: Of the pages; the pictures go to `../figures/papers/NAME`, seen from there.

    Raises:
        ValueError: As for `read_page`.
    """
    path = folder / f"{paper.name}.md"
    path.write_text(fill(read_page(paper, folder), made.tables))
    pictures = folder.parent / "figures" / "papers" / paper.name
    pictures.mkdir(parents=True, exist_ok=True)
    return [path, *(Path(copy(file, pictures)) for file in written if file.suffix != ".csv")]


def to_markdown(table: pd.DataFrame) -> str:
    """A table in Markdown: four digits, differences in per cent to a hundredth."""
    lines = [list(table.columns), ["---"] * len(table.columns)]
    for row in table.itertuples(index=False):
        lines.append([_cell(name, value) for name, value in zip(table.columns, row, strict=True)])
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def _cell(column: str, value: object) -> str:
    if pd.isna(value):
        return ""
    if not isinstance(value, Real):
        return str(value)
    if column.endswith("(%)"):
        return f"{value:+.2f}"
    rounded = float(f"{value:.4g}")
    return f"{rounded:.0f}" if 1e4 <= abs(rounded) < 1e6 else f"{rounded:.4g}"
