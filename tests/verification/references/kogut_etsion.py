# SPDX-License-Identifier: GPL-2.0-or-later
"""L. Kogut & I. Etsion, J. Appl. Mech. 69 (2002) 657; unloading of Etsion, Kligerman & Kadin, Int.
J. Solids Struct. 42 (2005) 3716; Ghaednia et al., Int. J. Impact Eng. 86 (2015) 307, eqs 15-19.

d is the overlap, F the force, Y the yield strength, and H = 2.8 Y the hardness. Index m is for the
largest overlap; d_r is the residual overlap, and y = (d - d_r)/(d_m - d_r).

K = 0.454 + 0.41 nu, d_c = R* (pi K H/2E*)^2, F_c = 2/3 pi K H R* d_c, x = d/d_c:

    F/F_c = x^1.5 up to 1, 1.03 x^1.425 up to 6, then 1.40 x^1.263
    d_r = d_m (1 - x_m^-0.28) (1 - x_m^-0.69),  F = F_m y^n,  n = 1.5 x_m^-0.0331

Beyond x = 110, the last power law continues. With `fully_plastic on`, F = 2 pi R* d H there.
"""

from __future__ import annotations

from math import inf, pi, sqrt

from references.central_impact import CentralImpact


class Reference(CentralImpact):
    energy_guard = True
    readings = ("fully_plastic on",)

    def __init__(self, material, radius, speed):
        super().__init__(material, radius, speed)
        pressure = (0.454 + 0.41 * material.poissons_ratio) * 2.8 * material.yield_strength
        self.overlap_c = self.overlap_at(pressure)
        force_c = 2 / 3 * pi * pressure * radius * self.overlap_c

        def developed(overlap):
            return 1.40 * force_c * (overlap / self.overlap_c) ** 1.263

        def beyond(overlap):
            if self.reading == "fully_plastic on":
                return 2 * pi * radius * overlap * 2.8 * material.yield_strength
            return developed(overlap)

        self.pieces = [
            (1 * self.overlap_c, self.hertz),
            (6 * self.overlap_c, lambda d: 1.03 * force_c * (d / self.overlap_c) ** 1.425),
            (110 * self.overlap_c, developed),
            (inf, beyond),
        ]

    def contact_radius(self, overlap):
        x = overlap / self.overlap_c
        if self.reading == "fully_plastic on" and x > 110:
            return sqrt(2 * self.radius * overlap)
        area = 0.93 * x**1.136 if x <= 6 else 0.94 * x**1.146  # area / (pi R* d_c)
        return sqrt(self.radius * self.overlap_c * area)

    def released_radius(self, left, shape):
        return sqrt(left)  # not in the source: as for Hertz, for any exponent of the force

    def published_rebound(self, overlap_max):
        x = overlap_max / self.overlap_c
        residual = overlap_max * (1 - x**-0.28) * (1 - x**-0.69)
        return overlap_max - residual, lambda y: y ** (1.5 * x**-0.0331)
