# SPDX-License-Identifier: GPL-2.0-or-later
"""In LIGGGHTS, the yield strength grows with the strain rate, and each contact keeps the strength
of its first touch.

`thornton` represents the laws that are scaled to another strength, and `universal` those that are
interpolated between tables.
"""

from __future__ import annotations

import re

import numpy as np
import pytest
from attrs import evolve
from scenes import DECKS, Spheres

from plastigran import laws
from plastigran.engine.dumps import read_dump
from plastigran.engine.process import EngineError, run_deck
from plastigran.experiments.central import CentralImpact
from plastigran.experiments.collide import IMPACTS
from plastigran.experiments.collision import measure
from plastigran.materials import RIGID

LAW = "thornton"
RATE = {"rate_coefficient": 0.1, "reference_rate": 1e-3}  # factor 1.69 at 0.1 m/s, 0.1 m
SPHERES = Spheres(LAW, 0)
ALUMINIUM = evolve(SPHERES.material, **RATE)


@pytest.mark.parametrize(("law", "tolerance"), [(LAW, 1e-5), ("universal", 1e-3)])
@pytest.mark.parametrize("speed", [0.1, 1.0])
@pytest.mark.parametrize("geometry", IMPACTS["sphere"].geometries)
def test_impact_is_the_laws_at_its_rate(geometry, speed, law, tolerance, tmp_path):
    """At a twentieth of the recommended time step, the relative integration error is 1e-5. Where
    the plugin interpolates in tables, the tolerance is 1e-3, as docs/rate_factor.md states.
    """
    case = CentralImpact(law, speed, ALUMINIUM, 0.1, geometry=geometry)
    plain = evolve(case, material=SPHERES.material).predict()
    found, expected = case.run(tmp_path, timestep=case.timestep / 20), case.predict()
    assert expected.coefficient_of_restitution > 1.1 * plain.coefficient_of_restitution
    for outcome in ("coefficient_of_restitution", "force_max", "overlap_max"):
        assert getattr(found, outcome) == pytest.approx(getattr(expected, outcome), rel=tolerance)


def test_two_equal_spheres_are_one_on_a_rigid_plane(tmp_path):
    """The relative tolerance is 1e-6: with the same time steps, the integration errors are nearly
    equal."""
    plane, pair = (
        CentralImpact(LAW, 0.3, ALUMINIUM, 0.1, geometry=geometry)
        for geometry in ("sphere_wall", "two_spheres")
    )
    one = plane.run(tmp_path / "plane", timestep=plane.timestep / 20)
    both = pair.run(tmp_path / "pair", timestep=plane.timestep / 20)
    assert both.coefficient_of_restitution == pytest.approx(
        one.coefficient_of_restitution, rel=1e-6
    )
    assert both.force_max == pytest.approx(one.force_max, rel=1e-6)


@pytest.mark.parametrize("rebuild", ["no", "yes"])
@pytest.mark.parametrize("geometry", ["pair", "plane", "mesh"])
def test_second_touch_has_its_own_rate(geometry, rebuild, tmp_path):
    """With the rate of the first touch, the second restitution would be 0.04 higher. The tolerance
    is 0.02, because gravity changes the speed during the contact of one millisecond.
    """
    steep = {"rate_coefficient": 1.0, "reference_rate": 1.0}
    SPHERES.run("bounce", tmp_path, geometry=geometry, rebuild=rebuild, speed=1.0, **steep)
    body = evolve(SPHERES.material, **steep).body()
    law = laws.LAWS[LAW](laws.combine(body, body if geometry == "pair" else RIGID))
    radius_eff = 0.05 if geometry == "pair" else 0.1
    table = read_dump(tmp_path / "trajectory.dump")
    speed, weight = table["vx"].to_numpy(), SPHERES.mass() * 10
    touching = table["fx"].to_numpy() + weight > 1e-6 * weight
    edges = np.flatnonzero(np.diff(touching.astype(int)))
    for start, end in (edges[0:2], edges[2:4]):
        into, out = -speed[start], speed[end + 1]
        impact = law.central_impact(radius_eff, SPHERES.mass(), into)
        assert out / into == pytest.approx(impact.coefficient_of_restitution, abs=0.02)
    first = law.at_impact(radius_eff, -speed[edges[0]])
    remembered = first.central_impact(radius_eff, SPHERES.mass(), into)
    assert remembered.coefficient_of_restitution > impact.coefficient_of_restitution + 0.04


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("geometry", ["pair", "plane", "mesh"])
def test_restart_keeps_the_rate(geometry, ranks, tmp_path):
    """A run from a restart file, written during contact, loads the contact further and is
    bitwise identical to the whole run. At that time the bodies approach at half of their
    initial speed.
    """
    case = {"geometry": geometry, "ranks": ranks, **RATE}
    SPHERES.run("restart_write", tmp_path / "whole", before=40, **case)
    restart = (tmp_path / "whole" / "middle.restart").resolve()
    SPHERES.run("restart_read", tmp_path / "rest", restart=restart, **case)
    whole = read_dump(tmp_path / "whole" / "trajectory.dump")
    rest = read_dump(tmp_path / "rest" / "trajectory.dump")
    whole = whole[whole["step"] >= 40].drop_duplicates(["step", "id"]).reset_index(drop=True)
    assert whole["fx"].abs().max() > 1.05 * whole["fx"].abs().iloc[0] > 0
    assert len(rest) == len(whole)
    assert (rest.to_numpy() == whole.to_numpy()).all()


