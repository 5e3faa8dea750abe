# SPDX-License-Identifier: GPL-2.0-or-later
"""The neighbor skin sets how often lists are rebuilt and changes no contact."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from deck_head import head

from plastigran.engine.dumps import read_dump
from plastigran.engine.process import run_deck

# Spheres that fall on a plane three times and meet each other twice.
DECK = """
neigh_modify    delay 0
fix youngs  all property/global youngsModulus peratomtype 7e9
fix poisson all property/global poissonsRatio peratomtype 0.3
fix strength all property/global yieldStrength peratomtype 1e7
fix friction all property/global coefficientFriction peratomtypepair 1 0.5
create_atoms    1 single 0 0 0.0101
create_atoms    1 single 0.05 0 0.0101
create_atoms    1 single 0.05 0 0.0311
set group all diameter 0.02 density 2700
set group all vz -0.2
set group all vx 0.05
pair_style      gran model universal tangential history
pair_coeff      * *
fix floor all wall/gran model universal tangential history primitive type 1 zplane 0.0
fix gravity all gravity 200 vector 0 0 -1
timestep        1e-6
fix integrate   all nve/sphere
dump trajectory all custom 10 trajectory.dump id z vx vz fz omegay
dump_modify trajectory format "%d %.15g %.15g %.15g %.15g %.15g"
run             8000
"""


def trajectory(skin: float, folder: Path) -> np.ndarray:
    """Of all spheres: z, vx, vz, fz, omegay, (step and sphere, quantity)."""
    folder.mkdir()
    deck = folder / "deck.in"
    deck.write_text(head("-0.1 0.2 -0.1 0.1 -0.01 0.1", skin) + DECK)
    run_deck(deck, {}, folder)
    table = read_dump(folder / "trajectory.dump").sort_values(["step", "id"])
    return table[["z", "vx", "vz", "fz", "omegay"]].to_numpy()


@pytest.mark.parametrize("skin", [0.0, 1e-9])
def test_a_small_skin_changes_no_contact(skin, tmp_path):
    """1e-9 of the largest of each quantity: sums in another order."""
    expected = trajectory(2e-3, tmp_path / "usual")
    pressed = expected[0::3, 3] > 0  # the sphere that meets the plane alone
    assert np.count_nonzero(np.diff(pressed.astype(int)) == 1) >= 3
    found = trajectory(skin, tmp_path / "small")
    assert (np.abs(found - expected) <= 1e-9 * np.abs(expected).max(axis=0)).all()
