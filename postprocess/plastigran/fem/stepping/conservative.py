# SPDX-License-Identifier: GPL-2.0-or-later
"""Energy-conserving time steps of an elastic body on a rigid plane.

The steps follow the implicit midpoint rule. With the displacements u, velocities v and gaps g at
the start (0) and the end (1) of a step of length dt, the equations are

    u1 - u0 = dt (v0 + v1)/2,    M (v1 - v0)/dt + K (u0 + u1)/2 = f(g0, g1),

with the mass matrix M, the stiffness matrix K and the contact forces f of the plane.

Each Gauss point has a penalty spring of stiffness k, N/m, with the energy V(g) = k max(-g, 0)^2/2.
The force at this point is -(V(g1) - V(g0))/(g1 - g0), the discrete gradient of Gonzalez (2000,
Comput. Methods Appl. Mech. Engrg. 190:1763). The sum of kinetic, elastic and penalty energy is
therefore constant for any time step. Momentum changes by dt times the sum of f.

The body is linear, so that the matrix 2 M/dt^2 + K/2 is factored only once. Newton's method solves
only for the surface degrees of freedom that may touch the plane, with their compliance matrix.
"""

from __future__ import annotations

import attrs
import numpy as np
from scipy.sparse.linalg import splu

from plastigran.fem.body.body import Body
from plastigran.fem.body.elastic import ElasticBody
from plastigran.fem.contact.plane import PENALTY, RigidPlane
from plastigran.fem.stepping.increment import NoConvergence

ITERATIONS = 40
TOLERANCE = 1e-13  # tolerance relative to the surface displacements, at the level of round-off


