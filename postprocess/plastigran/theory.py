# SPDX-License-Identifier: GPL-2.0-or-later
"""Closed forms for central impacts, to hold simulations against."""

from __future__ import annotations

from math import gamma, pi, sqrt

import numpy as np
from numpy.typing import ArrayLike

from plastigran import laws


def hertz_duration(
    mass_eff: float, radius_eff: float, youngs_modulus_eff: float, speed: ArrayLike
) -> np.ndarray:
    """Duration of an elastic impact [s], 2.868 (m*^2 / (R* E*^2 v))^(1/5).

    Args:
        mass_eff: m* [kg].
        radius_eff: R* [m].
        youngs_modulus_eff: E* [Pa].
        speed: Closing speed v [m/s], any shape.

    Source: Hertz 1881; Johnson, Contact Mechanics (1985), sec. 11.4.
    """
    stiffness = 16 / 15 * youngs_modulus_eff * sqrt(radius_eff)
    constant = 4 * sqrt(pi) * gamma(2 / 5) / (5 * gamma(9 / 10))
    return constant * (mass_eff**2 / (stiffness**2 * np.asarray(speed, dtype=float))) ** 0.2


def yield_speed(pair: laws.MaterialPair, mass_eff: float, radius_eff: float) -> float:
    """Closing speed at which a central impact just reaches yield [m/s].

    From 1/2 m* v_y^2 = 2/5 F_y overlap_y; Thornton 1997, J. Appl. Mech. 64:383, eq. 22.
    """
    overlap = radius_eff * laws.yield_radius_ratio(pair) ** 2
    force = 4 / 3 * pair.youngs_modulus_eff * sqrt(radius_eff * overlap) * overlap
    return sqrt(0.8 * force * overlap / mass_eff)


def thornton_restitution(speed_ratio: ArrayLike) -> np.ndarray:
    """Coefficient of restitution of Thornton's law over v/v_y [-], any shape.

    Thornton 1997, J. Appl. Mech. 64:383, eq. 25; 1 at and below yield.
    """
    q = 1 / np.maximum(np.asarray(speed_ratio, dtype=float), 1)
    return (
        np.sqrt(6 * sqrt(3) / 5)
        * np.sqrt(1 - q**2 / 6)
        * (q / (q + 2 * np.sqrt(6 / 5 - q**2 / 5))) ** 0.25
    )
