# SPDX-License-Identifier: GPL-2.0-or-later
"""Write measured values as rows of a table in a page of the documentation."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Row:
    """Row of a table of measured values.

    Attributes:
        description: Measured quantity.
        value: Measured value.
        limit: Largest allowed value; None if there is no limit.
    """

    description: str
    value: float
    limit: float | None = None

    @property
    def passed(self) -> bool:
        return self.limit is None or bool(self.value <= self.limit)

    def cells(self) -> str:
        limit = "" if self.limit is None else f"{self.limit:.4g}"
        return f"{self.description} | {self.value:.4g} | {limit}"


def write_rows(page: Path, part: str, rows: list[Row]) -> None:
    """Replace one table in a page of the documentation. The table stands between two HTML comments.

    The first comment contains the text `part`, the second comment the word `end`.
    """
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
