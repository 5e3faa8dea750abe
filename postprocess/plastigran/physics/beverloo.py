# SPDX-License-Identifier: GPL-2.0-or-later
"""Discharge of grains through a round orifice: Beverloo's law, and the rate of a run.

Grains leave at W = C rho_b sqrt(g) (D0 - k d)^(5/2), whatever the level above: Beverloo, Leniger &
van de Velde 1961, Chem. Eng. Sci. 15:260. rho_b is the density of the bed at rest, D0 the orifice's
diameter, d a grain's. C and k are empirical.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import numpy as np
import pandas as pd
from scipy.optimize import curve_fit

#: What experiments scatter between, spheres and other grains: C and k of Nedderman, Tuzun, Savage &
#: Houlsby 1982, Chem. Eng. Sci. 37:1597, and Mankoc et al. 2007, Granular Matter 9:407.
COEFFICIENTS = (0.55, 0.65)
EMPTY_ANNULI = (1.0, 2.0)

#: Spheres pack no looser; a bed found to was too shallow to measure.
LOOSEST = 0.5
#: The steady part ends when this share of the grains is out: the level nears the cone.
STEADY_SHARE = 0.5
#: Blocks of equal time the steady part is cut into, for the error of its rate; an even number.
BLOCKS = 10


def discharge_rate(
    orifice: float,
    diameter: float,
    bulk_density: float,
    gravitational_acceleration: float,
    coefficient: float,
    empty_annulus: float,
) -> float:
    """Beverloo's law [kg/s].

    Args:
        orifice: Diameter of the orifice [m].
        diameter: Of a grain [m].
        bulk_density: Of the bed at rest [kg/m^3].
        gravitational_acceleration: [m/s^2].
        coefficient: C [-].
        empty_annulus: k [-]; no grain's centre passes within k/2 diameters of the rim.

    Raises:
        ValueError: The orifice is no wider than k grains.
    """
    effective = orifice - empty_annulus * diameter
    if effective <= 0:
        raise ValueError(
            f"orifice is {orifice:g} m; Beverloo's law needs more than {empty_annulus:g} grains of "
            f"{diameter:g} m"
        )
    return coefficient * bulk_density * gravitational_acceleration**0.5 * effective**2.5


@dataclass(frozen=True)
class Discharge:
    """The steady discharge of a run.

    Attributes:
        orifice: Diameter of the orifice [m].
        diameter: Of a grain [m].
        bulk_density: Of the bed before the orifice opened [kg/m^3].
        gravitational_acceleration: [m/s^2].
        rate: Of discharge [kg/s].
        rate_error: One standard deviation of it, from its blocks [kg/s].
        change: Of the rate from the first half of the steady part to the second [kg/s].
        change_error: One standard deviation of it, from the blocks of each half [kg/s].
        start: Of the steady part [s].
        stop: Of the steady part [s].
        coefficient: C of the law it is held against [-].
        empty_annulus: k of the law it is held against [-].
    """

    orifice: float
    diameter: float
    bulk_density: float
    gravitational_acceleration: float
    rate: float
    rate_error: float
    change: float
    change_error: float
    start: float
    stop: float
    coefficient: float
    empty_annulus: float

    @property
    def predicted(self) -> float:
        """Beverloo's law with its C and k [kg/s]."""
        return self._rate(self.coefficient, self.empty_annulus)

    @property
    def band(self) -> tuple[float, float]:
        """Least and greatest rate within the scatter of C and k [kg/s]."""
        return (
            self._rate(min(COEFFICIENTS), max(EMPTY_ANNULI)),
            self._rate(max(COEFFICIENTS), min(EMPTY_ANNULI)),
        )

    def _rate(self, coefficient: float, empty_annulus: float) -> float:
        of_bed = self.orifice, self.diameter, self.bulk_density, self.gravitational_acceleration
        return discharge_rate(*of_bed, coefficient, empty_annulus)

    @property
    def reduced(self) -> float:
        """(W/(rho_b sqrt(g)))^(2/5) [m], a straight line over the orifice by Beverloo's law."""
        return (self.rate / (self.bulk_density * self.gravitational_acceleration**0.5)) ** 0.4


def measure_discharge(
    series: pd.DataFrame,
    orifice: float,
    diameter: float,
    density: float,
    gravitational_acceleration: float,
    coefficient: float,
    empty_annulus: float,
) -> Discharge | None:
    """The rate of the steady part of a discharge: a line through the grains out over time.

    The first part is left out, sqrt(2 D0/g), in which a grain falls freely from an orifice's
    diameter above: until then those that leave were not yet in flow. So is the last, from
    `STEADY_SHARE` of the grains on, when the level nears the cone.

    Args:
        series: Columns time [s], since the orifice opened, atoms, counted, the grains out, and
            packing, the share of the bed that is grains, which is taken at the first row.
        orifice: Diameter of the orifice [m].
        diameter: Of a grain [m].
        density: Of a grain [kg/m^3].
        gravitational_acceleration: [m/s^2].
        coefficient: C of the law it is held against [-].
        empty_annulus: k of the law it is held against [-].

    Returns:
        None where the run ended before, has not two rows a block, or its bed was too shallow.
    """
    grains, out = series["atoms"].iloc[0], series["counted"]
    early = series["time"] < (2 * orifice / gravitational_acceleration) ** 0.5
    late = out > STEADY_SHARE * grains
    steady = series[~early & ~late]
    packing = float(series["packing"].iloc[0])
    if len(steady) < 2 * BLOCKS or not late.any() or packing < LOOSEST:
        return None
    mass = pi / 6 * diameter**3 * density
    time, counted = steady["time"].to_numpy(), steady["counted"].to_numpy()
    edges = np.linspace(0, len(time) - 1, BLOCKS + 1).astype(int)
    rates = mass * np.diff(counted[edges]) / np.diff(time[edges])
    halves = rates.reshape(2, -1)
    return Discharge(
        orifice,
        diameter,
        packing * density,
        gravitational_acceleration,
        mass * float(np.polyfit(time, counted, 1)[0]),
        float(rates.std(ddof=1)) / BLOCKS**0.5,
        float(np.diff(halves.mean(axis=1))[0]),
        float(np.hypot(*halves.std(axis=1, ddof=1))) / (BLOCKS / 2) ** 0.5,
        float(time[0]),
        float(time[-1]),
        coefficient,
        empty_annulus,
    )


@dataclass(frozen=True)
class Constants:
    """Beverloo's constants of several orifices, with one standard deviation of the fit [-]."""

    coefficient: float
    coefficient_error: float
    empty_annulus: float
    empty_annulus_error: float


def fit_constants(discharges: list[Discharge]) -> Constants:
    """C and k from a line through rate^(2/5) over the orifice.

    Raises:
        ValueError: Fewer than three orifices, or grains of different sizes.
    """
    diameters = {discharge.diameter for discharge in discharges}
    orifices = [discharge.orifice for discharge in discharges]
    if len(set(orifices)) < 3 or len(diameters) != 1:
        raise ValueError("C and k need three orifices or more, with grains of one size")
    diameter = diameters.pop()
    found, covariance = curve_fit(
        lambda width, coefficient, annulus: coefficient**0.4 * (width - annulus * diameter),
        np.array(orifices),
        np.array([discharge.reduced for discharge in discharges]),
        p0=(discharges[0].coefficient, discharges[0].empty_annulus),
    )
    errors = np.sqrt(np.diag(covariance))
    return Constants(float(found[0]), float(errors[0]), float(found[1]), float(errors[1]))
