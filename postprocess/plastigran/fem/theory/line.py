# SPDX-License-Identifier: GPL-2.0-or-later
"""Contact of a rigid circle with an elastic layer in plane strain.

The formulas are reference solutions (Johnson, Contact Mechanics, 1985, secs. 4.2 and 5.6). They
also give the estimates from which meshes and time steps are chosen.
"""

from __future__ import annotations

from math import exp, log, pi, sqrt

import attrs
from scipy.optimize import brentq, minimize_scalar

from plastigran.declared import number
from plastigran.fem.material.elastic_plastic import ElasticPlastic


@attrs.frozen(kw_only=True)
class HertzLine:
    """Rigid circle (cylinder) on an elastic layer that is fixed on its far side."""

    material: ElasticPlastic
    radius: float = number("radius of the circle", "m", 0)
    length: float = number("length of the cylinder", "m", 0)
    thickness: float = number("thickness of the layer", "m", 0)

    def half_width(self, force: float) -> float:
        """Return the half width of the contact, m, at a force, N."""
        return sqrt(4 * self._scale(force) * self.radius)

    def approach(self, force: float) -> float:
        """Return the approach, m, at a force, N."""
        return self._scale(force) * self._logarithm(force)

    def energy(self, force: float) -> float:
        """Return the work, J, that loading up to a force, N, needs."""
        return force * self._scale(force) * (2 * self._logarithm(force) - 1) / 4

    def _scale(self, force: float) -> float:
        """Return F/(pi E* L), m, for a force F, N.

        E* is the effective modulus and L the length of the cylinder.
        """
        return force / (pi * self.material.plane_modulus * self.length)

    def _logarithm(self, force: float) -> float:
        ratio = self.material.poissons_ratio
        return log(self.thickness**2 / (self._scale(force) * self.radius)) - ratio / (1 - ratio)

    @property
    def yield_force(self) -> float:
        """Force at which the body yields below its surface, N.

        The force is infinite if the body is elastic (has no hardening law).

        The body yields on the axis. There, at a depth of z half widths, the stress along the
        surface divided by the largest pressure is -(1 + 2 z^2)/r + 2 z, with r = sqrt(1 + z^2). The
        stress normal to the surface divided by the largest pressure is -1/r.
        """
        if self.material.hardening is None:
            return float("inf")
        least = minimize_scalar(lambda z: -self._mises(z), bounds=(0.05, 3), method="bounded")
        pressure = self.material.hardening.yield_strength / -least.fun
        return pi * self.length * self.radius * pressure**2 / self.material.plane_modulus

    def _mises(self, depth: float) -> float:
        """Return the von Mises stress on the axis / largest pressure; `depth` is in half widths."""
        root = sqrt(1 + depth * depth)
        along, across = 2 * depth - (1 + 2 * depth * depth) / root, -1 / root
        out = self.material.poissons_ratio * (along + across)
        return sqrt(((along - across) ** 2 + (across - out) ** 2 + (out - along) ** 2) / 2)

    def impact_force(self, mass: float, speed: float) -> float:
        """Return the largest force, N, of an impact of a mass (kg) at a speed (m/s)."""
        kinetic_energy = mass * speed**2 / 2
        ratio = self.material.poissons_ratio / (1 - self.material.poissons_ratio)
        # Limit the force to `largest`, because the formula of `approach` holds for small contacts.
        # At this force, the contact is about as wide as the layer is thick. Above e times
        # `largest`, the approach by the formula would decrease.
        largest = (
            pi * self.material.plane_modulus * self.length * self.thickness**2 / self.radius
        ) * exp(-2 - ratio)
        if self.energy(largest) < kinetic_energy:
            return largest
        return brentq(lambda force: self.energy(force) - kinetic_energy, 1e-12 * largest, largest)

    def duration(self, mass: float, speed: float) -> float:
        """Estimate the duration of an impact, s, of a mass, kg, at a speed, m/s.

        The estimate uses the secant stiffness at the largest force.
        """
        force = self.impact_force(mass, speed)
        return pi * sqrt(mass * self.approach(force) / force)