def test_ranks_hand_the_rate_over(tmp_path):
    """The contact lies on one border and crosses another. The relative tolerance is 1e-9, because
    positions are summed in another order.
    """
    found = {}
    for ranks, grid in ((1, "1 1"), (2, "2 1"), (2, "1 2"), (4, "2 2")):
        folder = tmp_path / grid.replace(" ", "x")
        SPHERES.run("ranks", folder, ranks=ranks, grid=grid, steps=400, **RATE)
        found[grid] = measure(read_dump(folder / "trajectory.dump"))
    body = ALUMINIUM.body()
    law = laws.LAWS[LAW](laws.combine(body, body))
    expected = law.central_impact(0.05, SPHERES.mass() / 2, 0.2).coefficient_of_restitution
    one = found.pop("1 1").coefficient_of_restitution
    assert one == pytest.approx(expected, rel=1e-3)
    for other in found.values():
        assert other.coefficient_of_restitution == pytest.approx(one, rel=1e-9)


def test_pair_flip_keeps_the_rate(tmp_path):
    """A contact turns by half a revolution, through sorts and rebuilds of the neighbor lists. The
    relative tolerance of its force is 1e-7, as without rate factor.
    """
    forces = {}
    for name, rate in {"at rest": {}, "moving": RATE}.items():
        SPHERES.run("rotating_pair", tmp_path / name, **rate)
        table = read_dump(tmp_path / name / "trajectory.dump")
        one = table[(table["step"] > 1100) & (table["id"] == 1)]
        forces[name] = np.linalg.norm(one[["fx", "fy", "fz"]].to_numpy(), axis=1)
    assert np.abs(forces["moving"] / forces["moving"][0] - 1).max() < 1e-7
    assert forces["moving"][0] > 1.05 * forces["at rest"][0]


def test_history_is_as_long_as_before_when_off(tmp_path):
    """With the rate factor, a restart file stores one more number per contact and particle. It also
    has a longer text of constants, which this test removes.
    """
    sizes = []
    for name, rate in {"off": {}, "on": RATE}.items():
        SPHERES.run("restart_write", tmp_path / name, **rate)
        file = (tmp_path / name / "middle.restart").read_bytes()
        sizes.append(len(re.sub(rb"\tmodel [^\n]*\n", b"", file)))
    assert sizes[1] - sizes[0] == 2 * 8


def test_coefficient_that_comes_too_late_is_refused(tmp_path):
    text = (DECKS / "restart_write.in").read_text()
    wall, late = "include ${decks}/wall_${geometry}.in", "rateCoefficient peratomtype 0.1 0.1"
    deck = tmp_path / "deck.in"
    deck.write_text(
        text.replace(wall, f"{wall}\nunfix rate_coefficient\nfix c all property/global {late}")
    )
    variables = {"law": LAW, "geometry": "plane", "decks": DECKS}
    with pytest.raises(EngineError, match="rateCoefficient must be given before the wall"):
        run_deck(deck, variables, tmp_path / "run")
