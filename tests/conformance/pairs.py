# SPDX-License-Identifier: GPL-2.0-or-later
"""Material pairs for the tests of loading paths, and their overlap and force at yield."""

from __future__ import annotations

import numpy as np

from plastigran import laws
from plastigran.physics import central

RADIUS = 0.01
LENGTH = 0.1  # length of cylinders and thickness of bodies [m]; default of law_between
PAIRS = {
    "aluminium on rigid": laws.combine(
        laws.Body(7e10, 0.3, 1e8, 1.61), laws.Body(1e30, 0.3, 1e30, 1.61)
    ),
    "polymer on steel": laws.combine(laws.Body(2e9, 0.4, 5e7), laws.Body(2.1e11, 0.3, 3e8)),
}


def scales(law_name: str, pair: laws.MaterialPair) -> tuple[float, float]:
    """Return overlap [m] and force [N] at first yield of spheres or cylinders."""
    if laws.LAWS[law_name].shape == "cylinder":
        force, overlap, _ = central.line_yield(pair, RADIUS, LENGTH, LENGTH)
        return overlap, force
    overlap = RADIUS * laws.yield_radius_ratio(pair) ** 2
    force = 4 / 3 * pair.youngs_modulus_eff * np.sqrt(RADIUS) * overlap**1.5
    return overlap, force
