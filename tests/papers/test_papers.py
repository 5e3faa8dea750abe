# SPDX-License-Identifier: GPL-2.0-or-later
"""Every paper has a page; its tables and pictures are those the command writes."""

from __future__ import annotations

import re

import numpy as np
import pandas as pd
import pytest

from plastigran.engine.process import PROJECT
from plastigran.papers import find_paper, paper_names
from plastigran.report.pages import read_pages, read_tables

PAGES = PROJECT / "docs" / "papers"
NAMES = paper_names()


def test_papers_are_found():
    assert {"gcm15", "zv02"} <= set(NAMES)
    with pytest.raises(ValueError, match=r"no paper 'xy99'; there are .*gcm15"):
        find_paper("xy99")


@pytest.mark.parametrize("name", NAMES)
def test_a_page_holds_the_papers_tables_and_pictures(name):
    paper = find_paper(name)
    assert paper.name == name
    (text,) = read_pages(paper, PAGES).values()
    shown = set(re.findall(rf"\(\.\./figures/papers/{name}/([\w.]+)\)", text))
    assert shown == {f"{f}.png" for f in paper.figures} | {f"{m}.gif" for m in paper.movies}
    for file in shown:
        assert (PAGES.parent / "figures" / "papers" / name / file).stat().st_size < 1.5e6


@pytest.mark.parametrize("name", NAMES)
def test_tables_of_a_page_hold(name):
    """Each has lines, and its differences are those of the columns beside them."""
    for table in read_tables((PAGES / f"{name}.md").read_text()).values():
        assert len(table)
        for column in table.columns:
            named = re.fullmatch(r"(.*) vs (.*) \(%\)", column)
            if named is None or not set(named.groups()) <= set(table.columns):
                continue
            ours, theirs, said = (pd.to_numeric(table[key]) for key in (*named.groups(), column))
            # Four digits of either number: 0.05 % of each, and the difference to a hundredth.
            expected = 100 * (ours / theirs - 1)
            bound = 0.11 + 0.001 * expected.abs()
            both = expected.notna() & np.isfinite(expected)
            assert both.any()
            assert ((said - expected).abs() <= bound)[both].all(), f"{name}: {column}"
