# SPDX-License-Identifier: GPL-2.0-or-later
"""C. Thornton, J. Appl. Mech. 64 (1997) 383.

d is the overlap, F the force, a the contact radius, and p_y the yield pressure. Index y is for
yield, index m for the largest overlap; d_r is the residual overlap, and y = (d - d_r)/(d_m - d_r).

Beyond d_y = R* (pi p_y/2E*)^2, the force grows linearly: F = F_y + pi p_y R* (d - d_y). Unloading
starts with the contact area at the largest overlap: d_m - d_r = 3 F_m/(4 E* a_m), a_m^2 = R* d_m,
and F = F_m y^1.5.
"""

from __future__ import annotations

from math import inf, pi, sqrt

from references.central_impact import CentralImpact


class Reference(CentralImpact):
    cases = """\
material,radius,speed
aluminium_zv02,0.1,0.001
aluminium_zv02,0.1,0.02
aluminium_zv02,0.1,0.06
aluminium_zv02,0.1,0.10
aluminium_zv02,0.1,0.20
"""

    def __init__(self, material, radius, speed):
        super().__init__(material, radius, speed)
        pressure = material.yield_pressure
        overlap_y = self.overlap_at(pressure)

        def beyond(overlap):
            return self.hertz(overlap_y) + pi * pressure * radius * (overlap - overlap_y)

        self.pieces = [(overlap_y, self.hertz), (inf, beyond)]

    def contact_radius(self, overlap):
        return sqrt(self.radius * overlap)

    def published_rebound(self, overlap_max):
        force_max, contact_radius = (
            self.loading_force(overlap_max),
            self.contact_radius(overlap_max),
        )
        return 3 * force_max / (4 * self.material.modulus * contact_radius), lambda y: y**1.5
