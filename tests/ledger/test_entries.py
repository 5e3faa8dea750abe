# SPDX-License-Identifier: GPL-2.0-or-later
"""Terms of the energy balance do not depend on how and when they are read."""

from __future__ import annotations

import re
from math import pi
from pathlib import Path

import numpy as np
import pytest
from ledger_runs import largest_difference, ledger

from plastigran.engine.dumps import read_dump
from plastigran.engine.process import EngineError


def test_terms_do_not_depend_on_the_output_interval(bed, tmp_path):
    """Energy terms that are printed every seven steps equal those of less frequent output.

    They agree to 1e-12 of the initial energy, because a log has 15 digits.
    """
    often = ledger("bed", tmp_path, before=10000, after=0, every=7)
    whole = bed[1]
    scale = whole[["kinetic", "gravity"]].iloc[0].sum()
    assert largest_difference(often, whole[whole["run"] == 0]) < 1e-12 * scale


def builds(folder: Path) -> int:
    """Return the number of neighbor-list builds in the first run."""
    log = (folder / "log.liggghts").read_text()
    return int(re.findall(r"Neighbor list builds = (\d+)", log)[0])


def test_terms_are_the_same_in_the_loop_of_liggghts(tmp_path):
    """The plugin's loop over contacts and LIGGGHTS' own loop give the same energy terms.

    LIGGGHTS' own loop runs if contacts are dumped. It counts stored energies together with the
    forces; the plugin's loop counts them later. The deck also writes restart files, and a small
    neighbor skin causes many neighbor-list builds. The terms agree to 1e-12 of the initial energy,
    because a log has 15 digits.
    """
    deck = {"before": 7000, "after": 0, "every": 7, "skin": 0.0002}
    ours = ledger("bed", tmp_path / "ours", **deck)
    engines = ledger("bed", tmp_path / "engines", files=1, **deck)
    assert len(ours) == len(engines) > 1000 and builds(tmp_path / "ours") > 200
    scale = ours[["kinetic", "gravity"]].iloc[0].sum()
    assert largest_difference(ours, engines) < 1e-12 * scale


@pytest.mark.parametrize("asks", [1, 2, 3], ids=["move", "adapt", "setforce"])
@pytest.mark.parametrize("every", [1, 50])
def test_terms_are_known_after_all_forces(asks, every, tmp_path):
    """A term cannot be read before all forces of a step are known: in the first part of the step,
    before the pair forces, or before the wall forces. This also holds if the term was read in the
    previous step.
    """
    with pytest.raises(EngineError, match="was read within a step, before all forces are known"):
        ledger("between", tmp_path, asks=asks, every=every)


def test_a_fix_within_a_step_reads_the_previous_term(tmp_path):
    """A fix that acts within a step gets the energy term of the previous step.

    The deck moves a grain by one meter per joule of an energy term, which `fix ave/time` reads. The
    displacement equals the term of the previous step. The tolerance is 1e-9 of the largest term,
    because the log has a limited number of digits.
    """
    entries = ledger("between", tmp_path, asks=1, fed=1, every=1)
    motion = read_dump(tmp_path / "trajectory.dump")
    height = motion[motion["id"] == 2].set_index("step")["z"]
    moved = (height - height.iloc[0]).to_numpy()
    asked = entries["elastic"].to_numpy()
    assert len(moved) == len(asked) == 101 and np.ptp(asked) > 0.01 * asked.max() > 0
    assert moved[2:] == pytest.approx(asked[1:-1], rel=0, abs=1e-9 * asked.max())


def test_terms_before_the_first_run_are_current(tmp_path):
    """Before the first run, the energy terms follow from the current velocities.

    The deck sets the velocity to 0.1 m/s between two outputs.
    """
    ledger("changed", tmp_path)
    log = (tmp_path / "log.liggghts").read_text()
    resting, given = (
        float(re.findall(rf"^{word} (\S+)$", log, re.MULTILINE)[-1])
        for word in ("resting", "given")
    )
    assert resting == 0
    assert given == pytest.approx(0.5 * 2500 * pi / 6 * 0.006**3 * 0.1**2, rel=1e-6)


def test_a_deforming_box_changes_no_term(tmp_path):
    """In a box that deforms, the plugin's loop and LIGGGHTS' own loop give the same energy terms.

    `fix deform` displaces particles before the output, but after LIGGGHTS' loop has counted. The
    terms agree to 1e-12 of the initial kinetic energy, because a log has 15 digits.
    """
    ours = ledger("deformed", tmp_path / "ours")
    engines = ledger("deformed", tmp_path / "engines", contacts=1)
    assert len(ours) > 100
    assert largest_difference(ours, engines) < 1e-12 * ours["kinetic"].iloc[0]
