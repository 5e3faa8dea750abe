# SPDX-License-Identifier: GPL-2.0-or-later
"""A run must have the time step with which LIGGGHTS' integrators were set up."""

from __future__ import annotations

from pathlib import Path

import pytest
from deck_text import error_of, head, material, run_text

from plastigran.engine.dumps import read_dump

DECK = (
    head("0 1 -0.1 0.1 -0.1 0.1", skin=1e-3)
    + material("7.0e10", "1.0e8")
    + """
pair_style gran model thornton tangential off
pair_coeff * *
create_atoms 1 single 0.1 0 0 units box
set group all diameter 0.02 density 2700
velocity all set 1 0 0
fix integrate all nve/sphere
dump d all custom 1 ${output}/path.dump id x
dump_modify d format "%d %.15g"
timestep 1e-5
run 1000
"""
)


def last_position(folder: Path, more: str) -> float:
    run_text(folder, DECK + more)
    return read_dump(folder / "path.dump")["x"].iloc[-1]


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_time_step_without_a_setup_is_refused(ranks, tmp_path):
    """A new time step is refused with `pre no`: particles would still move with the earlier time
    step, and everything else would use the new one.
    """
    message = error_of(tmp_path, DECK + "timestep 1e-6\nrun 1000 pre no", ranks)
    assert "run ... pre no: timestep is 1e-06, but particles would move with 1e-05" in message
    assert "Remove `pre no`" in message


def test_a_time_step_with_a_setup_is_taken(tmp_path):
    """A run with setup uses the new time step.

    The particle moves from 0.1 m at 1 m/s during 1000 steps of 10 us and 1000 steps of 1 us.
    """
    x = last_position(tmp_path, "timestep 1e-6\nrun 1000")
    assert x == pytest.approx(0.111, rel=1e-12)


def test_a_fix_may_change_the_time_step(tmp_path):
    """`fix dt/reset` changes the time step of all integrators to 2 us, also for the next run. The
    particle moves from 0.1 m at 1 m/s during 1000 steps of 10 us and then 200 steps of 2 us."""
    x = last_position(tmp_path, "fix reset all dt/reset 10 1e-6 2e-6 1.0\nrun 100\nrun 100 pre no")
    assert x == pytest.approx(0.1104, rel=1e-12)
