# SPDX-License-Identifier: GPL-2.0-or-later
"""What every law's model must keep in the engine: history, symmetry, restarts, ranks."""

from __future__ import annotations

import re
from functools import cache
from math import ceil
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from scenes import scene

from plastigran import laws
from plastigran.engine.dumps import read_dump
from plastigran.engine.process import run_deck
from plastigran.experiments.collision import force_overlap_loop, measure
from plastigran.materials import RIGID

GEOMETRIES = ("pair", "plane", "mesh")
# Of the dissipative constant [s]: for spheres of 10 mm as much restitution as the paper's have, and
# for less of it.
SMALL, LARGE = 3e-6, 1e-4


def turned_pair_forces(law: str, folder: Path) -> np.ndarray:
    """Force on atom 1 along the line of centres while the pair turns rigidly."""
    bodies = scene(law) if law in laws.LAWS else scene("hertz")
    bodies.run("rotating_pair", folder, law=law)
    table = read_dump(folder / "trajectory.dump")
    table = table[table["step"] > 1100]
    one, two = (table[table["id"] == k] for k in (1, 2))
    line = one[["x", "y", "z"]].to_numpy() - two[["x", "y", "z"]].to_numpy()
    line /= np.linalg.norm(line, axis=1)[:, None]
    assert line[0, 0] > 0.99 and line[-1, 0] < -0.99, "the pair did not turn"
    return np.einsum("ij,ij->i", line, one[["fx", "fy", "fz"]].to_numpy())


def test_pair_flip(engine_law, tmp_path):
    """A held, unloading contact turned half around keeps its force through sorts and rebuilds.

    1e-7: the overlap is a difference of positions 2000 times larger than itself, and the unloading
    curve is steep.
    """
    force = turned_pair_forces(engine_law, tmp_path)
    assert force[0] > 0
    assert np.abs(force / force[0] - 1).max() < 1e-7


def test_pair_flip_catches_a_law_that_flips(tmp_path):
    """The engine's thornton_ning marks scalars as vectors: the test above must see that."""
    force = turned_pair_forces("thornton_ning", tmp_path)
    assert np.abs(force / force[0] - 1).max() > 0.1


@pytest.mark.parametrize("rebuild", ["no", "yes"])
@pytest.mark.parametrize("geometry", GEOMETRIES)
def test_second_touch_is_a_virgin_contact(engine_law, geometry, rebuild, tmp_path):
    """Both impacts of a bouncing sphere have the restitution of their own speed.

    A contact that remembered the first would return the second, slower one elastically (1 instead
    of 0.8 or less). 0.02: gravity of 10/s times the speed, over a millisecond of contact.
    """
    bodies = scene(engine_law, dissipative_constant=LARGE)
    body = bodies.material.body()
    law = bodies.law(laws.combine(body, body if geometry == "pair" else RIGID))
    # A held sphere is half of an equal pair: R/2, and as heavy as the falling one alone.
    radius_eff = 0.05 if geometry == "pair" else 0.1
    mass = bodies.mass()

    def restitution(speed: float) -> float:
        return law.central_impact(radius_eff, mass, speed).coefficient_of_restitution

    first = next(speed for speed in (0.1, 0.3, 1.0) if restitution(speed) < 0.8)
    log = bodies.run("bounce", tmp_path, geometry=geometry, rebuild=rebuild, speed=first)
    builds = int(re.search(r"Neighbor list builds = (\d+)", log)[1])
    assert (builds > 1000) if rebuild == "yes" else (builds == 0)

    table = read_dump(tmp_path / "trajectory.dump")
    speed, force = table["vx"].to_numpy(), table["fx"].to_numpy()
    weight = mass * 10 * first
    touching = force + weight > 1e-6 * weight
    edges = np.flatnonzero(np.diff(touching.astype(int)))
    assert len(edges) >= 4, "fewer than two impacts"
    speeds_in = []
    for start, end in (edges[0:2], edges[2:4]):
        speed_in, speed_out = -speed[start], speed[end + 1]
        assert speed_out / speed_in == pytest.approx(restitution(speed_in), abs=0.02)
        speeds_in.append(speed_in)
    assert speeds_in[1] < 0.9 * speeds_in[0]


@pytest.fixture(scope="session")
def course(tmp_path_factory):
    """When a law's impact at 0.1 m/s turns and ends: measured once a law."""

    @cache
    def collide(law: str):
        return scene(law).impact(0.1).run(tmp_path_factory.mktemp("course"))

    return collide


