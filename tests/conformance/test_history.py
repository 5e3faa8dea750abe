# SPDX-License-Identifier: GPL-2.0-or-later
"""A contact of every law keeps its history when atoms are sorted, a run restarts, or the contact
crosses a border between ranks. The history is lost when the contact ends.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from math import ceil
from pathlib import Path

import numpy as np
import pytest
from scenes import GEOMETRIES, scene

from plastigran import laws
from plastigran.engine.dumps import read_dump
from plastigran.experiments.collision import measure
from plastigran.materials import RIGID

LARGE = 1e-4  # dissipative constant [s]; restitution is lower than with the 3e-5 s of `scene`


def turned_pair_forces(law: str, folder: Path) -> np.ndarray:
    """Return the force on atom 1 along the line of centers while the pair turns rigidly."""
    if law == "thornton_ning":
        scene("hertz").run("rotating_pair", folder, law=law)
    else:
        scene(law).run("rotating_pair", folder)
    table = read_dump(folder / "trajectory.dump")
    table = table[table["step"] > 1100]
    one, two = (table[table["id"] == k] for k in (1, 2))
    line = one[["x", "y", "z"]].to_numpy() - two[["x", "y", "z"]].to_numpy()
    line /= np.linalg.norm(line, axis=1)[:, None]
    assert line[0, 0] > 0.99 and line[-1, 0] < -0.99, "the pair did not turn"
    return np.einsum("ij,ij->i", line, one[["fx", "fy", "fz"]].to_numpy())


def test_pair_flip(history_law, tmp_path):
    """A contact turns by half a revolution during unloading. It keeps its force when atoms are
    sorted and neighbor lists are rebuilt.

    The relative tolerance is 1e-7: the overlap is a difference of positions 2000 times larger, and
    the unloading curve is steep.
    """
    force = turned_pair_forces(history_law, tmp_path)
    assert force[0] > 0
    assert np.abs(force / force[0] - 1).max() < 1e-7


def test_pair_flip_catches_a_law_that_flips(tmp_path):
    """LIGGGHTS' thornton_ning treats scalars of the history as vectors, so the test above must
    fail for it.
    """
    force = turned_pair_forces("thornton_ning", tmp_path)
    assert np.abs(force / force[0] - 1).max() > 0.1


@pytest.mark.parametrize("rebuild", ["no", "yes"])
@pytest.mark.parametrize("geometry", GEOMETRIES)
def test_second_touch_is_a_new_contact(history_law, geometry, rebuild, tmp_path):
    """Both impacts of a bouncing sphere have the restitution of their own speed.

    If the contact kept its history, the slower second impact would be elastic, with restitution 1
    instead of 0.8 or less. The tolerance of restitution is 0.02: during a contact of about a
    millisecond, gravity changes the speed by about 1 %.
    """
    bodies = scene(history_law, dissipative_constant=LARGE)
    body = bodies.material.body()
    law = bodies.law(laws.combine(body, body if geometry == "pair" else RIGID))
    # In a pair of equal spheres, one sphere is kept in place: R* = R/2, and m* is the mass of the
    # moving sphere.
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
    """Return a function that measures an impact of a law at 0.1 m/s once, with its loading and
    contact time.
    """

    @cache
    def collide(law: str):
        return scene(law).impact(0.1).run(tmp_path_factory.mktemp("course"))

    return collide


def check_restart(
    law: str, geometry: str, moment: str, ranks: int, course: Callable, folder: Path
) -> None:
    """Check that a run which continues from a restart file is bitwise identical to the second half
    of the whole run.

    The exception is the first frame of a rate-dependent law. The forces at the start of a run use
    the current speeds; those at the end of a run use speeds of half a step earlier.
    """
    bodies = scene(law)
    loading_time, contact_time = course(law).loading_time, course(law).contact_time
    if moment == "loading":
        time = 0.5 * loading_time
    else:
        time = loading_time + 0.4 * (contact_time - loading_time)
    before = round(time / 8e-6)
    case = {"geometry": geometry, "after": 160}
    bodies.run("restart_write", folder / "whole", ranks=ranks, before=before, **case)
    restart = (folder / "whole" / "middle.restart").resolve()
    bodies.run("restart_read", folder / "rest", ranks=ranks, restart=restart, **case)
    whole = read_dump(folder / "whole" / "trajectory.dump")
    rest = read_dump(folder / "rest" / "trajectory.dump")
    peak = whole["fx"].abs().max()
    whole = whole[whole["step"] >= before].drop_duplicates(["step", "id"]).reset_index(drop=True)
    force = whole["fx"].abs().to_numpy()
    assert 0.1 * peak < force[0] < 0.95 * peak
    assert (force.max() > 1.05 * force[0]) == (moment == "loading")
    if laws.LAWS[bodies.law_name].rate_dependent:
        rest, whole = (table[table["step"] > before] for table in (rest, whole))
    assert len(rest) == len(whole)
    assert (rest.to_numpy() == whole.to_numpy()).all()


@pytest.mark.parametrize("moment", ["loading", "unloading"])
@pytest.mark.parametrize("geometry", GEOMETRIES)
def test_restart_in_mid_contact(history_law, geometry, moment, course, tmp_path):
    check_restart(history_law, geometry, moment, 1, course, tmp_path)


def test_restart_on_two_ranks(stored_law, course, tmp_path):
    check_restart(stored_law, "pair", "unloading", 2, course, tmp_path)


@pytest.mark.parametrize(("geometry", "moment"), [("plane", "loading"), ("mesh", "unloading")])
@pytest.mark.parametrize("law", ["thornton", "universal"])
def test_restart_at_walls_on_two_ranks(law, geometry, moment, course, tmp_path):
    """A wall contact keeps its history after a restart on two ranks.

    Two laws suffice, because the wall contacts of other laws differ only in the number of values.
    """
    check_restart(law, geometry, moment, 2, course, tmp_path)


def test_ranks_share_and_hand_over_a_contact(stored_law, course, tmp_path):
    """A contact lies on one border between ranks and moves across another. The collision is the
    same on 1 and 4 ranks. The relative tolerance is 1e-9, because the round-off of a position
    differs after a grain moves to another rank.
    """
    bodies, found = scene(stored_law), {}
    steps = ceil(1.3 * course(stored_law).contact_time / 4e-6)
    for ranks, grid in ((1, "1 1"), (4, "2 2")):
        folder = tmp_path / grid.replace(" ", "x")
        log = bodies.run("ranks", folder, ranks=ranks, grid=grid, drift=bodies.drift, steps=steps)
        assert f"{grid.replace(' ', ' by ')} by 1 MPI processor grid" in log
        table = read_dump(folder / "trajectory.dump")
        x, y = (table.loc[table["fy"] != 0, axis] for axis in "xy")
        assert x.min() < -0.005 and x.max() > 0.005, "the contact did not cross x = 0"
        assert y.min() < 0 < y.max(), "the contact is not on y = 0"
        found[grid] = measure(table)
    one, four = found.values()
    assert 0 < one.coefficient_of_restitution < 0.99
    assert four.coefficient_of_restitution == pytest.approx(
        one.coefficient_of_restitution, rel=1e-9
    )
    assert four.force_max == pytest.approx(one.force_max, rel=1e-9)
