# SPDX-License-Identifier: GPL-2.0-or-later
"""The theory of oblique impacts with a tangential spring and a slider (Coulomb friction)."""

from __future__ import annotations

import pytest
from attrs import evolve
from chung_ooi_cases import few

from plastigran import laws
from plastigran.materials import RIGID
from plastigran.physics import central
from plastigran.physics.oblique import Motion, ObliqueImpact


def test_spring_and_slider_without_friction_or_slip():
    """Without friction, the tangential motion does not change; rolling surfaces do not slip."""
    pair = laws.combine(laws.Body(7e10, 0.3, 1e30, 1.61), RIGID)
    before = Motion(normal=1.0, along=0.3, spin=5.0)
    smooth = ObliqueImpact(pair, 0.01, 1.0, 0.0, 0.7, before)
    after = smooth.spring_slider()
    assert (after.along, after.spin) == pytest.approx((0.3, 5.0), rel=1e-12)
    assert after.normal == pytest.approx(central.restitution_without_pull(0.7), rel=1e-8)


@pytest.mark.parametrize(("poissons_ratio", "gained"), [(0.1, 0.030), (0.23, 0.004), (0.3, -0.030)])
def test_sticking_spring_gains_or_loses_energy(poissons_ratio, gained):
    """A spring that hardly slides changes the tangential energy, here relative to the initial one.
    The force is k_t(a) times the path, and k_t changes with the contact radius a, so the spring
    does not conserve energy. The change depends on the number of oscillations during the contact,
    and so on k_t / normal stiffness = 2 (1 - nu)/(2 - nu). The energy increases for small nu and
    decreases for nu = 0.3. The tolerance 5e-4 is the round-off of the expected values, which are
    results of these equations.
    """
    pair = laws.combine(laws.Body(7e10, poissons_ratio, 1e30, 1.61), RIGID)
    impact = ObliqueImpact(pair, 0.01, 1.0, 50.0, 1.0, Motion(normal=1.0, along=0.3, spin=0.0))
    after = impact.spring_slider()
    energy = 0.5 * after.along**2 + 0.5 * 0.4 * (0.01 * after.spin) ** 2
    assert energy / (0.5 * 0.3**2) - 1 == pytest.approx(gained, abs=5e-4)
    # Friction changes spin and tangential motion with the lever arm R - overlap/2, which is up to
    # 0.55 % shorter than R; the speed changes by up to 2.5 * 0.17 m/s.
    assert after.spin * 0.01 == pytest.approx(2.5 * (after.along - 0.3), abs=2.5e-3)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"coefficient_of_restitution": 0.0}, "coefficient_of_restitution is 0"),
        ({"coefficient_of_friction": -1.0}, "coefficient_of_friction is -1"),
        ({"mass": 0.0}, "mass is 0"),
        ({"before": Motion(-1.0, 0.0, 0.0)}, "closing speed is -1"),
    ],
)
def test_impossible_impacts_are_named(change, said):
    impact = few(6)[0].impact()
    with pytest.raises(ValueError, match=said):
        evolve(impact, **change)
