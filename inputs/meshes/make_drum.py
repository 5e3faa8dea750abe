#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Write drum.stl next to this file: the shell of a drum about the y axis.

Radius and length are 1, and the center is the origin. Decks scale the mesh.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from stl import write

#: Number of facets. Few facets keep the energy error small. LIGGGHTS transfers a grain to the next
#: facet when its center crosses the plane that is normal to the facet at the edge. At this plane,
#: the force jumps if the overlap exceeds (1 - cos(2 pi / FACETS)) of the grain radius. The shell
#: deviates from a circle by 1 % of its radius.
FACETS = 24


def shell(facets: int) -> np.ndarray:
    """Return the triangles of a prism inscribed in the cylinder.

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
