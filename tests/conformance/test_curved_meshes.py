# SPDX-License-Identifier: GPL-2.0-or-later
"""A sphere has one contact with a smooth surface of triangles; its history moves across edges.

Corners in a mesh file have seven digits. The round-off of a corner is about 1e-8 m, which is 1e-4
of an overlap.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import stl
import surfaces
from attrs import frozen

from plastigran.engine.dumps import read_dump
from plastigran.engine.log import read_thermo
from plastigran.engine.process import EngineStopped, run_deck

DECKS = Path(__file__).parent / "decks"
LINE = "fix wall all wall/gran model ${law} tangential ${tangential} rolling_friction ${rolling} "
CYLINDER = LINE + "primitive type 2 ycylinder 0.3 0 0 energy_ledger on"
RADIUS = 0.1
# A soft sphere rolls across the bottom of a pipe of three times its radius. Seen from the axis of
# the pipe, the contact covers 2.7 degrees.
ROLLING = {"z": 1e-9 - 0.2, "vx": 5, "youngs_modulus": 7e9, "yield_strength": 2e7}


@frozen
class Outcome:
    """Results of a run: energy terms at each log line, and motion of the sphere at each frame."""

    ledger: pd.DataFrame
    sphere: pd.DataFrame

    def drift(self) -> float:
        """Return the balance error divided by the largest kinetic energy."""
        return self.ledger["drift"].abs().max() / self.ledger["kinetic"].max()

    def forces(self) -> np.ndarray:
        """Return the forces on the sphere by frame [N]."""
        return self.sphere[["fx", "fy", "fz"]].to_numpy()


def mesh(folder: Path, triangles: np.ndarray, options: str = "") -> str:
    """Return the lines of a deck for a wall of triangles."""
    stl.write(folder / "surface.stl", triangles)
    return (
        f"fix surface all mesh/surface file {folder}/surface.stl type 2\n"
        f"{LINE} mesh n_meshes 1 meshes surface energy_ledger on {options}"
    )


def let_go(steps: int) -> str:
    return f"fix integrate all nve/sphere\nrun {steps}"


def moved(velocity: tuple[float, float, float], steps: int = 100) -> str:
    """Return the lines that move the sphere on a given path."""
    return (
        f"fix motion all move linear {'{:.17g} {:.17g} {:.17g}'.format(*velocity)} units box\n"
        + (f"run {steps}\nunfix motion\n")
    )


def run(folder: Path, wall: str, motion: str, ranks: int = 1, **variables) -> Outcome:
    """Run curved.in with these lines for the wall and for the motion of the sphere."""
    (folder / "wall.in").write_text(wall + "\n")
    (folder / "motion.in").write_text(motion + "\n")
    files = {name: folder / f"{name}.in" for name in ("wall", "motion")}
    run_deck(DECKS / "curved.in", {"decks": DECKS, **files, **variables}, folder, ranks=ranks)
    return Outcome(read_thermo(folder / "log.liggghts"), read_dump(folder / "trajectory.dump"))


def rolled(folder: Path, wall: str, steps: int = 5000, timestep: float = 1e-5, **variables):
    folder.mkdir(exist_ok=True)
    variables = {**ROLLING, "every": steps // 10, "timestep": timestep, **variables}
    return run(folder, wall, let_go(steps), **variables)


def in_a_pipe(folder: Path, facets: int, options: str = "", **variables) -> Outcome:
    folder.mkdir(exist_ok=True)
    pipe = surfaces.pipe(facets, 0.3, 0.6)
    return rolled(folder, mesh(folder, pipe, options), **variables)


@pytest.mark.parametrize("tangential", ["off", "history"])
def test_a_fine_pipe_is_a_cylinder(tangential, tmp_path):
    """A sphere rolls in a pipe of 720 facets as in a primitive cylinder.

    Each facet covers half a degree, so the sphere overlaps up to five facets at once. Energies
    agree to 1e-3 of the initial kinetic energy, because the corners of the pipe lie 1e-5 of its
    radius outside the cylinder. The balance error arises because the force on a facet turns between
    two steps.
    """
    pipe = in_a_pipe(tmp_path / "pipe", 720, tangential=tangential)
    cylinder = rolled(tmp_path / "cylinder", CYLINDER, tangential=tangential)
    start = cylinder.ledger["kinetic"].iloc[0]
    for entry in ("kinetic", "elastic", "plastic", "friction"):
        ours, exact = pipe.ledger[entry].iloc[-1], cylinder.ledger[entry].iloc[-1]
        assert ours == pytest.approx(exact, abs=1e-3 * start), entry
    places = [outcome.sphere[["x", "z"]].iloc[-1].to_numpy() for outcome in (pipe, cylinder)]
    assert places[0] == pytest.approx(places[1], abs=1e-3 * RADIUS)
    assert pipe.drift() < 2e-4


@pytest.mark.parametrize("facets", [36, 90, 180, 360])
def test_no_energy_is_made_in_a_pipe(facets, tmp_path):
    """A sphere that rolls over the facets of a pipe gains no energy.

    A quarter of the time step at least halves the balance error: the error arises because a force
    keeps its direction during a time step. With narrow facets, LIGGGHTS' own contacts create energy
    at any time step.
    """
    coarse = in_a_pipe(tmp_path / "coarse", facets, tangential="off")
    fine = in_a_pipe(tmp_path / "fine", facets, tangential="off", steps=20000, timestep=2.5e-6)
    assert coarse.drift() < 1e-4
    assert fine.drift() < 0.5 * coarse.drift()
    if facets == 360:
        engines = in_a_pipe(tmp_path / "engines", facets, "feature_angle 0", tangential="off")
        assert engines.drift() > 5e-4


TIMESTEP = 1e-5
PRESSED, HELD = 2e-4, 1.9e-4  # overlaps [m]


def pressed_and_held() -> list[str]:
    """Return the lines that compress the sphere until it has yielded, and unload it a little."""
    return [
        moved((0, 0, -PRESSED / (100 * TIMESTEP))),
        moved((0, 0, (PRESSED - HELD) / (100 * TIMESTEP))),
    ]


def over_a_fold(angle: float) -> tuple[float, str]:
    """Return lines that move a yielded sphere over a folded plate at constant overlap with the
    nearer side.

    Returns:
        Start of the sphere along x [m], and the lines of its motion. Each part has 100 steps:
        loading, unloading, motion to the fold, rotation about a fold that bends away, and motion
        behind the fold.
    """
    turn, pace = np.radians(angle), 0.02 / (100 * TIMESTEP)
    at_fold = -(RADIUS - HELD) * np.tan(max(0, turn) / 2)
    motions = [*pressed_and_held(), moved((pace, 0, 0))]
    if angle < 0:
        period = 100 * TIMESTEP * 360 / -angle
        motions += [
            f"fix motion all move rotate 0 0 0 0 1 0 {period!r} units box\nrun 100\nunfix motion\n"
        ]
    motions += [moved((pace * np.cos(turn), 0, pace * np.sin(turn)))]
    return at_fold - 0.02, "".join(motions)


def folded(folder: Path, angle: float, options: str = "", **variables) -> np.ndarray:
    """Return the forces on the sphere that moves over a fold, by step [N]."""
    x, motion = over_a_fold(angle)
    wall = mesh(folder, surfaces.folded_plate(angle, 0.3, pieces=3), options)
    place = {"x": x, "z": RADIUS, "every": 1}
    return run(folder, wall, motion, **{"tangential": "off", **place, **variables}).forces()


@pytest.mark.parametrize("angle", [0.2, 10, 25, -0.2, -10, -60, -120])
def test_a_dent_is_remembered_over_a_fold(angle, tmp_path):
    """A yielded contact keeps its history, and so its force, on its way over a fold of the mesh.

    This holds for folds towards the sphere up to the feature angle of 30 degrees, and for all folds
    away from the sphere.

    With LIGGGHTS' own contacts, the force is 3.3 times as large on the fold and 2.3 times behind
    it. Over an edge that bends away by 0.2 degrees, it is zero.
    """
    size = np.linalg.norm(folded(tmp_path, angle), axis=1)
    assert size[100] > 2 * size[200] > 0
    assert size[201:] == pytest.approx(size[200], rel=2e-3)


def test_a_spring_turns_with_the_surface(tmp_path):
    """A tangential spring that does not slip is stretched along and across the fold, and turns with
    the surface. Forces agree to 2e-3, because mesh corners with 7 digits change the overlap.
    """
    angle, x = 20, over_a_fold(20)[0]
    turn, pace = np.radians(angle), 0.02 / (100 * TIMESTEP)
    motions = [*pressed_and_held(), moved((pace, pace, 0), 90), moved((pace, 0, 0), 10)]
    motions += [moved((pace * np.cos(turn), 0, pace * np.sin(turn)), 80)]
    wall = mesh(tmp_path, surfaces.folded_plate(angle, 0.3))
    start = {"x": x, "z": RADIUS, "every": 10, "coefficient_of_friction": 1e6}
    forces = run(tmp_path, wall, "".join(motions), **start).forces()
    before, after = forces[29], forces[38]
    assert before[0] == pytest.approx(before[1], rel=1e-6)
    assert -before[0] > 100 * before[2] > 0
    assert after[1] == pytest.approx(before[1], rel=2e-3)
    assert after @ [np.cos(turn), 0, np.sin(turn)] == pytest.approx(2 * before[0], rel=2e-3)
    assert 0 < after @ [-np.sin(turn), 0, np.cos(turn)] < -0.01 * before[0]


def pressed_on(folder: Path, triangles: np.ndarray, place: tuple, options: str = "") -> np.ndarray:
    """Return the force on a sphere that moves to a place from one millimeter above it [N]."""
    motion = moved((0, 0, -1e-3 / (100 * TIMESTEP)))
    x, y, z = place
    start = {"x": x, "y": y, "z": z + 1e-3, "every": 100, "tangential": "off"}
    folder.mkdir(exist_ok=True)
    return run(folder, mesh(folder, triangles, options), motion, **start).forces()[-1]


def test_true_edges_keep_their_contacts(tmp_path):
    """A sphere has one contact with each side of an edge or corner that is not smooth.

    It has three contacts in a corner. In a groove, it has two contacts, or one if the feature angle
    exceeds the angle of the fold. At an edge that bends away, it has one contact.
    """
    depth = RADIUS - 1e-4
    plate = surfaces.folded_plate(0, 0.3)
    alone = pressed_on(tmp_path / "plate", plate, (-0.05, 0.03, depth))
    assert alone[:2] == pytest.approx(0, abs=1e-9 * alone[2])
    corner = pressed_on(tmp_path / "corner", surfaces.corner(0.3), (depth, depth, depth))
    assert corner == pytest.approx(np.full(3, alone[2]), rel=1e-9)

    groove, turn = surfaces.folded_plate(60, 0.3), np.radians(60)
    centre = (-depth * np.tan(turn / 2), 0.03, depth)
    both = pressed_on(tmp_path / "groove", groove, centre)
    expected = alone[2] * np.array([-np.sin(turn), 0, 1 + np.cos(turn)])
    assert both == pytest.approx(expected, rel=1e-3, abs=1e-9 * alone[2])
    single = pressed_on(tmp_path / "smooth", groove, centre, "feature_angle 90")
    assert np.linalg.norm(single) == pytest.approx(alone[2], rel=1e-3)

    edge = surfaces.folded_plate(-90, 0.3)
    beside = pressed_on(tmp_path / "beside", edge, (-0.001, 0.03, depth))
    assert beside == pytest.approx(alone, rel=1e-9)


@pytest.mark.parametrize("angle", [35, 40, 50])
@pytest.mark.parametrize("overlap", [0.01, 0.03, 0.08])
def test_a_groove_of_small_triangles_keeps_both_contacts(angle, overlap, tmp_path):
    """A sphere in a groove of small triangles has one contact with each side.

    Deep in the groove, it touches triangles of both sides at a common node, in nearly the same
    direction.
    """
    depth, turn = RADIUS * (1 - overlap), np.radians(angle)
    near = (0.05 * RADIUS, 0.15 * RADIUS, 0.3 * RADIUS)
    groove = surfaces.folded_plate(angle, 0.3, 12, near)
    alone = pressed_on(tmp_path / "plate", surfaces.folded_plate(0, 0.3), (-0.05, 0.03, depth))
    both = pressed_on(tmp_path / "groove", groove, (-depth * np.tan(turn / 2), 0.03, depth))
    expected = alone[2] * np.array([-np.sin(turn), 0, 1 + np.cos(turn)])
    assert both == pytest.approx(expected, rel=1e-3, abs=1e-3 * alone[2])


def test_two_triangles_with_one_between_out_of_reach_are_one_surface(tmp_path):
    """A sphere has one contact with two triangles of a shallow fold that share only a node.

    It does not touch the narrow triangle between them.
    """
    depth = RADIUS - 1e-4
    alone = pressed_on(tmp_path / "plate", surfaces.folded_plate(0, 0.3), (-0.05, 0.03, depth))
    foot = -depth * np.tan(np.radians(5))
    fold = pressed_on(tmp_path / "fold", surfaces.folded_plate(10, 0.3), (foot, 0.1495, depth))
    assert np.linalg.norm(fold) == pytest.approx(alone[2], rel=1e-3)
    assert "joins them" not in (tmp_path / "fold" / "log.liggghts").read_text()


def test_the_engines_list_of_contacts_has_the_one_force(tmp_path):
    """`compute wall/gran/local` has one row per overlapped triangle; one row has the force.

    The sphere has one contact with the smooth surface of these triangles.
    """
    groove, depth = surfaces.folded_plate(60, 0.3), RADIUS - 1e-4
    lines = (
        "compute contacts all wall/gran/local id force\n"
        f"dump contacts all local 1 {tmp_path}/contacts.dump"
        + "".join(f" c_contacts[{k}]" for k in range(1, 7))
        + "\nrun 0"
    )
    place = {
        "x": -depth * np.tan(np.radians(30)) - 1e-5,
        "y": 0.03,
        "z": depth,
        "tangential": "off",
    }
    wall = mesh(tmp_path, groove, "feature_angle 90")
    force = run(tmp_path, wall, lines, **place).forces()[-1]
    rows = read_dump(tmp_path / "contacts.dump").filter(like="contacts").to_numpy()[:, 3:]
    assert len(rows) > 1
    assert np.count_nonzero(np.abs(rows).max(axis=1)) == 1
    assert rows.sum(axis=0) == pytest.approx(force, rel=1e-5, abs=1e-5 * np.abs(force).max())


def test_triangles_that_share_neither_edge_nor_node_are_named(tmp_path):
    """A warning names a particle that touches triangles of a plate which share no edge or node.

    The left half of the plate consists of strips that end in the middle of edges of the right
    half. The sphere touches both halves, and its contact force is too large.
    """
    whole, halved, thirds = (surfaces.folded_plate(0, 0.3, pieces) for pieces in (1, 2, 3))
    sides = [np.mean(plate[:, :, 0], axis=1) for plate in (halved, thirds)]
    split = np.concatenate([halved[sides[0] < 0], thirds[sides[1] > 0]])
    place, seam = (-0.001, 0.03, RADIUS - 1e-4), "which share no edge or node"
    alone = pressed_on(tmp_path / "whole", whole, place)
    double = pressed_on(tmp_path / "split", split, place)
    assert double[2] > 1.5 * alone[2]
    assert seam not in (tmp_path / "whole" / "log.liggghts").read_text()
    log = (tmp_path / "split" / "log.liggghts").read_text()
    assert log.count(seam) == 1
    assert "fix wall/gran: particle 1 at (-0.001 0.03" in log


RESTING = {"x": 0.004, "y": 0.002, "z": 0.15, "g": 9.81, "timestep": 5e-5, "every": 1000}
RESTING |= {"youngs_modulus": 1e7, "yield_strength": 1e5, "coefficient_of_friction": 0.3}


def test_a_ball_that_leans_on_all_sides_is_named(tmp_path):
    """A warning names a sphere that rests on all sides of a cone, which one contact cannot hold.

    With a contact per facet, as the warning recommends, the sphere comes to rest without a warning.
    The balance error is below 1e-3 of the released potential energy.
    """
    wall, moving = mesh(tmp_path, surfaces.cone(36, 0.02, 0.3)), {}
    said = "of one smooth surface, in directions"
    for name, options in (("one", ""), ("each", "feature_angle 5")):
        folder = tmp_path / name
        folder.mkdir()
        ledger = run(folder, f"{wall} {options}", let_go(20_000), **RESTING).ledger
        came_in = ledger["gravity"].iloc[0] - ledger["gravity"].iloc[-1]
        moving[name] = ledger["kinetic"].iloc[-1] / came_in
        assert abs(ledger["drift"].iloc[-1]) < 1e-3 * came_in
        warned = (folder / "log.liggghts").read_text().count(said)
        assert warned == (name == "one")
    assert moving["each"] < 1e-3 < moving["one"]


# A sphere moves along the bottom of a bowl, slightly to one side.
THROWN = {"x": -0.03, "z": -0.1975, "vx": 4, "vy": 0.5, "vz": -0.7, "g": 9.81, "timestep": 2e-5}
SOFT = {"youngs_modulus": 7e8, "yield_strength": 1e7}


def in_a_bowl(folder: Path, motion: str, ranks: int = 1, **variables) -> Outcome:
    folder.mkdir(exist_ok=True)
    wall = mesh(folder, surfaces.bowl(24, 80, 0.3))
    return run(folder, wall, motion, ranks, **{**THROWN, **SOFT, "every": 100, **variables})


@pytest.mark.parametrize(("ranks", "grid", "rolling"), [(2, "2 1 1", "off"), (4, "2 2 1", "epsd2")])
def test_a_bowl_is_the_same_on_all_ranks_and_after_a_restart(ranks, grid, rolling, tmp_path):
    """A sphere in a bowl of triangles moves alike on several ranks and after a restart.

    It yields and rolls where borders between ranks meet. The restart file is written during
    contact. The last position and spin agree to 1e-9 of their largest value, because other ranks
    sum forces in another order.
    """
    motion = let_go(300) + f"\nwrite_restart {tmp_path}/middle.restart\nrun 500"
    alone = in_a_bowl(tmp_path / "alone", motion, rolling=rolling)
    assert alone.ledger["elastic"].iloc[3] > 0, "no contact at the restart"
    assert alone.ledger["plastic"].iloc[-1] > alone.ledger["plastic"].iloc[3] > 0
    assert alone.drift() < 1e-4
    shared = in_a_bowl(tmp_path / "shared", motion, ranks, grid=grid, rolling=rolling)
    going_on = {"begin": "restarted", "restart": tmp_path / "middle.restart"}
    half = in_a_bowl(tmp_path / "half", let_go(500), rolling=rolling, **going_on)
    columns = ["x", "y", "z", "omegax", "omegay", "omegaz"]
    last = alone.sphere[columns].iloc[-1].to_numpy()
    for other in (shared, half):
        there = other.sphere[columns].iloc[-1].to_numpy()
        assert there == pytest.approx(last, abs=1e-9 * np.abs(last).max())


def test_over_a_round_edge_no_energy_is_made(tmp_path):
    """A sphere that rolls off a table and down its side gains no energy at the edge.

    With a quarter of the time step, the balance error is less than 0.3 times as large.
    """
    edge = surfaces.folded_plate(-90, 0.3)
    start = {"x": -0.05, "z": RADIUS, "vx": 0.5, "g": 9.81, "youngs_modulus": 7e8}
    drifts = []
    for refine in (1, 4):
        folder = tmp_path / str(refine)
        folder.mkdir()
        steps = {"timestep": 1e-5 / refine, "every": 2000 * refine}
        off = run(folder, mesh(folder, edge), let_go(40000 * refine), **start, **steps)
        assert off.sphere["z"].iloc[-1] < 0 < off.sphere["x"].iloc[-1]
        drifts.append(off.drift())
    assert drifts[0] < 1e-4
    assert drifts[1] < 0.3 * drifts[0]


@pytest.mark.parametrize(
    ("options", "complaint"),
    [
        ("feature_angle 91", "feature_angle is 91; it must be from 0 to 90 degrees"),
        ("feature_angle steep", "Expected floating point parameter"),
        ("feature_angle", "feature_angle"),
    ],
)
def test_an_impossible_feature_angle_is_refused(options, complaint, tmp_path):
    wall = mesh(tmp_path, surfaces.folded_plate(0, 0.3), options)
    with pytest.raises(EngineStopped, match=complaint):
        run(tmp_path, wall, let_go(1), z=0.2)


def test_a_feature_angle_of_a_primitive_wall_is_refused(tmp_path):
    with pytest.raises(EngineStopped, match="feature_angle is supported only for mesh walls"):
        run(tmp_path, CYLINDER + " feature_angle 30", let_go(1))
