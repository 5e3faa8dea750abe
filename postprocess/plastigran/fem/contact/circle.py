# SPDX-License-Identifier: GPL-2.0-or-later
"""Contact of a rigid circle with the surface of a body: penalty method, Coulomb friction.

The contact forces act at the Gauss points of the surface. The center of the circle adds two degrees
of freedom; the circle does not rotate. The method follows Wriggers (Computational Contact
Mechanics, 2006, sec. 5.2).

Let d be the vector from the center of the circle to a point of the deformed surface. The normal is
n = d/|d|, and the gap is g = |d| - R, with the radius R. The pressure is p = k max(-g, 0) along n,
with the penalty stiffness k. The trial shear traction is the shear traction of the last equilibrium
minus k times the slip since then. The coefficient of friction mu limits the shear traction to mu p.
"""

from __future__ import annotations

import attrs
import numpy as np

from plastigran.fem.body.struck import StruckBody
from plastigran.fem.contact.edges import Edges, contact_edge
from plastigran.fem.contact.plane import Touch


@attrs.frozen
class Rub(Touch):
    """State of the contact with a circle; `force` is the upward force on the circle.

    Attributes:
        drag: Force on the circle along the surface, N.
        shear: Tangential traction on the body at the Gauss points (n_edges, n_points), Pa.
        distance: Vectors from the center of the circle to the Gauss points (n_edges, n_points, 2),
            m.
        dissipated: Work of friction since the last equilibrium, J.
    """

    drag: float
    shear: np.ndarray
    distance: np.ndarray
    dissipated: float


