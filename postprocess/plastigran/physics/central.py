# SPDX-License-Identifier: GPL-2.0-or-later
"""Closed forms for central impacts, for comparison with simulations."""

from __future__ import annotations

from math import gamma, log, pi, sqrt

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import betainc

from plastigran import laws


def hertz_duration(
    radius_eff: float, mass_eff: float, youngs_modulus_eff: float, speed: ArrayLike
) -> np.ndarray:
    """Return the duration of an elastic impact [s], 2.868 (m*^2 / (R* E*^2 v))^(1/5).

    Args:
        radius_eff: Effective radius R* [m].
        mass_eff: Effective mass m* [kg].
        youngs_modulus_eff: Effective Young's modulus E* [Pa].
        speed: Closing speed v [m/s], any shape.

    Source: Hertz 1881; Johnson, Contact Mechanics (1985), sec. 11.4.
    """
    stiffness = 16 / 15 * youngs_modulus_eff * sqrt(radius_eff)
    constant = 4 * sqrt(pi) * gamma(2 / 5) / (5 * gamma(9 / 10))
    return constant * (mass_eff**2 / (stiffness**2 * np.asarray(speed, dtype=float))) ** 0.2


def hertz_overlap_max(
    radius_eff: float, mass_eff: float, youngs_modulus_eff: float, speed: ArrayLike
) -> np.ndarray:
    """Return the largest overlap of an elastic impact [m], (15 m* v^2 / (16 E* sqrt(R*)))^(2/5).

    Arguments and source are as for `hertz_duration`.
    """
    work = 16 / 15 * youngs_modulus_eff * sqrt(radius_eff)
    return (mass_eff * np.asarray(speed, dtype=float) ** 2 / work) ** 0.4


def hertz_force_max(
    radius_eff: float, mass_eff: float, youngs_modulus_eff: float, speed: ArrayLike
) -> np.ndarray:
    """Return the largest force of an elastic impact [N], the force at `hertz_overlap_max`.

    Arguments and source are as for `hertz_duration`.
    """
    overlap = hertz_overlap_max(radius_eff, mass_eff, youngs_modulus_eff, speed)
    return hertz_force(radius_eff, youngs_modulus_eff, overlap)


def viscoelastic_number(
    dissipative_constant: float,
    radius_eff: float,
    mass_eff: float,
    youngs_modulus_eff: float,
    speed: ArrayLike,
) -> np.ndarray:
    """Return the dimensionless number v* of an impact of viscoelastic spheres [-].

    v* = (3/2 A)^(1/2) (rho_k/m*)^(1/5) v^(1/10) with rho_k = 4/3 E* sqrt(R*). The restitution
    depends only on v*. For spheres of one material and of radius R, v* is proportional to R^(-1/2).

    Args:
        dissipative_constant: Ratio A of viscous to elastic constants [s].
        radius_eff: Effective radius R* [m].
        mass_eff: Effective mass m* [kg].
        youngs_modulus_eff: Effective Young's modulus E* [Pa].
        speed: Closing speed v [m/s], any shape.

    Source: Schwager & Pöschel 2008, Phys. Rev. E 78:051304.
    """
    stiffness = 4 / 3 * youngs_modulus_eff * sqrt(radius_eff)
    scale = sqrt(1.5 * dissipative_constant) * (stiffness / mass_eff) ** 0.2
    return scale * np.asarray(speed, dtype=float) ** 0.1


def viscoelastic_restitution(number: ArrayLike) -> np.ndarray:
    """Return the coefficient of restitution of viscoelastic spheres [-].

    `number` is v* [-] of `viscoelastic_number`; it may have any shape.

    The formula is the Padé form of Müller & Pöschel 2011, Phys. Rev. E 84:021302. The Padé form
    exceeds the solution of the equation of motion by 6e-8 at v* = 0.1, by 0.14 % at v* = 0.6 and by
    1.2 % at v* = 1.
    """
    x = np.asarray(number, dtype=float)
    above = np.polynomial.Polynomial([1, 0.501086])
    below = np.polynomial.Polynomial([1, 0.501086, 1.15345, 0.577977, 0.532178])
    return above(x) / below(x)


def hertz_force(radius_eff: float, youngs_modulus_eff: float, overlap: ArrayLike) -> np.ndarray:
    """Return the force of an elastic contact [N], 4/3 E* R*^(1/2) overlap^(3/2).

    The overlap [m] may have any shape.
    """
    return 4 / 3 * youngs_modulus_eff * sqrt(radius_eff) * np.asarray(overlap, dtype=float) ** 1.5


