# SPDX-License-Identifier: GPL-2.0-or-later
"""Measurements of a die compaction: the pressure-density loop, and Heckel's line."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

#: Fraction of the peak pressure at which contact with the bed begins and ends. At lower pressures,
#: the punch touches only single grains that protrude from the bed.
TOUCH = 0.01
#: Fractions of the peak pressure between which Heckel's line is fitted. At these pressures, the
#: rearrangement of the grains has ended.
STRAIGHT = (0.3, 0.9)


@dataclass(frozen=True)
class Loop:
    """Results of one compaction: a loop of loading and unloading.

    Attributes:
        touch: Relative density at the start of loading [-].
        peak: Relative density at the highest pressure [-].
        released: Relative density after unloading [-]; NaN if the pressure does not vanish.
        pressure: Highest pressure [Pa].
    """

    touch: float
    peak: float
    released: float
    pressure: float

    @property
    def permanent(self) -> float:
        """Permanent increase of relative density [-]."""
        return self.released - self.touch

    @property
    def spring_back(self) -> float:
        """Recovered part of the relative density, divided by its value at the peak [-]."""
        return 1 - self.released / self.peak


@dataclass(frozen=True)
class HeckelLine:
    """Heckel's line ln(1/(1 - D)) = K P + A, with the relative density D and the pressure P.

    Attributes:
        slope: Slope K [1/Pa].
        intercept: Intercept A [-].
        correlation: Coefficient of determination R^2 of the fit [-].
    """

    slope: float
    intercept: float
    correlation: float


def measure_loop(density: ArrayLike, pressure: ArrayLike) -> Loop:
    """Measure one loop of loading and unloading.

    Args:
        density: Relative density (n,) [-].
        pressure: Pressure of the punch (n,) [Pa].

    Raises:
        ValueError: The pressure never rises.
    """
    density, pressure = np.asarray(density, dtype=float), np.asarray(pressure, dtype=float)
    top = int(np.argmax(pressure))
    if not pressure[top] > 0:
        raise ValueError(
            f"the highest pressure is {pressure[top]:g} Pa, so the punch does not touch the grains"
        )
    level = TOUCH * pressure[top]
    loading = int(np.argmax(pressure > level))
    gone = np.flatnonzero(pressure[top:] <= level)
    released = np.nan
    if gone.size:
        after = top + gone[0]
        released = _between(density, pressure, after, level)
    touch = _between(density, pressure, loading, level) if loading else density[0]
    return Loop(touch, density[top], released, pressure[top])


def _between(density: np.ndarray, pressure: np.ndarray, row: int, level: float) -> float:
    """Return the density at which the pressure crosses `level`, between `row` - 1 and `row`."""
    ends = slice(row - 1, row + 1)
    order = np.argsort(pressure[ends])
    return float(np.interp(level, pressure[ends][order], density[ends][order]))


def heckel_line(density: ArrayLike, pressure: ArrayLike) -> HeckelLine:
    """Fit Heckel's line to the straight part of a loading curve.

    Args:
        density: Relative density (n,) [-].
        pressure: Pressure of the punch (n,) [Pa], up to its peak.

    Source: Heckel 1961, Trans. Metall. Soc. AIME 221:671. The slope is 1/(3 sigma_Y) for grains of
    yield strength sigma_Y (ibid. 221:1001).
    """
    density, pressure = np.asarray(density, dtype=float), np.asarray(pressure, dtype=float)
    top = int(np.argmax(pressure))
    share = pressure[: top + 1] / pressure[top]
    straight = (share >= STRAIGHT[0]) & (share <= STRAIGHT[1])
    from scipy.stats import linregress  # imported here: scipy.stats is slow

    fit = linregress(pressure[: top + 1][straight], -np.log1p(-density[: top + 1][straight]))
    return HeckelLine(fit.slope, fit.intercept, fit.rvalue**2)


def punch_work(height: ArrayLike, force: ArrayLike) -> np.ndarray:
    """Return the accumulated work of the punch (n,) [J], by trapezoidal integration.

    Args:
        height: Height of the punch (n,) [m].
        force: Upward force on the punch (n,) [N].
    """
    height, force = np.asarray(height, dtype=float), np.asarray(force, dtype=float)
    return -np.append(0, np.cumsum((force[1:] + force[:-1]) / 2 * np.diff(height)))
