# SPDX-License-Identifier: GPL-2.0-or-later
"""Yield strength with which a law reproduces measured restitutions, and its uncertainty.

A measured restitution is the law's times a log-normal factor. The strength has the least squares of
the logarithm. Its 95 % interval contains every strength whose sum of squares exceeds the least one
only by chance (profile likelihood). This needs no linearization; the interval may be open if the
impacts are nearly elastic. The larger of two scatters is used: the stated scatter of one
measurement
(normal distribution), and the scatter of the measurements about the law (Student's t with one
degree
of freedom less than measurements).
"""

from __future__ import annotations

from collections.abc import Callable
from math import exp, inf, sqrt

import attrs
import numpy as np
from scipy import stats
from scipy.optimize import brentq, minimize_scalar

CONFIDENCE = 0.95
GRID = 48  # number of strengths for the first search
ELASTIC = 1 - 1e-6  # restitution from which an impact counts as elastic


class TooElastic(ValueError):
    """The impacts hardly yield, so there is only a lower bound of the strength."""


@attrs.frozen
class Estimate:
    """Strength from measurements.

    Attributes:
        yield_strength: Least-squares value [Pa].
        interval: 95 % interval [Pa]; its upper end may be infinite.
        residual_scatter: Relative standard deviation of the measurements about the law; NaN for
            one.
    """

    yield_strength: float
    interval: tuple[float, float]
    residual_scatter: float


def estimate_strength(
    restitution: Callable[[float], np.ndarray],
    measured: np.ndarray,
    bounds: tuple[float, float],
    scatter: float,
) -> Estimate:
    """Fit the yield strength to measured restitutions.

    Args:
        restitution: Function from yield strength [Pa] to the law's restitution of each impact (N,).
        measured: Coefficients of restitution (N,), above 0 and at most 1.
        bounds: Smallest and largest strength of the search [Pa].
        scatter: Relative standard deviation of one measurement.

    Raises:
        TooElastic: No impact yields at the best strength; the message has the lower bound.
        ValueError: A restitution is below that at the smallest strength, or the restitution does
            not depend on the strength.
    """
    measured = np.asarray(measured, dtype=float)
    target = np.log(measured)

    def misfit(logarithm: float) -> float:
        found = np.maximum(restitution(exp(logarithm)), 1e-12)
        return float(np.sum((np.log(found) - target) ** 2))

    grid = np.linspace(*np.log(bounds), GRID)
    values = np.array([misfit(at) for at in grid])
    lowest = int(np.argmin(values))
    if lowest == 0:
        raise ValueError(
            f"restitution {measured.min():g} is too low: the law does not reach it even at the "
            f"lowest yield strength tried, {bounds[0]:.3g} Pa. Check the materials of ball and "
            "plate and the units of the data"
        )
    around = grid[max(lowest - 1, 0)], grid[min(lowest + 1, GRID - 1)]
    best = minimize_scalar(misfit, bounds=around, method="bounded", options={"xatol": 1e-7})
    at, least = (best.x, best.fun) if best.fun < values[lowest] else (grid[lowest], values[lowest])

    count = len(measured)
    allowed = (stats.norm.ppf(0.5 + CONFIDENCE / 2) * scatter) ** 2
    if count > 1:
        shown = least / (count - 1)
        allowed = max(allowed, stats.t.ppf(0.5 + CONFIDENCE / 2, count - 1) ** 2 * shown)

    def excess(logarithm: float) -> float:
        return misfit(logarithm) - least - allowed

    lower, upper = (
        _crossing(excess, at, side) for side in (grid[grid < at][::-1], grid[grid > at])
    )
    if lower is None:
        raise ValueError(
            "the law's restitution hardly depends on the yield strength here (restitution "
            f"{measured.min():g} to {measured.max():g}). Use another law or other speeds"
        )
    if np.all(restitution(exp(at)) > ELASTIC):
        raise TooElastic(
            f"restitution {measured.max():g} is almost elastic and gives only a lower bound: "
            f"the yield strength is above {exp(lower):.4g} Pa (95 %)"
        )
    interval = exp(lower), inf if upper is None else exp(upper)
    residual = sqrt(least / (count - 1)) if count > 1 else float("nan")
    return Estimate(exp(at), interval, residual)


def _crossing(excess: Callable[[float], float], start: float, grid: np.ndarray) -> float | None:
    """Return where the excess first becomes positive along a grid; None if nowhere."""
    inside = start
    for outside in grid:
        if excess(outside) > 0:
            return brentq(excess, *sorted((inside, outside)), xtol=1e-7)
        inside = outside
    return None
