# SPDX-License-Identifier: GPL-2.0-or-later
"""The yield strength with which a law gives measured restitutions, and how sure it is.

A measured restitution is the law's times a factor whose logarithm is normal. The strength is the
one of least squares in the logarithm; its 95 % interval holds every strength whose sum of squares
exceeds the least one by no more than chance allows: profile likelihood, which needs no straight
line and may be open where the impacts are nearly elastic. Chance is the wider of two: the scatter
stated for one measurement, taken as known (normal), and the scatter that the measurements show
about the law (Student's t with one degree of freedom less than measurements).
"""

from __future__ import annotations

from collections.abc import Callable
from math import exp, inf, sqrt

import attrs
import numpy as np
from scipy import stats
from scipy.optimize import brentq, minimize_scalar

CONFIDENCE = 0.95
GRID = 48  # strengths at which the misfit is first looked at
ELASTIC = 1 - 1e-6  # restitution of an impact that does not yield


class TooElastic(ValueError):
    """The impacts hardly yield: only a lower bound of the strength can be said."""


@attrs.frozen
class Estimate:
    """A strength from measurements.

    Attributes:
        yield_strength: Of least squares [Pa].
        interval: 95 % [Pa]; its upper end may be infinite.
        residual_scatter: Standard deviation of the measurements about the law [share]; nan of one.
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
        restitution: What the law gives of each impact [-], (N,), at a yield strength [Pa].
        measured: Coefficients of restitution [-], (N,), above 0 and at most 1.
        bounds: Least and largest strength to look at [Pa].
        scatter: Standard deviation of one measurement [share].

    Raises:
        TooElastic: No impact yields at the best strength; the message has the lower bound.
        ValueError: Some restitution is below what the law gives at the least strength, or the
            restitution does not depend on the strength.
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
            f"restitution {measured.min():g} is below what the law gives down to a yield strength "
            f"of {bounds[0]:.3g} Pa; is it of these bodies, and are its units right?"
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
            f"the law's restitution hardly depends on the yield strength here (restitution "
            f"{measured.min():g} to {measured.max():g}); another law or other speeds can tell more"
        )
    if np.all(restitution(exp(at)) > ELASTIC):
        raise TooElastic(
            f"restitution {measured.max():g} is too elastic, it says only a lower bound: the yield "
            f"strength is above {exp(lower):.4g} Pa (95 %)"
        )
    interval = exp(lower), inf if upper is None else exp(upper)
    residual = sqrt(least / (count - 1)) if count > 1 else float("nan")
    return Estimate(exp(at), interval, residual)


def _crossing(excess: Callable[[float], float], start: float, grid: np.ndarray) -> float | None:
    """Where the excess first turns positive along a grid away from the start; None if nowhere."""
    inside = start
    for outside in grid:
        if excess(outside) > 0:
            return brentq(excess, *sorted((inside, outside)), xtol=1e-7)
        inside = outside
    return None
