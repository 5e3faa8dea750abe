# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests that `validate` and `reproduce` write tables and figures into pages of the docs."""

from __future__ import annotations

import attrs
import pandas as pd
import pytest

from plastigran.plot.style import subplots
from plastigran.report.base import Evidence, Findings, add_difference
from plastigran.report.pages import fill, publish, read_pages, to_markdown


def small_evidence() -> Evidence:
    table = add_difference(pd.DataFrame({"paper": [2.0, 0.0], "ours": [2.1, 3.0]}), "ours", "paper")
    with_figure = {"line": subplots(figsize=(2, 2))[0]}
    return Evidence(
        name="small",
        title="Small",
        pictures="../figures/small",
        tables=("one",),
        figures=("line",),
        compute=lambda progress, coarse: Findings({"one": table}, with_figure),
    )


PAGE = "before\n<!-- table one -->\nold\n<!-- end -->\nafter\n"


def test_differences_are_in_per_cent_and_empty_for_zero_references():
    table = small_evidence().run().tables["one"]
    assert list(table) == ["paper", "ours", "ours vs paper (%)"]
    assert table["ours vs paper (%)"].iloc[0] == pytest.approx(5)
    assert to_markdown(table).splitlines()[2:] == ["| 2 | 2.1 | +5.00 |", "| 0 | 3 |  |"]


def test_tables_replace_the_text_in_their_places():
    tables = {"one": pd.DataFrame({"a": [1.23456, 12345.6]})}
    filled = fill(PAGE, tables)
    table = "| a |\n| --- |\n| 1.235 |\n| 12350 |\n"
    assert filled == f"before\n<!-- table one -->\n{table}<!-- end -->\nafter\n"
    assert fill(filled, tables) == filled


def test_a_page_is_written_with_its_pictures(tmp_path):
    evidence, folder = small_evidence(), tmp_path / "docs" / "pages"
    folder.mkdir(parents=True)
    (folder / "small.md").write_text(PAGE)
    findings = evidence.run()
    page, picture = publish(evidence, findings, findings.write(tmp_path / "results"), folder)
    assert "+5.00" in page.read_text()
    assert picture == tmp_path / "docs" / "figures" / "small" / "line.png"
    assert picture.read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (PAGE + PAGE.replace("one", "two"), "table two -->`, but small has no such table"),
        (PAGE + PAGE, "a table has two places"),
        (None, "small.md is missing"),
    ],
)
def test_a_page_with_wrong_places_is_refused(text, message, tmp_path):
    if text is not None:
        (tmp_path / "small.md").write_text(text)
    with pytest.raises(ValueError, match=message):
        read_pages(small_evidence(), tmp_path)


def test_missing_results_are_refused():
    evidence = attrs.evolve(small_evidence(), tables=("one", "two"))
    with pytest.raises(ValueError, match=r"tables of small: .* declared names differ in two"):
        evidence.run()
