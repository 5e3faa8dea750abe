# SPDX-License-Identifier: GPL-2.0-or-later
"""N. Ye & K. Komvopoulos, J. Tribol. 125 (2003) 685; Ghaednia et al., Int. J. Impact Eng. 86 (2015)
307, eqs 23-27.

d is the overlap, F the force, A the contact area, p the mean pressure, and Y the yield strength.
Index m is for the largest overlap, and y = (d - d_r)/(d_m - d_r) with the residual overlap d_r.
With r'^2 = d (2R* - d) and Q = (E*/Y) d/r', the contact is Hertzian up to Q = 1.78, then F = p A:

    p = Y (0.70 ln Q + 0.66), from Q = 21 on 2.9 Y
    A = pi r'^2/(0.05 ln^2 Q - 0.57 ln Q + 2.41), from Q = 400 on pi r'^2/0.71

The residual overlap is that of Jackson & Green, which is 0 up to 1.9 d_c; F = F_m y^1.5.
"""

from __future__ import annotations

from math import inf, pi

import numpy as np
from references import jackson_green
from references.central_impact import CentralImpact


class Reference(CentralImpact):
    energy_guard = True
    readings = ("reading pair",)

    def __init__(self, material, radius, speed):
        super().__init__(material, radius, speed)
        strength, ratio = material.yield_strength, material.modulus / material.yield_strength
        self.jackson_green = jackson_green.Reference(material, radius, speed)

        def log_q(overlap):
            return np.log(ratio * np.sqrt(overlap / (2 * radius - overlap)))

        def area(overlap):
            q = log_q(overlap)
            return pi * overlap * (2 * radius - overlap) / (0.05 * q**2 - 0.57 * q + 2.41)

        def widest(overlap):
            return pi * overlap * (2 * radius - overlap) / 0.71

        def end(q):
            squared = (q / ratio) ** 2
            return 2 * radius * squared / (1 + squared)

        self.pieces = [
            (end(1.78), self.hertz),
            (end(21), lambda d: strength * (0.70 * log_q(d) + 0.66) * area(d)),
            (end(400), lambda d: 2.9 * strength * area(d)),
            (inf, lambda d: 2.9 * strength * widest(d)),
        ]
        self.areas = area, widest

    def contact_radius(self, overlap):
        area, widest = self.areas
        return np.sqrt((area if overlap <= self.pieces[2][0] else widest)(overlap) / pi)

    def published_rebound(self, overlap_max):
        elastic = overlap_max <= self.jackson_green.pieces[0][0]
        residual = 0 if elastic else self.jackson_green.residual(overlap_max)
        return overlap_max - residual, lambda y: y**1.5
