# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables of the validation's pages beside what is computed."""

from __future__ import annotations

from collections.abc import Callable

import pandas as pd
import pytest

from plastigran.engine.process import PROJECT
from plastigran.report.pages import fill, read_pages, read_tables
from plastigran.validation.report import EVIDENCE


@pytest.fixture(scope="session")
def page_table() -> Callable[[str], pd.DataFrame]:
    """A table of the pages, its cells as text, `page_table(name)`."""
    found: dict[str, pd.DataFrame] = {}
    for text in read_pages(EVIDENCE, PROJECT / "docs").values():
        found |= read_tables(text)
    return found.__getitem__


@pytest.fixture(scope="session")
def assert_on_page(page_table) -> Callable[[str, pd.DataFrame], None]:
    """Asserts that the pages show a table, or rows of it, `assert_on_page(name, table)`: numbers to
    a last digit, which a library's rounding may turn over."""

    def check(name: str, table: pd.DataFrame) -> None:
        shown = page_table(name)
        expected = read_tables(fill(f"<!-- table {name} -->\n<!-- end -->", {name: table}))[name]
        assert list(shown) == list(expected)
        first = shown.columns[0]
        shown = shown[shown[first].isin(expected[first])].reset_index(drop=True)
        for column in shown:
            numbers = pd.to_numeric(expected[column], errors="coerce")
            if numbers.notna().any():
                said = pd.to_numeric(shown[column])
                assert said.to_numpy() == pytest.approx(
                    numbers.to_numpy(), rel=1.1e-3, abs=0.011, nan_ok=True
                ), f"{name}: {column}"
            else:
                assert list(shown[column]) == list(expected[column]), f"{name}: {column}"

    return check
