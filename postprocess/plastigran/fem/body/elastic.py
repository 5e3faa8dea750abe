# SPDX-License-Identifier: GPL-2.0-or-later
"""Elastic body with constant stiffness and mass matrices, and its free vibrations."""

from __future__ import annotations

from math import pi

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import eigsh

from plastigran.fem.body.body import Body

# A mode counts as rigid-body motion if its eigenvalue divided by the highest computed eigenvalue is
# below this value.
RIGID = 1e-6


class ElasticBody:
    """Stiffness and mass of a body for the degrees of freedom that are not fixed.

    Attributes:
        body: Body.
        free: Degrees of freedom that are not fixed (size,).
        stiffness: Stiffness matrix (size, size), N/m.
        mass_matrix: Mass matrix (size, size), kg.
        upward: 1 at each vertical degree of freedom, 0 at all others (size,).
    """

    def __init__(self, body: Body) -> None:
        self.body = body
        self.free = free = np.setdiff1d(np.arange(body.size), body.fixed)
        nodes = body.dofs.shape[1]
        rows, columns = np.repeat(body.dofs, nodes, axis=1), np.tile(body.dofs, (1, nodes))
        entries = (body.elastic_stiffness.ravel(), (rows.ravel(), columns.ravel()))
        stiffness = coo_matrix(entries, shape=(body.size, body.size)).tocsr()
        self.stiffness = stiffness[free][:, free].tocsr()
        self.mass_matrix = body.mass_matrix[free][:, free].tocsr()
        self.upward = body.upward[free]

    def nearest(self, point: tuple[float, float], vertical: bool) -> int:
        """Return the index in `free` of the degree of freedom closest to a point (r, y), m."""
        candidates = np.flatnonzero((self.upward == 1) == vertical)
        away = self.body.locations[:, self.free[candidates]] - np.array(point)[:, None]
        return int(candidates[np.argmin(np.linalg.norm(away, axis=0))])

    def vibrations(self, count: int) -> tuple[np.ndarray, np.ndarray]:
        """Return the free vibration modes of lowest frequency, without rigid-body motions.

        Returns:
            Increasing frequencies (count,), Hz; mode shapes (size, count) with unit modal mass.
        """
        scale = self.stiffness.diagonal().sum() / self.mass_matrix.diagonal().sum()
        squares, shapes = eigsh(
            self.stiffness,
            k=count + 1,  # one more mode, because the rigid-body motion along the axis is removed
            M=self.mass_matrix,
            sigma=-1e-8 * scale,  # small shift, because the stiffness matrix is singular
        )
        order = np.argsort(squares)
        elastic = order[squares[order] > RIGID * squares.max()][:count]
        return np.sqrt(squares[elastic]) / (2 * pi), shapes[:, elastic]

    def modal_energies(
        self,
        frequencies: np.ndarray,
        shapes: np.ndarray,
        displacement: np.ndarray,
        velocity: np.ndarray,
    ) -> np.ndarray:
        """Return the energy of each vibration mode (count,), J.

        The arguments are the results of `vibrations`, and the nodal displacements, m, and nodal
        velocities, m/s, of the body.
        """
        amplitude = shapes.T @ (self.mass_matrix @ displacement)
        rate = shapes.T @ (self.mass_matrix @ velocity)
        return (rate**2 + (2 * pi * frequencies * amplitude) ** 2) / 2
