# SPDX-License-Identifier: GPL-2.0-or-later
"""Measurements on a die compaction: the pressure-density loop, and Heckel's line through it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.stats import linregress

#: Share of the peak pressure at which grains count as touched and as released. Below it the punch
#: meets single grains that stand out of the bed.
TOUCH = 0.01
#: Pressures over the peak's between which Heckel's line is fitted: after rearrangement.
STRAIGHT = (0.3, 0.9)


@dataclass(frozen=True)
class Loop:
    """What a loop of loading and release shows.

    Attributes:
        touch: Relative density where loading begins [-].
        peak: Relative density at the highest pressure [-].
        released: Relative density where the pressure has gone again [-]; nan if it has not.
        pressure: The highest [Pa].
    """

    touch: float
    peak: float
    released: float
    pressure: float

    @property
    def permanent(self) -> float:
        """Densification that stays [-]."""
        return self.released - self.touch

    @property
    def spring_back(self) -> float:
        """Densification that does not stay, over the density at the peak [-]."""
        return 1 - self.released / self.peak


@dataclass(frozen=True)
class HeckelLine:
    """ln(1/(1 - D)) = slope P + intercept.

    Attributes:
        slope: K [1/Pa].
        intercept: A [-].
        correlation: R^2 of the fit [-].
    """

    slope: float
    intercept: float
    correlation: float


def measure_loop(density: ArrayLike, pressure: ArrayLike) -> Loop:
    """The loop through one loading and one release.

    Args:
        density: Relative density [-], (n,).
        pressure: Of the punch [Pa], (n,).

    Raises:
        ValueError: The pressure never rises.
    """
    density, pressure = np.asarray(density, dtype=float), np.asarray(pressure, dtype=float)
    top = int(np.argmax(pressure))
    if not pressure[top] > 0:
        raise ValueError(f"the highest pressure is {pressure[top]:g} Pa; the punch meets no grain")
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
    """Density where the pressure passes `level`, between `row` and the one before."""
    ends = slice(row - 1, row + 1)
    order = np.argsort(pressure[ends])
    return float(np.interp(level, pressure[ends][order], density[ends][order]))


def heckel_line(density: ArrayLike, pressure: ArrayLike) -> HeckelLine:
    """Heckel's line through the straight part of a loading curve.

    Args:
        density: Relative density [-], (n,).
        pressure: Of the punch [Pa], (n,); up to its peak.

    Source: Heckel 1961, Trans. Metall. Soc. AIME 221:671, who relates the slope to the grains'
    yield strength by 1/(3 sigma_Y) (ibid. 221:1001).
    """
    density, pressure = np.asarray(density, dtype=float), np.asarray(pressure, dtype=float)
    top = int(np.argmax(pressure))
    share = pressure[: top + 1] / pressure[top]
    straight = (share >= STRAIGHT[0]) & (share <= STRAIGHT[1])
    fit = linregress(pressure[: top + 1][straight], -np.log1p(-density[: top + 1][straight]))
    return HeckelLine(fit.slope, fit.intercept, fit.rvalue**2)


def punch_work(height: ArrayLike, force: ArrayLike) -> np.ndarray:
    """Work of the punch so far [J], (n,): the integral of force over travel, by trapezia.

    Args:
        height: Of the punch [m], (n,).
        force: On it, upwards [N], (n,).
    """
    height, force = np.asarray(height, dtype=float), np.asarray(force, dtype=float)
    return -np.append(0, np.cumsum((force[1:] + force[:-1]) / 2 * np.diff(height)))