RESTARTS = [(geometry, moment, 1) for geometry in GEOMETRIES for moment in ("loading", "unloading")]
RESTARTS += [("pair", "unloading", 2), ("plane", "loading", 2), ("mesh", "unloading", 2)]


@pytest.mark.parametrize(("geometry", "moment", "ranks"), RESTARTS)
def test_restart_in_mid_contact(engine_law, geometry, moment, ranks, course, tmp_path):
    """The second half from the file is the second half of the whole run, to every digit written.

    A run begins with the forces at the speeds of that moment, the one before ended with those at
    the speeds of half a step earlier: where they matter, the first frame shows other forces.
    """
    bodies = scene(engine_law)
    loading_time, contact_time = course(engine_law).loading_time, course(engine_law).contact_time
    if moment == "loading":
        time = 0.5 * loading_time
    else:
        time = loading_time + 0.4 * (contact_time - loading_time)
    before = round(time / 8e-6)
    case = {"geometry": geometry, "after": 160}
    bodies.run("restart_write", tmp_path / "whole", ranks=ranks, before=before, **case)
    restart = (tmp_path / "whole" / "middle.restart").resolve()
    bodies.run("restart_read", tmp_path / "rest", ranks=ranks, restart=restart, **case)
    whole = read_dump(tmp_path / "whole" / "trajectory.dump")
    rest = read_dump(tmp_path / "rest" / "trajectory.dump")
    peak = whole["fx"].abs().max()
    whole = whole[whole["step"] >= before].drop_duplicates(["step", "id"]).reset_index(drop=True)
    force = whole["fx"].abs().to_numpy()
    assert 0.1 * peak < force[0] < 0.95 * peak
    assert (force.max() > 1.05 * force[0]) == (moment == "loading")
    if laws.LAWS[engine_law].rate_dependent:
        rest, whole = (table[table["step"] > before] for table in (rest, whole))
    assert len(rest) == len(whole)
    assert (rest.to_numpy() == whole.to_numpy()).all()


def test_ranks_share_and_hand_over_a_contact(engine_law, course, tmp_path):
    """1, 2 and 4 ranks, the contact on one border and crossing another: the same collision.

    1e-9: positions enter sums in another order on the other side of a border.
    """
    bodies, found = scene(engine_law), {}
    steps = ceil(1.3 * course(engine_law).contact_time / 4e-6)
    for ranks, grid in ((1, "1 1"), (2, "2 1"), (2, "1 2"), (4, "2 2")):
        folder = tmp_path / grid.replace(" ", "x")
        log = bodies.run("ranks", folder, ranks=ranks, grid=grid, drift=bodies.drift, steps=steps)
        assert f"{grid.replace(' ', ' by ')} by 1 MPI processor grid" in log
        table = read_dump(folder / "trajectory.dump")
        x, y = (table.loc[table["fy"] != 0, axis] for axis in "xy")
        assert x.min() < -0.005 and x.max() > 0.005, "the contact did not cross x = 0"
        assert y.min() < 0 < y.max(), "the contact is not on y = 0"
        found[grid] = measure(table)
    one = found.pop("1 1")
    assert 0 < one.coefficient_of_restitution < 0.99
    for other in found.values():
        assert other.coefficient_of_restitution == pytest.approx(
            one.coefficient_of_restitution, rel=1e-9
        )
        assert other.force_max == pytest.approx(one.force_max, rel=1e-9)


