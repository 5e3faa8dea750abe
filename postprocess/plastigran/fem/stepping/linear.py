# SPDX-License-Identifier: GPL-2.0-or-later
"""Linear systems that are assembled from element matrices; their sparsity pattern is constant."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_matrix, csc_matrix
from scipy.sparse.linalg import SuperLU, splu


class SingularError(ArithmeticError):
    """The matrix is singular."""


class SymmetricSystem:
    """Sparse matrix that is assembled from element matrices and factored with SuperLU.

    The sparsity pattern is symmetric; the values may be unsymmetric, as with friction. The pattern
    and the ordering are computed only once. Degrees of freedom are reordered to reduce fill-in.

    Attributes:
        free: Free degrees of freedom, in the order of the matrix.
    """

    def __init__(self, groups: list[np.ndarray], size: int, fixed: np.ndarray) -> None:
        """Compute the sparsity pattern and the ordering.

        Args:
            groups: One array (n_elements, n_dofs) for each type of element: the degrees of freedom
                of its elements.
            size: Number of degrees of freedom.
            fixed: Degrees of freedom fixed at zero.
        """
        self._rows = np.concatenate([np.repeat(g, g.shape[1], axis=1).ravel() for g in groups])
        self._columns = np.concatenate([np.tile(g, (1, g.shape[1])).ravel() for g in groups])
        self._size = size
        self._number(np.setdiff1d(np.arange(size), fixed))
        dominant = self._matrix(np.ones(self._rows.size))
        dominant.setdiag(10 * np.diff(self._pointers).max())
        options = {"SymmetricMode": True}
        order = splu(dominant, permc_spec="MMD_AT_PLUS_A", options=options).perm_c
        self._number(self.free[np.argsort(order)])

    def _number(self, free: np.ndarray) -> None:
        self.free = free
        index = np.full(self._size, -1)
        index[free] = np.arange(free.size)
        row, column = index[self._rows], index[self._columns]
        self._used = np.flatnonzero((row >= 0) & (column >= 0))
        row, column = row[self._used], column[self._used]
        pattern = coo_matrix((np.ones(row.size), (row, column)), shape=(free.size,) * 2).tocsc()
        pattern.sort_indices()
        self._indices, self._pointers = pattern.indices, pattern.indptr
        keys = np.repeat(np.arange(free.size), np.diff(self._pointers)) * free.size + self._indices
        self._slots = np.searchsorted(keys, column * free.size + row)

    def _matrix(self, values: np.ndarray) -> csc_matrix:
        data = np.bincount(self._slots, values[self._used], minlength=self._indices.size)
        return csc_matrix((data, self._indices, self._pointers), shape=(self.free.size,) * 2)

    def factor(self, matrices: list[np.ndarray]) -> Factor:
        """Return the factorization of the matrix assembled from element matrices.

        `matrices` has one array (n_elements, n_dofs, n_dofs) for each type of element.

        Raises:
            SingularError: The assembled matrix is singular.
        """
        matrix = self._matrix(np.concatenate([matrix.ravel() for matrix in matrices]))
        try:
            factor = splu(
                matrix,
                permc_spec="NATURAL",
                diag_pivot_thresh=0.0,
                options={"SymmetricMode": True},
            )
        except RuntimeError as error:
            raise SingularError(f"the stiffness matrix cannot be factored: {error}") from None
        return Factor(factor, self.free)


class Factor:
    """Factored matrix of a linear system."""

    def __init__(self, factor: SuperLU, free: np.ndarray) -> None:
        self._factor = factor
        self._free = free

    def solve(self, right: np.ndarray) -> np.ndarray:
        """Return the solution (size, ...) for right sides (size, ...).

        The solution is zero at fixed degrees of freedom.
        """
        result = np.zeros_like(right)
        result[self._free] = self._factor.solve(right[self._free])
        return result
