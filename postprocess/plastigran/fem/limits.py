# SPDX-License-Identifier: GPL-2.0-or-later
"""What is refused or warned of before anything is computed."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from math import isfinite, pi, sqrt

from plastigran.fem.theory.hertz import HertzSphere

SMALL_STRAIN = 0.1  # a/R up to which small strain is good within a few tenths of a per cent
LARGEST = 0.4  # a/R beyond which nothing here is meant
SMALLEST = 1e-6  # a/R below which the gap at the contact's edge, r^2/2R, is lost in rounding of R
SUBSONIC = 0.1  # speed over that of sound up to which an impact is computed
LEAST_HARDNESS = 2.5  # mean pressure over the flow stress of a fully plastic contact, at least


class SmallStrainWarning(UserWarning):
    """The contact becomes so wide that small strain is no longer good."""


def contact_reach(sphere: HertzSphere, force: float) -> float:
    """Largest contact radius to expect at a force, m: that of a fully plastic contact, or of Hertz
    where it is the larger one.
    """
    elastic = sphere.contact_radius(force)
    if force <= sphere.yield_force:
        return elastic
    strength = sphere.yielding.hardening.yield_strength
    ratio = (force / sphere.yield_force) ** (1 / 3)
    # Fit to perfectly plastic spheres, within 1 % up to 600 times the force at yield.
    plastic = sphere.contact_radius(sphere.yield_force) * (
        ratio + 0.745 * max(ratio**0.615 - 1, 0) ** 2.215
    )
    return max(elastic, min(plastic, sqrt(force / (pi * LEAST_HARDNESS * strength))))


def check_forces(sphere: HertzSphere, forces: Sequence[float], *, strain: str = "small") -> None:
    """Refuse forces that cannot be pressed.

    Args:
        sphere: The sphere.
        forces: N.
        strain: "small", which warns of wide contacts, or "finite".

    Raises:
        ValueError: A force that is not positive and finite, not larger than the one before, or one
            at which the contact is wider than LARGEST times the radius.
    """
    if len(forces) == 0:
        raise ValueError("forces is empty; give one or more, N")
    for before, force in zip([0.0, *forces], forces, strict=False):
        if not before < force or not isfinite(force):
            raise ValueError(
                f"forces holds {force:g} N after {before:g} N; they must be positive and increase"
            )
    check_reach(
        sphere, contact_reach(sphere, forces[-1]), f"a force of {forces[-1]:g} N", strain=strain
    )


def force_of_impact(sphere: HertzSphere, speed: float) -> tuple[float, float]:
    """Largest force, N, and contact radius, m, to expect of an impact: enough to lay out a mesh."""
    elastic = sphere.force(sphere.approach_max(speed))
    if elastic <= sphere.yield_force:
        return elastic, sphere.contact_radius(elastic)
    # The finite elements' 17.8, 107 and 228 P_Y at 12, 60 and 120 v_Y lie within 8 % of this.
    force = sphere.yield_force * (speed / sphere.yield_speed) ** 1.15
    force = min(force, elastic)
    return force, contact_reach(sphere, force)


def check_speed(
    sphere: HertzSphere, speed: float, largest: float = LARGEST, strain: str = "small"
) -> None:
    """Refuse a speed that cannot be thrown.

    Args:
        sphere: The sphere.
        speed: m/s.
        largest: Widest contact over the radius.
        strain: "small", which warns of wide contacts, or "finite".

    Raises:
        ValueError: It is not positive and finite, faster than a tenth of the speed of sound, or
            the contact becomes wider than `largest` times the radius.
    """
    if not 0 < speed or not isfinite(speed):
        raise ValueError(f"speed is {speed:g} m/s; it must be positive and finite")
    sound = sqrt(sphere.material.youngs_modulus / sphere.material.density)
    if speed > SUBSONIC * sound:
        raise ValueError(
            f"speed is {speed:g} m/s; it must be below {SUBSONIC:g} of the speed of sound in the "
            f"metal, {sound:.4g} m/s (are the units Pa and kg/m3?)"
        )
    reach = force_of_impact(sphere, speed)[1]
    check_reach(sphere, reach, f"a speed of {speed:g} m/s", largest, strain)


def check_reach(
    sphere: HertzSphere,
    reach: float,
    cause: str,
    largest: float = LARGEST,
    strain: str = "small",
) -> None:
    """Warn of, or refuse, a contact too wide for the method.

    Raises:
        ValueError: It is wider than `largest` times the radius, or narrower than SMALLEST times it.
    """
    ratio = reach / sphere.radius
    if ratio < SMALLEST:
        raise ValueError(
            f"{cause} makes a contact of about {ratio:.2g} of the radius; from {SMALLEST:g} on it "
            "can be computed (are the units Pa, kg/m3, m?)"
        )
    if ratio > largest:
        raise ValueError(
            f"{cause} makes a contact of about {ratio:.2g} of the radius; up to {largest:g} can be "
            "computed (are the units Pa, kg/m3, m?)"
        )
    if strain == "small" and ratio > SMALL_STRAIN:
        warnings.warn(
            f"{cause} makes a contact of about {ratio:.2g} of the radius; small strain is good to "
            f"{SMALL_STRAIN:g}; finite strain goes further",
            SmallStrainWarning,
            stacklevel=3,
        )
