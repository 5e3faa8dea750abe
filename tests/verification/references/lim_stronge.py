# SPDX-License-Identifier: GPL-2.0-or-later
"""C. T. Lim & W. J. Stronge, Math. Comput. Model. 28 (1998) 323, as collected in R. R. Katta & A.
A. Polycarpou, J. Tribol. 132 (2010): a rigid cylinder of length L on a body of thickness D.

d is the overlap, F the force, a the half-width of the contact, R the radius of the cylinder, and Y
the yield strength of the body. Index Y is for yield, index m for the largest overlap; d_r is the
residual overlap, and R_b the radius of the crater. With q = F/(pi E* L) and kappa = nu/(1 - nu):

    elastic   d = q (ln(4 D^2/a^2) - kappa), a^2 = 4 q R  (Johnson, Contact Mechanics, sec. 5.6)
    yield     at a mean pressure of 1.5 Y: a_Y = 12 Y R/(pi E*)
    beyond    d = d_Y + (a^2 - a_Y^2)/(2R), F = 2 a L p, p = Y min(1.5 + ln(a/a_Y)/sqrt(3), 2.4)
    rebound   a straight line down to d_r = a_m^2/(2 R_b), 1/R_b = 1/R - 1/R_e, a_m^2 = 4 q_m R_e
"""

from __future__ import annotations

from math import exp, inf, log, pi, sqrt

import numpy as np
from references.central_impact import CentralImpact
from scipy.special import lambertw


class Reference(CentralImpact):
    cases = """\
material,radius,speed,mass,length_ratio,body_thickness
glass_kp10,1.0e-05,0.2,1.59e-6,10,1e-4
glass_kp10,1.0e-05,0.6,1.59e-6,10,1e-4
glass_kp10,1.0e-05,1,1.59e-6,10,1e-4
glass_kp10,2.0e-06,1,1.59e-6,10,1e-4
glass_kp10,1.0e-05,1,1.59e-6,100,1e-4
glass_kp10,1.0e-05,3,1.59e-6,100,1e-4
glass_kp10,5.0e-06,5,1.59e-6,100,1e-4
"""
    energy_guard = True

    def __init__(self, material, radius, speed, mass, length_ratio, body_thickness):
        super().__init__(material, radius, speed)
        self.mass, self.thickness = mass, body_thickness
        strength, length = material.yield_strength, length_ratio * radius
        self.kappa = material.poissons_ratio / (1 - material.poissons_ratio)
        self.line_stiffness = pi * material.modulus * length  # F/q
        self.radius_y = 12 * strength * radius / (pi * material.modulus)
        q_y = self.radius_y**2 / (4 * radius)
        self.overlap_y = q_y * (2 * log(2 * body_thickness / self.radius_y) - self.kappa)

        def elastic(overlap):
            # u = d/q solves u e^-u = z.
            z = overlap * radius * exp(self.kappa) / body_thickness**2
            return self.line_stiffness * overlap / -lambertw(-z, -1).real if overlap > 0 else 0.0

        def cavity(overlap):
            a = self.half_width(overlap)
            return 2 * a * length * strength * (1.5 + np.log(a / self.radius_y) / sqrt(3))

        def full(overlap):
            return 2 * self.half_width(overlap) * length * strength * 2.4

        radius_full = self.radius_y * exp(0.9 * sqrt(3))
        end = self.overlap_y + (radius_full**2 - self.radius_y**2) / (2 * radius)
        self.pieces = [(self.overlap_y, elastic), (end, cavity), (inf, full)]

    def half_width(self, overlap):
        """Return the half-width beyond yield [m]."""
        return np.sqrt(self.radius_y**2 + 2 * self.radius * (overlap - self.overlap_y))

    def crater(self, overlap_max):
        """Return half-width [m], q [m] and curvature 1/R_b [1/m] of the crater at the largest
        overlap.
        """
        half_width = self.half_width(overlap_max)
        q = self.loading_force(overlap_max) / self.line_stiffness
        return half_width, q, 1 / self.radius - 4 * q / half_width**2

    def published_rebound(self, overlap_max):
        half_width, _, curvature = self.crater(overlap_max)
        return overlap_max - half_width**2 * curvature / 2, lambda y: y
