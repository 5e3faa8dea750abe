# SPDX-License-Identifier: GPL-2.0-or-later
"""A softer material with the same restitution, which allows a longer time step.

Let Young's modulus become s E. For laws without other constants, an impact at speed v depends only
on
nu and v / v_Y, with the yield speed v_Y ~ (p_Y^5 / (E*^4 rho))^(1/2). If the yield strength is
multiplied by s^(4/5), at the same nu and rho, v_Y and the restitution at every speed are unchanged.
Durations, time step and overlap grow as s^(-2/5), and contact radius / radius as s^(-1/5). Forces
decrease as s^(2/5). Constants of a law are scaled by `POWERS`.
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
from plastigran.physics.central import yield_speed
from plastigran.physics.rebound_hardness import GRAVITATIONAL_ACCELERATION
from plastigran.usable_laws import laws_for

#: Power of s by which each constant of a material is multiplied; other constants stay.
POWERS = {
    "youngs_modulus": 1.0,
    "yield_strength": 0.8,
    "tangent_modulus": 1.0,  # times a strain ~ a/R, it scales like the strength
    "dissipative_constant": -0.4,  # a time, it scales like the duration
}
#: Power of s by which durations, overlaps and time steps are multiplied.
TIME_POWER = -0.4
#: Largest overlap / radius at which grains count as hard: one per cent of the diameter.
SOUND_OVERLAP = 0.02
#: Speeds / yield speed at which laws are compared.
SPEED_RATIOS = np.geomspace(1, 1000, 61)
#: Largest change of restitution of an exact law.
EXACT = 1e-9
#: Contacts per grain and volume fraction of a random packing.
COORDINATION, FILLING = 6, 0.6

_MODULUS = Declaration("original modulus", "Pa", 1e4, 2e12)
_FACTOR = Declaration("softened / original modulus", "-", 1e-12, 1, True, True)


def soften(material: Material, factor: float) -> Material:
    """Return the material with `factor` times its Young's modulus and the same restitution.

    Args:
        material: Original material.
        factor: s, softened / original modulus [-], at most 1.

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
    """Compare impacts of two equal spheres before and after softening, a row for each law.

    Args:
        material: Original material.
        factor: s [-].
        radius: Radius of the spheres [m].
        speed: Closing speed [m/s].
        laws: Names of laws; by default those for spheres whose constants the material has.

    Returns:
        Columns law; coefficient_of_restitution and coefficient_of_restitution_softened [-], at
        `speed`; restitution_change [-], the largest from 1 to 1000 yield speeds, 0 for an exact
        law;
        timestep and timestep_softened [s], recommended at `speed`; overlap and overlap_softened,
        the largest at `speed` / radius [-]; in_range and in_range_softened, whether that impact is
        within the range of the law.

    Raises:
        ValueError: A number is out of range, or the material lacks a constant of a law.
    """
    rows = []
    for name in laws or laws_for("sphere", [material]):
        before, after = (
            Contact(name, body, body, radius=radius, radius_other=radius)
            for body in (material, soften(material, factor))
        )
        hard, soft = before.impact(speed), after.impact(speed)
        change = np.max(np.abs(_restitution(after) - _restitution(before)))
        rows.append(
            {
                "law": name,
                "coefficient_of_restitution": hard.coefficient_of_restitution,
                "coefficient_of_restitution_softened": soft.coefficient_of_restitution,
                "restitution_change": change if change > EXACT else 0.0,
                "timestep": before.timestep(speed),
                "timestep_softened": after.timestep(speed),
                "overlap": hard.overlap_max / radius,
                "overlap_softened": soft.overlap_max / radius,
                "in_range": bool(hard.in_range),
                "in_range_softened": bool(soft.in_range),
            }
        )
    return pd.DataFrame(rows)


def _restitution(contact: Contact) -> np.ndarray:
    speed = yield_speed(contact.pair, contact.radius_eff, contact.mass_eff)
    return contact.impact(SPEED_RATIOS * speed).coefficient_of_restitution


def lowest_factor(impact: float, rest: Callable[[float], float] | None = None) -> float:
    """Return the factor at which the first of two overlaps reaches SOUND_OVERLAP.

    Args:
        impact: Overlap / radius of the fastest impact of the original grains [-].
        rest: Function from factor to overlap / radius at rest under a load [-].
    """
    lowest = (impact / SOUND_OVERLAP) ** (-1 / TIME_POWER)
    lowest = min(1.0, max(lowest, _FACTOR.lower))

    def beyond(logarithm: float) -> float:
        return rest(exp(logarithm)) - SOUND_OVERLAP

    if rest is None or rest(lowest) <= SOUND_OVERLAP:
        return lowest
    if rest(1.0) >= SOUND_OVERLAP:
        return 1.0
    return exp(brentq(beyond, log(lowest), 0.0))


def resting_overlap(material: Material, radius: float, depth: float, law: str = "hertz") -> float:
    """Return the overlap / radius of grains at rest under a bed of the same grains [-].

    A contact carries F = 4 pi R^2 p/(Z phi) of the pressure p = rho phi g h (Rumpf 1958, Chem. Ing.
    Tech. 30:144), Z = 6 and phi = 0.6.

    Args:
        material: Material of the grains.
        radius: R [m].
        depth: Depth h of the bed above them [m].
        law: Law of the contact, in first loading.

    Returns:
        At most 1, for a contact that cannot carry the load.

    Raises:
        ValueError: A number is out of range, or the material lacks a constant of the law.
    """
    radius = read_number("radius", radius, RADIUS)
    depth = read_number("depth", depth, Declaration("depth of the bed", "m", 0))
    pressure = material.density * FILLING * GRAVITATIONAL_ACCELERATION * depth
    force = 4 * pi * radius**2 * pressure / (COORDINATION * FILLING)
    contact = Contact(law, material, material, radius=radius, radius_other=radius)

    def beyond(logarithm: float) -> float:
        return float(contact.law.follow(radius / 2, [exp(logarithm) * radius])["force"][0]) - force

    ends = log(1e-12), 0.0
    if beyond(ends[1]) <= 0:
        return 1.0
    return exp(brentq(beyond, *ends)) if beyond(ends[0]) < 0 else exp(ends[0])
