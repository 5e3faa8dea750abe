# SPDX-License-Identifier: GPL-2.0-or-later
"""Series and energy balance of users' decks, from logs of several runs and continuations."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose
from own_decks import PLAIN, finished_run, table

import plastigran as pg
from plastigran.bulk.run import run_bulk
from plastigran.bulk.vtk import time_of
from plastigran.engine.log import read_thermo

#: Columns of the energy balance in a log.
ENERGIES = "v_kinetic v_elastic v_plastic v_friction v_viscous v_drift"
#: Logs of the simulations before and after `clear`; the second one starts with twice the energy.
BEFORE_CLEAR = table(f"Time {ENERGIES}", "0 0 1 0 0 0 0 0", "10 1e-5 0.5 0 0.5 0 0 0")
AFTER_CLEAR = table(f"Time {ENERGIES}", "0 0 2 0 0 0 0 0", "20 2e-5 1 0 1 0 0 0")


def test_runs_that_restart_the_step_count_are_all_kept(plain, tmp_path):
    """The series has the rows of every `run` command, also if `reset_timestep` repeats steps.

    The last row of a run is the first row of the next run if the step count continues.
    """
    text = PLAIN.replace("run 500", "run 200\nreset_timestep 0\nrun 500")
    plain.write_text(text, encoding="latin-1")
    series = run_bulk(plain, {}, tmp_path / "run", show=False).series
    assert series["step"].tolist() == [*range(0, 1201, 100), *range(0, 501, 100)]
    assert series["run"].tolist() == [0] * 11 + [1] * 2 + [2] * 6


def test_energy_balance_is_checked_over_every_run(tmp_path):
    """The check of the energy balance covers a second run that repeats steps of the first run."""
    log = BEFORE_CLEAR
    log += table(f"Time {ENERGIES}", "0 0 0.5 0 0.5 0 0 0", "10 1e-5 0.2 0 0.4 0 0 0.4")
    run = pg.open(finished_run(tmp_path / "run", log))
    assert run.checks["value"].tolist() == pytest.approx([0.4, 0.1])
    assert not run.passed


def test_energy_balance_is_checked_for_each_simulation(tmp_path):
    """The energy balance is checked separately after `clear`, which resets losses and time step."""
    first = "timestep 1e-6\n" + table(ENERGIES, "0 1 0 0 0 0 0", "10 0.5 0 0.5 0 0 0")
    second = table(ENERGIES, "10 4 0 0 0 0 0", "20 3 0 1 0 0 0.04")
    run = pg.open(finished_run(tmp_path / "run", f"{first}clear\ntimestep 2e-6\n{second}"))
    assert run.checks["value"].tolist() == pytest.approx([0.01, 0])
    assert run.series["simulation"].tolist() == [0, 0, 1, 1]
    assert_allclose(run.series["time"], np.array([0, 10, 10, 30]) * 1e-6)
    assert "time" not in pg.open(finished_run(tmp_path / "other", f"{first}clear\n{second}")).series


def test_continued_run_belongs_to_the_last_simulation(tmp_path):
    earlier = finished_run(tmp_path / "before", f"{BEFORE_CLEAR}clear\n{AFTER_CLEAR}")
    before = pg.open(earlier).series
    log = table(f"Time {ENERGIES}", "20 2e-5 1 0 1 0 0 0")
    log += table(f"Time {ENERGIES}", "20 2e-5 1 0 1 0 0 0", "40 4e-5 0.1 0 1 0 0 0.9")
    run = pg.open(finished_run(tmp_path / "run", log, before.to_csv(index=False)))
    assert run.checks["value"].tolist() == pytest.approx([0.45, 0])
    assert not run.passed
    assert run.series["simulation"].tolist() == [0, 0, 1, 1, 1]
    assert_allclose(np.diff(run.series["time"].iloc[2:]), 2e-5)
    assert run.notes == [
        "the energy balance restarts at each `clear`. It was checked for every simulation between "
        "`clear` commands, and drawn for the last simulation"
    ]


@pytest.mark.parametrize("columns", ["", "dt", "time"])
def test_time_accumulates_over_runs(columns, plain, tmp_path):
    """The time accumulates over runs with different time steps and after `reset_timestep`.

    It comes from a log column (`dt` or `time`) or from the `timestep` commands in the log.
    """
    runs = """
    timestep 1e-6   # s
    run 200
    timestep ${twice}
    run 200
    reset_timestep 0
    timestep .000003
    run 200
    """
    text = PLAIN.partition("timestep")[0] + "variable twice equal 2e-6\n"
    text += f"thermo_style custom step {columns} atoms\nthermo 100\n{runs}"
    plain.write_text(text, encoding="latin-1")
    series = run_bulk(plain, {}, tmp_path / "run", show=False).series
    assert_allclose(series["time"], np.array([0, 100, 200, 400, 600, 600, 900, 1200]) * 1e-6)


@pytest.mark.parametrize(
    "commands",
    ["", "timestep ${mine}\n", "timestep 1e-6\nfix a all dt/reset 1 1e-9 1e-6 1e-9 units box\n"],
)
def test_unknown_time_step_gives_no_time(commands, tmp_path):
    """If the time step is unknown, the series has no time, but the energy balance is checked."""
    log = commands + table(ENERGIES, "0 1 0 0 0 0 0", "10 0.5 0 0.5 0 0 0")
    run = pg.open(finished_run(tmp_path / "run", log))
    assert "time" not in run.series and run.passed and len(run.checks) == 2
    assert not run.figures and any("log has no time" in note for note in run.notes)


def test_varying_time_step_gives_no_time(tmp_path):
    log = table("Dt", "0 1e-6", "10 2e-6", "20 2e-6")
    assert "time" not in pg.open(finished_run(tmp_path / "run", log)).series


@pytest.mark.parametrize(
    ("log", "before", "times"),
    [
        # The first run has no steps and takes no time.
        (table("Atoms", "0 1") + "timestep 1e-6\n" + table("Atoms", "0 1", "10 1"), "", [0, 1e-5]),
        # The checkpoint lies between two lines of the earlier log.
        (
            "timestep 1e-6\n" + table("Atoms", "15 5", "25 5"),
            "step,time,atoms\n0,0,5\n10,1e-5,5\n",
            [0, 1e-5, 1.5e-5, 2.5e-5],
        ),
        (
            "timestep 1e-6\n" + table("Atoms", "10 5", "20 5"),
            "step,time,atoms\n10,1,5\n",
            [1, 1 + 1e-5],
        ),
        # One of the two logs has no time.
        ("timestep 1e-6\n" + table("Atoms", "10 5", "20 5"), "step,atoms\n10,5\n", None),
        (table("Atoms", "10 5", "20 5"), "step,time,atoms\n10,1,5\n", None),
    ],
)
def test_time_of_a_continued_run(log, before, times, tmp_path):
    series = pg.open(finished_run(tmp_path / "run", log, before)).series
    if times is None:
        assert series["step"].tolist() == [10, 20] and "time" not in series
    else:
        assert_allclose(series["time"], times, rtol=1e-9, atol=1e-15)


def test_later_line_of_a_step_adds_columns(tmp_path):
    """If a deck changes its log columns between two runs, the row of their common step has both.

    A column of both runs keeps the value of the earlier run.
    """
    log = table("Atoms", "0 5") + table("Atoms KinEng", "0 6 2", "10 6 3")
    series = pg.open(finished_run(tmp_path / "run", log)).series
    assert series["atoms"].tolist() == [5, 6] and series["kinetic_energy"].tolist() == [2, 3]


def test_log_without_lines_gives_an_empty_series(tmp_path):
    log, before = "timestep 1e-6\nStep Atoms\n", "step,time,atoms\n0,0,5\n10,1e-5,5\n"
    assert pg.open(finished_run(tmp_path / "run", log)).series.empty
    continued = pg.open(finished_run(tmp_path / "continued", log, before))
    assert continued.series["step"].tolist() == [0, 10]


def test_frames_of_repeated_steps_have_the_later_time(tmp_path):
    """A frame whose step occurs in two runs has the time of the second run, which overwrites it."""
    log = table("Time", "0 0", "10 1", "20 2") + table("Time", "0 2", "10 3")
    run = pg.open(finished_run(tmp_path / "run", log))
    assert [time_of(run, step) for step in (0, 5, 10, 20)] == [2, 2.5, 3, 2]


def test_equal_column_names_are_numbered(tmp_path):
    """Columns with equal names get numbers, because LIGGGHTS truncates long names."""
    log = tmp_path / "log"
    log.write_text("Step kinetic_ kinetic_\n0 1 2\n10 3 4\nLoop time of 1\n")
    columns = read_thermo(log)
    assert columns["kinetic_"].tolist() == [1, 3] and columns["kinetic_.2"].tolist() == [2, 4]
