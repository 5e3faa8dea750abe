# SPDX-License-Identifier: GPL-2.0-or-later
"""Checks of the input of a finite-element computation, with errors and warnings."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from itertools import pairwise
from math import isfinite, pi, sqrt

from plastigran.fem.theory.hertz import HertzSphere

SMALL_STRAIN = 0.1  # largest a/R for small strain, with errors of some tenths of a per cent
LARGEST = 0.4  # largest a/R of any computation
# Smallest a/R. At smaller values, the gap r^2/2R at the contact edge is lost in the round-off of R.
SMALLEST = 1e-6
SUBSONIC = 0.1  # largest speed / speed of sound of an impact
LEAST_HARDNESS = 2.5  # smallest mean pressure / flow stress of a fully plastic contact


class SmallStrainWarning(UserWarning):
    """The contact radius is too large for small-strain kinematics."""


def contact_reach(sphere: HertzSphere, force: float) -> float:
    """Estimate the contact radius, m, of an elastic or plastic contact at a force, N."""
    elastic = sphere.contact_radius(force)
    if force <= sphere.yield_force:
        return elastic
    strength = sphere.yielding.hardening.yield_strength
    ratio = (force / sphere.yield_force) ** (1 / 3)
    # This empirical fit for perfectly plastic spheres deviates by at most 1 % up to
    # 600 times the yield force.
    plastic = sphere.contact_radius(sphere.yield_force) * (
        ratio + 0.745 * max(ratio**0.615 - 1, 0) ** 2.215
    )
    return max(elastic, min(plastic, sqrt(force / (pi * LEAST_HARDNESS * strength))))


def check_forces(sphere: HertzSphere, forces: Sequence[float], *, strain: str = "small") -> None:
    """Check the forces of a compression, N; `strain` is "small" or "finite".

    Raises:
        ValueError: A force is not positive and finite, does not exceed the previous force, or gives
            a contact radius that is too small or too large; see `check_reach`.
    """
    if len(forces) == 0:
        raise ValueError("forces is empty. Give one or more forces [N]")
    for before, force in pairwise([0.0, *forces]):
        if not before < force or not isfinite(force):
            raise ValueError(
                f"forces contains {force:g} N after {before:g} N. Each force must be finite, "
                "positive and larger than the force before"
            )
    cause = f"a force of {forces[-1]:g} N"
    check_reach(sphere, contact_reach(sphere, forces[-1]), cause, strain=strain)


def force_of_impact(sphere: HertzSphere, speed: float) -> tuple[float, float]:
    """Estimate the largest force, N, and the largest contact radius, m, of an impact.

    The mesh of the impact is built for these estimates. `speed` is in m/s.
    """
    elastic = sphere.force(sphere.approach_max(speed))
    if elastic <= sphere.yield_force:
        return elastic, sphere.contact_radius(elastic)
    # Use an empirical power law, which is within 8 % of finite elements: 17.8, 107 and 228 times
    # the yield force at 12, 60 and 120 times the yield speed.
    force = min(sphere.yield_force * (speed / sphere.yield_speed) ** 1.15, elastic)
    return force, contact_reach(sphere, force)


def check_speed(
    sphere: HertzSphere, speed: float, largest: float = LARGEST, strain: str = "small"
) -> None:
    """Check the speed of an impact, m/s; other arguments are as for `check_reach`.

    Raises:
        ValueError: The speed is not positive and finite, exceeds a tenth of the speed of sound, or
            gives a contact radius that is too small or too large.
    """
    if not 0 < speed or not isfinite(speed):
        raise ValueError(f"speed is {speed:g} m/s; it must be positive and finite")
    material = sphere.material
    check_subsonic("speed", speed, sqrt(material.youngs_modulus / material.density))
    reach = force_of_impact(sphere, speed)[1]
    check_reach(sphere, reach, f"a speed of {speed:g} m/s", largest, strain)


def check_subsonic(name: str, speed: float, sound: float) -> None:
    """Check that a speed, m/s, is at most SUBSONIC times the speed of sound.

    Raises:
        ValueError: The speed exceeds the limit.
    """
    if speed > SUBSONIC * sound:
        raise ValueError(
            f"{name} is {speed:g} m/s; it must be at most {SUBSONIC:g} times the speed of sound in "
            f"the metal, {sound:.4g} m/s. Check the units: Pa, kg/m3"
        )


def check_reach(
    sphere: HertzSphere,
    reach: float,
    cause: str,
    largest: float = LARGEST,
    strain: str = "small",
) -> None:
    """Check that the contact radius is within the limits of the computation.

    Args:
        sphere: Sphere.
        reach: Largest contact radius, m.
        cause: Cause of this contact radius, for messages; such as "a force of 3 N".
        largest: Largest allowed a/R.
        strain: "small", which warns of large a/R, or "finite".

    Raises:
        ValueError: The contact radius is above `largest` or below SMALLEST times the radius.
    """
    ratio = reach / sphere.radius
    estimate = f"{cause} gives a contact radius of about {ratio:.2g} times the radius"
    if ratio < SMALLEST:
        raise ValueError(
            f"{estimate}; the lower limit is {SMALLEST:g}. Check the units: Pa, kg/m3, m"
        )
    if ratio > largest:
        raise ValueError(
            f"{estimate}; the upper limit is {largest:g}. Reduce the load, or check the units: "
            "Pa, kg/m3, m"
        )
    if strain == "small" and ratio > SMALL_STRAIN:
        warn_of_small_strain(estimate)


def warn_of_small_strain(estimate: str) -> None:
    """Warn that the contact is too large for small strain.

    `estimate` is the start of the message: it states the expected contact radius.
    """
    warnings.warn(
        f"{estimate}; small strain is accurate up to {SMALL_STRAIN:g}. Reduce the load, or use "
        "finite strain (--finite-strain, Settings(strain='finite')), except for vibrations",
        SmallStrainWarning,
        stacklevel=4,
    )
