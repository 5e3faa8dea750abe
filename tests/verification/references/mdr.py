# SPDX-License-Identifier: GPL-2.0-or-later
"""W. Zunker & K. Kamrin, J. Mech. Phys. Solids 183 (2024) 105492, a single contact without
adhesion.

d is the overlap of a sphere of radius R and a rigid flat, F the force, a the contact radius, Y the
yield strength, and G the shear modulus. The sphere is mapped to an elliptical indenter of height A
and width B. It sinks by d_e into a bed of springs with E' = E/(1 - nu^2):

    F = E' A B/4 [acos(1 - 2 d_e/A) - (1 - 2 d_e/A) sqrt(4 d_e/A - 4 d_e^2/A^2)]

The contact is elastic, with A = 4R, B = 2R and d_e = d, while 4 E' sqrt(d)/(3 pi sqrt R) <= p(d),
that is up to d_Y, with p(d) = Y (1.75 exp(-4.4 d/R) + 1). Beyond, with the largest overlap d_m:

    a^2 = 2 d_m R - d_m^2 + d_Y^2 - d_Y R,  A = 4 p(d_m) a/E',  B = 2 a
    d_e = (d - d_m + A/2 + d_R)/(1 + 2 d_R/A)
    d_R = F_m (2 a^2 (nu-1) - (2 nu-1) z (sqrt(a^2+z^2) - z))/(2 pi a^2 G sqrt(a^2+z^2)),
    z = R - d_m + A/2, F_m = F at d_e = A/2
"""

from __future__ import annotations

from math import inf, pi, sqrt

import numpy as np
from references.central_impact import CentralImpact
from scipy.optimize import brentq
from scipy.special import hyp2f1


class Reference(CentralImpact):
    energy_guard = True
    cases = """\
material,radius,speed
aluminium_zv02,0.1,0.01
aluminium_zv02,0.1,0.05
aluminium_zv02,0.1,0.10
aluminium_zv02,0.1,0.20
"""

    def __init__(self, material, radius, speed):
        super().__init__(material, radius, speed)
        self.yield_overlap = brentq(
            lambda d: 4 * material.modulus * sqrt(d / radius) / (3 * pi) - self.pressure(d),
            0,
            radius,
            xtol=1e-30,
            rtol=1e-15,
        )
        self.pieces = [(self.yield_overlap, self.elastic), (inf, self.beyond)]

    def pressure(self, overlap):
        """Return the mean pressure p at which the contact yields [Pa]."""
        return self.material.yield_strength * (1.75 * np.exp(-4.4 * overlap / self.radius) + 1)

    def mapped(self, overlap, height, width):
        """Return the force on the elliptical indenter [N]. With q = d_e/A, acos(1 - 2q) - (1 - 2q)
        sqrt(4q - 4q^2) cancels for small q; it equals 16/3 q^1.5 2F1(-1/2, 3/2; 5/2; q)."""
        share = overlap / height
        shape = 16 / 3 * share**1.5 * hyp2f1(-0.5, 1.5, 2.5, share)
        return self.material.modulus * height * width / 4 * shape

    def elastic(self, overlap):
        return self.mapped(overlap, 4 * self.radius, 2 * self.radius)

    def contact_radius(self, overlap):
        """Return the largest contact radius a [m], at an overlap beyond yield."""
        intercept = self.yield_overlap**2 - self.yield_overlap * self.radius
        return np.sqrt(2 * overlap * self.radius - overlap**2 + intercept)

    def height(self, overlap):
        """Return A [m]."""
        return 4 * self.pressure(overlap) * self.contact_radius(overlap) / self.material.modulus

    def beyond(self, overlap):
        height, radius = self.height(overlap), self.contact_radius(overlap)
        return self.material.modulus * height * 2 * radius / 4 * (pi / 2)

    def published_rebound(self, overlap_max):
        nu, radius = self.material.poissons_ratio, self.contact_radius(overlap_max)
        height = self.height(overlap_max)
        depth = self.radius - overlap_max + height / 2
        slant = sqrt(radius**2 + depth**2)
        shear_modulus = self.material.youngs_modulus / (2 * (1 + nu))
        correction = (
            self.beyond(overlap_max)
            * (2 * radius**2 * (nu - 1) - (2 * nu - 1) * depth * (slant - depth))
            / (2 * pi * radius**2 * shear_modulus * slant)
        )
        recovery = height / 2 + correction

        def shape(left):
            return self.mapped(left * height / 2, height, 2 * radius) / self.beyond(overlap_max)

        return recovery, shape
