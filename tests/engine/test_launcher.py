# SPDX-License-Identifier: GPL-2.0-or-later
"""The launcher reads decks as LIGGGHTS does, and names a model that does not exist."""

from __future__ import annotations

import subprocess

import pytest

from plastigran.engine.process import engine_path

HEAD = "units si\natom_style granular\n"


def test_a_deck_may_be_read_from_a_pipe(tmp_path):
    (tmp_path / "deck.in").write_text(HEAD + 'print "speed is ${speed}"\n')
    with open(tmp_path / "deck.in") as deck:
        line = [engine_path(), "-log", "none", "-var", "speed", "3"]
        done = subprocess.run(
            line, stdin=deck, cwd=tmp_path, capture_output=True, text=True, check=False
        )
    assert "speed is 3" in done.stdout


@pytest.mark.parametrize(
    "line", ["pair_style gran model throton", "pair_style gran &\n model throton"]
)
def test_a_model_that_does_not_exist_is_named(line, tmp_path):
    (tmp_path / "deck.in").write_text(HEAD + f"{line} tangential off\n# gran model thronton\n")
    done = subprocess.run(
        [engine_path(), "-in", "deck.in", "-log", "none"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        errors="replace",  # LIGGGHTS frees some messages before it prints them
        check=False,
    )
    assert done.returncode != 0
    assert (
        "WARNING: plastigran: model throton is unknown. Available models: brake_2012 "
        in done.stderr
    )
    assert done.stderr.count("is unknown") == 1
