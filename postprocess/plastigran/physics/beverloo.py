# SPDX-License-Identifier: GPL-2.0-or-later
"""Discharge of grains through a round orifice: Beverloo's law, and the rate in a simulation.

The discharge rate is W = C rho_b sqrt(g) (D0 - k d)^(5/2) in kg/s, independent of the filling level
(Beverloo, Leniger & van de Velde 1961, Chem. Eng. Sci. 15:260). rho_b is the bulk density of the
bed at rest, g the gravitational acceleration, D0 the orifice diameter and d the grain diameter. C
and k are empirical.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import numpy as np
import pandas as pd
from scipy.optimize import curve_fit

#: Ranges of C and k in experiments, for spheres and other grains: Nedderman, Tuzun, Savage &
#: Houlsby 1982, Chem. Eng. Sci. 37:1597, and Mankoc et al. 2007, Granular Matter 9:407.
COEFFICIENTS = (0.55, 0.65)
EMPTY_ANNULI = (1.0, 2.0)

#: Smallest volume fraction of a packing of spheres. If the measured volume fraction is lower, the
#: bed is too shallow for the measurement.
LOOSEST = 0.5
#: Discharged fraction of the grains at which the steady discharge ends, because the surface of the
#: bed is then near the cone of the hopper.
STEADY_SHARE = 0.5
#: Number of time blocks of equal length whose scatter gives the error of the rate; must be even.
BLOCKS = 10


def discharge_rate(
    orifice: float,
    diameter: float,
    bulk_density: float,
    gravitational_acceleration: float,
    coefficient: float,
    empty_annulus: float,
) -> float:
    """Return the discharge rate by Beverloo's law [kg/s].

    Args:
        orifice: Orifice diameter [m].
        diameter: Grain diameter [m].
        bulk_density: Bulk density of the bed at rest [kg/m^3].
        gravitational_acceleration: Gravitational acceleration [m/s^2].
        coefficient: Constant C of Beverloo's law [-].
        empty_annulus: Constant k of Beverloo's law [-]; grain centers stay k/2 diameters away from
            the rim.

    Raises:
        ValueError: The orifice is at most k grain diameters wide.
    """
    effective = orifice - empty_annulus * diameter
    if effective <= 0:
        raise ValueError(
            f"orifice is {orifice:g} m; Beverloo's law needs more than {empty_annulus:g} grain "
            f"diameters of {diameter:g} m"
        )
    return coefficient * bulk_density * gravitational_acceleration**0.5 * effective**2.5


@dataclass(frozen=True)
class Discharge:
    """Steady discharge in a simulation.

    Attributes:
        orifice: Orifice diameter [m].
        diameter: Grain diameter [m].
        bulk_density: Bulk density of the bed before the orifice opened [kg/m^3].
        gravitational_acceleration: Gravitational acceleration [m/s^2].
        rate: Discharge rate [kg/s].
        rate_error: Standard deviation of the rate, from the scatter between time blocks [kg/s].
        change: Change of the rate from the first to the second half of the steady part [kg/s].
        change_error: Standard deviation of `change`, from the scatter between the time blocks of
            each half [kg/s].
        start: Start of the steady part [s].
        stop: End of the steady part [s].
        coefficient: Constant C of Beverloo's law, for comparison [-].
        empty_annulus: Constant k of Beverloo's law, for comparison [-].
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
        """Rate that Beverloo's law predicts with `coefficient` and `empty_annulus` [kg/s]."""
        return self._rate(self.coefficient, self.empty_annulus)

    @property
    def band(self) -> tuple[float, float]:
        """Smallest and largest rate by Beverloo's law with C and k from experiments [kg/s]."""
        return (
            self._rate(min(COEFFICIENTS), max(EMPTY_ANNULI)),
            self._rate(max(COEFFICIENTS), min(EMPTY_ANNULI)),
        )

    def _rate(self, coefficient: float, empty_annulus: float) -> float:
        of_bed = self.orifice, self.diameter, self.bulk_density, self.gravitational_acceleration
        return discharge_rate(*of_bed, coefficient, empty_annulus)

    @property
    def reduced(self) -> float:
        """Reduced discharge rate (W/(rho_b sqrt(g)))^(2/5) [m].

        W is the discharge rate, rho_b the bulk density and g the gravitational acceleration. In
        Beverloo's law, the reduced rate is a linear function of the orifice diameter.
        """
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
    """Measure the rate of the steady discharge: fit a line to the discharged grains versus time.

    The steady part begins after the time of a free fall by one orifice diameter, during which the
    flow develops. It ends when `STEADY_SHARE` of the grains are discharged, because the surface of
    the bed is then near the cone of the hopper.

    Args:
        series: Table with the columns time [s] since the orifice opened, atoms (grains), counted
            (discharged grains), and packing (volume fraction of the bed; only the first row is
            used).
        orifice: Orifice diameter [m].
        diameter: Grain diameter [m].
        density: Grain density [kg/m^3].
        gravitational_acceleration: Gravitational acceleration [m/s^2].
        coefficient: Constant C of Beverloo's law, for comparison [-].
        empty_annulus: Constant k of Beverloo's law, for comparison [-].

    Returns:
        The discharge. None if the simulation ended too early, if the steady part has fewer than two
        rows per time block, or if the bed is too shallow.
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
    """Constants C and k of Beverloo's law and their standard deviations in the fit [-]."""

    coefficient: float
    coefficient_error: float
    empty_annulus: float
    empty_annulus_error: float


def fit_constants(discharges: list[Discharge]) -> Constants:
    """Fit C and k of Beverloo's law by a line through the reduced rates versus orifice diameter.

    Raises:
        ValueError: There are fewer than three orifice diameters, or several grain diameters.
    """
    diameters = {discharge.diameter for discharge in discharges}
    orifices = [discharge.orifice for discharge in discharges]
    if len(set(orifices)) < 3 or len(diameters) != 1:
        raise ValueError(
            "C and k of Beverloo's law cannot be fitted: the fit needs three or more orifice "
            f"diameters and one grain diameter, but the runs have {len(set(orifices))} and "
            f"{len(diameters)}"
        )
    diameter = diameters.pop()
    fitted, covariance = curve_fit(
        lambda width, coefficient, annulus: coefficient**0.4 * (width - annulus * diameter),
        np.array(orifices),
        np.array([discharge.reduced for discharge in discharges]),
        p0=(discharges[0].coefficient, discharges[0].empty_annulus),
    )
    errors = np.sqrt(np.diag(covariance))
    return Constants(float(fitted[0]), float(errors[0]), float(fitted[1]), float(errors[1]))
