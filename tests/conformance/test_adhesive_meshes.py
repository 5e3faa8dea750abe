# SPDX-License-Identifier: GPL-2.0-or-later
"""Adhesive contacts without overlap at meshes: folds, edges, corners and moving plates."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from adhesive_grains import (
    DENSITY,
    MASS,
    PLATE,
    RADIUS,
    SIDE,
    STRETCHED,
    energy_terms,
    law_of,
    run,
    sphere,
    table,
)

STEP = 1e-4 * RADIUS  # time step of a motion at 1 m/s [s]
DEPTH = 0.002 * RADIUS


def held_gap(law: str) -> float:
    """Return 0.7 times the gap at which a contact breaks after an overlap of `DEPTH` [m]."""
    model = law_of(law)
    path = np.linspace(DEPTH, -model.pull_off_distance(RADIUS), 10001)
    contact_radius = model.follow(RADIUS, path, model.State())["contact_radius"]
    return -0.7 * path[np.flatnonzero(contact_radius)[-1]]


def leg(displacement: tuple[float, float, float], steps: int = 50) -> str:
    """Return lines that move grain 1 by a displacement [m]."""
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
    """Return a plate in x = 0 whose half y > 0 is bent by `angle` [degrees] towards the grains."""
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

    The relative tolerance is 1e-4. Corners in a mesh file have 7 digits, and LIGGGHTS extends
    triangles by 1e-8 m.
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
    """The grain moves from one face to the common corner of three faces, and turns there until it
    is equally far from all three.
    """
    travel = 0.4 * RADIUS
    moves = leg((0, travel, travel)) + turned((0, 1, -1), 54)
    constant_force(law, tmp_path, block(), (-travel, -travel), moves)


LAW = "thornton_ning_1998"  # its force depends on the history
HALF = 6e-5  # half the side of the box [m]
GEOMETRIES = {
    "pair": ([sphere(-3e-6 - 2 * RADIUS, 0, 0), sphere(-3e-6, 0, 0)], {}),
    "plane": ([sphere(-RADIUS, 0, 0)], {}),
    "mesh": ([sphere(-RADIUS, 0, 0)], {"mesh": PLATE}),
}
AT_THE_SIDE = {
    "pair": ([sphere(HALF - 1e-7, 0, 0), sphere(-HALF - 1e-7 + 2 * RADIUS, 0, 0)], {}),
    "plane": ([sphere(-RADIUS, HALF - 1e-7, 0)], {}),
    "mesh": ([sphere(-RADIUS, HALF - 1e-7, 0)], {"mesh": PLATE * 2 * HALF / SIDE}),
}


@pytest.mark.parametrize("geometry", GEOMETRIES)
def test_a_stretched_contact_outlives_other_grains(geometry, tmp_path):
    """A stretched contact keeps its force when other grains are deleted and created between runs.

    Both change the atom IDs.
    """
    bodies, variables = GEOMETRIES[geometry]
    others = [sphere(-2e-5, (k - 1.5) * 3 * RADIUS, 0) for k in range(4)]
    commands = (
        "region whole block INF INF INF INF INF INF\n"
        + pressed_and_stretched(held_gap(LAW) / 2).replace("mover id 1", "mover id 5")
        + "run 10\ngroup gone id 1 3\ndelete_atoms group gone compress yes\nrun 10\n"
        "create_atoms 1 single -3e-5 2e-5 0 units box\n"
        f"set region whole diameter {2 * RADIUS:.17g} density 1350\nrun 10\n"
    )
    run(LAW, tmp_path, others + bodies, commands, timestep=STEP, **variables)
    force = table(tmp_path).query("step >= 70").groupby("step")["fx"].max().to_numpy()
    assert len(force) == 31
    assert force == pytest.approx(force[0], rel=1e-12)
    assert force[0] > 0


@pytest.mark.parametrize("geometry", GEOMETRIES)
def test_a_stretched_grain_can_be_deleted(geometry, tmp_path):
    """The history of a stretched contact ends when its grain is deleted.

    A new grain at the same place overlaps nothing, so it has no force.
    """
    bodies, variables = GEOMETRIES[geometry]
    spot = np.array([-RADIUS if geometry != "pair" else -3e-6 - 2 * RADIUS, 0, 0])
    spot[0] -= held_gap(LAW) / 2
    place = " ".join(f"{x:.17g}" for x in spot)
    commands = (
        "region whole block INF INF INF INF INF INF\n"
        + pressed_and_stretched(held_gap(LAW) / 2)
        + "delete_atoms group mover compress yes\nrun 10\n"
        f"create_atoms 1 single {place} units box\n"
        f"set region whole diameter {2 * RADIUS:.17g} density 1350\nrun 10\n"
    )
    run(LAW, tmp_path, [*bodies, sphere(-2e-5, 2e-5, 0)], commands, timestep=STEP, **variables)
    after = table(tmp_path).query("step > 70")
    assert len(after[after["step"] == 90]) == len(bodies) + 1
    assert (after["fx"] == 0).all()


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("geometry", AT_THE_SIDE)
def test_a_stretched_contact_crosses_a_periodic_side(geometry, ranks, tmp_path):
    """A stretched contact keeps its force, to round-off, when its grain crosses a periodic side.

    The same holds for a run that continues from a restart file written before the crossing.
    """
    bodies, variables = AT_THE_SIDE[geometry]
    axis = "x" if geometry == "pair" else "y"
    variables = {
        **variables,
        "timestep": STEP,
        "grid": "2 1 1" if axis == "x" else f"1 {ranks} 1",
        "boundary": "p p p" if axis == "x" else "f p p",
    }
    if ranks == 1:
        variables["grid"] = "1 1 1"
    across = "fix across all move linear " + ("50 0 0" if axis == "x" else "0 50 0")
    across += " units box\nrun 20\n"
    file = tmp_path.resolve() / "middle.restart"
    commands = pressed_and_stretched(held_gap(LAW) / 2) + f"write_restart {file}\n" + across
    run(LAW, tmp_path / "whole", bodies, commands, ranks, **variables)
    run(LAW, tmp_path / "rest", bodies, "unfix motion\n" + across, ranks, restart=file, **variables)
    force = forces(tmp_path / "whole")
    assert np.linalg.norm(force[0]) > 0
    assert force == pytest.approx(np.broadcast_to(force[0], force.shape), rel=1e-9)
    rest = table(tmp_path / "rest").query("id == 1").sort_values("step")
    assert rest[axis].iloc[0] > 0 > rest[axis].iloc[-1]
    assert rest[["fx", "fy", "fz"]].to_numpy() == pytest.approx(force[-len(rest) :], rel=1e-12)


def strips(count: int) -> np.ndarray:
    """Return the plate in x = 0, cut into strips along z."""
    y = np.linspace(-SIDE / 2, SIDE / 2, count + 1)
    low, high = (np.stack([0 * y, y, z + 0 * y], axis=1) for z in (-SIDE / 2, SIDE / 2))
    return np.concatenate(
        [
            np.stack([low[:-1], low[1:], high[1:]], axis=1),
            np.stack([low[:-1], high[1:], high[:-1]], axis=1),
        ]
    )


@pytest.mark.parametrize("law", STRETCHED)
@pytest.mark.parametrize("ranks", [1, 2])
def test_a_grain_that_sticks_to_triangles_moves_as_on_a_plane(law, ranks, tmp_path):
    """A grain that hits a mesh and sticks to it moves as on a primitive plane.

    The impact is oblique, with friction and below the sticking speed; the grain crosses edges
    and a border between ranks. Each column agrees to 1e-9 of its largest value, because sums have
    another order.
    """
    bodies = [sphere(-RADIUS - 1e-9, -8e-7, 0.3) + "set atom 1 vy 12\n"]
    timestep = 0.5 * float(law_of(law).recommended_timestep(RADIUS, MASS, 0.3))
    variables = {"timestep": timestep, "every": 20, "tangential": "history"}
    commands = f"run {int(1.5e-7 / timestep)}"
    plane = run(law, tmp_path / "plane", bodies, commands, **variables)
    variables |= {"mesh": strips(300), "grid": f"1 {ranks} 1"}
    mesh = run(law, tmp_path / "mesh", bodies, commands, ranks, **variables)
    plane, mesh = (table(tmp_path / name).sort_values("step") for name in ("plane", "mesh"))
    assert plane["y"].iloc[-1] > 8e-7
    assert (plane["x"] < -RADIUS).mean() > 0.1, "the contact is not stretched"
    for column in ("x", "y", "vx", "vy", "fx", "fy"):
        scale = plane[column].abs().max()
        assert mesh[column].to_numpy() == pytest.approx(plane[column], abs=1e-9 * scale)


@pytest.mark.parametrize("law", STRETCHED)
def test_a_plate_pulls_on_a_grain(law, tmp_path):
    """The plate moves away from a fixed grain; the force follows the law until the contact
    breaks.
    """
    commands = (
        "group mover id 1\nunfix motion\n"
        + leg((DEPTH, 0, 0), 40)
        + "fix away all move/mesh mesh plate linear 0.4 0 0\n"
        + leg((0, 0, 0), 200)
    )
    run(law, tmp_path, [sphere(-RADIUS, 0, 0)], commands, mesh=PLATE, timestep=STEP)
    grain = table(tmp_path).sort_values("step")
    plate = 0.4 * STEP * np.maximum(0, grain["step"].to_numpy() - 40)
    overlap = RADIUS + grain["x"].to_numpy() - plate
    model = law_of(law)
    expected = model.follow(RADIUS, overlap, model.State())["force"]
    assert expected[-1] == 0 > expected.min()
    assert -grain["fx"].to_numpy() == pytest.approx(expected, abs=1e-9 * np.abs(expected).max())


def test_a_moving_plate_takes_light_grains_along(tmp_path):
    """A moving adhesive plate carries a light grain along, and separates from a heavy one.

    The plate starts at the speed at which a grain of 1350 kg/m^3 just separates from it. In the
    frame of the plate, a grain with 0.8 times this density has too little energy to break the
    contact; one with 1.25 times this density has enough. The tolerances are 1e-3 of the speed and
    2e-3 of the energy, because the force jumps where the contact breaks.
    """
    law = law_of("jkr")
    overlap = np.linspace(-law.pull_off_distance(RADIUS), 1e-8, 100_001)
    path = law.follow(RADIUS, overlap[::-1], law.State())["force"][::-1]
    rest = int(np.flatnonzero(path < 0)[-1])  # overlap of zero force
    work = -np.sum(path[:rest]) * (overlap[1] - overlap[0])
    speed = np.sqrt(2 * work / MASS)
    bodies = [
        sphere(overlap[rest] - RADIUS, y, 0, density=share * DENSITY)
        for y, share in ((-2e-5, 0.8), (2e-5, 1.25))
    ]
    timestep = 0.3 * float(law.recommended_timestep(RADIUS, 0.8 * MASS, speed))
    steps = int(2e-7 / timestep)
    motion = f"fix away all move/mesh mesh plate linear {speed:.17g} 0 0"
    variables = {"mesh": PLATE, "motion": motion, "timestep": timestep}
    options = "energy_ledger on"
    terms = energy_terms("jkr", tmp_path, bodies, steps, options=options, **variables)
    light, heavy = table(tmp_path).query(f"step == {steps}").sort_values("id").to_dict("records")
    plate = speed * timestep * steps
    assert plate > 10 * law.pull_off_distance(RADIUS)
    assert RADIUS - (plate - light["x"]) > -law.pull_off_distance(RADIUS)
    assert RADIUS - (plate - heavy["x"]) < -law.pull_off_distance(RADIUS)
    assert heavy["vx"] == pytest.approx(speed * (1 - np.sqrt(1 - 1 / 1.25)), abs=1e-3 * speed)
    energy = terms["wallwork"].iloc[-1]
    assert terms["drift"].abs().max() < 2e-3 * energy


def test_a_box_of_triangles_is_a_box_of_planes(tmp_path):
    """A box of triangles on two ranks gives the same forces as a box of six primitive planes.

    Adhesive grains hit faces, edges and corners of the box from inside, below and above the
    sticking speed. Each column agrees to 1e-6 of its largest value: sums have another order, and
    this round-off grows at each impact.
    """
    wall, random = 5.2e-5, np.random.default_rng(3)
    bodies = []
    for k, side in enumerate(s for s in np.ndindex(3, 3, 3) if s != (1, 1, 1)):
        side = np.array(side) - 1
        place = side * (wall - RADIUS - 1e-9)
        velocity = np.where(side, side * random.uniform(0.05, 1.2, 3), random.uniform(-5, 5, 3))
        bodies.append(
            sphere(place[0], place[1], velocity[0], z=place[2])
            + f"set atom {k + 1} vy {velocity[1]:.17g}\nset atom {k + 1} vz {velocity[2]:.17g}\n"
        )
    corners = wall * np.array([[1, -1, -1], [1, 1, -1], [1, 1, 1], [1, -1, 1]])
    face = corners[[[0, 1, 2], [0, 2, 3]]]
    faces = [np.roll(side, k, axis=2) for k in range(3) for side in (face, face * [-1, 1, 1])]
    line = f"fix w@ all wall/gran model {LAW} tangential history primitive type 2 "
    ends = [f"{axis}plane {end}" for axis in "xyz" for end in (-wall, wall)]
    planes = "\n".join(line.replace("@", str(k)) + end for k, end in enumerate(ends[1:]))
    timestep = 0.4 * float(law_of(LAW).recommended_timestep(RADIUS, MASS, 1.0))
    variables = {"timestep": timestep, "tangential": "history", "every": 200}
    commands = f"run {int(1.5e-7 / timestep)}"
    first = f"primitive type 2 {ends[0]}"
    run(LAW, tmp_path / "planes", bodies, commands, motion=planes, wall=first, **variables)
    mesh = np.concatenate(faces)
    run(LAW, tmp_path / "mesh", bodies, commands, 2, mesh=mesh, grid="2 1 1", **variables)
    planes, mesh = (
        table(tmp_path / name).sort_values(["step", "id"]) for name in ("planes", "mesh")
    )
    gaps = wall - RADIUS - planes[["x", "y", "z"]].abs()
    assert ((gaps > 0) & (planes[["fx", "fy", "fz"]] != 0).to_numpy()).any(axis=1).mean() > 0.05
    for column in ("x", "y", "z", "vx", "vy", "vz", "fx", "fy", "fz"):
        scale = planes[column].abs().max()
        assert mesh[column].to_numpy() == pytest.approx(planes[column], abs=1e-6 * scale)
