# SPDX-License-Identifier: GPL-2.0-or-later
"""A rigid frictionless plane under a sphere: a penalty at the Gauss points of the surface's edges.

The undeformed surface is the exact circle, not its elements: the gap at radius r is
R - sqrt(R^2 - r^2) + u_y - h over a plane of height h. Pressures act on the horizontal projection
of the surface.
"""

from __future__ import annotations

from math import pi

import attrs
import numpy as np
from skfem import ElementQuadS2, ElementVector, FacetBasis

from plastigran.fem.body import Body

EDGE_ORDER = 5  # three Gauss points on an edge: fewer make the force waver as edges open
PENALTY = 50.0  # stiffness over E*/h, h the length of the edge


@attrs.frozen
class Touch:
    """Contact at one displacement.

    Attributes:
        force: Upward on the body, N.
        nodal: Forces on the degrees of freedom (size,), N.
        stiffness: Of each edge (n_edges, 3, 3), N/m.
        gap: At the Gauss points from the axis outward (n_points,), m.
        pressure: There (n_points,), Pa.
        stored: Energy in the penalty, J.
    """

    force: float
    nodal: np.ndarray
    stiffness: np.ndarray
    gap: np.ndarray
    pressure: np.ndarray
    stored: float


class RigidPlane:
    """The plane under the lower half of a sphere.

    Attributes:
        dofs: Vertical degrees of freedom of each edge (n_edges, 3).
        radii: Distances of the Gauss points from the axis, increasing (n_points,), m.
    """

    def __init__(self, body: Body, radius: float, reach: float, penalty: float = PENALTY) -> None:
        """
        Args:
            body: The sphere.
            radius: Of the sphere, m.
            reach: No contact is looked for beyond this distance from the axis, m.
            penalty: Stiffness over E*/h.
        """
        mesh = body.mesh
        facets = mesh.boundaries["circle"]
        ends = mesh.p[:, mesh.facets[:, facets]]
        near = (ends[0].max(axis=0) < reach) & (ends[1].max(axis=0) < radius)
        facets = facets[near][np.argsort(ends[0].mean(axis=0)[near])]
        basis = FacetBasis(mesh, ElementVector(ElementQuadS2()), facets=facets, intorder=EDGE_ORDER)
        scalar = basis.with_element(ElementQuadS2())
        values = np.array([np.asarray(shape[0]) for shape in scalar.basis])  # (8, edges, points)
        on_edge = np.sort(np.argsort(-np.abs(values).max(axis=2), axis=0)[:3], axis=0)
        shapes = np.take_along_axis(values, on_edge[:, :, None], axis=0)
        self.dofs = np.take_along_axis(basis.element_dofs, 2 * on_edge + 1, axis=0).T.copy()
        distance = np.asarray(basis.global_coordinates())[0]
        order = np.argsort(distance, axis=1)
        self._shapes = np.take_along_axis(shapes, order[None], axis=2).transpose(1, 2, 0)
        distance, weight = (
            np.take_along_axis(array, order, axis=1)
            for array in (distance, np.abs(basis.normals[1]) * basis.dx)
        )
        self._areas = 2 * pi * distance * weight
        material = body.material
        modulus = material.youngs_modulus / (1 - material.poissons_ratio**2)
        self._stiffness = penalty * modulus / basis.dx.sum(axis=1)[:, None]
        self._heights = radius - np.sqrt(radius**2 - distance**2)
        self.radii = distance.ravel()
        self._size = body.size

    def touch(self, displacement: np.ndarray, height: float) -> Touch:
        """Contact at displacements (size,), m, over a plane at `height`, m."""
        moved = (self._shapes @ displacement[self.dofs][:, :, None])[:, :, 0]
        gap = self._heights + moved - height
        pressure = self._stiffness * np.maximum(-gap, 0)
        nodal = np.bincount(
            self.dofs.ravel(),
            np.einsum("eq,eqn->en", pressure * self._areas, self._shapes).ravel(),
            minlength=self._size,
        )
        closed = self._stiffness * self._areas * (gap < 0)
        stiffness = np.einsum("eq,eqn,eqm->enm", closed, self._shapes, self._shapes)
        return Touch(
            float(np.sum(pressure * self._areas)),
            nodal,
            stiffness,
            gap.ravel(),
            pressure.ravel(),
            float(np.sum(closed * gap**2) / 2),
        )

    def profile(self, pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Mean radius and mean pressure of each edge. Within an edge the penalty's pressure sways
        about its mean by some per cent, for the edge is a parabola and the plane is stiff."""
        areas = self._areas / self._areas.sum(axis=1, keepdims=True)
        radii, pressures = self.radii.reshape(areas.shape), pressure.reshape(areas.shape)
        return (radii * areas).sum(axis=1), (pressures * areas).sum(axis=1)

    def spread(self, stiffness: np.ndarray) -> np.ndarray:
        """Forces (size,) that edge stiffnesses give to a plane raised by one, N/m."""
        return np.bincount(self.dofs.ravel(), stiffness.sum(axis=2).ravel(), minlength=self._size)

    def contact_radius(self, gap: np.ndarray) -> float:
        """Where the gap opens, m: past a contact's edge it grows as (r - a)^(3/2), so its power 2/3
        through the first two open points is drawn back to zero."""
        closed = np.flatnonzero(gap < 0)
        if closed.size == 0:
            return 0.0
        first = closed[-1] + 1
        if first + 1 >= gap.size:
            return float(self.radii[-1])
        inner, outer = gap[first : first + 2] ** (2 / 3)
        left, right = self.radii[first : first + 2]
        if outer <= inner:
            return float(left)
        edge = left - inner * (right - left) / (outer - inner)
        return float(max(edge, self.radii[first - 1]))
