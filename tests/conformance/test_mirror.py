# SPDX-License-Identifier: GPL-2.0-or-later
"""Mirror symmetry: two equal spheres that collide behave like one sphere on a rigid plane.

The plane of symmetry between the spheres stays plane and has no friction, so it acts like a rigid
plane. More generally, two spheres behave like one sphere of the yielding body's material on a rigid
plane. The radius of this sphere is R* E'/E*, and its overlap is E*/E' times the overlap of the two
spheres. E' = E/(1-nu^2) is the modulus of the yielding body.
"""

from __future__ import annotations

import numpy as np
import pytest
from scenes import scene

from plastigran import laws
from plastigran.experiments.central import GEOMETRIES, CentralImpact
from plastigran.materials import RIGID
from plastigran.physics.central import yield_speed

RADIUS, MASS = 0.01, 0.03  # m, kg
BODIES = {
    "aluminium": laws.Body(7e10, 0.3, 1e8, 1.61),
    "hardening_steel": laws.Body(2.1e11, 0.28, 9e8, tangent_modulus=4e9),
    "metallic_glass": laws.Body(8.9e10, 0.37, 1.9e9),
    "polymer": laws.Body(3e9, 0.45, 6e7),
    "rate_dependent": laws.Body(7e10, 0.3, 1e8, rate_coefficient=0.02, reference_rate=1e-3),
}
#: Impact speeds divided by the yield speed.
SPEEDS = np.geomspace(1, 1000, 13)
#: Relative tolerance for round-off; bisection finds the largest overlap to the last bit.
SAME = 1e-9


@pytest.fixture(params=BODIES)
def body(request) -> laws.Body:
    return BODIES[request.param]


def options(law_name: str) -> list[dict[str, str]]:
    """Return the sets of options of a law: its defaults, and each choice of each option. The option
    `reading` is left out, because it can break the symmetry.
    """
    rows = [row for row in laws.LAWS[law_name].options() if row["name"] != "reading"]
    return [{}, *({row["name"]: word} for row in rows for word in row["choices"])]


def test_two_equal_spheres_are_one_on_a_rigid_plane(sphere_law, body, law_between):
    """Two equal spheres that meet at speed 2 v behave like one sphere on a rigid plane at speed v.

    Restitution and force are equal; each of the two spheres has half of their overlap.
    """
    two, one = laws.combine(body, body), laws.combine(body, RIGID)
    speeds = SPEEDS * yield_speed(one, RADIUS, MASS)
    for given in options(sphere_law):
        pair, plane = (law_between(sphere_law, bodies, **given) for bodies in (two, one))
        found = pair.central_impact(RADIUS / 2, MASS / 2, 2 * speeds)
        expected = plane.central_impact(RADIUS, MASS, speeds)
        for name, factor in {
            "coefficient_of_restitution": 1,
            "force_max": 1,
            "overlap_max": 2,
            "stiffness_max": 0.5,
        }.items():
            assert getattr(found, name) == pytest.approx(
                factor * getattr(expected, name), rel=SAME
            ), (given, name)
        # A residual overlap is a difference, so the tolerance is relative to the largest overlap.
        off = np.abs(found.overlap_res - 2 * expected.overlap_res)
        assert (off <= SAME * found.overlap_max).all(), given


