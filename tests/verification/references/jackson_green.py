# SPDX-License-Identifier: GPL-2.0-or-later
"""R. L. Jackson & I. Green, J. Tribol. 127 (2005) 343; residual overlap of Jackson, Green &
Marghitu, Nonlinear Dyn. 60 (2010) 217; hardness of Ghaednia et al., Int. J. Impact Eng. 86 (2015)
307, eqs 9-14.

d is the overlap, F the force, a the contact radius, Y the yield strength, and H the hardness. Index
m is for the largest overlap; d_r is the residual overlap, and y = (d - d_r)/(d_m - d_r).

C = 1.295 e^(0.736 nu), d_c = R* (pi C Y/2E*)^2, F_c = 4/3 E* sqrt(R*) d_c^1.5, x = d/d_c. Beyond
x = 1.9:

    F/F_c = exp(-x^(5/12)/4) x^1.5 + 4H/(C Y) (1 - exp(-x^(5/9)/25)) x
    H/Y = 2.84 - 0.92 (1 - cos(pi a/R*)),  a^2 = R* d (x/1.9)^B,  B = 0.14 exp(23 Y/E*)
    d_r = 1.02 d_m (1 - ((x_m + 5.9)/6.9)^-0.54),  F = F_m y^1.5

With the option `hardness exponential`, H/Y = 2.84 (1 - exp(-0.82 (a/R*)^-0.7)), as in 2005. With
`reading pair`, R* and E* are those of the pair.
"""

from __future__ import annotations

from math import exp, inf, pi

import numpy as np
from references.central_impact import CentralImpact


class Reference(CentralImpact):
    energy_guard = True
    readings = ("hardness exponential", "reading pair")

    def __init__(self, material, radius, speed):
        super().__init__(material, radius, speed)
        self.yield_factor = 1.295 * exp(0.736 * material.poissons_ratio)
        self.overlap_c = self.overlap_at(self.yield_factor * material.yield_strength)
        self.pieces = [(1.9 * self.overlap_c, self.hertz), (inf, self.beyond)]

    def contact_radius(self, overlap):
        growth = 0.14 * exp(23 * self.material.yield_strength / self.material.modulus)
        return np.sqrt(self.radius * overlap * (overlap / (1.9 * self.overlap_c)) ** growth)

    def hardness_ratio(self, x):
        """Return 4 H/(C Y)."""
        ratio = self.contact_radius(x * self.overlap_c) / self.radius
        if self.reading == "hardness exponential":
            hardness = 2.84 * (1 - np.exp(-0.82 * ratio**-0.7))
        else:
            hardness = 2.84 - 0.92 * (1 - np.cos(pi * ratio))
        return 4 * hardness / self.yield_factor

    def beyond(self, overlap):
        x = overlap / self.overlap_c
        plastic = self.hardness_ratio(x) * (1 - np.exp(-(x ** (5 / 9)) / 25)) * x
        return self.hertz(self.overlap_c) * (np.exp(-(x ** (5 / 12)) / 4) * x**1.5 + plastic)

    def residual(self, overlap_max):
        x = overlap_max / self.overlap_c
        return 1.02 * overlap_max * (1 - ((x + 5.9) / 6.9) ** -0.54)

    def published_rebound(self, overlap_max):
        return overlap_max - self.residual(overlap_max), lambda y: y**1.5
