# SPDX-License-Identifier: GPL-2.0-or-later
"""W. J. Stronge, Impact Mechanics, Cambridge University Press (2000), ch. 6.

d is the overlap, F the force, a the contact radius, and Y the yield strength. Index Y is for yield,
index m for the largest overlap; d_r is the residual overlap, and y = (d - d_r)/(d_m - d_r).

Yield is at a mean pressure of 1.1 Y: a_Y = 3 pi/4 1.1 Y R*/E*, d_Y = a_Y^2/R*, F_Y = 1.1 Y pi
a_Y^2. With q = 2 d/d_Y - 1, the force is F_Y q (1 + ln q/3.3) up to a mean pressure of 2.8 Y, which
then stays constant.

Unloading is F = F_m y^1.5 with d_m - d_r = d_Y sqrt(q_m) in the book. With the option `unloading
area`, d_m - d_r is 3 F_m/(4 E* a_m) with a_m^2 = q_m a_Y^2. With `unloading original_radius`,
d_m - d_r is (3 F_m/(4 E* sqrt(R*)))^(2/3). d_r is at least 0.
"""

from __future__ import annotations

from math import exp, inf, pi, sqrt

import numpy as np
from references.central_impact import CentralImpact


class Reference(CentralImpact):
    energy_guard = True
    readings = ("unloading area", "unloading original_radius")

    def __init__(self, material, radius, speed):
        super().__init__(material, radius, speed)
        yield_pressure = 1.1 * material.yield_strength
        self.radius_y = 0.75 * pi * yield_pressure * radius / material.modulus
        self.overlap_y = self.radius_y**2 / radius
        force_y = pi * yield_pressure * self.radius_y**2

        def expanding(overlap):
            q = 2 * overlap / self.overlap_y - 1
            return force_y * q * (1 + np.log(q) / 3.3)

        def fully_plastic(overlap):
            return force_y * (2 * overlap / self.overlap_y - 1) * 2.8 / 1.1

        full = (exp(3 * (2.8 - 1.1)) + 1) / 2 * self.overlap_y
        self.pieces = [(self.overlap_y, self.hertz), (full, expanding), (inf, fully_plastic)]

    def contact_radius(self, overlap):
        return self.radius_y * np.sqrt(2 * overlap / self.overlap_y - 1)

    def published_rebound(self, overlap_max):
        q_max = 2 * overlap_max / self.overlap_y - 1
        load = 0.75 * self.loading_force(overlap_max) / self.material.modulus
        recovery = {
            "": self.overlap_y * sqrt(q_max),
            "unloading area": load / (self.radius_y * sqrt(q_max)),
            "unloading original_radius": (load / sqrt(self.radius)) ** (2 / 3),
        }
        return min(recovery[self.reading], overlap_max), lambda y: y**1.5
