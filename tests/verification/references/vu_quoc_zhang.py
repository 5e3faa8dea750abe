# SPDX-License-Identifier: GPL-2.0-or-later
"""L. Vu-Quoc & X. Zhang, Proc. R. Soc. A 455 (1999) 4013; X. Zhang & L. Vu-Quoc, Int. J. Impact
Eng. 27 (2002) 317, eqs 4.1-4.9, written for the total overlap.

The law gives the overlap d as a function of the force F. p_y is the yield pressure. Index m is for
the largest overlap; d_r is the residual overlap, and y = (d - d_r)/(d_m - d_r). Beyond the yield
force P_Y = pi^3 R*^2 p_y^3/(6 E*^2):

    d = (a_e + a_p)^2/(C_R R*),  a_e^3 = 3 F R*/(4 E*),  a_p = C_a (F - P_Y),
    C_R = 1 + K_c (F - P_Y)

During unloading, a_p and C_R are constant: d_m - d_r = a_e,m^2/(C_R R*), F = F_m y^1.5. C_a and K_c
are valid only for the aluminum sphere of the paper, with a radius of 0.1 m.
"""

from __future__ import annotations

from math import inf, pi

from references import thornton
from references.central_impact import CentralImpact
from scipy.optimize import brentq

C_A, K_C = 2.33e-7, 2.69e-4  # m/N, 1/N


class Reference(CentralImpact):
    cases = thornton.Reference.cases

    def __init__(self, material, radius, speed):
        super().__init__(material, radius, speed)
        pressure = material.yield_pressure
        self.force_y = pi**3 * radius**2 * pressure**3 / (6 * material.modulus**2)
        overlap_y = self.overlap_at(pressure)
        self.pieces = [(overlap_y, self.hertz), (inf, self.force_beyond)]

    def elastic_radius(self, force):
        return (3 * force * self.radius / (4 * self.material.modulus)) ** (1 / 3)

    def overlap_under(self, force):
        beyond = max(force - self.force_y, 0.0)
        radius = self.elastic_radius(force) + C_A * beyond
        return radius**2 / ((1 + K_C * beyond) * self.radius)

    def force_beyond(self, overlap):
        reach = self.hertz(overlap)
        while self.overlap_under(reach) < overlap:
            reach *= 2
        return brentq(lambda force: self.overlap_under(force) - overlap, 0, reach, rtol=1e-15)

    def published_rebound(self, overlap_max):
        force_max = self.force_beyond(overlap_max)
        curvature = 1 + K_C * (force_max - self.force_y)
        recovery = self.elastic_radius(force_max) ** 2 / (curvature * self.radius)
        return recovery, lambda y: y**1.5
