# SPDX-License-Identifier: GPL-2.0-or-later
"""Progress counts the steps of all runs of a deck, and estimates the time left from them."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastigran.bulk.own import planned_steps
from plastigran.engine.deck import read_deck
from plastigran.engine.watch import RunBar

HEAD = "Step Atoms\n"


def write(log: Path, text: str) -> None:
    with log.open("a") as file:
        file.write(text)


def line(bar: RunBar, seconds: float) -> str:
    """Return the text of the progress bar after some seconds."""
    bar.update()
    bar._bar._time = lambda: bar._bar.start_t + seconds
    return bar._bar._line()


@pytest.fixture(params=["by the log", "by Python"])
def bar(request, tmp_path):
    log = tmp_path / "log.liggghts"
    write(log, "planned steps = 1000\n" if request.param == "by the log" else "")
    bar = RunBar("deck", log, planned=0 if request.param == "by the log" else 1000)
    yield bar, log
    bar.close()


def test_time_left_covers_all_runs(bar):
    """The estimate includes runs that have not started: here 900 steps after the first 100 steps.

    A step of the second run takes ten times as long as a step of the first run.
    """
    bar, log = bar
    write(log, f"run 100\n{HEAD}0 1\n50 1\n")
    assert line(bar, 5) == "deck: 50.0/1.00k steps, 00:05 so far, 01:35 to go"
    write(log, f"100 1\nLoop time of 10\nrun 900\n{HEAD}100 1\n200 1\n")
    # 200 steps took 110 s, and 800 are left.
    assert line(bar, 110) == "deck: 200/1.00k steps, run 2, 01:50 so far, 07:20 to go"


def test_time_left_covers_the_current_run_if_the_plan_is_unknown(tmp_path):
    log = tmp_path / "log.liggghts"
    bar = RunBar("deck", log)
    write(log, f"run 100\n{HEAD}0 1\n50 1\n")
    assert line(bar, 5) == "deck: 50.0/100 steps, 00:05 so far, 00:05 to go in this run"
    bar.close()


@pytest.mark.parametrize(
    ("script", "steps"),
    [
        ("run 100\nrun 900\n", 1000),
        ("variable n index 400\nrun ${n}\nrun 1000 upto # steps\n", 1000),
        ("variable n equal 400\nrun ${n}\n", 0),
        ('run 100\nif "1 > 0" then "run 900"\n', 0),
        ('variable extra index ""\nrun 100\n${extra}\n', 100),
        ("include more.in\nrun 100\n", 100),
        ("include ${where}\nrun 100\n", 0),
        ("include runs.in\nrun 100\n", 0),
    ],
)
def test_steps_of_a_script(script, steps, tmp_path):
    (tmp_path / "own.in").write_text(script)
    (tmp_path / "more.in").write_text("timestep 1e-6\n")
    (tmp_path / "runs.in").write_text("run 10\n")
    assert planned_steps(read_deck(tmp_path / "own.in", {}, tmp_path / "out")) == steps
