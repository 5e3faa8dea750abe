# SPDX-License-Identifier: GPL-2.0-or-later
"""Yield strength with which a law reproduces measured restitutions, and its uncertainty.

A measured restitution is the law's restitution times a log-normal factor. The estimated strength
minimizes the sum of squares of the logarithm of this factor. The 95 % interval contains every
strength whose sum of squares is not significantly larger than the smallest sum (profile
likelihood). This method needs no linearization. The interval has no upper end if the impacts are
nearly elastic.

The interval is the larger of two intervals. The first interval uses the stated scatter of a
measurement and a normal distribution. The second interval uses the scatter of the n measurements
about the law, and Student's t distribution with n - 1 degrees of freedom.
"""

from __future__ import annotations

from collections.abc import Callable
from math import exp, inf, nan, sqrt

import attrs
import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import brentq, minimize_scalar
from scipy.special import ndtri, stdtrit

CONFIDENCE = 0.95
GRID = 48  # number of strengths for the first search
ELASTIC = 1 - 1e-6  # an impact with at least this restitution counts as elastic


@attrs.frozen
class Estimate:
    """Yield strength that was estimated from measured restitutions.

    Attributes:
        yield_strength: Least-squares value [Pa].
        interval: 95 % interval [Pa]; its upper end may be infinite.
        residual_scatter: Relative standard deviation of the measurements about the law; NaN for
            one measurement.
    """

    yield_strength: float
    interval: tuple[float, float]
    residual_scatter: float


def estimate_strength(
    restitution: Callable[[float], np.ndarray],
    measured: ArrayLike,
    bounds: tuple[float, float],
    scatter: float,
) -> Estimate:
    """Fit the yield strength to measured restitutions.

    Args:
        restitution: Function that returns the restitution of each impact (N,) by the law, for a
            yield strength [Pa].
        measured: Coefficients of restitution (N,), above 0 and at most 1.
        bounds: Smallest and largest strength of the search [Pa].
        scatter: Relative standard deviation of one measurement.

    Raises:
        ValueError: No impact yields at the best strength; the message states the lower bound. Or a
            measured restitution is lower than the restitution by the law at the smallest strength.
            Or the restitution does not depend on the strength.
    """
    measured = np.asarray(measured, dtype=float)
    target = np.log(measured)

    def misfit(logarithm: float) -> float:
        predicted = np.maximum(restitution(exp(logarithm)), 1e-12)
        return float(np.sum((np.log(predicted) - target) ** 2))

    grid = np.linspace(*np.log(bounds), GRID)
    values = np.array([misfit(logarithm) for logarithm in grid])
    lowest = int(np.argmin(values))
    if lowest == 0:
        raise ValueError(
            f"restitution {measured.min():g} is too low: the law does not reach it even at the "
            f"lowest yield strength tried, {bounds[0]:.3g} Pa. Check the materials of ball and "
            "plate and the units of the data"
        )
    around = grid[lowest - 1], grid[min(lowest + 1, GRID - 1)]
    search = minimize_scalar(misfit, bounds=around, method="bounded", options={"xatol": 1e-7})
    best, least = grid[lowest], values[lowest]
    if search.fun < least:
        best, least = search.x, search.fun

    allowed = (ndtri(0.5 + CONFIDENCE / 2) * scatter) ** 2
    residual, freedom = nan, len(measured) - 1
    if freedom:
        residual = sqrt(least / freedom)
        quantile = stdtrit(freedom, 0.5 + CONFIDENCE / 2)
        allowed = max(allowed, quantile**2 * least / freedom)

    def excess(logarithm: float) -> float:
        return misfit(logarithm) - least - allowed

    lower = _first_positive(excess, best, grid[grid < best][::-1])
    upper = _first_positive(excess, best, grid[grid > best])
    if lower is None:
        raise ValueError(
            "the law's restitution hardly depends on the yield strength here (restitution "
            f"{measured.min():g} to {measured.max():g}). Use another law or other speeds"
        )
    if np.all(restitution(exp(best)) > ELASTIC):
        raise ValueError(
            f"restitution {measured.max():g} is almost elastic and gives only a lower bound: "
            f"the yield strength is above {exp(lower):.4g} Pa (95 %)"
        )
    return Estimate(exp(best), (exp(lower), inf if upper is None else exp(upper)), residual)


def _first_positive(
    excess: Callable[[float], float], start: float, grid: np.ndarray
) -> float | None:
    """Return the value at which `excess` first becomes positive along a grid, or None."""
    inside = start
    for outside in grid:
        if excess(outside) > 0:
            return brentq(excess, *sorted((inside, outside)), xtol=1e-7)
        inside = outside
    return None
