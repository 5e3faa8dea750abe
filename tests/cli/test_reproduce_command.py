# SPDX-License-Identifier: GPL-2.0-or-later
"""The command `reproduce` refuses wrong arguments before it computes anything."""

from __future__ import annotations

import pytest

from plastigran.cli import main
from plastigran.papers import find_paper


def test_an_unknown_paper_is_refused_with_those_there_are(capsys):
    with pytest.raises(SystemExit):
        main(["reproduce", "xy99"])
    assert "zv02" in capsys.readouterr().err


@pytest.mark.parametrize("ending", [".csv", ".png", ".gif"])
def test_results_are_not_overwritten(ending, tmp_path, capsys):
    (name, *_) = (name for name in find_paper("zv02").files if name.endswith(ending))
    (tmp_path / name).write_text("kept")
    assert main(["reproduce", "zv02", "--output", str(tmp_path)]) == 1
    assert f"contains results ({name})" in capsys.readouterr().err


def test_a_folder_that_cannot_be_made_is_refused_before_anything_is_computed(tmp_path, capsys):
    (tmp_path / "file").write_text("kept")
    assert main(["reproduce", "zv02", "--output", str(tmp_path / "file" / "below")]) == 1
    assert str(tmp_path / "file") in capsys.readouterr().err


def test_a_page_with_an_unknown_table_is_refused(tmp_path, capsys):
    (tmp_path / "zv02.md").write_text("<!-- table colours -->\n<!-- end -->\n")
    line = ["reproduce", "zv02", "--output", str(tmp_path / "out"), "--docs", str(tmp_path)]
    assert main(line) == 1
    assert "has a line `<!-- table colours -->`" in capsys.readouterr().err
    assert main([*line, "--coarse"]) == 1
    assert "Remove --coarse" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
