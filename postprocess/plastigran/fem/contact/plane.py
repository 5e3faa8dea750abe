# SPDX-License-Identifier: GPL-2.0-or-later
"""Contact of a sphere with a rigid frictionless plane below: penalty method at Gauss points.

The undeformed surface is the exact circle, not the edges of the elements. At distance r from the
axis, the gap is therefore R - sqrt(R^2 - r^2) + u_y - h, with the sphere radius R, the vertical
displacement u_y of the surface and the height h of the plane. Pressures act on the horizontal
projection of the surface.
"""

from __future__ import annotations

import attrs
import numpy as np

from plastigran.fem.body.body import Body
from plastigran.fem.contact.edges import Edges, contact_edge

# Number of nodes of an element edge of the sphere. In `dofs`, these nodes come before the nodes of
# a half space.
EDGE_NODES = 3
PENALTY = 50.0  # penalty stiffness divided by E*/h, with the length h of an element edge


@attrs.frozen
class Touch:
    """State of the contact at given displacements of the body.

    Attributes:
        force: Upward force on the body, N.
        nodal: Forces on the degrees of freedom (size,), N.
        stiffness: Stiffness matrix of each element edge with n degrees of freedom (n_edges, n, n),
            N/m.
        gap: Gap at the Gauss points from the axis outward (n_points,), m.
        pressure: Pressure at the Gauss points, per undeformed area (n_points,), Pa.
        stored: Elastic energy of the penalty springs, J.
    """

    force: float
    nodal: np.ndarray
    stiffness: np.ndarray
    gap: np.ndarray
    pressure: np.ndarray
    stored: float


@attrs.frozen
class PlaneTouch(Touch):
    """State of the contact with a plane.

    Attributes:
        radii: Distances of the Gauss points from the axis (n_points,), m; in small strain,
            distances in the undeformed body.
        widening: Deformed / undeformed horizontal area of each element edge (n_edges,); 1 in small
            strain.
    """

    radii: np.ndarray
    widening: np.ndarray

    @property
    def contact_radius(self) -> float:
        """Contact radius, m: distance from the axis at which the gap opens."""
        return contact_edge(self.radii, self.gap)


class RigidPlane:
    """Plane under the lower half of a sphere.

    Attributes:
        dofs: Vertical degrees of freedom of each element edge (n_edges, 3).
        radii: Undeformed distances of the Gauss points from the axis, increasing (n_points,), m.
    """

    def __init__(self, body: Body, radius: float, reach: float, penalty: float = PENALTY) -> None:
        """Collect the edges of the sphere that may touch the plane.

        Args:
            body: Sphere.
            radius: Radius of the sphere, m.
            reach: Largest distance from the axis at which contact is possible, m.
            penalty: Penalty stiffness divided by E*/h, with the length h of an element edge.
        """
        mesh = body.mesh
        facets = mesh.boundaries["circle"]
        ends = mesh.p[:, mesh.facets[:, facets]]
        near = (ends[0].max(axis=0) < reach) & (ends[1].max(axis=0) < radius)
        self._edges = edges = Edges(body, facets[near])
        self.dofs = edges.dofs[:, :, 1].copy()
        self._shapes, self._areas = edges.shapes, edges.areas
        self._stiffness = penalty * body.material.plane_modulus / edges.lengths[:, None]
        self._heights = radius - np.sqrt(radius**2 - edges.first**2)
        self.radii = edges.first.ravel()
        self._size = body.size
        self._radial = edges.dofs[:, :, 0].copy()
        self._ends = body.locations[0, self._radial[:, :2]]
        self._follows = body.kinematics.surface_moves

    def touch(self, displacement: np.ndarray, height: float) -> PlaneTouch:
        """Return the state of the contact at displacements (size,), m; `height` is in m."""
        rise = (self._shapes @ displacement[self.dofs][:, :, None])[:, :, 0]
        gap = self._heights + rise - height
        pressure = self._stiffness * np.maximum(-gap, 0)
        nodal = np.einsum("eq,eqn->en", pressure * self._areas, self._shapes)
        closed = self._stiffness * self._areas * (gap < 0)
        stiffness = np.einsum("eq,eqn,eqm->enm", closed, self._shapes, self._shapes)
        return PlaneTouch(
            float(np.sum(pressure * self._areas)),
            self._scatter(nodal),
            stiffness,
            gap.ravel(),
            pressure.ravel(),
            float(np.sum(closed * gap**2) / 2),
            *self._radii_and_widening(displacement),
        )

    def _radii_and_widening(self, displacement: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        if not self._follows:
            return self.radii, np.ones(len(self._edges.lengths))
        outward = (self._shapes @ displacement[self._radial][:, :, None]).ravel()
        ends = self._ends + displacement[self._radial[:, :2]]
        area, undeformed = (np.abs(np.diff(r**2, axis=1)[:, 0]) for r in (ends, self._ends))
        return self.radii + outward, area / undeformed

    def profile(self, touch: PlaneTouch) -> tuple[np.ndarray, np.ndarray]:
        """Return the mean radius, m, and mean pressure, Pa, of each element edge (n_edges,)."""
        mean = self._edges.mean
        return mean(touch.radii), mean(touch.pressure) / touch.widening

    def spread(self, stiffness: np.ndarray) -> np.ndarray:
        """Return the nodal forces per unit rise of the plane (size,), N/m.

        `stiffness` contains the stiffness matrices of the edges.
        """
        return self._scatter(stiffness[:, :, :EDGE_NODES].sum(axis=2))

    def _scatter(self, nodal: np.ndarray) -> np.ndarray:
        """Sum the forces on the nodes of each edge to the forces on the body (size,), N."""
        return np.bincount(self.dofs.ravel(), nodal.ravel(), minlength=self._size)
