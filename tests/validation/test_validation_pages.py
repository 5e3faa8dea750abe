# SPDX-License-Identifier: GPL-2.0-or-later
"""The validation's pages hold its tables and pictures."""

from __future__ import annotations

import re

from plastigran.cli import main
from plastigran.engine.process import PROJECT
from plastigran.report.pages import read_pages
from plastigran.validation.report import REPORT


def test_the_pages_show_every_picture():
    text = "".join(read_pages(REPORT, PROJECT / "docs").values())
    shown = set(re.findall(r"\(figures/validation/([\w.]+)\)", text))
    assert shown == {f"{name}.png" for name in REPORT.figures}
    for file in shown:
        assert 0 < (PROJECT / "docs" / REPORT.pictures / file).stat().st_size < 3e5


def test_results_are_not_overwritten(tmp_path, capsys):
    (tmp_path / "leeb.csv").write_text("kept")
    assert main(["validate", "--output", str(tmp_path)]) == 1
    assert "holds results (leeb.csv)" in capsys.readouterr().err
