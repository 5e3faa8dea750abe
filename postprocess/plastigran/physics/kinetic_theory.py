# SPDX-License-Identifier: GPL-2.0-or-later
"""Mean-field cooling of a granular gas with a restitution that depends on impact speed.

The gas is homogeneous, with Maxwellian velocities and smooth equal spheres in binary collisions.
The granular temperature T is a third of the mean square speed [m^2/s^2], per unit mass.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import pi

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike
from scipy.integrate import solve_ivp
from scipy.interpolate import PchipInterpolator

#: Function that returns the restitution (N,) [-] for normal impact speeds (N,) [m/s].
Restitution = Callable[[np.ndarray], np.ndarray]

#: Normal impact speeds for averages over impacts, divided by 2 T^(1/2), where T is the granular
#: temperature. Higher speeds have a probability of exp(-49). The steps are equal, because the
#: restitution has a kink at yield.
_SPEEDS = np.linspace(0, 7, 2801)[1:]

#: Smallest ln(T/T0) in the table of the energy loss, with the granular temperature T and its
#: initial value T0. Below this ln(T/T0), the loss is assumed to be constant.
_DEEPEST = -25.0

#: Highest volume fraction of a fluid of hard spheres (Hoover & Ree 1968, J. Chem. Phys. 49:3609).
FREEZING = 0.494


def contact_value(volume_fraction: ArrayLike) -> np.ndarray:
    """Return the value at contact of the pair correlation function of hard spheres [-].

    The value is (1 - phi/2) / (1 - phi)^3. The volume fraction phi may be an array; the result
    has the same shape. Source: Carnahan & Starling 1969, J. Chem. Phys. 51:635.
    """
    phi = np.asarray(volume_fraction, dtype=float)
    return (1 - 0.5 * phi) / (1 - phi) ** 3


@dataclass(frozen=True)
class Gas:
    """Grains of a gas.

    Attributes:
        radius: Radius of a grain [m].
        volume_fraction: Volume fraction of the grains [-], between 0 and `FREEZING`.
        restitution: Coefficient of restitution as a function of normal impact speed.
        count: Number of grains [-], which determines the statistical error.
    """

    radius: float
    volume_fraction: float
    restitution: Restitution
    count: int

    def collision_rate(self, temperature: ArrayLike) -> np.ndarray:
        """Return the number of collisions of a grain per second, 4 n d^2 chi sqrt(pi T) [1/s].

        n is the number of grains per volume, d the grain diameter and chi the `contact_value`. The
        granular temperature T [m^2/s^2] may have any shape. Source: Chapman & Cowling, The
        Mathematical Theory of Non-uniform Gases (1970), sec. 5.2 and 16.2.
        """
        number_density = self.volume_fraction / (4 / 3 * pi * self.radius**3)
        rate = 16 * number_density * self.radius**2 * contact_value(self.volume_fraction)
        return rate * np.sqrt(pi * np.asarray(temperature, dtype=float))

    def loss(self, temperature: float, power: int = 1) -> float:
        """Return the mean over impacts of ((1 - e^2) g^2 / 4T)^power [-].

        g is the normal impact speed, e the coefficient of restitution and T the granular
        temperature [m^2/s^2]. In a Maxwellian gas, the quantity x = g^2/4T of the impacts has the
        probability density exp(-x). The reason is that the relative normal velocity has the
        variance 2T, and that faster pairs collide more often.
        """
        lost = 1 - self.restitution(2 * temperature**0.5 * _SPEEDS) ** 2
        density = 2 * _SPEEDS * np.exp(-(_SPEEDS**2))
        return float(np.trapezoid(density * (lost * _SPEEDS**2) ** power, _SPEEDS))

    def cooling_rate(self, temperature: float) -> float:
        """Return the cooling rate -d ln T/dt [1/s], with the granular temperature T.

        There are collision_rate/2 impacts per grain and second, because two grains share an impact.
        An impact dissipates m/4 (1 - e^2) g^2, with the mass m of a grain, the restitution e and
        the normal speed g. The mean kinetic energy of a grain is 3/2 m T.
        """
        return float(self.collision_rate(temperature)) * self.loss(temperature) / 3


def cool(gas: Gas, temperature: float, times: ArrayLike) -> pd.DataFrame:
    """Return the granular temperature T of a freely cooling gas versus time.

    The equation is dT/dt = -cooling_rate T. For constant restitution, the solution is Haff's law
    (`haff`). For a restitution that depends on speed, see Brilliantov & Poeschel, Kinetic Theory of
    Granular Gases (2004), ch. 9; this function omits their Sonine terms.

    The temperature of a gas of N = `gas.count` grains fluctuates about this solution. The variance
    `var` of the relative deviation starts at zero and follows from
    var' = -2 d(cooling_rate)/d(ln T) var + collision_rate <(l/(3/2))^2>/2N, where l is the quantity
    that `loss` averages. The first term exists because a hotter gas cools faster. The second term
    assumes that the energy losses of the impacts are independent.

    Args:
        gas: Grains of the gas.
        temperature: Granular temperature at time 0 [m^2/s^2].
        times: Ascending times (N,) [s].

    Returns:
        N rows with the columns `time` [s], `temperature` [m^2/s^2], `temperature_error` [-]
        (relative standard deviation) and `collisions` [-] (number per grain since time 0).
    """
    times = np.asarray(times, dtype=float)

    logarithm = np.log(temperature) + np.linspace(_DEEPEST, 0.1, 400)
    loss, square = (
        PchipInterpolator(logarithm, [gas.loss(t, power) for t in np.exp(logarithm)])
        for power in (1, 2)
    )
    slope = loss.derivative()

    def rates(_: float, y: np.ndarray) -> list[float]:
        x = max(y[0], logarithm[0])
        impacts = float(gas.collision_rate(np.exp(y[0])))
        cooling = impacts * loss(x) / 3
        growth = -2 * impacts / 3 * (0.5 * loss(x) + slope(x))
        return [-cooling, growth * y[1] + impacts / (2 * gas.count) * square(x) / 1.5**2, impacts]

    course = solve_ivp(
        rates,
        (0.0, times[-1]),
        [np.log(temperature), 0.0, 0.0],
        t_eval=times,
        method="LSODA",
        rtol=1e-7,
        atol=[1e-8, 1e-10, 1e-8],
    )
    return pd.DataFrame(
        {
            "time": times,
            "temperature": np.exp(course.y[0]),
            "temperature_error": np.sqrt(np.maximum(course.y[1], 0)),
            "collisions": course.y[2],
        }
    )


def haff(temperature: float, cooling_rate: float, times: ArrayLike) -> np.ndarray:
    """Return the temperature [m^2/s^2] of a gas with constant restitution at given times.

    The granular temperature is T0 / (1 + t/tau)^2 at the time t, with
    2/tau = (1 - e^2) collision_rate/3 at time 0 and the restitution e. Source: Haff 1983, J. Fluid
    Mech. 134:401.

    Args:
        temperature: Granular temperature T0 at time 0 [m^2/s^2].
        cooling_rate: Cooling rate -d ln T/dt at time 0 [1/s].
        times: Times [s], a number or an array. The result has the same shape.
    """
    return temperature / (1 + 0.5 * cooling_rate * np.asarray(times, dtype=float)) ** 2


def law_restitution(law, radius: float, mass: float, speeds: tuple[float, float]) -> Restitution:
    """Return a function that interpolates the restitution of two equal spheres versus speed.

    Args:
        law: Contact law, an instance of a class of `plastigran.laws.LAWS`.
        radius: Radius of a sphere [m].
        mass: Mass of a sphere [kg].
        speeds: Lowest and highest speed of the interpolation [m/s]. Outside this range, the
            restitution is constant.
    """
    speed = np.geomspace(*speeds, 400)
    value = law.central_impact(radius / 2, mass / 2, speed).coefficient_of_restitution
    return lambda g: np.interp(np.log(g), np.log(speed), value)
