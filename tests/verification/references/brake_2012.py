# SPDX-License-Identifier: GPL-2.0-or-later
"""M. R. Brake, Int. J. Solids Struct. 49 (2012) 3129.

d is the overlap, F the force, a the contact radius, and P0 = 2.8 Y the hardness, with the yield
strength Y. Index m is for the largest overlap; d_r is the residual overlap, and
y = (d - d_r)/(d_m - d_r).

Yield is at d_y = R* (pi p_y/2E*)^2. The contact is fully plastic from a_p = 3 pi P0 R*/(4 E*) and
d_p = a_p^2/R*: F = pi P0 a^2, a^2 = 2 R* d - a_p^2. Between d_y and d_p, F and a are cubics with
the values and slopes at both ends. Unloading starts with the contact area at the largest overlap:
d_m - d_r = 3 F_m/(4 E* a_m), F = F_m y^1.5.
"""

from __future__ import annotations

from math import inf, pi, sqrt

from references.central_impact import CentralImpact
from scipy.interpolate import CubicHermiteSpline


class Reference(CentralImpact):
    energy_guard = True

    def __init__(self, material, radius, speed):
        super().__init__(material, radius, speed)
        modulus, hardness = material.modulus, 2.8 * material.yield_strength
        pressure = material.yield_pressure
        overlap_y = self.overlap_at(pressure)
        radius_y, radius_p = sqrt(radius * overlap_y), 0.75 * pi * hardness * radius / modulus
        self.overlap_p = radius_p**2 / radius
        ends = [overlap_y, self.overlap_p]
        force = CubicHermiteSpline(
            ends,
            [self.hertz(overlap_y), pi * hardness * radius_p**2],
            [2 * modulus * radius_y, 2 * pi * hardness * radius],
        )
        self.cubic_radius = CubicHermiteSpline(
            ends, [radius_y, radius_p], [radius / (2 * radius_y), radius / radius_p]
        )
        self.pieces = [
            (overlap_y, self.hertz),
            (self.overlap_p, force),
            (inf, lambda d: pi * hardness * (2 * radius * d - radius_p**2)),
        ]

    def contact_radius(self, overlap):
        if overlap <= self.overlap_p:
            return self.cubic_radius(overlap)
        return sqrt(self.radius * (2 * overlap - self.overlap_p))

    def published_rebound(self, overlap_max):
        stiffness = 4 * self.material.modulus * self.contact_radius(overlap_max)
        recovery = 3 * self.loading_force(overlap_max) / stiffness
        return min(recovery, overlap_max), lambda y: y**1.5