def hertz_history(
    radius_eff: float, mass_eff: float, youngs_modulus_eff: float, speed: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return time [s] and overlap [m] during an elastic impact, both (401,).

    Let d_max be the largest overlap, d = overlap/d_max and v the closing speed. Energy conservation
    gives dt = (d_max/v) dd / (1 - d^(5/2))^(1/2). The integral is an incomplete beta function of
    d^(5/2).

    Arguments and source are as for `hertz_duration`.
    """
    duration = hertz_duration(radius_eff, mass_eff, youngs_modulus_eff, speed)
    overlap_max = hertz_overlap_max(radius_eff, mass_eff, youngs_modulus_eff, speed)
    share = np.sin(np.linspace(0, np.pi / 2, 201)) ** 0.8  # points are dense near the maximum
    time = 0.5 * duration * betainc(0.4, 0.5, share**2.5)
    return (
        np.concatenate([time, duration - time[-2::-1]]),
        overlap_max * np.concatenate([share, share[-2::-1]]),
    )


def damping_ratio(coefficient_of_restitution: ArrayLike) -> np.ndarray:
    """Return the damping ratio of the dashpot for a restitution [-], -ln e / (pi^2 + ln^2 e)^(1/2).

    The coefficient of restitution e may have any shape. In the variables x = overlap^(5/4) and
    d tau = overlap^(1/4) dt, a Hertzian contact with this dashpot is a linear oscillator with this
    damping ratio (Antypov & Elliott 2011, Europhys. Lett. 94:50004).
    """
    logarithm = np.log(np.asarray(coefficient_of_restitution, dtype=float))
    return -logarithm / np.hypot(np.pi, logarithm)


def restitution_without_pull(coefficient_of_restitution: ArrayLike) -> np.ndarray:
    """Return the restitution [-] of a damped Hertzian contact that ends at zero force.

    The dashpot is set for a nominal restitution e, `coefficient_of_restitution`. A contact has this
    restitution if its force may become attractive until the overlap is zero. If the contact ends at
    zero force, the restitution is e^(1 - 2/pi atan(-ln e / pi)).

    Derivation: In an oscillator with the `damping_ratio` sin(a), the force vanishes at the phase
    pi - 2a. The speed is then exp(-tan(a) (pi - 2a)) times the initial speed, and
    e = exp(-pi tan(a)). Schwager & Pöschel 2007 (Granular Matter 9:465) treat the linear contact.
    """
    e = np.asarray(coefficient_of_restitution, dtype=float)
    return e ** (1 - 2 / np.pi * np.arctan(-np.log(e) / np.pi))


def sphere_yield(pair: laws.MaterialPair, radius_eff: float) -> tuple[float, float, float]:
    """Return the yield point of the Hertzian contact of spheres, where the largest pressure is p_y.

    The contact radius is a_y = pi p_y R*/(2 E*), with the yield pressure p_y and the effective
    Young's modulus E*. Then overlap_y = a_y^2/R*, F_y = 4/3 E* a_y^3/R*, W_y = 2/5 F_y overlap_y.

    Args:
        pair: Constants of the two bodies.
        radius_eff: Effective radius R* [m].

    Returns:
        Force F_y [N], overlap_y [m] and work W_y [J].

    Source: Johnson, Contact Mechanics (1985), sec. 6.1; Thornton 1997, J. Appl. Mech. 64:383.
    """
    overlap = radius_eff * laws.yield_radius_ratio(pair) ** 2
    force = 4 / 3 * pair.youngs_modulus_eff * sqrt(radius_eff * overlap) * overlap
    return force, overlap, 0.4 * force * overlap


def yield_speed(pair: laws.MaterialPair, radius_eff: float, mass_eff: float) -> float:
    """Return the closing speed at which a central impact just reaches yield [m/s].

    The yield speed v_y follows from 1/2 m* v_y^2 = 2/5 F_y overlap_y, with the results F_y and
    overlap_y of `sphere_yield`. Source: Thornton 1997, J. Appl. Mech. 64:383, eq. 22.
    """
    *_, work = sphere_yield(pair, radius_eff)
    return sqrt(2 * work / mass_eff)


def line_yield(
    pair: laws.MaterialPair, radius_eff: float, cylinder_length: float, body_thickness: float
) -> tuple[float, float, float]:
    """Return the yield point of the line contact of a cylinder: the mean pressure is 1.5 sigma_Y.

    With E' = pi E* and C = 2 ln(body_thickness/R*) + 2 ln(E'/(6 sigma_Y)) - nu/(1-nu):
    F_Y = 36 sigma_Y^2 R* L/E', overlap_Y = R* (6 sigma_Y/E')^2 C, W_Y = F_Y overlap_Y (2C-1)/(4C).
    E* is the effective Young's modulus. sigma_Y and nu are the yield strength and the Poisson's
    ratio of the body that yields.

    Args:
        pair: Constants of the two bodies.
        radius_eff: Effective radius R* [m].
        cylinder_length: Length L of the cylinder [m].
        body_thickness: Thickness of the body that yields [m].

    Returns:
        Force F_Y [N], overlap [m] and work W_Y [J].

    Raises:
        ValueError: The contact at yield is too wide for a line contact (C < 2).

    Source: Katta & Polycarpou 2010, J. Tribol. 132:041402; Johnson, Contact Mechanics (1985), sec.
    5.6.
    """
    ratio = 6 * pair.yield_strength / (pi * pair.youngs_modulus_eff)
    lateral = pair.poissons_ratio / (1 - pair.poissons_ratio)
    logarithm = 2 * log(body_thickness / radius_eff) - 2 * log(ratio) - lateral
    if logarithm < 2:
        raise ValueError(
            f"body_thickness is {body_thickness:g} m; the contact width at yield must be below 0.6 "
            f"times this value, but is {2 * ratio * radius_eff:.2g} m with radius {radius_eff:g} m"
        )
    force = 6 * pair.yield_strength * ratio * radius_eff * cylinder_length
    overlap = radius_eff * ratio**2 * logarithm
    return force, overlap, force * overlap * (2 * logarithm - 1) / (4 * logarithm)
