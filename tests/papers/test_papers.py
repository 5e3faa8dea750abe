# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests that every paper has a page with the tables and figures of `plastigran reproduce`."""

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


def test_papers_by_name():
    assert {"gcm15", "zv02"} <= set(NAMES)
    with pytest.raises(ValueError, match=r"no paper 'xy99'\. Available papers: .*gcm15"):
        find_paper("xy99")


@pytest.mark.parametrize("name", NAMES)
def test_the_page_has_all_pictures(name):
    paper = find_paper(name)
    assert paper.name == name
    (text,) = read_pages(paper, PAGES).values()
    shown = set(re.findall(rf"\(\.\./figures/papers/{name}/([\w.]+)\)", text))
    assert shown == {f"{f}.png" for f in paper.figures} | {f"{m}.gif" for m in paper.movies}
    for file in shown:
        assert (PAGES.parent / "figures" / "papers" / name / file).stat().st_size < 1.5e6


@pytest.mark.parametrize("name", NAMES)
def test_differences_on_the_page_are_those_of_its_columns(name):
    for table in read_tables((PAGES / f"{name}.md").read_text()).values():
        assert len(table)
        for column in table.columns:
            compared = re.fullmatch(r"(.*) vs (.*) \(%\)", column)
            if compared is None or not set(compared.groups()) <= set(table.columns):
                continue
            keys = (*compared.groups(), column)
            ours, theirs, difference = (pd.to_numeric(table[key]) for key in keys)
            expected = 100 * (ours / theirs - 1)
            # Rounding to four digits changes each number by up to 0.05 %; differences have two
            # decimals.
            bound = 0.11 + 0.001 * expected.abs()
            given = np.isfinite(expected)
            assert given.any()
            assert ((difference - expected).abs() <= bound)[given].all(), f"{name}: {column}"
