# SPDX-License-Identifier: GPL-2.0-or-later
"""M. R. Brake, Int. J. Solids Struct. 62 (2015) 104; Ghaednia et al., Int. J. Impact Eng. 86 (2015)
307, eqs 28-31.

d is the overlap, F the force (F_H: of Hertz), and a the contact radius. Index m is for the largest
overlap; d_r is the residual overlap, and y = (d - d_r)/(d_m - d_r).

Yield is at d_y = R* (pi p_y/2E*)^2. With d_p = R* (3 pi P0/2E*)^2, a_p^2 = 2 R* d_p and
s = (d - d_y)/(d_p - d_y),

    F = sech((n - 1) s) F_H + (1 - sech((3 - n) s)) pi P0 (2 R* d)^(n/2)/a_p^(n - 2)
    d_r = d_m (1 - F_m/F_H(d_m)), not below 0,  F = F_m y^1.5
    a^2 = R* d (2 - sech((n - 1) s))

P0 = 2.8 Y is the hardness, with the yield strength Y. Meyer's index n is 2 or another value. The
source has no contact radius; a is the contact radius of this package.
"""

from __future__ import annotations

from math import inf, pi

import numpy as np
from references.central_impact import CentralImpact


class Reference(CentralImpact):
    energy_guard = True
    readings = ("meyer_index 2.4",)

    def __init__(self, material, radius, speed):
        super().__init__(material, radius, speed)
        hardness = 2.8 * material.yield_strength
        pressure = material.yield_pressure
        overlap_y = self.overlap_at(pressure)
        overlap_p = radius * (1.5 * pi * hardness / material.modulus) ** 2

        def shares(overlap):
            """Return Meyer's index n, and s = (d - d_Y)/(d_p - d_Y) for the overlap d.

            d_Y is the overlap at yield, and d_p the overlap of a fully plastic contact.
            """
            index = 2.4 if self.reading == "meyer_index 2.4" else 2
            return index, (overlap - overlap_y) / (overlap_p - overlap_y)

        def beyond(overlap):
            index, s = shares(overlap)
            meyer = pi * hardness * (2 * radius * overlap) ** (index / 2)
            meyer /= (2 * radius * overlap_p) ** (index / 2 - 1)
            plastic = 1 - 1 / np.cosh((3 - index) * s)
            return self.hertz(overlap) / np.cosh((index - 1) * s) + plastic * meyer

        self.pieces = [(overlap_y, self.hertz), (inf, beyond)]
        self.shares = shares

    def contact_radius(self, overlap):
        index, s = self.shares(overlap)
        return np.sqrt(self.radius * overlap * (2 - 1 / np.cosh((index - 1) * s)))

    def published_rebound(self, overlap_max):
        share = self.loading_force(overlap_max) / self.hertz(overlap_max)
        return overlap_max * min(1, share), lambda y: y**1.5
