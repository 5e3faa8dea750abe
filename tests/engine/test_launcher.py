# SPDX-License-Identifier: GPL-2.0-or-later
"""The launcher refuses a -var the deck cannot use, and none that it may."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

from plastigran.engine.process import engine_path, run_deck

HEAD = "units si\natom_style granular\n"
OTHER = 'print "speed is ${speed}"\n'


def launch(folder: Path, deck: str, *words: str) -> subprocess.CompletedProcess:
    (folder / "deck.in").write_text(HEAD + deck)
    (folder / "other.in").write_text(OTHER)
    line = [engine_path(), "-in", "deck.in", "-log", "none", "-var", "speed", "3", *words]
    return subprocess.run(
        line, cwd=folder, capture_output=True, text=True, errors="replace", check=False
    )


@pytest.mark.parametrize(
    "deck",
    [
        OTHER,
        "variable speed index 1\n",
        "include other.in\n",
        "include &\n  other.in\n",
        'include "other.in"\n',
        "variable name index other.in\ninclude ${name}\n",
        'variable n equal 2\nif "${n} == 2" then "jump other.in"\n',
        'variable n equal 1\nif "${n} == 2" then "print no" else "jump other.in"\n',
        'if "2 == 2" then "variable speed index 1"\n',
        "variable name string other.in\ninclude ${name}\n",
        "jump other.in\n",
        'print "${speed} # no comment"\n',
        "print 'no # comment ${speed}'\n",
        "variable twice equal 2*v_speed\n",
    ],
)
def test_a_deck_that_may_use_a_variable_runs(deck, tmp_path):
    done = launch(tmp_path, deck)
    assert done.returncode == 0, done.stdout + done.stderr


NO_SPEED = ["", "# ${speed}\n", "variable sped index 1\n", 'if "1 == 2" then "print no"\n']


@pytest.mark.parametrize("deck", NO_SPEED)
def test_a_misspelt_variable_is_refused(deck, tmp_path):
    done = launch(tmp_path, deck)
    assert done.returncode == 1
    assert "ERROR: -var speed: deck.in has no such variable" in done.stderr
    assert ("it takes sped" in done.stderr) == ("sped index" in deck)


def test_the_engine_itself_says_what_it_refuses(tmp_path):
    """It takes no include within an `if`; the launcher is not the one to say so."""
    done = launch(tmp_path, 'if "2 == 2" then "include other.in"\n')
    assert "Cannot use include command within an if command" in done.stdout


def test_a_deck_may_be_read_from_a_pipe(tmp_path):
    (tmp_path / "deck.in").write_text(HEAD + OTHER)
    with open(tmp_path / "deck.in") as deck:
        line = [engine_path(), "-log", "none", "-var", "speed", "3"]
        done = subprocess.run(
            line, stdin=deck, cwd=tmp_path, capture_output=True, text=True, check=False
        )
    assert "speed is 3" in done.stdout


def test_ranks_that_are_told_to_yield_sleep(decks, tmp_path, monkeypatch):
    """The MPI library calls the launcher's sched_yield, not the system's."""
    monkeypatch.setenv("OMPI_MCA_mpi_yield_when_idle", "1")
    monkeypatch.setenv("LD_DEBUG", "bindings")
    monkeypatch.setenv("LD_DEBUG_OUTPUT", str(tmp_path / "bound"))
    run_deck(decks / "ranks.in", {"grid": "2 1", "steps": 20}, tmp_path, ranks=2)
    bound = "".join(file.read_text() for file in tmp_path.glob("bound*"))
    found = re.findall(r"libopen-pal\S* \S+ to (.+) \S+ normal symbol `sched_yield'", bound)
    assert found == 2 * [str(engine_path())]
