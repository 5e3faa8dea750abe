# SPDX-License-Identifier: GPL-2.0-or-later
"""Write tables and pictures into the pages of a report.

A table stands between the lines `<!-- table NAME -->` and `<!-- end -->`.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from numbers import Real
from os.path import normpath
from pathlib import Path
from shutil import copy

import pandas as pd

from plastigran.report.base import Findings, Report

PLACE = re.compile(r"(<!-- table (\w+) -->\n)(.*?)(<!-- end -->)", re.DOTALL)


def read_pages(report: Report, folder: Path) -> dict[Path, str]:
    """Return the text of the pages of a report.

    Args:
        report: Report.
        folder: Folder of the pages.

    Raises:
        ValueError: A page is missing, or its places do not match the tables of the report.
    """
    pages = {}
    for path in (folder / name for name in report.pages):
        if not path.is_file():
            raise ValueError(f"{path} is missing. Create it before you write its tables")
        pages[path] = path.read_text()
    said = " or ".join(str(path) for path in pages)
    found = [place[1] for text in pages.values() for place in PLACE.findall(text)]
    if missing := set(report.tables) - set(found):
        raise ValueError(f"{said} has no <!-- table {min(missing)} --> ... <!-- end -->")
    if unknown := set(found) - set(report.tables):
        raise ValueError(
            f"{said} has a place for {min(unknown)}, which is not a table of {report.name}"
        )
    if len(found) != len(set(found)):
        raise ValueError(f"{said} has two places for one table")
    return pages


def read_tables(text: str) -> dict[str, pd.DataFrame]:
    """Return the tables of a page by name; cells are text."""
    found = {}
    for _, name, table, _ in PLACE.findall(text):
        head, _, *lines = (
            [cell.strip() for cell in line.split("|")[1:-1]] for line in table.splitlines()
        )
        found[name] = pd.DataFrame(lines, columns=head)
    return found


def fill(text: str, tables: Mapping[str, pd.DataFrame]) -> str:
    """Return the text of a page with the tables in their places."""
    return PLACE.sub(lambda place: place[1] + to_markdown(tables[place[2]]) + place[4], text)


def publish(report: Report, made: Findings, written: list[Path], folder: Path) -> list[Path]:
    """Write tables into the pages of a report and copy its pictures; return the files.

    Args:
        report: Report.
        made: Results, with the tables to write.
        written: Files that `made.write` wrote; pictures are copied.
        folder: Folder of the pages; pictures go to `report.pictures` relative to it.

    Raises:
        ValueError: As for `read_pages`.
    """
    pages = read_pages(report, folder)
    for path, text in pages.items():
        path.write_text(fill(text, made.tables))
    pictures = Path(normpath(folder / report.pictures))
    pictures.mkdir(parents=True, exist_ok=True)
    return [*pages, *(Path(copy(file, pictures)) for file in written if file.suffix != ".csv")]


def to_markdown(table: pd.DataFrame) -> str:
    """Return a table in Markdown: four digits, differences in per cent with two decimals."""
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
