# SPDX-License-Identifier: GPL-2.0-or-later
"""L. Kogut & K. Komvopoulos, J. Mater. Res. 19 (2004) 3641; Ghaednia et al., Int. J. Impact Eng. 86
(2015) 307, eqs 20-22.

d is the overlap, F the force, and Y the yield strength. Index m is for the largest overlap; d_r is
the residual overlap, and y = (d - d_r)/(d_m - d_r). With r'^2 = d (2R* - d) and t = d/r', the
contact is Hertzian up to (E*/Y) t = 1.78, then

    F = pi r'^2 Y (0.839 + ln((E*/Y)^0.656 t^0.651))/(2.192 - ln((E*/Y)^0.394 t^0.419))
    d_m - d_r = 0.591 (E*/Y)^-0.156 d_m,  F = F_m y^1.5

The denominator is at least 0.71.
"""

from __future__ import annotations

from math import exp, inf, pi

import numpy as np
from references.central_impact import CentralImpact


class Reference(CentralImpact):
    energy_guard = True
    readings = ("reading pair",)

    def __init__(self, material, radius, speed):
        super().__init__(material, radius, speed)
        self.ratio = ratio = material.modulus / material.yield_strength

        def area(overlap):
            """Return pi r'^2 over the denominator: the contact area of Ye & Komvopoulos."""
            truncated = overlap * (2 * radius - overlap)
            slope = overlap / np.sqrt(truncated)
            share = np.maximum(0.71, 2.192 - np.log(ratio**0.394 * slope**0.419))
            return pi * truncated / share

        def beyond(overlap):
            slope = np.sqrt(overlap / (2 * radius - overlap))
            pressure = 0.839 + np.log(ratio**0.656 * slope**0.651)
            return area(overlap) * material.yield_strength * pressure

        def end(slope):
            return 2 * radius * slope**2 / (1 + slope**2)

        self.area = area
        held = (exp(2.192 - 0.71) / ratio**0.394) ** (1 / 0.419)
        self.pieces = [(end(1.78 / ratio), self.hertz), (end(held), beyond), (inf, beyond)]

    def contact_radius(self, overlap):
        return np.sqrt(self.area(overlap) / pi)

    def published_rebound(self, overlap_max):
        return 0.591 * self.ratio**-0.156 * overlap_max, lambda y: y**1.5
