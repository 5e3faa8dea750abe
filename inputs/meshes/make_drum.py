#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Write drum.stl beside this file: the shell of a drum about the y axis.

Radius and length are 1, and the center is the origin. Decks scale it.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from stl import write

#: Few, for the sake of energy: LIGGGHTS hands a grain from a facet to the next where its centre
#: crosses the normal of their edge. The next one's force begins there, with a jump when the overlap
#: is beyond (1 - cos(2 pi / FACETS)) of the grain's radius. The shell is round to 1 % of its own.
FACETS = 24


def shell(facets: int) -> np.ndarray:
    """Triangles of a prism inscribed in the cylinder.

    Args:
        facets: Sides of the prism, two triangles each.

    Returns:
        (2 * facets, 3, 3) corners; normals point to the axis.
    """
    angle = 2 * np.pi * np.arange(facets + 1) / facets
    ring = np.column_stack([np.sin(angle), np.zeros(facets + 1), -np.cos(angle)])
    ring[-1] = ring[0]
    along = np.array([0, 0.5, 0])
    near, far = ring - along, ring + along
    lower = np.stack([near[:-1], far[1:], far[:-1]], axis=1)
    upper = np.stack([near[:-1], near[1:], far[1:]], axis=1)
    return np.stack([lower, upper], axis=1).reshape(-1, 3, 3)


if __name__ == "__main__":
    write(Path(__file__).with_name("drum.stl"), shell(FACETS))
