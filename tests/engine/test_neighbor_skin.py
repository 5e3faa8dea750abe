# SPDX-License-Identifier: GPL-2.0-or-later
"""The neighbor skin determines how often neighbor lists are rebuilt; it changes no contact."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from deck_text import head, material, run_text

from plastigran.engine.dumps import read_dump

# Three spheres fall on a plane; one hits it three times, and two of them collide twice.
DECK = f"""
neigh_modify    delay 0
{material(7e9, 1e7, friction=0.5)}
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


#: Texts of the deck and their replacements, by case. With `surface multicontact`, LIGGGHTS keeps
#: the tangential spring of a plane that a sphere has left, so this case has no springs.
MODELS = {
    "universal": {"": ""},
    "hertz": {
        "boundary f f f": "boundary f f f\nhard_particles yes",
        "model universal tangential history": "model hertz tangential partial_slip",
        "neigh_modify": "fix e all property/global coefficientRestitution peratomtypepair 1 0.7\n"
        "neigh_modify",
    },
    "multicontact": {
        "tangential history": "tangential no_history surface multicontact",
        "fix gravity": "fix pressing all multicontact/halfspace geometric_prefactor 1\nfix gravity",
    },
}


def trajectory(skin: float, models: str, folder: Path) -> np.ndarray:
    """Return z, vx, vz, fz and omegay of all spheres, (steps * spheres, quantities)."""
    text = head("-0.1 0.2 -0.1 0.1 -0.01 0.1", skin) + DECK
    for words, others in MODELS[models].items():
        text = text.replace(words, others)
    run_text(folder, text)
    table = read_dump(folder / "trajectory.dump").sort_values(["step", "id"])
    return table[["z", "vx", "vz", "fz", "omegay"]].to_numpy()


@pytest.mark.parametrize("models", MODELS)
@pytest.mark.parametrize("skin", [0.0, 1e-9])
def test_a_small_skin_changes_no_contact(skin, models, tmp_path):
    """A very small neighbor skin, or none, does not change motion and forces.

    Each quantity changes by at most 1e-9 of its largest value, because sums have another order.
    `surface multicontact` depends on the skin if a sphere has several contacts. With this model,
    the test compares only the sphere that hits only the plane.
    """
    expected = trajectory(2e-3, models, tmp_path / "usual")
    pressed = expected[0::3, 3] > 0  # the sphere that hits only the plane
    assert np.count_nonzero(np.diff(pressed.astype(int)) == 1) >= 3
    small_skin = trajectory(skin, models, tmp_path / "small")
    counted = slice(0, None, 3 if models == "multicontact" else 1)
    off = np.abs(small_skin - expected)[counted]
    assert (off <= 1e-9 * np.abs(expected).max(axis=0)).all()


def test_a_contact_ends_where_the_deck_takes_the_particle_away(tmp_path):
    """The history of a contact ends if a deck moves its particle away between two runs.

    A sphere overlaps a plane, is far away during the next run, and comes back with less overlap.
    Its force then equals the force of a new contact.
    """
    text = head("-0.1 0.1 -0.1 0.1 -0.1 0.1", 2e-3) + (
        f"{material(7e9, 1e7, friction=0.5)}\n"
        "create_atoms 1 single 0 0 {height}\n"
        "set group all diameter 0.02 density 2700\n"
        "pair_style gran model universal tangential history\n"
        "pair_coeff * *\n"
        "fix floor all wall/gran model universal tangential history primitive type 1 zplane 0.0\n"
        "timestep 1e-6\n"
        "dump trajectory all custom 1 trajectory.dump id z fz\n"
    )
    away = "displace_atoms all move 0 0 0.05 units box\nrun 1\n"
    back = "displace_atoms all move 0 0 -0.04995 units box\nrun 1\n"
    run_text(tmp_path / "first", text.format(height=0.0099 + 0.00005) + "run 1\n")
    run_text(tmp_path / "again", text.format(height=0.0099) + "run 1\n" + away + back)
    first, again = (
        read_dump(tmp_path / name / "trajectory.dump")["fz"].iloc[-1] for name in ("first", "again")
    )
    assert first > 0
    assert again == pytest.approx(first, rel=1e-9)
