# SPDX-License-Identifier: GPL-2.0-or-later
"""Adhesive spheres: sticking speed of an impact, and pull-off force."""

from __future__ import annotations

from math import pi

import numpy as np
from numpy.typing import ArrayLike

from plastigran import laws


def _separation_work() -> float:
    """Return the work of separation of JKR spheres, from zero overlap to pull-off [-].

    The work is divided by (Gamma^5 R*^4/E*^2)^(1/3), with the work of adhesion Gamma, the effective
    radius R* and the effective Young's modulus E*. Let a be the contact radius, E* = R* = Gamma = 1
    and c = (2 pi)^(1/2). In the JKR theory, force and overlap are then polynomials in a^(1/2).
    """
    c = (2 * pi) ** 0.5
    overlap = np.polynomial.Polynomial([0, -c, 0, 0, 1])
    force = np.polynomial.Polynomial([0, 0, 0, -2 * c, 0, 0, 4 / 3])
    work = (force * overlap.deriv()).integ()
    return float(work((c / 4) ** (1 / 3)) - work(c ** (1 / 3)))


_SEPARATION_WORK = _separation_work()


def jkr_sticking_speed(
    surface_energy: ArrayLike,
    radius_eff: ArrayLike,
    youngs_modulus_eff: ArrayLike,
    mass_eff: ArrayLike,
) -> np.ndarray | float:
    """Return the speed below which adhesive elastic spheres stick [m/s].

    The work between first touch and pull-off equals 1/2 m* v^2 (Johnson, Kendall & Roberts 1971,
    Proc. R. Soc. Lond. A 324:301; Thornton & Ning 1998, Powder Technol. 99:154).

    Args:
        surface_energy: Work of adhesion Gamma [J/m2].
        radius_eff: Effective radius R* [m].
        youngs_modulus_eff: Effective Young's modulus E* [Pa].
        mass_eff: Effective mass m* [kg].
    """
    gamma, radius = np.asarray(surface_energy, float), np.asarray(radius_eff, float)
    work = _SEPARATION_WORK * np.cbrt(gamma**5 * radius**4 / np.square(youngs_modulus_eff))
    return np.sqrt(2 * work / mass_eff)[()]


def jkr_surface_energy(
    sticking_speed: ArrayLike,
    radius_eff: ArrayLike,
    youngs_modulus_eff: ArrayLike,
    mass_eff: ArrayLike,
) -> np.ndarray | float:
    """Return the work of adhesion [J/m2] for a sticking speed.

    This function is the inverse of `jkr_sticking_speed`.

    Args:
        sticking_speed: Speed below which the spheres stick [m/s].
        radius_eff, youngs_modulus_eff, mass_eff: As for `jkr_sticking_speed`.
    """
    work = 0.5 * np.asarray(mass_eff, float) * np.square(sticking_speed) / _SEPARATION_WORK
    gamma = (work**3 * np.square(youngs_modulus_eff) / np.power(radius_eff, 4.0)) ** 0.2
    return gamma[()]


def sticking_speed(
    law: laws.Law, radius_eff: float, mass_eff: float, slowest: float = 1e-6, fastest: float = 1e2
) -> float:
    """Return the largest speed at which two bodies stick [m/s]; 0 if they stick at no speed.

    The search starts at the fastest speed. With some laws, such as `luding_2008`, the bodies
    rebound at low speeds but stick at higher speeds.

    Args:
        law: Law between the bodies.
        radius_eff: Effective radius R* [m].
        mass_eff: Effective mass m* [kg].
        slowest, fastest: Bounds of the search [m/s]. The search tries 64 speeds, then bisects. It
            omits speeds at which the overlap would be too large to compute.

    Raises:
        ValueError: The bodies stick at the fastest speed that can be computed, or no speed can be
            computed.
    """

    def sticks(speed: float) -> bool:
        return law.central_impact(radius_eff, mass_eff, speed).coefficient_of_restitution == 0

    upper = None  # lowest speed so far at which the bodies rebound
    for lower in np.geomspace(fastest, slowest, 64):
        try:
            if sticks(lower):
                break
        except ValueError:
            if upper is None and lower > slowest:
                continue
            raise
        upper = lower
    else:
        return 0.0
    if upper is None:
        raise ValueError(f"the bodies stick even at {lower:.4g} m/s, the highest speed tried")
    while upper > lower * (1 + 1e-12):
        middle = (lower * upper) ** 0.5
        lower, upper = (middle, upper) if sticks(middle) else (lower, middle)
    return float(lower)


def plastic_pull_off_force(
    surface_energy: float, youngs_modulus_eff: float, pressure: float, contact_radius: float
) -> float:
    """Return the pull-off force of a fully plastic contact that unloads elastically [N].

    At the largest load, the pressure p is the same over the whole contact of radius a_0. During
    unloading to a smaller contact radius a, the force is

        F = 2 p a_0^2 (asin x - x (1 - x^2)^(1/2)) - (8 pi E* Gamma a^3)^(1/2),   x = a/a_0

    The pull-off force is the largest attractive force. The first term is a superposition of flat
    punches, as in Mesarovic & Johnson 2000 (J. Mech. Phys. Solids 48:2009). The second term is the
    adhesion in the JKR theory.

    Args:
        surface_energy: Work of adhesion Gamma [J/m2].
        youngs_modulus_eff: Effective Young's modulus E* [Pa].
        pressure: Mean pressure p at the largest load, without adhesion [Pa].
        contact_radius: Contact radius a_0 at the largest load [m].
    """
    from scipy.optimize import minimize_scalar  # imported here: scipy.optimize is slow

    def force(x: float) -> float:
        punch = 2 * pressure * contact_radius**2 * (np.arcsin(x) - x * np.sqrt(1 - x * x))
        cube = (x * contact_radius) ** 3
        return float(punch - np.sqrt(8 * pi * youngs_modulus_eff * surface_energy * cube))

    return -minimize_scalar(force, bounds=(0, 1), method="bounded", options={"xatol": 1e-10}).fun
