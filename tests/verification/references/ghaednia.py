# SPDX-License-Identifier: GPL-2.0-or-later
"""H. Ghaednia, D. B. Marghitu & R. L. Jackson, J. Tribol. 137 (2014) 011403; Ghaednia et al., Int.
J. Impact Eng. 86 (2015) 307, eqs 32-34.

Yield and hardness H are those of Jackson & Green. d is the overlap, F the force, Y the yield
strength, and C = 1.295 e^(0.736 nu). F_c and d_c are force and overlap at yield, and x = d/d_c.
Index m is for the largest overlap; d_r is the residual overlap, and y = (d - d_r)/(d_m - d_r).
Beyond x = 1.9:

    F/F_c = exp(-0.17 x^(5/12)) x^1.5 + 4H/(C Y) (1 - exp(-x^(5/9)/78)) x^1.1
    d_r = 0.8 d_m (1 - ((x_m + 5.5)/6.5)^-2),  F = F_m y^1.5

The printed 1.1 can also be read as a factor, 1.1 x.
"""

from __future__ import annotations

import numpy as np
from references import jackson_green


class Reference(jackson_green.Reference):
    readings = ("loading prefactor", "reading pair")

    def beyond(self, overlap):
        x = overlap / self.overlap_c
        growth = 1.1 * x if self.reading == "loading prefactor" else x**1.1
        plastic = self.hardness_ratio(x) * (1 - np.exp(-(x ** (5 / 9)) / 78)) * growth
        return self.hertz(self.overlap_c) * (np.exp(-0.17 * x ** (5 / 12)) * x**1.5 + plastic)

    def residual(self, overlap_max):
        x = overlap_max / self.overlap_c
        return 0.8 * overlap_max * (1 - ((x + 5.5) / 6.5) ** -2)
