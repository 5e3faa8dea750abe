# SPDX-License-Identifier: GPL-2.0-or-later
"""The plugin works for walls alone: walls have a law, and pairs LIGGGHTS' `hertz`."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from deck_text import error_of, head, material, run_text

from plastigran.engine.dumps import read_dump

BOX = "-0.1 0.2 -0.1 0.1 -0.01 0.1"
MATERIAL = f"""
neigh_modify    delay 0
{material(7e9, 1e7, friction=0.5)}
fix restitution all property/global coefficientRestitution peratomtypepair 1 0.9
pair_style      gran model hertz tangential history
pair_coeff      * *
fix floor all wall/gran model universal tangential history primitive type 1 zplane 0.0
fix gravity all gravity 200 vector 0 0 -1
timestep        1e-6
fix integrate   all nve/sphere
"""
SPHERE = """
create_atoms    1 single 0 0 0.0101
set group all diameter 0.02 density 2700
set group all vz -0.2
set group all vx 0.05
"""
DUMP = """
dump trajectory all custom 10 trajectory.dump id z vx vz fz omegay
dump_modify trajectory format "%d %.15g %.15g %.15g %.15g %.15g"
"""


def start(skin: float = 2e-3) -> str:
    return head(BOX, skin) + "hard_particles yes\n"


def trajectory(folder: Path, deck: str) -> np.ndarray:
    """Return z, vx, vz, fz and omegay of the sphere, (steps, quantities)."""
    run_text(folder, deck)
    return read_dump(folder / "trajectory.dump")[["z", "vx", "vz", "fz", "omegay"]].to_numpy()


def same(one: np.ndarray, other: np.ndarray) -> bool:
    """Return whether two trajectories agree to 1e-9 of the largest values."""
    return bool((np.abs(one - other) <= 1e-9 * np.abs(other).max(axis=0)).all())


@pytest.mark.parametrize("skin", [0.0, 1e-9])
def test_a_small_skin_changes_no_contact(skin, tmp_path):
    """A very small neighbor skin, or none, does not change impacts on a wall with a law.

    The sphere bounces on the plane at least three times.
    """
    decks = {s: start(s) + MATERIAL + SPHERE + DUMP + "run 8000\n" for s in (2e-3, skin)}
    expected = trajectory(tmp_path / "usual", decks[2e-3])
    pressed = expected[:, 3] > -1e-9
    assert np.count_nonzero(np.diff(pressed.astype(int)) == 1) >= 3
    assert same(trajectory(tmp_path / "small", decks[skin]), expected)


def test_a_wall_given_again_keeps_its_contacts(tmp_path):
    wall = next(line for line in MATERIAL.splitlines() if line.startswith("fix floor"))
    decks = {
        again: start() + MATERIAL + SPHERE + DUMP + f"run 540\n{again}run 500\n"
        for again in ("", f"unfix floor\n{wall}\n")
    }
    kept, given_again = (trajectory(tmp_path / str(len(a)), deck) for a, deck in decks.items())
    assert kept[54, 3] > 0  # in contact
    assert same(given_again, kept)


@pytest.mark.parametrize("pairs", ["hertz", "universal"])
@pytest.mark.parametrize("again", [True, False])
def test_a_wall_given_before_a_run_without_setup_is_there(again, pairs, tmp_path):
    """A wall that a deck adds between two runs acts in the next run, with and without `pre no`.

    The plugin sets up the contacts of a new wall line even if the run has no setup.
    """
    wall = next(line for line in MATERIAL.splitlines() if line.startswith("fix floor"))
    models = MATERIAL.replace("gran model hertz", f"gran model {pairs}", 1)
    lines = f"unfix floor\n{wall}" if again else wall
    if not again:
        models = models.replace(wall, "")
    decks = [
        start() + models + SPHERE + DUMP + f"run 300\n{lines}\nrun 700{pre}\n"
        for pre in ("", " pre no")
    ]
    one, other = (trajectory(tmp_path / str(k), deck) for k, deck in enumerate(decks))
    assert one[:, 3].max() > 0
    assert same(other, one)


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        ("run 10\ntimestep 1e-7\nrun 10 pre no\n", "run ... pre no: timestep is 1e-07"),
        ("set group all vx 30000\nrun 10\n", "moved 3 times its radius in one step"),
    ],
)
def test_the_first_run_is_checked(lines, message, tmp_path):
    assert message in error_of(tmp_path, start() + MATERIAL + SPHERE + lines)


@pytest.mark.parametrize("pairs", ["hertz", "universal"])
@pytest.mark.parametrize(
    ("models", "others"),
    [
        ("universal tangential history", "thornton tangential history"),
        ("universal tangential history", "universal tangential off"),
        ("universal tangential history", "universal tangential history rolling_friction epsd2"),
        ("universal tangential off", "universal tangential no_history rolling_friction epsd"),
    ],
)
def test_a_restart_with_other_models_on_the_wall_is_refused(pairs, models, others, tmp_path):
    rolling = "fix rolling all property/global coefficientRollingFriction peratomtypepair 1 0.1\n"
    properties = rolling + MATERIAL.replace("gran model hertz", f"gran model {pairs}", 1)
    first, second = (
        properties.replace(
            "wall/gran model universal tangential history", f"wall/gran model {line}"
        )
        for line in (models, others)
    )
    run_text(tmp_path, start() + first + SPHERE + "run 540\nwrite_restart middle.restart\n")
    create = start().split("region")[0] + "hard_particles yes\nread_restart middle.restart\n"
    message = error_of(tmp_path, create + second + "run 10\n")
    models, others = (line.replace(" tangential off", "") for line in (models, others))
    assert f"fix floor: the restart file has contacts of `model {models}" in message
    assert f"but the line has `model {others}" in message


def test_a_wall_elsewhere_after_a_restart_has_new_contacts(tmp_path):
    """After a restart, contacts with a wall that has moved start without history.

    The floor of the second run is 2 um lower, which is less than the overlap. Its fix has the same
    ID or another one.
    """
    run_text(tmp_path, start() + MATERIAL + SPHERE + "run 540\nwrite_restart middle.restart\n")
    create = (
        start().split("region")[0] + f"hard_particles yes\nread_restart {tmp_path}/middle.restart\n"
    )
    lower = create + MATERIAL.replace("zplane 0.0", "zplane -2e-6") + DUMP + "run 3000\n"
    one = trajectory(tmp_path / "one", lower)
    other = trajectory(tmp_path / "other", lower.replace("fix floor", "fix other_floor"))
    assert np.abs(one[:, 3]).max() > 0
    np.testing.assert_array_equal(one, other)
    log = (tmp_path / "one" / "log.liggghts").read_text()
    message = "fix floor: contacts start without history, because the position of the wall"
    assert log.count(message) == 1