class RigidCircle:
    """Circle above the surface y = 0 of a body; it touches the undeformed surface.

    Attributes:
        dofs: Degrees of freedom of each element edge (n_edges, 8): x and y of its three nodes and
            of the center of the circle.
        coordinates: Coordinates x of the Gauss points, increasing (n_points,), m.
        start: Initial coordinate x of the center, m.
        longest_edge: Length of the longest edge, m.
    """

    def __init__(
        self,
        body: StruckBody,
        radius: float,
        track: tuple[float, float],
        start: float,
        coefficient_of_friction: float,
        penalty: float,
    ) -> None:
        """Place the circle on the boundary `surface` of the body.

        Args:
            body: Body.
            radius: Radius of the circle, m.
            track: Smallest and largest coordinate x at which contact is possible, m.
            start: Initial coordinate x of the center, m.
            coefficient_of_friction: Coulomb coefficient of friction.
            penalty: Penalty stiffness divided by E*/h, where h is the length of an element edge.
        """
        mesh = body.mesh
        facets = mesh.boundaries["surface"]
        ends = mesh.p[0, mesh.facets[:, facets]]
        on_track = (ends.min(axis=0) >= track[0]) & (ends.max(axis=0) <= track[1])
        self._edges = edges = Edges(body, facets[on_track])
        self._center, self._size = body.center, body.size
        count = len(edges.lengths)
        center = np.broadcast_to(body.center, (count, 2))
        self.dofs = np.concatenate([edges.dofs.reshape(count, -1), center], axis=1)
        self._distance_matrices = np.zeros((count, edges.first.shape[1], 2, self.dofs.shape[1]))
        for axis in (0, 1):
            self._distance_matrices[:, :, axis, axis:-2:2] = edges.shapes
            self._distance_matrices[:, :, axis, -2 + axis] = -1
        self._start = np.stack([edges.first - start, np.full_like(edges.first, -radius)], axis=-1)
        self._areas = edges.areas
        self._stiffness = penalty * body.material.plane_modulus / edges.lengths[:, None]
        self._radius, self._friction = radius, coefficient_of_friction
        # With an axis of symmetry, the drag is zero, because the forces on the two halves cancel.
        self._drag_and_force = np.array([0.0 if "axis" in mesh.boundaries else 1.0, 1.0])
        self.coordinates = edges.first.ravel()
        self.start = start
        self.longest_edge = edges.lengths.max()

    def touch(self, displacement: np.ndarray, last: Rub | None = None) -> Rub:
        """Return the contact state at displacements (size,), m.

        `last` is the contact state of the last equilibrium; None at the start.
        """
        change = np.einsum("eqid,ed->eqi", self._distance_matrices, displacement[self.dofs])
        distance = self._start + change
        length = np.linalg.norm(distance, axis=2)
        normal = distance / length[:, :, None]
        tangent = np.stack([-normal[:, :, 1], normal[:, :, 0]], axis=-1)
        gap = length - self._radius
        closed = self._stiffness * (gap < 0)
        pressure = -closed * gap
        motion = distance - (self._start if last is None else last.distance)
        slip = np.einsum("eqi,eqi->eq", tangent, motion)
        before = 0.0 if last is None else last.shear
        trial, limit = before - self._stiffness * slip, self._friction * pressure
        shear = np.clip(trial, -limit, limit)
        traction = pressure[:, :, None] * normal + shear[:, :, None] * tangent
        nodal = np.einsum("eqid,eqi,eq->ed", self._distance_matrices, traction, self._areas)
        nodal = np.bincount(self.dofs.ravel(), nodal.ravel(), minlength=self._size)
        drag, force = nodal[self._center] * self._drag_and_force

        # Derivatives of pressure and shear with respect to distance, and of traction with respect
        # to pressure and shear.
        by_distance = -closed[:, :, None] * normal
        slip_by_distance = 1 - np.einsum("eqi,eqi->eq", normal, motion) / length
        sticks = np.abs(trial) < limit
        shear_by_distance = np.where(
            sticks[:, :, None],
            -(self._stiffness * slip_by_distance)[:, :, None] * tangent,
            self._friction * np.sign(trial)[:, :, None] * by_distance,
        )
        turning = (pressure[:, :, None] * tangent - shear[:, :, None] * normal) / length[:, :, None]
        derivative = (
            normal[..., None] * by_distance[:, :, None]
            + tangent[..., None] * shear_by_distance[:, :, None]
            + turning[..., None] * tangent[:, :, None]
        )
        derivative *= self._areas[:, :, None, None]
        transposed = self._distance_matrices.transpose(0, 1, 3, 2)
        stiffness = -(transposed @ derivative @ self._distance_matrices).sum(axis=1)
        lost = -slip * (shear + before) / 2 - (shear**2 - before**2) / (2 * self._stiffness)
        return Rub(
            force=float(force),
            nodal=nodal,
            stiffness=stiffness,
            gap=gap.ravel(),
            pressure=pressure.ravel(),
            stored=float(np.sum(self._areas * (closed * gap**2 + shear**2 / self._stiffness)) / 2),
            drag=float(drag),
            shear=shear,
            distance=distance,
            dissipated=float(np.sum(self._areas * lost)),
        )

    def surface(self, displacement: np.ndarray) -> np.ndarray:
        """Return (x, y) of the Gauss points (n_points, 2), m, at displacements (size,), m.

        x is measured from the initial position of the circle.
        """
        fixed_center = displacement.copy()
        fixed_center[self._center] = 0
        change = np.einsum("eqid,ed->eqi", self._distance_matrices, fixed_center[self.dofs])
        return (self._start + change + np.array([0, self._radius])).reshape(-1, 2)

    def profile(self, touch: Rub) -> tuple[np.ndarray, np.ndarray]:
        """Return the mean coordinate x, m, and mean pressure, Pa, of each edge (n_edges,)."""
        return self._edges.mean(self.coordinates), self._edges.mean(touch.pressure)

    def ends(self, gap: np.ndarray) -> tuple[float, float]:
        """Return the coordinates x of both ends of the contact, m; zeros without contact.

        With an axis of symmetry, the left end is the mirror image of the right end.
        """
        last = contact_edge(self.coordinates, gap)
        if self.coordinates[0] >= 0:
            return -last, last
        return -contact_edge(-self.coordinates[::-1], gap[::-1]), last
