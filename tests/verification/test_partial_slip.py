# SPDX-License-Identifier: GPL-2.0-or-later
"""Oblique impacts with partial slip, compared with Cattaneo's contact, full sliding and energy."""

from __future__ import annotations

from math import cos, pi, radians, sin

import attrs
import numpy as np
import pytest

from plastigran import laws
from plastigran.materials import RIGID
from plastigran.physics.oblique import Motion, ObliqueImpact
from plastigran.physics.partial_slip import Rings, partial_slip

FRICTION = 0.3


@pytest.fixture
def glass_sphere():
    """`glass_sphere(angle)` returns an impact of a sphere of radius 2.5 mm on a rigid plane. The
    sphere has a speed of 3.9 m/s at an angle from the normal, and a normal restitution of 1.
    """

    def make(angle: float) -> ObliqueImpact:
        return ObliqueImpact(
            pair=laws.combine(laws.Body(70e9, 0.25), RIGID),
            radius=2.5e-3,
            mass=4 / 3 * pi * 2.5e-3**3 * 2500,
            coefficient_of_friction=0.1,
            coefficient_of_restitution=1.0,
            before=Motion(3.9 * cos(radians(angle)), 3.9 * sin(radians(angle)), 0.0),
        )

    return make


def sheared(shifts: np.ndarray) -> np.ndarray:
    """Return the ratio of tangential to sliding force after each displacement, for an overlap of
    1."""
    rings = Rings(FRICTION, compliance=1.1)
    rings.move(1.0, 0.0)
    forces = []
    for shift in shifts:
        rings.move(1.0, shift)
        forces.append(rings.force() / FRICTION)
    return np.array(forces)


def test_a_contact_sheared_under_a_constant_force_is_cattaneos():
    """A first shear displacement s gives the force T = mu F (1 - (1 - s/s_max)^(3/2)).

    The contact begins to slide at s_max = mu E*/(4 G*) overlap (Cattaneo 1938).
    """
    share = np.linspace(0.02, 0.98, 25)
    moved = np.diff(share, prepend=0) * FRICTION * 1.1
    # Rings represent this contact exactly, so only round-off remains.
    assert sheared(moved) == pytest.approx(1 - (1 - share) ** 1.5, rel=1e-12)


def test_beyond_its_reach_it_slides_at_the_limit_of_friction():
    assert sheared(np.array([2 * FRICTION * 1.1, 1.0])) == pytest.approx([1, 1], rel=1e-12)


def test_sheared_back_it_follows_mindlin_and_deresiewicz():
    """Reversed shear follows the curve of first shear at twice the scale.

    After a reversal at the force T*, a displacement ds back gives the force
    T* - 2 mu F (1 - (1 - ds/(2 s_max))^1.5) (Mindlin & Deresiewicz 1953, J. Appl. Mech. 20:327).
    """
    reach = FRICTION * 1.1
    back = np.linspace(0.05, 1.0, 12)
    forces = sheared(np.concatenate([[0.7 * reach], -np.diff(back, prepend=0) * reach]))
    top = 1 - 0.3**1.5
    assert forces[0] == pytest.approx(top, rel=1e-12)
    assert forces[1:] == pytest.approx(top - 2 * (1 - (1 - back / 2) ** 1.5), rel=1e-12)


def test_steeply_along_the_surface_it_slides_throughout(glass_sphere):
    """The sphere rebounds like a rigid body that slides; the steps miss 1e-4 of the normal
    impulse."""
    impact = glass_sphere(60)
    after, rigid = partial_slip(impact), impact.rigid_sliding()
    gained = impact.before.along - rigid.along
    assert after.along - rigid.along == pytest.approx(0, abs=2e-4 * gained)
    assert after.spin == pytest.approx(rigid.spin, rel=2e-4)


@pytest.mark.parametrize("angle", [1, 5, 10, 15, 20, 25, 40])
def test_no_energy_is_made_and_the_moment_about_the_contact_stays(angle, glass_sphere):
    impact = glass_sphere(angle)
    before, after = impact.before, partial_slip(impact)
    turned = 0.4 * impact.radius * after.spin
    assert turned == pytest.approx(after.along - before.along, rel=1e-9)
    left = after.along**2 + 0.4 * (impact.radius * after.spin) ** 2
    assert left < before.along**2


def test_results_do_not_depend_on_the_steps(glass_sphere):
    for angle in (2, 10, 20):
        impact = glass_sphere(angle)
        coarse, fine = (partial_slip(impact, steps).along for steps in (500, 4000))
        assert coarse == pytest.approx(fine, abs=3e-5 * impact.before.along)


def test_two_moving_bodies_are_refused(glass_sphere):
    with pytest.raises(ValueError, match="a sphere on a plane with friction"):
        partial_slip(attrs.evolve(glass_sphere(10), mass_other=1.0))
    with pytest.raises(ValueError, match="a sphere on a plane with friction"):
        partial_slip(attrs.evolve(glass_sphere(10), coefficient_of_friction=0.0))
