# SPDX-License-Identifier: GPL-2.0-or-later
"""Laws whose yield strength grows with the strain rate of the impact, tested without LIGGGHTS."""

from __future__ import annotations

import numpy as np
import pytest

from plastigran import laws
from plastigran.materials import RIGID

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
YIELDING = sorted(name for name, law in laws.LAWS.items() if law.yields and not law.adhesive)


def stronger(factor: float, **rate: float) -> laws.MaterialPair:
    strength = factor * ALUMINIUM["yield_strength"]
    return laws.combine(laws.Body(**ALUMINIUM | {"yield_strength": strength}, **rate), RIGID)


def test_factor():
    """The rate factor is 1 + C ln(rate/reference), with the rate coefficient C and the rate v/R.

    It is rounded to 1e-4, and is 1 up to the reference rate.
    """
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
    """An impact equals the impact of a body with the yield strength at its strain rate.

    The relative tolerance 1e-9 is round-off, because the rate factor multiplies the yield strength
    or the yield pressure.
    """
    factor = laws.rate_factor(PAIR, RADIUS, speed)
    assert factor > 1.05
    found = law_between(name, PAIR, LENGTH).central_impact(RADIUS, MASS, speed)
    expected = law_between(name, stronger(factor), LENGTH).central_impact(RADIUS, MASS, speed)
    for outcome in OUTCOMES:
        assert getattr(found, outcome) == pytest.approx(getattr(expected, outcome), rel=1e-9)


def test_given_hardness_grows_too():
    """The rate factor also multiplies constants in Pa, such as a hardness that the user gives."""
    factor = laws.rate_factor(PAIR, RADIUS, 0.2)
    found = laws.Brake2015(PAIR, indentation_pressure=3e8).central_impact(RADIUS, MASS, 0.2)
    hard = laws.Brake2015(stronger(factor), indentation_pressure=factor * 3e8)
    expected = hard.central_impact(RADIUS, MASS, 0.2)
    assert found.force_max == pytest.approx(expected.force_max, rel=1e-9)


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
