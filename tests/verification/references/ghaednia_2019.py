# SPDX-License-Identifier: GPL-2.0-or-later
"""H. Ghaednia, M. R. W. Brake, M. Berryhill & R. L. Jackson, J. Tribol. 141 (2019) 031402.

The metal has a tangent modulus E_t, with e = E_t/E. d is the overlap, F the force (F_H: of Hertz),
a the contact radius, and Y the yield strength. The overlap d_c at yield, x = d/d_c, the contact
radius a_p and the hardness H are those of Jackson & Green. Beyond x = 1.9:

    F = F_p + (F_H - F_p)(1 - exp(-3.3 e)),  F_p by Jackson & Green, with H at the following a:
    a = a_e + (a_p - a_e) exp(U),  a_e = sqrt(R* d)
    U = -2 sqrt(E/Y) e^(1 - (d - d_c)/R*) / ((4 - 3 exp(-2 sqrt(E/Y) e)) (1 - e)), 0 for e = 0

Unloading from the largest overlap d_m to the residual overlap d_r follows Brake, Int. J. Solids
Struct. 62 (2015) 104: d_r = d_m (1 - F_m/F_H(d_m)), then Hertz with the radius that gives F_m at
d_m. With the option `unloading etsion_2005`, unloading follows Etsion, Kligerman & Kadin, Int. J.
Solids Struct. 42 (2005) 3716.
"""

from __future__ import annotations

import numpy as np
from references import jackson_green


class Reference(jackson_green.Reference):
    cases = """\
material,radius,speed
aluminium_zv02,0.1,0.02
aluminium_zv02,0.1,0.20
steel_s355,0.01,0.1
steel_s355,0.01,0.5
steel_s355,0.01,2.0
"""
    readings = ("unloading etsion_2005",)
    material_name = "steel_s355"

    def contact_radius(self, overlap):
        strength, modulus = self.material.yield_strength, self.material.youngs_modulus
        plastic = super().contact_radius(overlap)
        share = self.material.tangent_modulus / modulus
        if share == 0:
            return plastic
        root = np.sqrt(modulus / strength)
        power = -2 * root * share ** (1 - (overlap - self.overlap_c) / self.radius)
        power /= (4 - 3 * np.exp(-2 * root * share)) * (1 - share)
        elastic = np.sqrt(self.radius * overlap)
        return elastic + (plastic - elastic) * np.exp(power)

    def released_radius(self, left, shape):
        return np.sqrt(left)  # for both options of unloading, as in kogut_etsion

    def hardness_ratio(self, x):
        """Return 4 H/(C Y)."""
        ratio = self.contact_radius(x * self.overlap_c) / self.radius
        return 4 * (2.84 - 0.92 * (1 - np.cos(np.pi * ratio))) / self.yield_factor

    def beyond(self, overlap):
        plastic = super().beyond(overlap)
        hardened = 1 - np.exp(-3.3 * self.material.tangent_modulus / self.material.youngs_modulus)
        return plastic + (self.hertz(overlap) - plastic) * hardened

    def published_rebound(self, overlap_max):
        if self.reading == "unloading etsion_2005":
            x = overlap_max / self.overlap_c
            residual = overlap_max * (1 - x**-0.28) * (1 - x**-0.69)
            return overlap_max - residual, lambda y: y ** (1.5 * x**-0.0331)
        force = self.loading_force(overlap_max)
        residual = max(0.0, overlap_max * (1 - force / self.hertz(overlap_max)))
        # 4/3 E* sqrt(R_u) (d - d_r)^1.5 with R_u = (3 F_m/4E*)^2/(d_m - d_r)^3.
        stiffness = self.hertz(1.0) / np.sqrt(self.radius)
        radius = (force / stiffness) ** 2 / (overlap_max - residual) ** 3
        recovery = overlap_max - residual
        return recovery, lambda y: stiffness * np.sqrt(radius) * (y * recovery) ** 1.5 / force
