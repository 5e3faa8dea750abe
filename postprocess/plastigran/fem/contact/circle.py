# SPDX-License-Identifier: GPL-2.0-or-later
"""A rigid circle on the surface of a body, with Coulomb friction: a penalty at the Gauss points.

The circle's centre is two more degrees of freedom after those of the body; it does not turn. With d
from the centre to a point of the surface where it is now, its normal n = d/|d| and the gap
g = |d| - R, the surface bears the pressure p = k <-g> along n. Along the tangent t it bears the
traction of the last equilibrium less k times its slip since, but mu p at most: the return of
elastic stick to the cone of friction (Wriggers, Computational Contact Mechanics, 2006, sec. 5.2).
"""

from __future__ import annotations

import attrs
import numpy as np

from plastigran.fem.body.struck import StruckBody
from plastigran.fem.contact.edges import Edges, contact_edge
from plastigran.fem.contact.plane import PENALTY, Touch


@attrs.frozen
class Rub(Touch):
    """Contact with a circle; `force` is that on the circle, upward.

    Attributes:
        drag: Force on the circle along the surface, N.
        shear: Traction on the body along the tangent at the Gauss points (n_edges, n_points), Pa.
        distance: From the circle's centre to them (n_edges, n_points, 2), m.
        dissipated: Work of friction since the last equilibrium, J.
    """

    drag: float
    shear: np.ndarray
    distance: np.ndarray
    dissipated: float


class RigidCircle:
    """A circle over the surface y = 0 of a body, that it touches while nothing has moved.

    Attributes:
        dofs: Of each edge, x and y of its three nodes and of the centre (n_edges, 8).
        places: First coordinate of the Gauss points, increasing (n_points,), m.
        start: First coordinate of the centre while nothing has moved, m.
        longest_edge: m.
    """

    def __init__(
        self,
        body: StruckBody,
        radius: float,
        track: tuple[float, float],
        start: float = 0.0,
        coefficient_of_friction: float = 0.0,
        penalty: float = PENALTY,
    ) -> None:
        """Args:
        body: The body, with a boundary `surface`.
        radius: Of the circle, m.
        track: No contact is looked for outside of these first coordinates, m.
        start: First coordinate of the centre, m.
        coefficient_of_friction: Of Coulomb.
        penalty: Stiffness over E*/h, h the length of an edge.
        """
        mesh = body.mesh
        facets = mesh.boundaries["surface"]
        ends = mesh.p[0, mesh.facets[:, facets]]
        edges = Edges(body, facets[(ends.min(axis=0) >= track[0]) & (ends.max(axis=0) <= track[1])])
        self._edges, self._centre, self._size = edges, body.centre, body.size
        count = len(edges.lengths)
        centre = np.broadcast_to(body.centre, (count, 2))
        self.dofs = np.concatenate([edges.dofs.reshape(count, -1), centre], axis=1)
        self._distance_matrices = np.zeros((count, edges.first.shape[1], 2, self.dofs.shape[1]))
        for axis in (0, 1):
            self._distance_matrices[:, :, axis, axis:-2:2] = edges.shapes
            self._distance_matrices[:, :, axis, -2 + axis] = -1
        self._start = np.stack([edges.first - start, np.full_like(edges.first, -radius)], axis=-1)
        self._areas = edges.areas
        self._stiffness = penalty * body.material.plane_modulus / edges.lengths[:, None]
        self._radius, self._friction = radius, coefficient_of_friction
        # The halves on both sides of an axis drag the circle against each other.
        self._whole = np.array([0.0 if "axis" in mesh.boundaries else 1.0, 1.0])
        self.places = edges.first.ravel()
        self.start = start
        self.longest_edge = edges.lengths.max()

    def touch(self, displacement: np.ndarray, last: Rub | None = None) -> Rub:
        """Contact at displacements (size,), m, after the equilibrium `last`."""
        moves = displacement[self.dofs]
        distance = self._start + np.einsum("eqid,ed->eqi", self._distance_matrices, moves)
        length = np.linalg.norm(distance, axis=2)
        normal = distance / length[:, :, None]
        tangent = np.stack([-normal[:, :, 1], normal[:, :, 0]], axis=-1)
        gap = length - self._radius
        closed = self._stiffness * (gap < 0)
        pressure = -closed * gap
        moved = distance - (self._start if last is None else last.distance)
        slip = np.einsum("eqi,eqi->eq", tangent, moved)
        before = 0.0 if last is None else last.shear
        trial, limit = before - self._stiffness * slip, self._friction * pressure
        shear = np.clip(trial, -limit, limit)
        traction = pressure[:, :, None] * normal + shear[:, :, None] * tangent
        nodal = np.einsum("eqid,eqi,eq->ed", self._distance_matrices, traction, self._areas)
        nodal = np.bincount(self.dofs.ravel(), nodal.ravel(), minlength=self._size)
        drag, force = nodal[self._centre] * self._whole

        # Changes of pressure and shear with the distance, and of traction with these.
        by_distance = -closed[:, :, None] * normal
        turned = 1 - np.einsum("eqi,eqi->eq", normal, moved) / length
        sticks = np.abs(trial) < limit
        shear_by_distance = np.where(
            sticks[:, :, None],
            -(self._stiffness * turned)[:, :, None] * tangent,
            self._friction * np.sign(trial)[:, :, None] * by_distance,
        )
        turning = (pressure[:, :, None] * tangent - shear[:, :, None] * normal) / length[:, :, None]
        change = (
            normal[..., None] * by_distance[:, :, None]
            + tangent[..., None] * shear_by_distance[:, :, None]
            + turning[..., None] * tangent[:, :, None]
        )
        change *= self._areas[:, :, None, None]
        transposed = self._distance_matrices.transpose(0, 1, 3, 2)
        stiffness = -(transposed @ change @ self._distance_matrices).sum(axis=1)
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
        """(x, y) of the Gauss points at displacements (size,), m, x from the circle's start
        (n_points, 2), m.
        """
        still = displacement.copy()
        still[self._centre] = 0
        moves = np.einsum("eqid,ed->eqi", self._distance_matrices, still[self.dofs])
        return (self._start + moves + np.array([0, self._radius])).reshape(-1, 2)

    def profile(self, touch: Rub) -> tuple[np.ndarray, np.ndarray]:
        """Mean first coordinate and mean pressure of each edge."""
        return self._edges.mean(self.places), self._edges.mean(touch.pressure)

    def ends(self, gap: np.ndarray) -> tuple[float, float]:
        """First and last place in contact, m; on an axis the first is its mirror image; zeros where
        there is no contact.
        """
        last = contact_edge(self.places, gap)
        if self.places[0] >= 0:
            return -last, last
        return -contact_edge(-self.places[::-1], gap[::-1]), last
