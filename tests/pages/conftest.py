# SPDX-License-Identifier: GPL-2.0-or-later
"""Fixtures that read tables of the validation pages and compare them with computed tables."""

from __future__ import annotations

from collections.abc import Callable

import pandas as pd
import pytest

from plastigran.engine.process import PROJECT
from plastigran.report.pages import fill, read_pages, read_tables
from plastigran.validation.report import EVIDENCE


@pytest.fixture(scope="session")
def page_table() -> Callable[[str], pd.DataFrame]:
    """`page_table(name)` returns a table of the pages; its cells are text."""
    tables: dict[str, pd.DataFrame] = {}
    for text in read_pages(EVIDENCE, PROJECT / "docs").values():
        tables |= read_tables(text)
    return tables.__getitem__


@pytest.fixture(scope="session")
def assert_on_page(page_table) -> Callable[[str, pd.DataFrame], None]:
    """`assert_on_page(name, table)` asserts that the pages show a table, or rows of it. Numbers may
    differ by one in the last digit, because libraries have different round-off.
    """

    def check(name: str, table: pd.DataFrame) -> None:
        shown = page_table(name)
        expected = read_tables(fill(f"<!-- table {name} -->\n<!-- end -->", {name: table}))[name]
        assert list(shown) == list(expected)
        first = shown.columns[0]
        shown = shown[shown[first].isin(expected[first])].reset_index(drop=True)
        for column in shown:
            numbers = pd.to_numeric(expected[column], errors="coerce")
            if numbers.notna().any():
                allowed = {"rel": 1.1e-3, "abs": 0.011, "nan_ok": True}
                computed = pytest.approx(numbers.to_numpy(), **allowed)
                assert pd.to_numeric(shown[column]).to_numpy() == computed, f"{name}: {column}"
            else:
                assert list(shown[column]) == list(expected[column]), f"{name}: {column}"

    return check
