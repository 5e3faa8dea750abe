# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the yield strength from restitution: its value, and its confidence interval."""

from __future__ import annotations

from math import inf, isnan

import numpy as np
import pytest

from plastigran import laws
from plastigran.calibration.inversion import estimate_strength

TRUTH = 1e8
BOUNDS = 1e5, 2e10
SPEEDS = np.geomspace(0.02, 0.3, 6)


def thornton(strength: float, speeds: np.ndarray = SPEEDS) -> np.ndarray:
    """Return the restitutions of an aluminum sphere on a rigid plane by the law `thornton`."""
    pair = laws.combine(laws.Body(70e9, 0.3, strength), laws.Body(1e30, 0.3))
    mass = 4 / 3 * np.pi * 0.005**3 * 2700
    return (
        laws.LAWS["thornton"](pair).central_impact(0.005, mass, speeds).coefficient_of_restitution
    )


@pytest.mark.parametrize("count", [1, 2, 5])
def test_95_of_100_intervals_contain_the_strength(count):
    """The interval contains the true strength in at least 95 of 100 drop tests with 2 % noise.

    The interval is the wider of two 95 % confidence intervals.
    """
    random = np.random.default_rng(count)
    true = thornton(TRUTH, SPEEDS[:count])
    contained = 0
    for _ in range(100):
        measured = true * np.exp(0.02 * random.standard_normal(count))
        estimate = estimate_strength(lambda s: thornton(s, SPEEDS[:count]), measured, BOUNDS, 0.02)
        contained += estimate.interval[0] <= TRUTH <= estimate.interval[1]
    assert contained >= 95


def test_without_noise_the_strength_is_exact():
    estimate = estimate_strength(thornton, thornton(TRUTH), BOUNDS, 0.02)
    assert estimate.yield_strength == pytest.approx(TRUTH, rel=1e-5)  # accuracy of the search
    assert estimate.residual_scatter < 1e-6
    assert estimate.interval[0] < TRUTH < estimate.interval[1]


def test_interval_of_one_drop_is_the_stated_scatter():
    """With one drop, the interval of the strength follows from the stated scatter.

    Far beyond yield, restitution is proportional to the strength to the power 5/8. This follows
    from Thornton 1997, eq. 25: restitution is proportional to (v_Y/v)^(1/4), and v_Y to the
    strength to the power 5/2.
    """
    speed = np.array([1.0])
    estimate = estimate_strength(lambda s: thornton(s, speed), thornton(TRUTH, speed), BOUNDS, 0.02)
    half = 1.96 * 0.02 / (5 / 8)
    assert isnan(estimate.residual_scatter)
    # v/v_Y is about 600: the power is 5/8 within 1 %.
    assert np.log(estimate.interval[1] / TRUTH) == pytest.approx(half, rel=0.02)
    assert np.log(TRUTH / estimate.interval[0]) == pytest.approx(half, rel=0.02)


def test_more_drops_narrow_the_interval():
    few = estimate_strength(thornton, thornton(TRUTH), BOUNDS, 0.02)
    one = estimate_strength(
        lambda s: thornton(s, SPEEDS[:1]), thornton(TRUTH, SPEEDS[:1]), BOUNDS, 0.02
    )
    assert few.interval[1] / few.interval[0] < one.interval[1] / one.interval[0]


def test_impacts_near_yield_leave_the_interval_open():
    speed = np.array([0.01])
    estimate = estimate_strength(lambda s: thornton(s, speed), np.array([0.99]), BOUNDS, 0.02)
    assert estimate.interval[1] == inf
    assert 0 < estimate.interval[0] < estimate.yield_strength


def test_elastic_impacts_give_a_lower_bound_only():
    with pytest.raises(ValueError, match=r"restitution 1 .* above (\S+) Pa") as raised:
        estimate_strength(thornton, np.ones(len(SPEEDS)), BOUNDS, 0.02)
    bound = float(str(raised.value).split("above ")[1].split()[0])
    # At the bound, the misfit is the largest that chance allows.
    misfit = np.sum(np.log(thornton(bound)) ** 2)
    assert misfit == pytest.approx((1.96 * 0.02) ** 2, rel=0.01)


def test_restitution_below_that_of_the_law_is_refused():
    with pytest.raises(ValueError, match=r"restitution 0.0001 is too low"):
        estimate_strength(thornton, np.full(len(SPEEDS), 1e-4), BOUNDS, 0.02)


def test_a_law_that_does_not_depend_on_the_strength_is_refused():
    with pytest.raises(ValueError, match="hardly depends on the yield strength"):
        estimate_strength(
            lambda s: np.full(2, 0.5 - 1e-9 * np.log(s)), np.array([0.3, 0.4]), BOUNDS, 0.02
        )
