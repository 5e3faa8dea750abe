# SPDX-License-Identifier: GPL-2.0-or-later
"""Rows of measured figures, and the table of a page that shows them."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Row:
    """A line of a table.

    Attributes:
        what: In words.
        value: What was measured.
        limit: What it may be at most; None where it is only reported.
    """

    what: str
    value: float
    limit: float | None = None

    @property
    def passed(self) -> bool:
        return self.limit is None or bool(self.value <= self.limit)

    def cells(self) -> str:
        limit = "" if self.limit is None else f"{self.limit:.4g}"
        return f"{self.what} | {self.value:.4g} | {limit}"


def write_rows(page: Path, part: str, rows: list[Row]) -> None:
    """Replace a part's rows in a page's table, which stand between comments of its name."""
    text = page.read_text()
    table = "".join(f"| {row.cells()} |\n" for row in rows)
    head = "| | measured | at most |\n|---|---|---|\n"
    page.write_text(
        re.sub(
            rf"<!-- {part} -->\n.*?<!-- end -->\n",
            lambda _: f"<!-- {part} -->\n{head}{table}<!-- end -->\n",
            text,
            flags=re.DOTALL,
        )
    )
