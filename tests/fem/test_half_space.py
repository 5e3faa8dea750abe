# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of a sphere on a half space that is elastic or yields."""

from __future__ import annotations

import attrs
import numpy as np
import pytest
from coarse_sphere import COARSE, ELASTIC, METAL, RADIUS
from numpy.testing import assert_allclose

from plastigran.fem.sphere.assembly import pressed
from plastigran.fem.sphere.press import press
from plastigran.fem.sphere.throw import throw
from plastigran.fem.theory.hertz import HertzSphere

FORCE, SPEED = 200.0, 0.02
SOFT = attrs.evolve(ELASTIC, youngs_modulus=40e9, poissons_ratio=0.25)
STIFF = attrs.evolve(ELASTIC, youngs_modulus=70e14)  # 1e5 times as stiff as the sphere


@pytest.fixture(scope="module")
def indentation():
    """Compression of a stiff sphere that indents a metal, up to E*a/(sigma_Y R) = 10."""
    return press(STIFF, RADIUS, [1500.0], COARSE, plane=METAL)


@pytest.mark.parametrize("plane", [SOFT, ELASTIC])
def test_elastic_pair_follows_hertz_with_the_modulus_of_both(plane):
    pair = HertzSphere(ELASTIC, RADIUS, plane)
    top = press(ELASTIC, RADIUS, [FORCE], COARSE, plane=plane).unloadings.iloc[0]
    # As on a rigid plane, the coarse mesh has edges of a tenth of the contact radius.
    assert top["approach"] == pytest.approx(pair.approach(FORCE), rel=5e-3)
    assert top["contact_radius"] == pytest.approx(pair.contact_radius(FORCE), rel=0.02)
    assert top["coefficient_of_restitution"] == pytest.approx(1, abs=2e-3)


def test_stiff_half_space_is_a_rigid_plane(elastic_pressing):
    on_stiff = press(ELASTIC, RADIUS, [FORCE], COARSE, plane=STIFF).unloadings.iloc[0]
    on_rigid = elastic_pressing.unloadings.iloc[0]
    for name in ("approach", "contact_radius", "coefficient_of_restitution"):
        # The half space is not quite rigid; its stiffness makes the contact softer by 1e-5.
        assert on_stiff[name] == pytest.approx(on_rigid[name], rel=1e-4), name


def test_forces_on_both_bodies_are_opposite():
    pair = HertzSphere(ELASTIC, RADIUS, SOFT)
    equations = pressed(pair, pair.contact_radius(FORCE), COARSE)
    touch = equations.contact.touch(np.zeros(equations.body.size), pair.approach(FORCE))
    above, below = np.split(touch.nodal, [equations.body.sphere.size])
    assert touch.force > 0
    assert_allclose([above.sum(), below.sum()], [touch.force, -touch.force], rtol=1e-12)


def test_half_space_yields_below_its_surface_at_the_force_of_the_sphere():
    """A metal half space yields at the same force as a sphere of the same metal.

    The reason is that the pressure of a Hertz contact is the same on both bodies.
    """
    force = 1.15 * HertzSphere(METAL, RADIUS).yield_force
    pair = HertzSphere(STIFF, RADIUS, METAL)
    assert pair.yield_force == pytest.approx(HertzSphere(METAL, RADIUS).yield_force, rel=1e-4)
    strained = press(STIFF, RADIUS, [force], COARSE, plane=METAL).snapshots[0]
    deepest = strained.positions[np.argmax(strained.plastic_strain)]
    radius = pair.contact_radius(force)
    assert strained.plastic_strain.max() > 0
    assert deepest[0] < 0.3 * radius
    assert deepest[1] == pytest.approx(-0.48 * radius, rel=0.35)  # as in test_press.py


def test_indentation_pressure_is_of_the_order_of_the_expanding_cavity(indentation):
    """The mean pressure agrees with Johnson's expanding-cavity model within 15 %.

    The model (Johnson 1985, sec. 6.3) is only an estimate.
    """
    top = indentation.unloadings.iloc[0]
    strength = METAL.hardening.yield_strength
    strain = METAL.youngs_modulus * top["contact_radius"] / (RADIUS * strength)
    ratio = METAL.poissons_ratio
    cavity = 2 / 3 * (2 + np.log((strain + 4 * (1 - 2 * ratio)) / (6 * (1 - ratio))))
    mean = top["force"] / (np.pi * top["contact_radius"] ** 2 * strength)
    assert 8 < strain < 12
    assert mean == pytest.approx(cavity, rel=0.15)


def test_indentation_leaves_a_dent_and_dissipates(indentation):
    assert indentation.plane == METAL
    top = indentation.unloadings.iloc[0]
    assert 0.3 * top["approach"] < top["residual_approach"] < top["approach"]
    assert 0.6 < top["coefficient_of_restitution"] < 0.9


def test_impact_on_a_half_space_radiates_a_little_energy():
    """Elastic waves in the half space carry away the energy that Hunter (1957) estimates.

    For equal bodies with a Poisson's ratio of 0.25, the lost fraction of the energy is 1.04
    (v/c)^(3/5), with the impact speed v and c = sqrt(E/rho) (J. Mech. Phys. Solids 5:162).
    """
    impact = throw(ELASTIC, RADIUS, SPEED, COARSE, plane=ELASTIC)
    sound = np.sqrt(ELASTIC.youngs_modulus / ELASTIC.density)
    lost = 1 - impact.coefficient_of_restitution**2
    assert lost == pytest.approx(1.04 * (SPEED / sound) ** 0.6, rel=0.2)
    pair = HertzSphere(ELASTIC, RADIUS, ELASTIC)
    assert impact.contact_time == pytest.approx(pair.duration(SPEED), rel=0.01)
    assert impact.force_max == pytest.approx(pair.force(pair.approach_max(SPEED)), rel=0.01)
    parts = ["kinetic_energy", "elastic_energy", "penalty_energy"]
    total = impact.history[parts].sum(axis=1)
    assert total.max() / total.min() == pytest.approx(1, abs=2e-3)  # as in test_throw.py


def test_finite_strain_on_a_half_space_is_refused():
    with pytest.raises(ValueError, match="strain is finite; on a half space it must be small"):
        press(ELASTIC, RADIUS, [FORCE], attrs.evolve(COARSE, strain="finite"), plane=SOFT)
