# SPDX-License-Identifier: GPL-2.0-or-later
"""Logarithmic strain at many points, and its derivatives with respect to deformation."""

from __future__ import annotations

import numpy as np

# Indices of the in-plane components rr, yy, ry and yr among the gradients (rr, yy, tt, ry, yr).
IN_PLANE = np.array([0, 1, 3, 4])
# If the relative difference of two eigenvalues is smaller, divided differences use a series.
SERIES_BELOW = 1e-2


class InvertedError(ArithmeticError):
    """A displacement turns an element inside out (the determinant of F is not positive)."""


class Stretch:
    """Logarithmic strain E = 1/2 ln C at n points, and its derivatives with respect to F.

    F is the deformation gradient and C = F^T F.

    Indices in einsum: n is the point; g and h are in-plane components of F; a, b and k are
    eigenvectors.
    """

    def __init__(self, gradient: np.ndarray) -> None:
        """Compute eigenvalues and eigenvectors of C from displacement gradients (n, 5).

        Raises:
            InvertedError: The determinant of F is not positive.
        """
        radial, axial, self._hoop, upper, lower = gradient.T
        determinant = (1 + radial) * (1 + axial) - upper * lower
        if not (np.all(determinant > 0) and np.all(self._hoop > -1)):
            raise InvertedError("the displacements turn an element inside out")
        deformation = np.stack([1 + radial, upper, lower, 1 + axial], axis=-1).reshape(-1, 2, 2)
        # Compute C - 1 directly. C is close to one, so that a later subtraction would lose digits.
        first = 2 * radial + radial**2 + lower**2
        second = 2 * axial + axial**2 + upper**2
        mixed = upper + lower + radial * upper + axial * lower
        mean, half = (first + second) / 2, (first - second) / 2
        angle = np.arctan2(mixed, half) / 2
        cosine, sine = np.cos(angle), np.sin(angle)
        self._vectors = np.stack([cosine, -sine, sine, cosine], axis=-1).reshape(-1, 2, 2)
        spread = np.hypot(half, mixed)
        # Eigenvalues of C minus one.
        self._squares = np.stack([mean + spread, mean - spread], axis=-1)
        self._difference = 2 * spread
        # For each in-plane component of dF, compute the change dC in the basis of eigenvectors.
        turned = deformation @ self._vectors
        product = np.einsum("nia,njb->nijab", turned, self._vectors)
        product = product + product.swapaxes(3, 4)
        self._changes = product[:, [0, 1, 0, 1], [0, 1, 1, 0]]

    def strain(self) -> np.ndarray:
        """Return 1/2 ln C as columns (n, 4)."""
        logarithms = np.log1p(self._squares) / 2
        tensor = np.einsum("nia,na,nja->nij", self._vectors, logarithms, self._vectors)
        return np.stack(
            [tensor[:, 0, 0], tensor[:, 1, 1], np.log1p(self._hoop), 2 * tensor[:, 0, 1]], axis=-1
        )

    def conjugate(self, stress: np.ndarray) -> np.ndarray:
        """Return first Piola-Kirchhoff stresses (n, 5), Pa, from stresses (n, 4)."""
        weighted = self._turn(stress) * self._first()
        plane = np.einsum("nab,ngab->ng", weighted, self._changes)
        return np.insert(plane, 2, stress[:, 2] / (1 + self._hoop), axis=1)

    def tangent(self, stress: np.ndarray, material: np.ndarray) -> np.ndarray:
        """Return the derivatives of the first Piola-Kirchhoff stress by F (n, 5, 5), Pa.

        The arguments are stresses (n, 4), Pa, and tangents of the material (n, 4, 4), Pa.
        """
        slopes = self._slopes()
        result = slopes.swapaxes(1, 2) @ material @ slopes
        turned = self._turn(stress)
        curved = np.einsum(
            "nab,nakb,ngak,nhkb->ngh", turned, self._second(), self._changes, self._changes
        )
        piola = np.einsum(
            "nia,nab,njb->nij", self._vectors, 2 * turned * self._first(), self._vectors
        )
        plane = curved + curved.swapaxes(1, 2)
        # Add the term from the second derivative of C = F^T F. It couples components in the same
        # row of F: rr with ry, and yy with yr.
        for columns in np.array([[0, 2], [3, 1]]):
            plane[:, columns[:, None], columns] += piola
        result[:, IN_PLANE[:, None], IN_PLANE] += plane
        result[:, 2, 2] -= stress[:, 2] / (1 + self._hoop) ** 2
        return result

    def _slopes(self) -> np.ndarray:
        """Return the derivatives (n, 4, 5) of 4 strain components by 5 components of F."""
        changes = self._first()[:, None] * self._changes
        tensors = np.einsum("nia,ngab,njb->ngij", self._vectors, changes, self._vectors)
        result = np.zeros((len(tensors), 4, 5))
        for row, (first, second, times) in {0: (0, 0, 1), 1: (1, 1, 1), 3: (0, 1, 2)}.items():
            result[:, row, IN_PLANE] = times * tensors[:, :, first, second]
        result[:, 2, 2] = 1 / (1 + self._hoop)
        return result

    def _turn(self, stress: np.ndarray) -> np.ndarray:
        """Return the in-plane stresses (n, 2, 2) in the basis of the eigenvectors of C."""
        tensor = stress[:, [0, 3, 3, 1]].reshape(-1, 2, 2)
        return self._vectors.swapaxes(1, 2) @ tensor @ self._vectors

    def _first(self) -> np.ndarray:
        """Return divided differences f[a, b] (n, 2, 2) of f = 1/2 ln at the eigenvalues of C."""
        small = 1 + self._squares[:, 1]
        ratio = self._difference / small
        safe = np.where(ratio == 0, 1.0, ratio)
        mixed = np.where(ratio == 0, 1.0, np.log1p(ratio) / safe) / (2 * small)
        equal = 1 / (2 * (1 + self._squares))
        return np.stack([equal[:, 0], mixed, mixed, equal[:, 1]], axis=-1).reshape(-1, 2, 2)

    def _second(self) -> np.ndarray:
        """Return second divided differences f[a, k, b] (n, 2, 2, 2) of f; see `_first`."""
        values = 1 + self._squares
        result = np.empty((len(values), 2, 2, 2))
        for one, other in ((0, 1), (1, 0)):
            twice = _second_difference(values[:, one], values[:, other])
            result[:, one, one, one] = -1 / (4 * values[:, one] ** 2)
            result[:, one, one, other] = result[:, one, other, one] = twice
            result[:, other, one, one] = twice
        return result


def _second_difference(twice: np.ndarray, once: np.ndarray) -> np.ndarray:
    """Return the divided difference f[x, x, y] of f = 1/2 ln; if x and y are close, by a series.

    `twice` is x, which appears twice, and `once` is y.
    """
    ratio = (twice - once) / once
    near = np.abs(ratio) < SERIES_BELOW
    safe = np.where(near, 1.0, ratio)
    exact = (1 / (1 + safe) - np.log1p(safe) / safe) / safe
    close = np.where(near, ratio, 0.0)
    series = -sum((-close) ** n * (n + 1) / (n + 2) for n in range(7))
    return np.where(near, series, exact) / (2 * once**2)