def test_unequal_bodies_in_either_order(engine_law, tmp_path):
    """Unequal radii and materials, i and j swapped: the same to rounding, and the softer yields."""
    bodies = scene(engine_law, dissipative_constant=SMALL)
    loops, runs = [], []
    for swap in (0, 1):
        bodies.run("two_bodies", tmp_path / str(swap), swap=swap)
        table = read_dump(tmp_path / str(swap) / "trajectory.dump")
        loops.append(force_overlap_loop(table))
        runs.append(measure(table))
    assert len(loops[0]) == len(loops[1])
    # Mirrored sums round differently, 1e-16 of a position, 1e-12 of the overlap.
    scale = loops[0]["force"].max()
    assert loops[1]["force"].to_numpy() == pytest.approx(
        loops[0]["force"].to_numpy(), abs=1e-8 * scale
    )

    soft, hard = (
        laws.Body(7e10, 0.33, bodies.material.yield_strength),
        laws.Body(2.1e11, 0.28, 9e8),
    )
    law = bodies.law(laws.combine(soft, hard))
    masses = bodies.mass(0.01, 2700), bodies.mass(0.02, 7850)
    mass_eff = masses[0] * masses[1] / sum(masses)
    expected = law.central_impact(0.01 * 0.02 / 0.03, mass_eff, 0.2)
    assert expected.coefficient_of_restitution < 0.9, "the softer body does not yield"
    for found in runs:
        assert found.coefficient_of_restitution == pytest.approx(
            expected.coefficient_of_restitution, rel=1e-3
        )
        # Where the force of a rate-dependent law vanishes depends on the speed there, too, which
        # the engine knows of half a step ago.
        tolerance = 2e-2 if law.rate_dependent else 2e-3
        assert found.overlap_res == pytest.approx(expected.overlap_res, rel=tolerance)


def test_wall_is_a_huge_sphere(engine_law, tmp_path):
    """A sphere on one 3000 times larger of the same material as on a wall of that material.

    R* and m* differ by 3e-4, restitution by less; 1e-3 adds the time step's share.
    """
    bodies = scene(engine_law, dissipative_constant=SMALL)
    bodies.run("two_bodies_equal_material", tmp_path, ratio=3000)
    found = measure(tmp_path / "trajectory.dump")
    body = bodies.material.body()
    wall = bodies.law(laws.combine(body, body)).central_impact(0.01, bodies.mass(0.01), 0.2)
    assert found.coefficient_of_restitution == pytest.approx(
        wall.coefficient_of_restitution, rel=1e-3
    )
    assert found.force_max == pytest.approx(wall.force_max, rel=2e-3)


@pytest.fixture(scope="session")
def unyielding(tmp_path_factory):
    """Trajectory of an oblique impact of bodies without yield and viscosity."""

    @cache
    def collide(law: str, geometry: str):
        folder = tmp_path_factory.mktemp("unyielding")
        bodies = scene(law, dissipative_constant=1e-30)
        bodies.run("restart_write", folder, geometry=geometry, yield_strength=1e18)
        return read_dump(folder / "trajectory.dump").drop_duplicates(["step", "id"])

    return collide


def test_unyielding_model_is_elastic(engine_law, unyielding):
    """No yield and no viscosity: every step of an oblique impact of spheres as undamped stock
    hertz; of bodies with another elastic contact its force.

    1e-10 after 200 steps: the two write 4/3 E* sqrt(R* d) d in different orders.
    """
    for geometry in GEOMETRIES:
        ours = unyielding(engine_law, geometry)
        if not scene(engine_law).hertzian:
            has_the_elastic_force(engine_law, ours, geometry)
            continue
        stock = unyielding("hertz", geometry)
        for column in stock.columns:
            expected = stock[column].to_numpy()
            assert ours[column].to_numpy() == pytest.approx(
                expected, rel=1e-10, abs=1e-10 * np.abs(expected).max()
            ), column


def has_the_elastic_force(law: str, table: pd.DataFrame, geometry: str) -> None:
    """The law's elastic force at every overlap.

    1e-11: the overlap is a difference of positions some 1000 times larger.
    """
    bodies = scene(law)
    first, second = (table[table["id"] == k][["x", "y"]].to_numpy() for k in (1, 2))
    force = table.loc[table["id"] == 1, ["fx", "fy"]].to_numpy()
    if geometry == "pair":
        body = bodies.material.body()
        line, pair, radius_eff, reach = first - second, laws.combine(body, body), 0.05, 0.2
    else:
        line, pair, radius_eff, reach = first * [1, 0], bodies.wall(), 0.1, 0.1
    distance = np.linalg.norm(line, axis=1)
    overlap = reach - distance
    touching = overlap > 0.1 * overlap.max()
    normal = np.einsum("ij,ij->i", line, force)[touching] / distance[touching]
    expected = bodies.elastic_force(pair, radius_eff, overlap[touching])
    assert normal == pytest.approx(expected, rel=1e-11)


