# SPDX-License-Identifier: GPL-2.0-or-later
"""Equations of docs/laws/universal.md for a perfectly plastic sphere of radius R and modulus E' on
a rigid plane.

d is the overlap, F the force, a the contact radius, and p_y the yield pressure. Index m is for the
largest overlap; d_r is the residual overlap, and y = (d - d_r)/(d_m - d_r).

d_y = R (pi p_y/2E')^2, with Hertz' F_y and a_y at d_y; t = sqrt(d/d_y), s = t - 1, r = a_y/R; w is
p_y divided by p_y(nu = 0.3) at the same yield strength:

    S = t (6.791 + w s)/(6.791 + s) - 1,  Z = (rS)^2/(1 + rS)
    F_y t^3/F = 1 + 0.1253 S^2 (S + 11.91)/((S + 8.355)(S + 1.114)) (1 + 3.802 Z)
    (a/a_y t)^2 = (1 + 1.248 S^2/(S^2 + 5.11 S + 4.411)) (1 + 7.842 Z)^2
    D = 0.1902 S^2/(S^2 + 0.6156 S + 0.359)
    d_m - d_r = (1 - D) 3 F_m/(4 E' a_m),  F = F_m y^1.5 (1 + g)/(1 + g sqrt(y)),  g = 3.642 D

For a yielding flat, Z = 0.
"""

from __future__ import annotations

from math import inf, sqrt

import numpy as np
from references import thornton
from references.central_impact import CentralImpact

#: Yield pressure / yield strength of a Hertzian contact at nu = 0.3 (Johnson, Contact Mechanics,
#: 1985, sec. 4.1). It is the inverse of the largest 1.5/(1 + z^2) - 1.3 (1 - z atan(1/z)), where z
#: is depth / contact radius.
DEPTHS = np.linspace(0.47, 0.49, 2_000_001)
AT_NU_03 = 1 / float(np.max(1.5 / (1 + DEPTHS**2) - 1.3 * (1 - DEPTHS * np.arctan(1 / DEPTHS))))


class Reference(CentralImpact):
    cases = thornton.Reference.cases
    readings = ("yielding flat",)

    def __init__(self, material, radius, speed):
        super().__init__(material, radius, speed)
        self.overlap_y = self.overlap_at(material.yield_pressure)
        self.pieces = [(self.overlap_y, self.hertz), (inf, self.force_beyond)]

    def depth(self, overlap):
        t = np.sqrt(overlap / self.overlap_y)
        w = self.material.yield_pressure_factor / AT_NU_03
        return t * (6.791 + w * (t - 1)) / (6.791 + t - 1) - 1

    def wide(self, depth):
        """Return Z of the module docstring, which is zero for a yielding flat."""
        flat = self.reading == "yielding flat"
        a = 0 * depth if flat else sqrt(self.overlap_y / self.radius) * depth
        return a**2 / (1 + a)

    def force_beyond(self, overlap):
        s = self.depth(overlap)
        softening = 0.1253 * s**2 * (s + 11.91) / ((s + 8.355) * (s + 1.114))
        return self.hertz(overlap) / (1 + softening * (1 + 3.802 * self.wide(s)))

    def contact_radius(self, overlap):
        s = self.depth(overlap)
        spread = 1 + 1.248 * s**2 / (s**2 + 5.11 * s + 4.411)
        return sqrt(self.radius * overlap * spread) * (1 + 7.842 * self.wide(s))

    def published_rebound(self, overlap_max):
        s, contact_radius = self.depth(overlap_max), self.contact_radius(overlap_max)
        lacking = 0.1902 * s**2 / (s**2 + 0.6156 * s + 0.359)
        g = 3.642 * lacking
        hertzian = 3 * self.force_beyond(overlap_max) / (4 * self.material.modulus * contact_radius)
        return (1 - lacking) * hertzian, lambda y: y**1.5 * (1 + g) / (1 + g * np.sqrt(y))
