# SPDX-License-Identifier: GPL-2.0-or-later
"""A yield strength that grows with the strain rate of the impact, without LIGGGHTS."""

from __future__ import annotations

import numpy as np
import pytest

from plastigran import laws
from plastigran.materials import RIGID
from plastigran.physics import central
from plastigran.usable_laws import laws_for

RADIUS, LENGTH, MASS = 0.1, 0.1, 11.0  # m, m, kg
ALUMINIUM = {
    "youngs_modulus": 7e10,
    "poissons_ratio": 0.3,
    "yield_strength": 1e8,
    "yield_pressure_factor": 1.61,
}
RATE = {"rate_coefficient": 0.02, "reference_rate": 1e-3}
BODY = laws.Body(**ALUMINIUM, **RATE)
PAIR = laws.combine(BODY, RIGID)
OUTCOMES = ("coefficient_of_restitution", "force_max", "overlap_max", "overlap_res")
YIELDING = sorted(name for name, law in laws.LAWS.items() if law.yields)
SPHERES = sorted(set(laws_for("sphere")) & set(YIELDING))


def stronger(factor: float, **rate: float) -> laws.MaterialPair:
    strength = factor * ALUMINIUM["yield_strength"]
    return laws.combine(laws.Body(**ALUMINIUM | {"yield_strength": strength}, **rate), RIGID)


def test_factor():
    """The factor is 1 + C ln(rate/reference) with the rate v/R, rounded to 1e-4, and 1 up to the
    reference rate."""
    speed = np.array([0.0, 1e-5, 1e-4, 2e-4, 0.1, 100.0])
    found = laws.rate_factor(PAIR, RADIUS, speed)
    assert (found[:3] == 1).all()
    expected = 1 + 0.02 * np.log(speed[3:] / RADIUS / 1e-3)
    assert found[3:] == pytest.approx(expected, abs=0.5e-4)
    assert found * 1e4 == pytest.approx(np.round(found * 1e4), rel=1e-12)
    assert (laws.rate_factor(stronger(1), RADIUS, speed) == 1).all()


@pytest.mark.parametrize("name", YIELDING)
@pytest.mark.parametrize("speed", [0.01, 0.3])
def test_impact_is_that_of_the_strength_at_its_rate(name, speed, law_between):
    """The relative tolerance 1e-9 is round-off: the strength is multiplied before or after its
    yield pressure factor."""
    factor = laws.rate_factor(PAIR, RADIUS, speed)
    assert factor > 1.05
    found = law_between(name, PAIR, LENGTH).central_impact(RADIUS, MASS, speed)
    expected = law_between(name, stronger(factor), LENGTH).central_impact(RADIUS, MASS, speed)
    for outcome in OUTCOMES:
        assert getattr(found, outcome) == pytest.approx(getattr(expected, outcome), rel=1e-9)


def test_thornton_has_a_closed_form():
    """The yield speed is proportional to the strength to the power 5/2."""
    for speed in (0.02, 0.2, 2.0):
        factor = laws.rate_factor(PAIR, RADIUS, speed)
        scale = central.yield_speed(PAIR, RADIUS, MASS) * factor**2.5
        found = laws.Thornton(PAIR).central_impact(RADIUS, MASS, speed)
        expected = float(central.thornton_restitution(speed / scale))
        assert found.coefficient_of_restitution == pytest.approx(expected, rel=1e-9)


def test_given_hardness_grows_too():
    """A constant in Pa is a pressure of plastic flow, so the rate factor multiplies it."""
    factor = laws.rate_factor(PAIR, RADIUS, 0.2)
    found = laws.Brake2015(PAIR, indentation_pressure=3e8).central_impact(RADIUS, MASS, 0.2)
    hard = laws.Brake2015(stronger(factor), indentation_pressure=factor * 3e8)
    expected = hard.central_impact(RADIUS, MASS, 0.2)
    assert found.force_max == pytest.approx(expected.force_max, rel=1e-9)


@pytest.mark.parametrize("name", SPHERES)
def test_two_equal_spheres_are_one_on_a_rigid_plane(name, law_between):
    """Two spheres at speeds of +-v and one sphere at v have the same rate, factor and impact,
    to round-off.
    """
    two = laws.combine(BODY, BODY)
    for speed in (0.02, 0.2, 20.0):
        assert laws.rate_factor(two, RADIUS / 2, 2 * speed) == laws.rate_factor(PAIR, RADIUS, speed)
        one = law_between(name, PAIR).central_impact(RADIUS, MASS, speed)
        both = law_between(name, two).central_impact(RADIUS / 2, MASS / 2, 2 * speed)
        assert both.force_max == pytest.approx(one.force_max, rel=1e-9)
        assert both.coefficient_of_restitution == pytest.approx(
            one.coefficient_of_restitution, rel=1e-9
        )


@pytest.mark.parametrize("name", SPHERES)
def test_restitution_rises_with_the_coefficient(name, law_between):
    for speed in (0.2, 1.0):
        found = [
            law_between(name, stronger(1, **RATE | {"rate_coefficient": coefficient}))
            .central_impact(RADIUS, MASS, speed)
            .coefficient_of_restitution
            for coefficient in (0, 0.01, 0.05)
        ]
        assert found[0] < found[1] < found[2]


def test_a_law_is_at_rest_unless_told_the_impact():
    """Along a path, a law uses its strength at rest; `at_impact` returns the law during an
    impact.
    """
    law, plain = laws.Thornton(PAIR), laws.Thornton(stronger(1))
    overlap = np.linspace(0, 1e-4, 20)
    assert (law.follow(RADIUS, overlap)["force"] == plain.follow(RADIUS, overlap)["force"]).all()
    moving = law.at_impact(RADIUS, 0.2)
    factor = laws.rate_factor(PAIR, RADIUS, 0.2)
    assert moving.pair.yield_strength == factor * 1e8
    assert moving.pair.rate_coefficient == 0
    assert moving.at_impact(RADIUS, 5.0) == moving
    found, expected = (x.central_impact(RADIUS, MASS, 0.2) for x in (law, moving))
    assert found.force_max == expected.force_max
    with pytest.raises(ValueError, match=r"speed is -1; it must be positive and finite \[m/s\]"):
        law.at_impact(RADIUS, -1)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"rate_coefficient": -0.1}, r"rate_coefficient is -0.1; it must be between 0 and 1"),
        ({"rate_coefficient": 1.5}, r"rate_coefficient is 1.5; it must be between 0 and 1"),
        ({"reference_rate": 0}, r"reference_rate is 0; it must be positive and finite \[1/s\]"),
    ],
)
def test_bad_values_are_refused(given, said):
    with pytest.raises(ValueError, match=said):
        laws.Body(**ALUMINIUM, **given)