@pytest.mark.parametrize("tangential", ["no_history", "history"])
def test_sliding_friction(engine_law, tangential, tmp_path):
    """A sphere that hits the plane obliquely and slides through leaves with mu times the normal
    impulse less tangential momentum: d(vy) = -mu (1 + e) v. 2e-3: the first instants, before the
    tangential force reaches mu F."""
    table = slide(engine_law, tangential, "off", tmp_path)
    normal = table["vx"].iloc[-1] - table["vx"].iloc[0]
    along = table["vy"].iloc[-1] - table["vy"].iloc[0]
    assert along == pytest.approx(-0.3 * normal, rel=2e-3)


def test_tangential_stiffness_is_the_laws(engine_law, tmp_path):
    """The tangential spring takes 8 G* a with the law's own contact radius, beyond yield too; of a
    cylinder pi E* L/(2 ln(2 D/a) + 1/(1 - nu)).

    A slow creep along the plane (10 um/s) never slides: the spring force is k_t times the path so
    far. 1e-3: the path begins within a step of the touch.
    """
    bodies = scene(engine_law)
    bodies.run("creep", tmp_path, tangential="history")
    table = read_dump(tmp_path / "trajectory.dump")
    law = bodies.law(bodies.wall())
    radius = law.follow(0.1, (0.1 - table["x"]).to_numpy(), law.State())["contact_radius"]
    slip = table["y"].to_numpy() - table["y"].iloc[0]
    middle = (np.abs(table["fx"]) > 0.5 * np.abs(table["fx"]).max()).to_numpy()
    assert radius[middle].max() > 2 * bodies.yield_contact_radius()
    expected = -bodies.tangential_stiffness(radius[middle]) * slip[middle]
    assert table["fy"].to_numpy()[middle] == pytest.approx(expected, rel=1e-3)


@pytest.mark.parametrize("damping", ["off", "on"])
def test_friction_without_history_is_critically_damped(engine_law, damping, tmp_path):
    """Creep far below sliding draws 2 sqrt(k_t m*) times its speed, with or without the dashpot."""
    bodies = scene(engine_law)
    bodies.run("creep", tmp_path, tangential="no_history", damping=damping)
    table = read_dump(tmp_path / "trajectory.dump")
    law = bodies.law(bodies.wall())
    radius = law.follow(0.1, (0.1 - table["x"]).to_numpy(), law.State())["contact_radius"]
    middle = (np.abs(table["fx"]) > 0.5 * np.abs(table["fx"]).max()).to_numpy()
    stiffness = bodies.tangential_stiffness(radius[middle])
    speed = table["vy"].to_numpy()[middle]
    expected = -2 * np.sqrt(stiffness * table["mass"].to_numpy()[middle]) * speed
    assert table["fy"].to_numpy()[middle] == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize("rolling", ["cdt", "epsd2"])
def test_rolling_friction_takes_the_models_force(engine_law, rolling, tmp_path):
    """The rolling torque of cdt is mu_r F R* against the spin; epsd2's is bounded by it."""
    table = slide(engine_law, "history", rolling, tmp_path, spin=-50.0)
    plain = slide(engine_law, "history", "off", tmp_path / "plain", spin=-50.0)
    inertia = scene(engine_law).inertia * table["mass"] * table["radius"] ** 2
    extra = (table["omegaz"] - plain["omegaz"]) * inertia
    impulse = (table["vx"].iloc[-1] - table["vx"].iloc[0]) * table["mass"].iloc[0]
    bound = 0.1 * impulse * table["radius"].iloc[0]
    assert extra.iloc[-1] == pytest.approx(bound, rel=1e-2 if rolling == "cdt" else 0.2)


def slide(law: str, tangential: str, rolling: str, folder: Path, spin: float = 0.0):
    scene(law).run("slide", folder, tangential=tangential, rolling=rolling, spin=spin)
    return read_dump(folder / "trajectory.dump")


def test_timestep_warning(engine_law, tmp_path):
    """Too long a step draws a warning with the recommended one; the recommended step none."""
    model = scene(engine_law).impact(0.1)
    recommended, deck = model.timestep, f"collision/{model.geometry}.in"
    log = run_deck(deck, model.variables() | {"timestep": 3 * recommended}, tmp_path / "long")
    said = re.search(r"time step .* is too long .* Recommended: timestep (\S+)", log)
    assert said and float(said[1]) == pytest.approx(recommended, rel=1e-3)
    log = run_deck(deck, model.variables() | {"timestep": 0.999 * recommended}, tmp_path / "good")
    assert "too long" not in log
