# SPDX-License-Identifier: GPL-2.0-or-later
"""Element edges on the surface of a body, and their Gauss points for the contact."""

from __future__ import annotations

import numpy as np
from skfem import ElementQuadS2, ElementVector, FacetBasis

from plastigran.fem.body.body import Body

# Integration order for three Gauss points per edge. With fewer points, the force oscillates while
# edges open.
EDGE_ORDER = 5


class Edges:
    """Element edges and their Gauss points, sorted by their first coordinate (r or x).

    Attributes:
        dofs: Degrees of freedom of the three nodes of each edge, in both directions
            (n_edges, 3, 2).
        shapes: Shape functions of the three nodes at the Gauss points (n_edges, n_points, 3).
        first: First coordinate of the Gauss points (n_edges, n_points), m.
        areas: Surface area that each Gauss point represents, projected on the horizontal
            (n_edges, n_points), m2.
        lengths: Lengths of the edges (n_edges,), m.
    """

    def __init__(self, body: Body, facets: np.ndarray) -> None:
        """Collect the element edges with the IDs `facets` in the mesh of the body."""
        mesh = body.mesh
        facets = facets[np.argsort(mesh.p[0, mesh.facets[:, facets]].mean(axis=0))]
        basis = FacetBasis(mesh, ElementVector(ElementQuadS2()), facets=facets, intorder=EDGE_ORDER)
        scalar = basis.with_element(ElementQuadS2())
        values = np.array([np.asarray(shape[0]) for shape in scalar.basis])  # (8, edges, points)
        on_edge = np.sort(np.argsort(-np.abs(values).max(axis=2), axis=0)[:3], axis=0)
        shapes = np.take_along_axis(values, on_edge[:, :, None], axis=0)
        self.dofs = np.stack(
            [np.take_along_axis(basis.element_dofs, 2 * on_edge + i, axis=0).T for i in (0, 1)],
            axis=-1,
        )
        first = np.asarray(basis.global_coordinates())[0]
        order = np.argsort(first, axis=1)
        self.shapes = np.take_along_axis(shapes, order[None], axis=2).transpose(1, 2, 0)
        self.first, projected = (
            np.take_along_axis(array, order, axis=1)
            for array in (first, np.abs(basis.normals[1]) * basis.dx)
        )
        self.areas = body.thickness(self.first) * projected
        self.lengths = basis.dx.sum(axis=1)

    def mean(self, values: np.ndarray) -> np.ndarray:
        """Return the mean on each edge (n_edges,) of values at the Gauss points (n_points,).

        The mean removes oscillations of the penalty pressure. Within an edge, the pressure
        oscillates by some per cent, because the edge is a parabola and the other body is stiff.
        """
        areas = self.areas / self.areas.sum(axis=1, keepdims=True)
        return (values.reshape(areas.shape) * areas).sum(axis=1)


def contact_edge(coordinates: np.ndarray, gap: np.ndarray) -> float:
    """Return the coordinate at which the gap opens, m; 0 without contact.

    Near the contact edge r = a, the gap grows as (r - a)^(3/2). The power 2/3 of the gap is
    extrapolated linearly to zero from the first two open points.

    Args:
        coordinates: Coordinates of the Gauss points, from inside to outside (n_points,), m.
        gap: Gap at these points (n_points,), m.
    """
    closed = np.flatnonzero(gap < 0)
    if closed.size == 0:
        return 0.0
    first = closed[-1] + 1
    if first + 1 >= gap.size:
        return float(coordinates[-1])
    inner, outer = gap[first : first + 2] ** (2 / 3)
    left, right = coordinates[first : first + 2]
    if outer <= inner:
        return float(left)
    edge = left - inner * (right - left) / (outer - inner)
    return float(max(edge, coordinates[first - 1]))
