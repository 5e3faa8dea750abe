# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of `viscoelastic_hertz`: restitution by a Padé approximation and by the equation of motion,
and energies.
"""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
import pytest
from references.viscoelastic_hertz import motion
from scipy.integrate import cumulative_simpson

from plastigran import laws
from plastigran.experiments.central import CentralImpact
from plastigran.materials import RIGID, read_material
from plastigran.physics import central

RADIUS, DENSITY, SPEED = 0.01, 900.0, 0.1
MASS = 4 / 3 * pi * RADIUS**3 * DENSITY
PAIR = laws.combine(laws.Body(9.3e9, 0.25), RIGID)


def constant(number: float, speed: float = SPEED) -> float:
    """Return the dissipative constant [s] with which this sphere has the dimensionless speed v* =
    `number` at `speed`.
    """
    return (
        number / central.viscoelastic_number(1.0, RADIUS, MASS, PAIR.youngs_modulus_eff, speed)
    ) ** 2


def law(number: float) -> laws.ViscoelasticHertz:
    return laws.ViscoelasticHertz(PAIR, dissipative_constant=constant(number))


def restitution(number: float) -> float:
    return law(number).central_impact(RADIUS, MASS, SPEED).coefficient_of_restitution


@pytest.mark.parametrize("number", [0.05, 0.3, 0.6, 1.0, 2.0, 4.0])
def test_impact_is_the_equation_of_motion(number):
    """The restitution of the law equals that of its equation of motion, to a relative 1e-9.

    The law and the reference integrate this equation with different variables.
    """
    rate = motion(number**2).y[1]
    assert restitution(number) == pytest.approx(-rate[-1], rel=1e-9)


@pytest.mark.parametrize(
    ("number", "off", "digit"),
    [
        (0.1, 6e-8, 1e-8),
        (0.3, 4e-5, 1e-6),
        (0.6, 1.4e-3, 5e-5),
        (1.0, 1.2e-2, 5e-4),
        (2.0, 9e-2, 5e-3),
    ],
)
def test_pade_form_is_as_good_as_it_is(number, off, digit):
    """The published Padé form of restitution has the error that docs/laws states.

    It exceeds the restitution of the equation of motion.
    """
    found = float(central.viscoelastic_restitution(number)) / restitution(number) - 1
    assert found == pytest.approx(off, abs=digit)


def test_series_at_low_speed():
    """For small v*, 1 - e = 1.15345 v*^2 (Schwager & Pöschel 2008); the next term is of order
    v*^4."""
    for number in (0.003, 0.01, 0.03):
        lost = 1 - restitution(number)
        assert lost == pytest.approx(1.15345 * number**2, rel=2 * number**2 + 1e-6)


def test_restitution_falls_with_speed_and_grows_with_radius():
    ice = laws.combine(laws.Body(9.3e9, 0.25), laws.Body(9.3e9, 0.25))
    sphere = laws.ViscoelasticHertz(ice, dissipative_constant=1e-5)
    radii, speeds = np.geomspace(1e-4, 1, 9), np.geomspace(1e-5, 10, 25)
    table = np.array(
        [
            [
                sphere.central_impact(r, 4 / 3 * pi * r**3 * DENSITY, v).coefficient_of_restitution
                for v in speeds
            ]
            for r in radii
        ]
    )
    assert (np.diff(table, axis=1) < 0).all()
    assert (np.diff(table, axis=0) > 0).all()


def test_only_the_number_matters():
    """Spheres of different size, speed, stiffness and mass have equal restitution at equal v*."""
    steel = laws.combine(laws.Body(2.1e11, 0.3), laws.Body(7e10, 0.33))
    scale = float(central.viscoelastic_number(1.0, 0.2, 3.0, steel.youngs_modulus_eff, 5.0))
    other = laws.ViscoelasticHertz(steel, dissipative_constant=(0.7 / scale) ** 2)
    found = other.central_impact(0.2, 3.0, 5.0).coefficient_of_restitution
    assert found == pytest.approx(restitution(0.7), rel=1e-9)


def test_spheres_part_before_they_stop_overlapping_and_never_pull():
    contact, state = law(0.6), laws.ViscoelasticHertz.State()
    impact = contact.central_impact(RADIUS, MASS, SPEED)
    assert 0.1 * impact.overlap_max < impact.overlap_res < impact.overlap_max
    rate = -SPEED * impact.coefficient_of_restitution
    for overlap, pushes in ((1.001, True), (0.999, False), (0.5, False)):
        answer = contact.respond(RADIUS, overlap * impact.overlap_res, state, rate)
        assert (answer.force > 0) == pushes
        assert (answer.contact_radius > 0) == pushes
    assert contact.respond(RADIUS, -1e-9, state, SPEED).force == 0


def test_energy_ledger_closes():
    """On any path, the work on the contact equals elastic plus dissipated energy.

    The dissipated energy grows. The tolerance is 1e-6 of the largest work, the error of Simpson's
    rule.
    """
    number, contact = 0.6, law(0.6)
    overlap_unit = (MASS * SPEED**2 / (4 / 3 * PAIR.youngs_modulus_eff * sqrt(RADIUS))) ** 0.4
    root = motion(number**2).y[0]
    fine = np.linspace(0, 1, 4001)
    index = np.linspace(0, 1, len(root))
    # The energies of the law are tested on any smooth path, here one near the motion.
    fit_root = np.polynomial.Polynomial.fit(index, root, 8)
    overlap = fit_root(fine) ** 2 * overlap_unit
    rate = 2 * fit_root(fine) * fit_root.deriv()(fine) * overlap_unit
    seconds = 20 * overlap_unit / SPEED
    answer = contact.follow(
        RADIUS, overlap, laws.ViscoelasticHertz.State(), overlap_rate=rate / seconds
    )
    power = answer["force"] * rate
    lost = answer["viscous_force"] * rate
    assert (lost >= 0).all()
    work = cumulative_simpson(power, x=fine, initial=0)
    dissipated = cumulative_simpson(lost, x=fine, initial=0)
    stored = answer["elastic_energy"] - answer["elastic_energy"][0]
    assert work == pytest.approx(stored + dissipated, abs=1e-6 * np.abs(work).max())
    assert dissipated[-1] > 0.1 * stored.max()


def test_without_viscosity_it_is_hertz():
    hertz, state = laws.Hertz(PAIR), laws.Hertz.State()
    contact = laws.ViscoelasticHertz(PAIR, dissipative_constant=0)
    overlap = np.geomspace(1e-9, 1e-4, 30)
    expected = hertz.follow(RADIUS, overlap, state)
    found = contact.follow(
        RADIUS, overlap, laws.ViscoelasticHertz.State(), np.linspace(-10, 10, overlap.size)
    )
    for name in expected:
        assert found[name] == pytest.approx(expected[name], rel=1e-14), name
    elastic = hertz.central_impact(RADIUS, MASS, SPEED)
    impact = contact.central_impact(RADIUS, MASS, SPEED)
    for name in ("coefficient_of_restitution", "force_max", "overlap_max"):
        assert getattr(impact, name) == pytest.approx(getattr(elastic, name), rel=1e-10)
    assert impact.overlap_res == 0


def test_rates_of_another_length_are_refused():
    with pytest.raises(ValueError, match=r"overlap \(3,\), overlap_rate \(2,\)"):
        law(0.5).follow(RADIUS, np.zeros(3), laws.ViscoelasticHertz.State(), np.zeros(2))


def test_the_constant_must_be_given():
    said = r"dissipative_constant is missing\. Add a value between 0 and 1 \[s\]"
    with pytest.raises(ValueError, match=f"viscoelastic_hertz: {said}"):
        laws.ViscoelasticHertz(PAIR)
    with pytest.raises(
        ValueError, match="needs dissipative_constant, which material steel does not"
    ):
        CentralImpact("viscoelastic_hertz", 0.1, read_material("steel"), 0.01)
    with pytest.raises(ValueError, match=r"dissipative_constant is -1; it must be between 0 and 1"):
        laws.ViscoelasticHertz(PAIR, dissipative_constant=-1)


def test_laws_that_yield_need_a_strength_and_the_others_do_not():
    soft = laws.Body(7e10, 0.3)
    assert laws.Hertz(laws.combine(soft, soft)).central_impact(RADIUS, MASS, SPEED).in_range
    with pytest.raises(ValueError, match="thornton: yield_strength is missing"):
        laws.Thornton(laws.combine(soft, soft))
