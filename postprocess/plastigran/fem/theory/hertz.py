# SPDX-License-Identifier: GPL-2.0-or-later
"""Hertz contact (1882) of an elastic sphere with a plane or a half space.

The formulas are reference solutions. They also give the estimates from which meshes, load
increments and time steps are chosen.
"""

from __future__ import annotations

from math import atan, gamma, pi, sqrt

import attrs
from scipy.optimize import minimize_scalar

from plastigran.declared import radius_field
from plastigran.fem.material.elastic_plastic import ElasticPlastic


@attrs.frozen
class HertzSphere:
    """Hertz contact of an elastic sphere with a plane.

    Attributes:
        material: Material of the sphere. Only the yield strength of its hardening law is used.
        radius: Radius of the sphere, m.
        plane: Material of the half space; None for a rigid plane.
    """

    material: ElasticPlastic
    radius: float = radius_field("radius of the sphere")
    plane: ElasticPlastic | None = None

    @property
    def modulus(self) -> float:
        """Effective modulus E* of both bodies, Pa."""
        return self.material.pair_modulus(self.plane)

    @property
    def mass(self) -> float:
        """Mass of the sphere, kg."""
        return self.material.density * 4 / 3 * pi * self.radius**3

    def contact_radius(self, force: float) -> float:
        """Return the contact radius, m, at a force, N."""
        return (3 * force * self.radius / (4 * self.modulus)) ** (1 / 3)

    def approach(self, force: float) -> float:
        """Return the approach, m, at a force, N."""
        return self.contact_radius(force) ** 2 / self.radius

    def force(self, approach: float) -> float:
        """Return the force, N, at an approach, m."""
        return 4 / 3 * self.modulus * sqrt(self.radius) * approach**1.5

    def approach_max(self, speed: float) -> float:
        """Return the largest approach, m, of an impact at a speed, m/s."""
        return (15 * self.mass * speed**2 / (16 * self.modulus * sqrt(self.radius))) ** 0.4

    def duration(self, speed: float) -> float:
        """Return the duration, s, of an impact at a speed, m/s."""
        return 4 * sqrt(pi) * gamma(0.4) / (5 * gamma(0.9)) * self.approach_max(speed) / speed

    @property
    def yielding(self) -> ElasticPlastic | None:
        """Material of the body that yields first; None if neither body yields."""
        metals = [metal for metal in (self.material, self.plane) if metal and metal.hardening]
        return min(metals, key=_yield_pressure, default=None)

    @property
    def yield_force(self) -> float:
        """Force at first yield below the surface of a body, N; infinite if neither body yields."""
        if self.yielding is None:
            return float("inf")
        return pi**3 * self.radius**2 * _yield_pressure(self.yielding) ** 3 / (6 * self.modulus**2)

    @property
    def yield_speed(self) -> float:
        """Impact speed at first yield, m/s."""
        force = self.yield_force
        return sqrt(0.8 * force * self.approach(force) / self.mass)


def _yield_pressure(metal: ElasticPlastic) -> float:
    """Return the largest pressure of a Hertz contact at which a metal yields, Pa.

    The largest von Mises stress on the axis is p_0 F, with the largest pressure p_0. F is the
    maximum of 1.5/(1 + z^2) - (1 + nu)(1 - z atan(1/z)) over z, the depth divided by the contact
    radius; nu is Poisson's ratio.
    """
    poissons_ratio = metal.poissons_ratio
    least = minimize_scalar(
        lambda z: -abs(1.5 / (1 + z * z) - (1 + poissons_ratio) * (1 - z * atan(1 / z))),
        bounds=(0.05, 3),
        method="bounded",
    )
    return metal.hardening.yield_strength / -least.fun