@pytest.mark.parametrize("stiffness", [0.2, 1.0, 5.0])
def test_two_spheres_are_the_fitted_sphere(sphere_law, body, stiffness, law_between):
    """A yielding sphere and an elastic one behave like one sphere on a rigid plane.

    The elastic sphere is softer or stiffer than the yielding one. Force, contact radius and energy
    agree on a path of loading, unloading and reloading.
    """
    other = laws.Body(stiffness * body.youngs_modulus, 0.3)
    two, one = laws.combine(body, other), laws.combine(body, RIGID)
    ratio = one.youngs_modulus_eff / two.youngs_modulus_eff
    overlap_y = laws.yield_radius_ratio(one) ** 2 * RADIUS
    peaks = overlap_y * np.array([0.5, 1.3, 4.1, 37, 211, 990])
    shares = np.concatenate([np.linspace(0, 1, 9), np.linspace(0.97, 0, 15)])
    path = np.concatenate([peak * shares for peak in peaks])
    for given in options(sphere_law):
        pair, plane = (law_between(sphere_law, bodies, **given) for bodies in (two, one))
        found = pair.follow(RADIUS / ratio, path * ratio, pair.State())
        expected = plane.follow(RADIUS, path, plane.State())
        given_work = expected["elastic_energy"] + expected["plastic_work"]
        for name, factor, scale in [
            ("force", 1, expected["force"]),
            ("contact_radius", 1, expected["contact_radius"]),
            ("elastic_energy", ratio, given_work),
            ("plastic_work", ratio, given_work),
        ]:
            off = np.abs(found[name] - factor * expected[name])
            assert (off <= SAME * factor * np.maximum.accumulate(scale)).all(), (given, name)


def test_the_fits_to_one_sphere_differ_in_the_other_reading():
    """With `reading pair`, laws use the effective constants of the pair and are not symmetric."""
    steel, found = BODIES["hardening_steel"], {}
    for name, law in laws.LAWS.items():
        if "reading" not in {row["name"] for row in law.options()}:
            continue
        two, one = (
            law(laws.combine(steel, other), reading="pair").central_impact(radius, mass, speed)
            for other, radius, mass, speed in (
                (steel, RADIUS / 2, MASS / 2, 2.0),
                (RIGID, RADIUS, MASS, 1.0),
            )
        )
        found[name] = two.coefficient_of_restitution / one.coefficient_of_restitution - 1
    assert {"ghaednia", "jackson_green", "kogut_komvopoulos", "ye_komvopoulos"} <= set(found)
    assert all(abs(off) > 1e-5 for off in found.values()), found


@pytest.mark.parametrize("name", ["ghaednia_2019", "jackson_green", "ye_komvopoulos"])
def test_the_range_of_a_fit_mirrors(name):
    """The validity range of overlap/R* is four times as large for two equal spheres as for one.

    Each of two equal spheres has half of the overlap, and R* is half as large. With a much softer
    elastic body, the range is 0.1, as in any law.
    """
    steel, soft = BODIES["hardening_steel"], laws.Body(2.1e7, 0.3)
    plane, pair, dented = (
        laws.LAWS[name](laws.combine(steel, other)).overlap_range for other in (RIGID, steel, soft)
    )
    assert pair == pytest.approx(4 * plane, rel=SAME)
    # Steel has only 1e-4 of the overlap with the soft body.
    assert dented == pytest.approx(0.1, rel=1e-3)


@pytest.mark.parametrize("speed", [0.02, 0.3])
def test_the_engine_mirrors(sphere_law, speed, tmp_path):
    """In LIGGGHTS, impacts on a plane, on a mesh and on an equal sphere agree, and have the same
    time-step error.

    The difference is round-off: 1e-16 of the radius, for overlaps of 1e-4 of the radius.
    """
    material, found = scene(sphere_law).material, {}
    step = CentralImpact(sphere_law, speed, material, 0.1).timestep
    for geometry in GEOMETRIES:
        case = CentralImpact(sphere_law, speed, material, 0.1, geometry=geometry)
        found[geometry] = case.run(tmp_path / geometry, timestep=step)
    one = found.pop("sphere_wall")
    for geometry, other in found.items():
        factor = 2 if geometry == "two_spheres" else 1
        for name in ("coefficient_of_restitution", "force_max"):
            assert getattr(other, name) == pytest.approx(getattr(one, name), rel=SAME), geometry
        assert other.overlap_max == pytest.approx(factor * one.overlap_max, rel=SAME)
        assert other.contact_time == pytest.approx(one.contact_time, rel=1e-6)
