# SPDX-License-Identifier: GPL-2.0-or-later
"""Checks and warnings before a computation."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from math import isfinite, pi, sqrt

from plastigran.fem.theory.hertz import HertzSphere

SMALL_STRAIN = 0.1  # a/R up to which the error of small strain is some tenths of a per cent
LARGEST = 0.4  # largest a/R of any computation
# smallest a/R; below it round-off of R hides the gap at the contact edge, r^2/2R
SMALLEST = 1e-6
SUBSONIC = 0.1  # largest speed / speed of sound of an impact
LEAST_HARDNESS = 2.5  # smallest mean pressure / flow stress of a fully plastic contact


class SmallStrainWarning(UserWarning):
    """The contact becomes too large for small strain."""


def contact_reach(sphere: HertzSphere, force: float) -> float:
    """Return the largest expected contact radius at a force, m: fully plastic or Hertz."""
    elastic = sphere.contact_radius(force)
    if force <= sphere.yield_force:
        return elastic
    strength = sphere.yielding.hardening.yield_strength
    ratio = (force / sphere.yield_force) ** (1 / 3)
    # Fit to perfectly plastic spheres, within 1 % up to 600 times the yield force.
    plastic = sphere.contact_radius(sphere.yield_force) * (
        ratio + 0.745 * max(ratio**0.615 - 1, 0) ** 2.215
    )
    return max(elastic, min(plastic, sqrt(force / (pi * LEAST_HARDNESS * strength))))


def check_forces(sphere: HertzSphere, forces: Sequence[float], *, strain: str = "small") -> None:
    """Check the forces of a compression.

    Args:
        sphere: Sphere.
        forces: Forces, N.
        strain: "small", which warns of large a/R, or "finite".

    Raises:
        ValueError: A force is not positive and finite, does not exceed the one before, or gives a
            contact radius above LARGEST times the radius.
    """
    if len(forces) == 0:
        raise ValueError("forces is empty. Give one or more forces, N")
    for before, force in zip([0.0, *forces], forces, strict=False):
        if not before < force or not isfinite(force):
            raise ValueError(
                f"forces contains {force:g} N after {before:g} N; they must be positive and "
                "increase"
            )
    check_reach(
        sphere, contact_reach(sphere, forces[-1]), f"a force of {forces[-1]:g} N", strain=strain
    )


def force_of_impact(sphere: HertzSphere, speed: float) -> tuple[float, float]:
    """Estimate the largest force, N, and contact radius, m, of an impact, for the mesh."""
    elastic = sphere.force(sphere.approach_max(speed))
    if elastic <= sphere.yield_force:
        return elastic, sphere.contact_radius(elastic)
    # Finite elements give 17.8, 107 and 228 P_Y at 12, 60 and 120 v_Y, within 8 % of this.
    force = sphere.yield_force * (speed / sphere.yield_speed) ** 1.15
    force = min(force, elastic)
    return force, contact_reach(sphere, force)


def check_speed(
    sphere: HertzSphere, speed: float, largest: float = LARGEST, strain: str = "small"
) -> None:
    """Check the speed of an impact.

    Args:
        sphere: Sphere.
        speed: Impact speed, m/s.
        largest: Largest allowed a/R.
        strain: "small", which warns of large a/R, or "finite".

    Raises:
        ValueError: The speed is not positive and finite, exceeds a tenth of the speed of sound, or
            gives a contact radius above `largest` times the radius.
    """
    if not 0 < speed or not isfinite(speed):
        raise ValueError(f"speed is {speed:g} m/s; it must be positive and finite")
    sound = sqrt(sphere.material.youngs_modulus / sphere.material.density)
    if speed > SUBSONIC * sound:
        raise ValueError(
            f"speed is {speed:g} m/s; it must be below {SUBSONIC:g} of the speed of sound in "
            f"the metal, {sound:.4g} m/s. Check the units: Pa, kg/m3"
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
    """Check that the contact radius suits the method.

    Raises:
        ValueError: It is larger than `largest` times the radius, or smaller than SMALLEST times it.
    """
    ratio = reach / sphere.radius
    if ratio < SMALLEST:
        raise ValueError(
            f"{cause} gives a contact radius of about {ratio:.2g} times the radius; the "
            f"smallest is {SMALLEST:g}. Check the units: Pa, kg/m3, m"
        )
    if ratio > largest:
        raise ValueError(
            f"{cause} gives a contact radius of about {ratio:.2g} times the radius; the "
            f"largest is {largest:g}. Use a smaller value, or check the units: Pa, kg/m3, m"
        )
    if strain == "small" and ratio > SMALL_STRAIN:
        warnings.warn(
            f"{cause} gives a contact radius of about {ratio:.2g} times the radius; small "
            f"strain is accurate up to {SMALL_STRAIN:g}. Use finite strain",
            SmallStrainWarning,
            stacklevel=3,
        )
