# SPDX-License-Identifier: GPL-2.0-or-later
"""Every paper has a page; its tables and pictures are those the command writes."""

from __future__ import annotations

import re

import attrs
import numpy as np
import pandas as pd
import pytest

from plastigran.engine.process import PROJECT
from plastigran.papers import find_paper, paper_names
from plastigran.papers.base import Paper, Reproduction, add_difference
from plastigran.papers.pages import PLACE, fill, publish, read_page, to_markdown
from plastigran.plot.style import subplots

PAGES = PROJECT / "docs" / "papers"
NAMES = paper_names()


def read_tables(name: str) -> dict[str, pd.DataFrame]:
    """The tables of a page, as text."""
    found = {}
    for _, table, text, _ in PLACE.findall((PAGES / f"{name}.md").read_text()):
        head, _, *lines = (
            [cell.strip() for cell in line.split("|")[1:-1]] for line in text.splitlines()
        )
        found[table] = pd.DataFrame(lines, columns=head)
    return found


def test_papers_are_found():
    assert {"gcm15", "zv02"} <= set(NAMES)
    with pytest.raises(ValueError, match=r"no paper 'xy99'; there are .*gcm15"):
        find_paper("xy99")


@pytest.mark.parametrize("name", NAMES)
def test_a_page_holds_the_papers_tables_and_pictures(name):
    paper = find_paper(name)
    assert paper.name == name
    text = read_page(paper, PAGES)
    shown = set(re.findall(rf"\(\.\./figures/papers/{name}/([\w.]+)\)", text))
    assert shown == {f"{f}.png" for f in paper.figures} | {f"{m}.gif" for m in paper.movies}
    for file in shown:
        assert (PAGES.parent / "figures" / "papers" / name / file).stat().st_size < 1.5e6


@pytest.mark.parametrize("name", NAMES)
def test_tables_of_a_page_hold(name):
    """Each has lines, and its differences are those of the columns beside them."""
    for table in read_tables(name).values():
        assert len(table)
        for column in table.columns:
            named = re.fullmatch(r"(.*) off (.*) \(%\)", column)
            if named is None or not set(named.groups()) <= set(table.columns):
                continue
            ours, theirs, said = (pd.to_numeric(table[key]) for key in (*named.groups(), column))
            # Four digits of either number: 0.05 % of each, and the difference to a hundredth.
            expected = 100 * (ours / theirs - 1)
            bound = 0.11 + 0.001 * expected.abs()
            both = expected.notna() & np.isfinite(expected)
            assert both.any()
            assert ((said - expected).abs() <= bound)[both].all(), f"{name}: {column}"


def own_paper() -> Paper:
    """A paper that is computed at once."""
    table = add_difference(pd.DataFrame({"paper": [2.0, 0.0], "ours": [2.1, 3.0]}), "ours", "paper")
    with_figure = {"line": subplots(figsize=(2, 2))[0]}
    return Paper(
        name="own",
        title="Own",
        citation="Nobody",
        tables=("one",),
        figures=("line",),
        compute=lambda progress, coarse: Reproduction({"one": table}, with_figure),
    )


PAGE = "before\n<!-- table one -->\nold\n<!-- end -->\nafter\n"


def test_differences_are_per_cent_of_the_other_and_empty_where_it_is_zero():
    table = own_paper().reproduce().tables["one"]
    assert list(table) == ["paper", "ours", "ours off paper (%)"]
    assert table["ours off paper (%)"].iloc[0] == pytest.approx(5)
    assert to_markdown(table).splitlines()[2:] == ["| 2 | 2.1 | +5.00 |", "| 0 | 3 |  |"]


def test_tables_replace_what_stood_in_their_places():
    tables = {"one": pd.DataFrame({"a": [1.23456, 12345.6]})}
    filled = fill(PAGE, tables)
    table = "| a |\n| --- |\n| 1.235 |\n| 12350 |\n"
    assert filled == f"before\n<!-- table one -->\n{table}<!-- end -->\nafter\n"
    assert fill(filled, tables) == filled


def test_a_page_is_written_with_its_pictures(tmp_path):
    paper, folder = own_paper(), tmp_path / "docs" / "papers"
    folder.mkdir(parents=True)
    (folder / "own.md").write_text(PAGE)
    made = paper.reproduce()
    page, picture = publish(paper, made, made.write(tmp_path / "results"), folder)
    assert "+5.00" in page.read_text()
    assert picture == tmp_path / "docs" / "figures" / "papers" / "own" / "line.png"
    assert picture.read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("nothing", "has no <!-- table one -->"),
        (PAGE + PAGE.replace("one", "two"), "has a place for two, which is no table"),
        (PAGE + PAGE, "two places for one table"),
        (None, "own.md is missing"),
    ],
)
def test_a_page_without_the_right_places_is_refused(text, said, tmp_path):
    if text is not None:
        (tmp_path / "own.md").write_text(text)
    with pytest.raises(ValueError, match=said):
        read_page(own_paper(), tmp_path)


def test_what_is_declared_must_be_made():
    paper = attrs.evolve(own_paper(), tables=("one", "two"))
    with pytest.raises(ValueError, match=r"tables of own: \['two'\] do not match"):
        paper.reproduce()
