# SPDX-License-Identifier: GPL-2.0-or-later
"""An elastic body: one stiffness and one mass matrix for all time, and its free vibrations."""

from __future__ import annotations

from math import pi

import numpy as np
from scipy.sparse import coo_matrix, csr_matrix
from scipy.sparse.linalg import eigsh

from plastigran.fem.body.body import Body

RIGID = 1e-6  # of the highest eigenvalue found: below it the body moves as a whole


class ElasticBody:
    """Stiffness and mass of a body over the degrees of freedom that can move.

    Attributes:
        body: The body.
        free: Its degrees of freedom that move (size,).
        stiffness: (size, size), N/m.
        mass_matrix: (size, size), kg.
        upward: One at each vertical degree of freedom (size,).
    """

    def __init__(self, body: Body) -> None:
        self.body = body
        kept = np.ones(body.size, bool)
        kept[body.held] = False
        self.free = np.flatnonzero(kept)
        self.stiffness = self._assemble(body.elastic_stiffness)
        self.mass_matrix = body.mass_matrix[self.free][:, self.free].tocsr()
        self.upward = body.upward[self.free]

    def _assemble(self, matrices: np.ndarray) -> csr_matrix:
        dofs, nodes = self.body.dofs, self.body.dofs.shape[1]
        rows, columns = np.repeat(dofs, nodes, axis=1), np.tile(dofs, (1, nodes))
        entries = (matrices.ravel(), (rows.ravel(), columns.ravel()))
        whole = coo_matrix(entries, shape=(self.body.size,) * 2).tocsr()
        return whole[self.free][:, self.free].tocsr()

    def places(self, dofs: np.ndarray) -> np.ndarray:
        """Where degrees of freedom of the body are among those that move."""
        return np.searchsorted(self.free, dofs)

    def nearest(self, point: tuple[float, float], vertical: bool) -> int:
        """Where the vertical or radial degree of freedom next to a point (r, y), m, is among those
        that move.
        """
        kind = np.flatnonzero((self.upward == 1) == vertical)
        away = self.body.locations[:, self.free[kind]] - np.array(point)[:, None]
        return int(kind[np.argmin(np.linalg.norm(away, axis=0))])

    def vibrations(self, count: int) -> tuple[np.ndarray, np.ndarray]:
        """The gravest free vibrations, without the motion as a whole.

        Args:
            count: How many.

        Returns:
            Frequencies (count,), Hz, rising; shapes (size, count) of unit modal mass.
        """
        scale = self.stiffness.diagonal().sum() / self.mass_matrix.diagonal().sum()
        squares, shapes = eigsh(
            self.stiffness,
            k=count + 1,  # and the motion along the axis
            M=self.mass_matrix,
            sigma=-1e-8 * scale,  # the stiffness itself is singular
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
        """Energy of each free vibration (count,), J, in a displacement and a velocity (size,)."""
        amplitude = shapes.T @ (self.mass_matrix @ displacement)
        rate = shapes.T @ (self.mass_matrix @ velocity)
        return (rate**2 + (2 * pi * frequencies * amplitude) ** 2) / 2
