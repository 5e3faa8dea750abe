# SPDX-License-Identifier: GPL-2.0-or-later
"""docs/laws/universal.md, for a perfectly plastic sphere of radius R and modulus E' on a plane.

With d_y = R (pi p_y/2E')^2, F_y and a_y Hertz's there, t = sqrt(d/d_y), s = t - 1,
w = (p_y/p_y(nu = 0.3))^2 at the same yield strength, r = a_y/R:

    S = t (19.89 + w s)/(19.89 + s) - 1
    F_y t^3/F = 1 + 0.1316 S^2 (S + 6.028)/((S + 3.7)(S + 1.429)) (1 + 3.266 (rS)^2/(1 + rS))
    (a/a_y t)^2 = (1 + 1.209 S^2/(S^2 + 5.001 S + 4.204)) (1 + 0.351 r S)^2
    D = 0.1917 S^2/(S^2 + 0.6424 S + 0.3508)
    d_m - d_r = (1 - D) 3 F_m/(4 E' a_m),  F = F_m y^1.5 (1 + g)/(1 + g sqrt(y)),  g = 3.622 D
"""

from __future__ import annotations

from math import inf, sqrt

import numpy as np
from references import thornton
from references.central_impact import CentralImpact

#: p_y/sigma_Y of a Hertzian contact at nu = 0.3 (Johnson, Contact Mechanics, 1985, sec. 4.1): the
#: inverse of the largest 1.5/(1 + z^2) - 1.3 (1 - z atan(1/z)).
DEPTHS = np.linspace(0.47, 0.49, 2_000_001)
AT_NU_03 = 1 / float(np.max(1.5 / (1 + DEPTHS**2) - 1.3 * (1 - DEPTHS * np.arctan(1 / DEPTHS))))


class Reference(CentralImpact):
    cases = thornton.Reference.cases

    def __init__(self, material, radius, speed):
        super().__init__(material, radius, speed)
        self.overlap_y = self.overlap_at(material.yield_pressure)
        self.pieces = [(self.overlap_y, self.hertz), (inf, self.force_beyond)]

    def depth(self, overlap):
        t = np.sqrt(overlap / self.overlap_y)
        w = (self.material.yield_pressure_factor / AT_NU_03) ** 2
        return t * (19.89 + w * (t - 1)) / (19.89 + t - 1) - 1

    def wide(self, depth):
        """r S."""
        return sqrt(self.overlap_y / self.radius) * depth

    def force_beyond(self, overlap):
        s = self.depth(overlap)
        rs = self.wide(s)
        resisting = 0.1316 * s**2 * (s + 6.028) / ((s + 3.7) * (s + 1.429))
        return self.hertz(overlap) / (1 + resisting * (1 + 3.266 * rs**2 / (1 + rs)))

    def published_rebound(self, overlap_max):
        s = self.depth(overlap_max)
        spread = 1 + 1.209 * s**2 / (s**2 + 5.001 * s + 4.204)
        contact_radius = sqrt(self.radius * overlap_max * spread) * (1 + 0.351 * self.wide(s))
        lacking = 0.1917 * s**2 / (s**2 + 0.6424 * s + 0.3508)
        g = 3.622 * lacking
        hertzian = 3 * self.force_beyond(overlap_max) / (4 * self.material.modulus * contact_radius)
        return (1 - lacking) * hertzian, lambda y: y**1.5 * (1 + g) / (1 + g * np.sqrt(y))
