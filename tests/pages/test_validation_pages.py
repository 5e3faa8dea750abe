# SPDX-License-Identifier: GPL-2.0-or-later
"""The validation pages show all tables and figures, and pages of laws show their errors."""

from __future__ import annotations

import re

import pytest

from plastigran import laws
from plastigran.calibration.expected_errors import errors_table
from plastigran.cli import main
from plastigran.engine.process import PROJECT
from plastigran.report.pages import read_pages
from plastigran.validation.report import EVIDENCE
from plastigran.validation.summary import summarised


def test_the_pages_show_every_picture():
    text = "".join(read_pages(EVIDENCE, PROJECT / "docs").values())
    shown = set(re.findall(r"\(figures/validation/([\w.]+)\)", text))
    assert shown == {f"{name}.png" for name in EVIDENCE.figures}
    for file in shown:
        assert 0 < (PROJECT / "docs" / EVIDENCE.pictures / file).stat().st_size < 3e5


def test_results_are_not_overwritten(tmp_path, capsys):
    (tmp_path / "leeb.csv").write_text("kept")
    assert main(["validate", "--output", str(tmp_path)]) == 1
    assert "contains results (leeb.csv)" in capsys.readouterr().err


@pytest.mark.parametrize("law", sorted(laws.LAWS))
def test_the_first_table_of_a_law_has_its_use_errors_and_cost(law):
    page = (PROJECT / "docs" / "laws" / f"{law}.md").read_text()
    first_lines = "\n".join(page.splitlines()[:12])
    rows = re.findall(r"^\| \*\*(.+?)\*\* \| .+ \|$", first_lines, re.MULTILINE)
    assert rows[:4] == ["Take it for", "Not for", "How far off", "Cost"]
    if law in set(errors_table()["law"]):
        assert summarised(page, law, errors_table()) == page


def test_a_law_page_without_a_line_for_its_errors_is_refused():
    with pytest.raises(ValueError, match="page of thornton has no line"):
        summarised("# `thornton`", "thornton", errors_table())
