# SPDX-License-Identifier: GPL-2.0-or-later
"""Elastic contact of the laws for spheres that do not use Hertz' contact."""

from __future__ import annotations

import numpy as np
from scipy.special import hyp2f1

from plastigran import laws

#: Laws whose elastic contact differs from LIGGGHTS' own hertz.
NOT_HERTZIAN = ("mdr",)


def mapped_sphere(
    pair: laws.MaterialPair, radius_eff: float, overlap: np.ndarray
) -> dict[str, np.ndarray]:
    """Return the elastic contact of `mdr` at an overlap d [m].

    The force is 2 E' R^2 [acos(1 - y) - (1 - y) sqrt(2y - y^2)] with y = d/2R. E' is the
    plane-strain modulus of the yielding body. R is chosen so that force and contact radius tend to
    those of Hertz' contact of the pair. The bracket equals 4 sqrt(2)/3 y^1.5 2F1(-1/2, 3/2; 5/2;
    y/2), with the hypergeometric function 2F1.
    """
    modulus = pair.youngs_modulus / (1 - pair.poissons_ratio**2)
    ratio = modulus / pair.youngs_modulus_eff
    radius = radius_eff * ratio
    y = overlap / ratio / (2 * radius)
    force = 2 * modulus * radius**2 * 4 * np.sqrt(2) / 3 * y**1.5
    return {
        "force": force * hyp2f1(-0.5, 1.5, 2.5, y / 2),
        "contact_radius": radius * np.sqrt(y * (2 - y)),
        "elastic_energy": 0.4 * force * overlap * hyp2f1(-0.5, 1.5, 3.5, y / 2),
        "plastic_work": np.zeros_like(y),
        "viscous_force": np.zeros_like(y),
        "surface_energy": np.zeros_like(y),
    }
