# SPDX-License-Identifier: GPL-2.0-or-later
"""Soften a material without a change of restitution, which allows a longer time step.

Young's modulus is multiplied by s < 1. For laws without other constants, an impact at speed v
depends only on Poisson's ratio nu and on v / v_Y. The yield speed v_Y is proportional to
(p_Y^5 / (E*^4 rho))^(1/2), with the yield pressure p_Y, the effective modulus E* and the density
rho. If the yield strength is multiplied by s^(4/5), at the same nu and rho, v_Y and the restitution
at every speed are unchanged. Durations, time step and overlap increase as s^(-2/5), and contact
radius / radius as s^(-1/5). Forces decrease as s^(2/5). `POWERS` gives the scaling of the constants
of a material.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import exp, log, pi

import attrs
import numpy as np
import pandas as pd
from scipy.optimize import brentq

from plastigran.contact import Contact
from plastigran.declared import RADIUS, Declaration, read_number
from plastigran.materials import Material
from plastigran.physics import central
from plastigran.physics.rebound_hardness import GRAVITATIONAL_ACCELERATION
from plastigran.usable_laws import laws_for

#: Exponents p by name of a material constant: softening by the factor s multiplies the constant by
#: s^p. Other constants do not change.
POWERS = {
    "youngs_modulus": 1.0,
    "yield_strength": 0.8,
    # Hardening stress is tangent modulus times strain. The strain scales as a/R, s^(-1/5). The
    # hardening stress therefore scales as the yield strength, s^(4/5).
    "tangent_modulus": 1.0,
    "dissipative_constant": -0.4,  # a time, which scales as the contact duration
}
#: Exponent p for durations, overlaps and time steps: softening multiplies them by s^p.
TIME_POWER = -0.4
#: Largest overlap / radius at which a softened grain still counts as hard (1 % of the diameter).
SOUND_OVERLAP = 0.02
#: Speeds / yield speed at which laws are compared.
SPEED_RATIOS = np.geomspace(1, 1000, 61)
#: Change of restitution below which softening counts as exact for a law.
EXACT = 1e-9
#: Number of contacts per grain, and volume fraction, of a random packing.
COORDINATION, FILLING = 6, 0.6

_MODULUS = Declaration("original modulus", "Pa", 1e4, 2e12)
_FACTOR = Declaration("softened / original modulus", "-", 1e-12, 1, True, True)


def soften(material: Material, factor: float) -> Material:
    """Return the material with `factor` times its Young's modulus and the same restitution.

    Args:
        material: Original material.
        factor: Softening factor s, softened / original modulus [-], at most 1.

    Raises:
        ValueError: The factor or the modulus is not a number or out of range.
    """
    factor = read_number("factor", factor, _FACTOR)
    read_number("youngs_modulus", material.youngs_modulus, _MODULUS)
    changed = {
        name: getattr(material, name) * factor**power
        for name, power in POWERS.items()
        if getattr(material, name, None) is not None
    }
    return attrs.evolve(material, name=f"{material.name}_softened", **changed)


def comparison(
    material: Material, factor: float, radius: float, speed: float, laws: Iterable[str] = ()
) -> pd.DataFrame:
    """Compare impacts of two equal spheres before and after softening: one row per law.

    Args:
        material: Original material.
        factor: Softening factor s, softened / original modulus [-].
        radius: Radius of the spheres [m].
        speed: Closing speed [m/s].
        laws: Names of laws; by default all laws for spheres whose constants the material has.

    Returns:
        Columns law and restitution_change [-], the largest change of restitution at 1 to 1000 times
        the yield speed. The change is 0 for laws that scale exactly. Further columns describe the
        impact at `speed`: coefficient_of_restitution [-], the recommended timestep [s], overlap
        (largest overlap / radius) [-], and in_range, whether the impact is within the range of the
        law. With the suffix _softened, they describe the impact after softening.

    Raises:
        ValueError: A number is out of range, or the material lacks a constant of a law.
    """
    bodies = {"": material, "_softened": soften(material, factor)}
    rows = []
    for law in laws or laws_for("sphere", [material]):
        row, restitutions = {"law": law}, []
        for suffix, body in bodies.items():
            contact = Contact(law, body, body, radius=radius, radius_other=radius)
            impact = contact.impact(speed)
            row |= {
                f"coefficient_of_restitution{suffix}": impact.coefficient_of_restitution,
                f"timestep{suffix}": contact.timestep(speed),
                f"overlap{suffix}": impact.overlap_max / radius,
                f"in_range{suffix}": bool(impact.in_range),
            }
            yield_speed = central.yield_speed(contact.pair, contact.radius_eff, contact.mass_eff)
            speeds = SPEED_RATIOS * yield_speed
            restitutions.append(contact.impact(speeds).coefficient_of_restitution)
        change = np.max(np.abs(np.subtract(*restitutions)))
        rows.append(row | {"restitution_change": change if change > EXACT else 0.0})
    return pd.DataFrame(rows)


def lowest_factor(impact: float, rest: Callable[[float], float] | None = None) -> float:
    """Return the lowest softening factor that keeps all overlaps below SOUND_OVERLAP.

    The overlaps are those of the fastest impact and of grains at rest under a load.

    Args:
        impact: Overlap / radius of the fastest impact of the original grains [-].
        rest: Function that returns the overlap / radius at rest under the load [-] for a factor.
    """
    lowest = (impact / SOUND_OVERLAP) ** (-1 / TIME_POWER)
    lowest = min(1.0, max(lowest, _FACTOR.lower))
    if rest is None or rest(lowest) <= SOUND_OVERLAP:
        return lowest
    if rest(1.0) >= SOUND_OVERLAP:
        return 1.0
    return exp(brentq(lambda logarithm: rest(exp(logarithm)) - SOUND_OVERLAP, log(lowest), 0.0))


def resting_overlap(material: Material, radius: float, depth: float, law: str = "hertz") -> float:
    """Return the overlap / radius of grains at rest under a bed of the same grains [-].

    At a pressure p = rho phi g h, a contact carries F = 4 pi R^2 p/(Z phi) (Rumpf 1958, Chem. Ing.
    Tech. 30:144), with Z = 6 contacts per grain and the volume fraction phi = 0.6.

    Args:
        material: Material of the grains.
        radius: Radius R of the grains [m].
        depth: Depth h of the bed above the grains [m].
        law: Name of the contact law; the contact is in first loading.

    Returns:
        Overlap / radius; 1 if the contact cannot carry the load.

    Raises:
        ValueError: A number is out of range, or the material lacks a constant of the law.
    """
    radius = read_number("radius", radius, RADIUS)
    depth = read_number("depth", depth, Declaration("depth of the bed", "m", 0))
    pressure = material.density * FILLING * GRAVITATIONAL_ACCELERATION * depth
    force = 4 * pi * radius**2 * pressure / (COORDINATION * FILLING)
    contact = Contact(law, material, material, radius=radius, radius_other=radius)

    def excess_force(logarithm: float) -> float:
        return float(contact.law.follow(radius / 2, [exp(logarithm) * radius])["force"][0]) - force

    if excess_force(0.0) <= 0:
        return 1.0
    least = log(1e-12)
    return exp(brentq(excess_force, least, 0.0) if excess_force(least) < 0 else least)
