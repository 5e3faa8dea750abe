# SPDX-License-Identifier: GPL-2.0-or-later
"""Entries of the ledger are the same however and whenever they are asked for."""

from __future__ import annotations

import re
from math import pi
from pathlib import Path

import numpy as np
import pytest
from ledger_runs import largest_difference, ledger

from plastigran.engine.dumps import read_dump
from plastigran.engine.process import EngineError


def test_entries_are_the_same_in_seldom_steps(bed, tmp_path):
    """What was counted before changes nothing.

    1e-12 of the energy: a log has 15 digits.
    """
    often = ledger("bed", tmp_path, before=10000, after=0, every=7)
    whole = bed[1]
    scale = whole[["kinetic", "gravity"]].iloc[0].sum()
    assert largest_difference(often, whole[whole["run"] == 0]) < 1e-12 * scale


def builds(folder: Path) -> int:
    """How many lists of neighbours the engine has made in a deck's first run."""
    log = (folder / "log.liggghts").read_text()
    return int(re.findall(r"Neighbor list builds = (\d+)", log)[0])


def test_entries_are_the_same_in_the_engines_own_loop(tmp_path):
    """It runs where contacts are dumped, and counts in each contact as its force is computed; ours
    asks the contacts afterwards. Restart files are written in these steps, too, and a narrow skin
    makes lists of neighbours in many of them.

    1e-12 of the energy: a log has 15 digits.
    """
    deck = {"before": 7000, "after": 0, "every": 7, "skin": 0.0002}
    ours = ledger("bed", tmp_path / "ours", **deck)
    engines = ledger("bed", tmp_path / "engines", files=1, **deck)
    assert len(ours) == len(engines) > 1000 and builds(tmp_path / "ours") > 200
    scale = ours[["kinetic", "gravity"]].iloc[0].sum()
    assert largest_difference(ours, engines) < 1e-12 * scale


@pytest.mark.parametrize("asks", [1, 2, 3], ids=["move", "adapt", "setforce"])
@pytest.mark.parametrize("every", [1, 50])
def test_entries_are_known_when_all_forces_are(asks, every, tmp_path):
    """Within a step they are not: in its first part, before forces, or while walls' are to come. It
    does not matter whether the step before has been asked."""
    with pytest.raises(EngineError, match="was read within a step, before all forces are known"):
        ledger("between", tmp_path, asks=asks, every=every)


def test_what_acts_in_a_step_takes_the_entry_of_the_step_before(tmp_path):
    """From a `fix ave/time`: a grain is moved by as many metres as were joules.

    1e-9 of the largest: the digits of the log.
    """
    entries = ledger("between", tmp_path, asks=1, fed=1, every=1)
    motion = read_dump(tmp_path / "trajectory.dump")
    height = motion[motion["id"] == 2].set_index("step")["z"]
    moved = (height - height.iloc[0]).to_numpy()
    asked = entries["elastic"].to_numpy()
    assert len(moved) == len(asked) == 101 and np.ptp(asked) > 0.01 * asked.max() > 0
    assert moved[2:] == pytest.approx(asked[1:-1], rel=0, abs=1e-9 * asked.max())


def test_entries_before_the_first_run_are_those_of_the_moment(tmp_path):
    """The deck gives a grain 0.1 m/s between two answers."""
    ledger("changed", tmp_path)
    log = (tmp_path / "log.liggghts").read_text()
    resting, given = (
        float(re.findall(rf"^{word} (\S+)$", log, re.MULTILINE)[-1])
        for word in ("resting", "given")
    )
    assert resting == 0
    assert given == pytest.approx(0.5 * 2500 * pi / 6 * 0.006**3 * 0.1**2, rel=1e-6)


def test_a_box_that_deforms_shifts_no_entry(tmp_path):
    """`fix deform` displaces particles before the output; the engine's own loop has counted then.

    1e-12 of the energy: a log has 15 digits.
    """
    ours = ledger("deformed", tmp_path / "ours")
    engines = ledger("deformed", tmp_path / "engines", contacts=1)
    assert len(ours) > 100
    assert largest_difference(ours, engines) < 1e-12 * ours["kinetic"].iloc[0]
