# SPDX-License-Identifier: GPL-2.0-or-later
"""Surface of a half space under a sphere, with the same penalty as a rigid plane.

Each Gauss point of the sphere's edges faces the surface point with the same radius in the
undeformed state. Sliding between the two surfaces must be small.
"""

from __future__ import annotations

import numpy as np

from plastigran.fem.body.body import Body
from plastigran.fem.body.pair import Pair
from plastigran.fem.contact.edges import Edges
from plastigran.fem.contact.plane import PENALTY, RigidPlane


class HalfSpace(RigidPlane):
    """Surface of the half space, the lower body of a pair.

    The argument `height` of `touch` is the height of the base of the half space. The base is the
    boundary far below the contact.

    Attributes:
        dofs: Vertical degrees of freedom of the sphere's edge and of the surface, for each Gauss
            point (n_points, 6).
    """

    def __init__(self, pair: Pair, radius: float, reach: float, penalty: float = PENALTY) -> None:
        """Pair the Gauss points of the sphere with points of the surface.

        The arguments are those of `RigidPlane`. `penalty` is the penalty stiffness divided by E*/h,
        with the effective modulus E* of both bodies and the length h of an element edge.
        """
        sphere, block = pair.sphere, pair.block
        modulus = sphere.material.pair_modulus(block.material)
        super().__init__(sphere, radius, reach, penalty * modulus / sphere.material.plane_modulus)
        facets = block.mesh.boundaries["surface"]
        first = block.mesh.p[0, block.mesh.facets[:, facets]].min(axis=0)
        surface_dofs, surface_shapes = _below(
            Edges(block, facets[first < reach]), self.radii, block
        )
        points = self._shapes.shape[1]
        self.dofs = np.hstack([np.repeat(self.dofs, points, axis=0), sphere.size + surface_dofs])
        sphere_shapes = self._shapes.reshape(-1, self._shapes.shape[2])
        self._shapes = np.hstack([sphere_shapes, -surface_shapes])[:, None]
        self._stiffness = np.repeat(self._stiffness, points, axis=0)
        self._areas, self._heights = self._areas.reshape(-1, 1), self._heights.reshape(-1, 1)
        self._size = pair.size


def _below(edges: Edges, radii: np.ndarray, block: Body) -> tuple[np.ndarray, np.ndarray]:
    """Return the element edges of the surface below points with given distances from the axis.

    Args:
        edges: Element edges of the surface.
        radii: Distances from the axis (n,), m.
        block: Half space.

    Returns:
        Vertical degrees of freedom of the three nodes of each edge (n, 3), and the values of their
        shape functions at `radii` (n, 3).
    """
    ends = block.locations[0, edges.dofs[:, :2, 0]]
    edge = np.searchsorted(ends.max(axis=1), radii)
    start, end = ends[edge].T
    place = (2 * radii - start - end) / (end - start)
    shapes = [place * (place - 1) / 2, place * (place + 1) / 2, 1 - place**2]
    return edges.dofs[edge, :, 1], np.stack(shapes, axis=-1)
