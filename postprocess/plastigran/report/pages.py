# SPDX-License-Identifier: GPL-2.0-or-later
"""Write computed tables and pictures into the pages of the docs that show them.

The place of a table on a page is between the lines `<!-- table NAME -->` and `<!-- end -->`. A
table without such a place is only written as a CSV file.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from numbers import Real
from os.path import normpath
from pathlib import Path
from shutil import copy

import pandas as pd

from plastigran.report.base import Evidence, Findings

PLACE = re.compile(r"(<!-- table (\w+) -->\n)(.*?)(<!-- end -->)", re.DOTALL)


def read_pages(evidence: Evidence, folder: Path) -> dict[Path, str]:
    """Return the text of the pages of the docs that show computed results, by path.

    Args:
        evidence: Evidence that names the pages.
        folder: Folder of the pages.

    Raises:
        ValueError: A page is missing, or has a place for a table that `evidence` does not declare.
            Or two places have the same table.
    """
    pages = {}
    for path in (folder / name for name in evidence.pages):
        if not path.is_file():
            raise ValueError(f"{path} is missing. Create it before you write its tables")
        pages[path] = path.read_text()
    paths = " or ".join(map(str, pages))
    places = [place[1] for text in pages.values() for place in PLACE.findall(text)]
    if unknown := set(places) - set(evidence.tables):
        raise ValueError(
            f"{paths} has a line `<!-- table {min(unknown)} -->`, but {evidence.name} has no such "
            f"table. Remove the line, or use one of {', '.join(evidence.tables)}"
        )
    if len(places) != len(set(places)):
        raise ValueError(
            f"{paths}: a table has two places. Remove the second pair of lines "
            "`<!-- table NAME -->` and `<!-- end -->`"
        )
    return pages


def read_tables(text: str) -> dict[str, pd.DataFrame]:
    """Return the tables of a page by name; cells are text."""
    tables = {}
    for _, name, table, _ in PLACE.findall(text):
        lines = [[c.strip() for c in line.split("|")[1:-1]] for line in table.splitlines()]
        tables[name] = pd.DataFrame(lines[2:], columns=lines[0])
    return tables


def fill(text: str, tables: Mapping[str, pd.DataFrame]) -> str:
    """Write each table into its place on a page; return the new text of the page."""
    return PLACE.sub(lambda place: place[1] + to_markdown(tables[place[2]]) + place[4], text)


def publish(
    evidence: Evidence, findings: Findings, written: list[Path], folder: Path
) -> list[Path]:
    """Write computed tables into pages of the docs, and copy the pictures; return all files.

    Args:
        evidence: Evidence that names the pages and the folder of pictures.
        findings: Computed results with the tables to write.
        written: Files that `findings.write` wrote. The pictures among them are copied.
        folder: Folder of the pages. The path `evidence.pictures` is relative to this folder.

    Raises:
        ValueError: As for `read_pages`.
    """
    pages = read_pages(evidence, folder)
    for path, text in pages.items():
        path.write_text(fill(text, findings.tables))
    pictures = Path(normpath(folder / evidence.pictures))
    pictures.mkdir(parents=True, exist_ok=True)
    return [*pages, *(Path(copy(file, pictures)) for file in written if file.suffix != ".csv")]


def to_markdown(table: pd.DataFrame) -> str:
    """Return a table in Markdown, with four digits for numbers and two decimals for percentages."""
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
