# SPDX-License-Identifier: GPL-2.0-or-later
"""W. J. Stronge, Impact Mechanics, Cambridge University Press (2000), ch. 6.

Yield at a mean pressure of 1.1 Y: a_Y = 3 pi/4 1.1 Y R*/E*, d_Y = a_Y^2/R*, F_Y = 1.1 Y pi a_Y^2.
With q = 2 d/d_Y - 1 the force is F_Y q (1 + ln q/3.3) up to a mean pressure of 2.8 Y, which then
stays. The book's rebound: d_m - d_r = d_Y sqrt(q_m), F = F_m y^1.5.
"""

from __future__ import annotations

from math import exp, inf, pi, sqrt

import numpy as np
from references.central_impact import CentralImpact


class Reference(CentralImpact):
    energy_guard = True

    def __init__(self, material, radius, speed):
        super().__init__(material, radius, speed)
        yield_pressure = 1.1 * material.yield_strength
        radius_y = 0.75 * pi * yield_pressure * radius / material.modulus
        self.overlap_y = radius_y**2 / radius
        force_y = pi * yield_pressure * radius_y**2

        def expanding(overlap):
            q = 2 * overlap / self.overlap_y - 1
            return force_y * q * (1 + np.log(q) / 3.3)

        def fully_plastic(overlap):
            return force_y * (2 * overlap / self.overlap_y - 1) * 2.8 / 1.1

        full = (exp(3 * (2.8 - 1.1)) + 1) / 2 * self.overlap_y
        self.pieces = [(self.overlap_y, self.hertz), (full, expanding), (inf, fully_plastic)]

    def published_rebound(self, overlap_max):
        q_max = 2 * overlap_max / self.overlap_y - 1
        return self.overlap_y * sqrt(q_max), lambda y: y**1.5
