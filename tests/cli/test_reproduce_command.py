# SPDX-License-Identifier: GPL-2.0-or-later
"""The command `reproduce`: what it refuses before anything is computed."""

from __future__ import annotations

import pytest

from plastigran.cli import main
from plastigran.papers import find_paper


def test_an_unknown_paper_is_refused_with_those_there_are(capsys):
    with pytest.raises(SystemExit):
        main(["reproduce", "xy99"])
    assert "zv02" in capsys.readouterr().err


def test_results_are_not_overwritten(tmp_path, capsys):
    table = find_paper("zv02").tables[0]
    (tmp_path / f"{table}.csv").write_text("kept")
    assert main(["reproduce", "zv02", "--output", str(tmp_path)]) == 1
    assert "holds results" in capsys.readouterr().err


def test_a_page_without_places_is_refused(tmp_path, capsys):
    (tmp_path / "zv02.md").write_text("no tables here")
    line = ["reproduce", "zv02", "--output", str(tmp_path / "out"), "--docs", str(tmp_path)]
    assert main(line) == 1
    assert "has no <!-- table" in capsys.readouterr().err
    assert main([*line, "--coarse"]) == 1
    assert "not --coarse" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
