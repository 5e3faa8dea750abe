# SPDX-License-Identifier: GPL-2.0-or-later
"""Contacts with meshes that adhesion stretches: folds, edges, corners and moving plates."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from adhesive_grains import PLATE, RADIUS, SIDE, STRETCHED, law_of, run, sphere, table

STEP = 1e-4 * RADIUS  # of a motion at 1 m/s [s]
DEPTH = 0.002 * RADIUS


def held_gap(law: str) -> float:
    """Return 0.7 of the gap at which a contact breaks that was pressed to `DEPTH` [m]."""
    model = law_of(law)
    path = np.linspace(DEPTH, -model.pull_off_distance(RADIUS), 10001)
    contact_radius = model.follow(RADIUS, path, model.State())["contact_radius"]
    return -0.7 * path[np.flatnonzero(contact_radius)[-1]]


def leg(displacement: tuple[float, float, float], steps: int = 50) -> str:
    """Return lines that move grain 1."""
    velocity = " ".join(f"{part / (steps * STEP):.17g}" for part in displacement)
    return f"fix leg mover move linear {velocity} units box\nrun {steps}\nunfix leg\n"


def turned(axis: tuple[float, float, float], angle: float, steps: int = 50) -> str:
    """Return lines that turn grain 1 about an axis through the origin by an angle [degrees]."""
    period = steps * STEP * 360 / angle
    direction = " ".join(map(str, axis))
    return (
        f"fix leg mover move rotate 0 0 0 {direction} {period:.17g} units box\n"
        f"run {steps}\nunfix leg\n"
    )


def pressed_and_stretched(gap: float) -> str:
    return (
        "group mover id 1\nunfix motion\n" + leg((DEPTH, 0, 0), 20) + leg((-DEPTH - gap, 0, 0), 50)
    )


def forces(folder: Path) -> np.ndarray:
    """Return the forces on grain 1 after it was stretched, by step [N]."""
    grain = table(folder).query("id == 1").sort_values("step")
    return grain[["fx", "fy", "fz"]].to_numpy()[70:]


def fold(angle: float) -> np.ndarray:
    """Return a plate in x = 0 that turns towards the grains behind the edge y = 0."""
    turn, half = np.radians(angle), SIDE / 2
    rows = [(0, -half), (0, 0), (-half * np.sin(turn), half * np.cos(turn))]
    low, high = ([(x, y, z) for x, y in rows] for z in (-half, half))
    return np.array(
        [
            t
            for k in (0, 1)
            for t in ((low[k], low[k + 1], high[k + 1]), (low[k], high[k + 1], high[k]))
        ]
    )


def block() -> np.ndarray:
    """Return three faces of a cube; their common corner, at the origin, points to the grains."""
    face = SIDE / 2 * np.array([[0, 0, 0], [0, -1, 0], [0, -1, -1], [0, 0, -1]])
    across = face[:, [1, 0, 2]] * [-1, 1, 1], face[:, [1, 2, 0]] * [-1, 1, 1]
    return np.concatenate([corners[[[0, 1, 2], [0, 2, 3]]] for corners in (face, *across)])


def constant_force(law: str, folder: Path, mesh: np.ndarray, start: tuple, moves: str) -> None:
    """Check that a stretched contact keeps its force during motions along the surface.

    1e-4, because corners in a mesh file have seven digits, and LIGGGHTS extends triangles by 1e-8 m.
    """
    gap = held_gap(law)
    bodies = [sphere(-RADIUS, start[0], 0, z=start[1])]
    run(law, folder, bodies, pressed_and_stretched(gap) + moves, mesh=mesh, timestep=STEP)
    force = np.linalg.norm(forces(folder), axis=1)
    assert force[0] > 0
    assert force == pytest.approx(force[0], rel=1e-4)


@pytest.mark.parametrize("law", STRETCHED)
@pytest.mark.parametrize("angle", [0, 20, -20, -100])
def test_a_stretched_contact_moves_over_a_fold(law, angle, tmp_path):
    turn, travel = np.radians(angle), 0.4 * RADIUS
    foot = -(RADIUS + held_gap(law)) * np.tan(max(0, turn) / 2)
    moves = leg((0, travel, 0))
    if angle < 0:
        moves += turned((0, 0, -1), -angle)
    moves += leg((-travel * np.sin(turn), travel * np.cos(turn), 0))
    constant_force(law, tmp_path, fold(angle), (foot - travel, 0), moves)


@pytest.mark.parametrize("law", STRETCHED)
def test_a_stretched_contact_moves_over_a_corner(law, tmp_path):
    """From a face over the corner of three faces, to the middle between them."""
    travel = 0.4 * RADIUS
    moves = leg((0, travel, travel)) + turned((0, 1, -1), 54)
    constant_force(law, tmp_path, block(), (-travel, -travel), moves)


GEOMETRIES = {
    "pair": ([sphere(-3e-6 - 2 * RADIUS, 0, 0), sphere(-3e-6, 0, 0)], {}),
    "plane": ([sphere(-RADIUS, 0, 0)], {}),
    "mesh": ([sphere(-RADIUS, 0, 0)], {"mesh": PLATE}),
}


@pytest.mark.parametrize("geometry", GEOMETRIES)
def test_a_stretched_contact_outlives_other_grains(geometry, tmp_path):
    """Deleting and creating other grains changes the atom IDs between runs."""
    bodies, variables = GEOMETRIES[geometry]
    others = [sphere(-2e-5, (k - 1.5) * 3 * RADIUS, 0) for k in range(4)]
    stretched = pressed_and_stretched(held_gap("thornton_ning_1998") / 2)
    commands = (
        "region whole block INF INF INF INF INF INF\n"
        + stretched.replace("mover id 1", "mover id 5")
        + "run 10\ngroup gone id 1 3\ndelete_atoms group gone compress yes\nrun 10\n"
        "create_atoms 1 single -3e-5 2e-5 0 units box\n"
        f"set region whole diameter {2 * RADIUS:.17g} density 1350\nrun 10\n"
    )
    law = "thornton_ning_1998"
    run(law, tmp_path, others + bodies, commands, timestep=STEP, **variables)
    trajectory = table(tmp_path).query("step >= 70")
    force = trajectory.groupby("step")["fx"].max().to_numpy()
    assert len(force) == 31
    assert force == pytest.approx(force[0], rel=1e-12)
    assert force[0] > 0