class SpringPlane(RigidPlane):
    """Rigid plane that acts on a body by one spring at each Gauss point of its surface.

    Attributes:
        surface: Vertical degrees of freedom of the body that may touch the plane (n_surface,).
        shapes: Matrix from displacements of these degrees of freedom to displacements of the Gauss
            points (n_points, n_surface).
    """

    def __init__(self, body: Body, radius: float, reach: float, penalty: float = PENALTY) -> None:
        super().__init__(body, radius, reach, penalty)
        self.surface = np.unique(self.dofs)
        self._rest = self._heights.ravel()
        self._springs = (self._stiffness * self._areas).ravel()
        edges, points, _ = self._shapes.shape
        shapes = np.zeros((edges, points, self.surface.size))
        columns = np.searchsorted(self.surface, self.dofs)[:, None]
        np.put_along_axis(shapes, np.repeat(columns, points, axis=1), self._shapes, axis=2)
        self.shapes = shapes.reshape(edges * points, -1)

    def gap(self, displacement: np.ndarray) -> np.ndarray:
        """Return the gap for displacements of the surface (n_surface,), m."""
        return self._rest + self.shapes @ displacement

    def energy(self, gap: np.ndarray) -> float:
        """Return the energy of the penalty springs, J, for gaps (n_points,), m."""
        return float(self._springs @ np.minimum(gap, 0) ** 2) / 2

    def mean_force(self, start: np.ndarray, end: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the mean contact forces of a step, and their slopes.

        The force at a Gauss point is the discrete gradient of its spring energy,
        k (p0 + p1)/2 |p1 - p0|/|g1 - g0|, with p = max(-g, 0) and the spring stiffness k.

        Args:
            start, end: Gaps g0 and g1 at the start and the end of the step (n_points,), m.

        Returns:
            Forces (n_points,), N, and slopes (n_points,), N/m. A slope is minus the derivative of
            the force with respect to the gap `end`.
        """
        before, after = np.maximum(-start, 0), np.maximum(-end, 0)
        closed, opened = (start < 0) & (end < 0), (start >= 0) & (end >= 0)
        path = np.where(closed | opened, 1, np.abs(end - start))
        share = np.where(closed, 1, np.abs(after - before) / path)
        slope = np.where(start < 0, share**2, 1 - (1 - share) ** 2)
        slope[opened] = 0
        half = self._springs / 2
        return half * (before + after) * share, half * slope


@attrs.frozen
class Motion:
    """Motion of an elastic body at one time, for the free degrees of freedom (size,).

    Attributes:
        time: Time, s.
        displacement: Displacements, m.
        velocity: Velocities, m/s.
        elastic_force: Stiffness times displacement, N.
        momentum: Mass times velocity, kg m/s.
        gap: Gaps at the Gauss points of the surface (n_points,), m.
        force: Upward force on the body, N, the mean over the step that ends at `time`.
    """

    time: float
    displacement: np.ndarray
    velocity: np.ndarray
    elastic_force: np.ndarray
    momentum: np.ndarray
    gap: np.ndarray
    force: float

    @property
    def kinetic_energy(self) -> float:
        """Kinetic energy, J."""
        return float(self.velocity @ self.momentum) / 2

    @property
    def elastic_energy(self) -> float:
        """Elastic energy, J."""
        return float(self.displacement @ self.elastic_force) / 2


class Steps:
    """Time steps of constant length; `now` is the current motion."""

    def __init__(
        self, elastic: ElasticBody, plane: SpringPlane, velocity: np.ndarray, timestep: float
    ) -> None:
        """Start from an undeformed body with nodal velocities (size,), m/s; `timestep` is in s."""
        self.elastic, self.plane, self.timestep = elastic, plane, timestep
        self._factor = splu(
            (2 / timestep**2 * elastic.mass_matrix + elastic.stiffness / 2).tocsc(),
            permc_spec="MMD_AT_PLUS_A",
            diag_pivot_thresh=0.0,
            options={"SymmetricMode": True},
        )
        self._surface = np.searchsorted(elastic.free, plane.surface)
        unit = np.zeros((elastic.free.size, plane.surface.size))
        unit[self._surface, np.arange(plane.surface.size)] = 1
        self._by_force = self._factor.solve(unit)
        self._compliance = self._by_force[self._surface]
        self._last = np.zeros(plane.surface.size)
        self.now = self._motion(0.0, np.zeros(elastic.free.size), velocity, 0.0)

    def _motion(
        self, time: float, displacement: np.ndarray, velocity: np.ndarray, force: float
    ) -> Motion:
        return Motion(
            time,
            displacement,
            velocity,
            self.elastic.stiffness @ displacement,
            self.elastic.mass_matrix @ velocity,
            self.plane.gap(displacement[self._surface]),
            force,
        )

    def advance(self) -> None:
        """Compute the motion at the end of the next time step.

        Raises:
            NoConvergence: Newton's method failed.
        """
        now, surface = self.now, self._surface
        change = self._factor.solve(2 / self.timestep * now.momentum - now.elastic_force)
        start, force = now.displacement[surface], 0.0
        if np.min(now.gap) < 0 or np.min(self.plane.gap(start + change[surface])) < 0:
            nodal, force = self._touch(start, change[surface])
            change += self._by_force @ nodal
        self._last = change[surface]
        self.now = self._motion(
            now.time + self.timestep,
            now.displacement + change,
            2 / self.timestep * change - now.velocity,
            force,
        )

    def _touch(self, start: np.ndarray, free: np.ndarray) -> tuple[np.ndarray, float]:
        """Return the mean nodal forces of the plane during the step, N, and their sum.

        Args:
            start: Displacements of the surface at the start of the step (n_surface,), m.
            free: Change of these displacements in the step without contact (n_surface,), m.
        """
        plane, compliance = self.plane, self._compliance
        change = self._last
        for _ in range(ITERATIONS):
            forces, slopes = plane.mean_force(self.now.gap, plane.gap(start + change))
            nodal = plane.shapes.T @ forces
            residual = change - free - compliance @ nodal
            if np.max(np.abs(residual)) <= TOLERANCE * np.max(np.abs(start + change)):
                return nodal, float(forces.sum())
            touching = np.flatnonzero(slopes)
            shapes = plane.shapes[touching]
            tangent = (compliance @ (shapes.T * slopes[touching])) @ shapes
            tangent[np.diag_indices_from(tangent)] += 1
            change = change - np.linalg.solve(tangent, residual)
        raise NoConvergence(
            f"the contact forces at {self.now.time:g} s do not converge in {ITERATIONS} iterations"
        )
