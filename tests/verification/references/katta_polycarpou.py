# SPDX-License-Identifier: GPL-2.0-or-later
"""R. R. Katta & A. A. Polycarpou, J. Tribol. 132 (2010): loading of Lim & Stronge, new unloading.

d is the overlap, F the force, and a the half-width of the contact of a cylinder of radius R. Index
m is for the largest overlap; d_r is the residual overlap.

    d_r = a_r^2/(2 R_b),  a_r^2 = a_m^2 - a_el^2,  a_el^2 = 4 q_m/(1/R + 1/R_b)
    x = y (1 - ln(y)/C'),  C' = ln(4 D^2/a_m^2) - kappa

with x = (d - d_r)/(d_m - d_r) and, unlike in contact.py, y = F/F_m. The thickness D, the radius R_b
of the crater, q and kappa are those of lim_stronge.py.
"""

from __future__ import annotations

from math import exp, log

from references import lim_stronge
from scipy.special import lambertw


class Reference(lim_stronge.Reference):
    def published_rebound(self, overlap_max):
        half_width, q, curvature = self.crater(overlap_max)
        stays = half_width**2 - 4 * q / (1 / self.radius + curvature)
        c = 2 * log(2 * self.thickness / half_width) - self.kappa

        def shape(x):  # u = x C'/y solves u e^-u = x C' e^-C'
            return x * c / -lambertw(-x * c * exp(-c), -1).real if x > 0 else 0.0

        return overlap_max - stays * curvature / 2, shape
