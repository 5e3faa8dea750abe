# SPDX-License-Identifier: GPL-2.0-or-later
"""Relation of strains and displacements: small strain, or finite logarithmic strain.

Displacement gradients are columns (rr, yy, tt, ry, yr); ry is the derivative of the first
displacement by the second coordinate. The material model always uses strains (rr, yy, tt, ry) with
engineering shear strain.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np

from plastigran.fem.material.elastic_plastic import Response
from plastigran.fem.material.stretch import Stretch

# Small strain per displacement gradient.
SYMMETRIC = np.array([[1.0, 0, 0, 0, 0], [0, 1.0, 0, 0, 0], [0, 0, 1.0, 0, 0], [0, 0, 0, 1.0, 1.0]])


class Kinematics(Protocol):
    """Conversion from displacement gradients to strains, and from stresses to forces.

    A "measure" is the quantity that strains are computed from.

    Attributes:
        follows: Whether the area and place of a surface follow its displacement.
    """

    follows: bool

    def matrices(self, gradients: np.ndarray) -> np.ndarray:
        """Return measures per nodal displacement (..., m, 16).

        The argument is the displacement gradients per nodal displacement (..., 5, 16).
        """

    def undeformed(self, elastic_tangent: np.ndarray) -> np.ndarray:
        """Return the tangent (m, m) of the undeformed body, Pa, from the elastic tangent (4, 4)."""

    def strain(self, measured: np.ndarray) -> np.ndarray:
        """Return strains (n, 4) for measures (n, m).

        Raises:
            InvertedError: The material is turned inside out.
        """

    def conjugate(self, measured: np.ndarray, stress: np.ndarray) -> np.ndarray:
        """Return the stresses (n, m), Pa, conjugate to the measures, from stresses (n, 4)."""

    def tangent(
        self, measured: np.ndarray, response: Response, elastic_tangent: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return points (k,) whose tangent has changed, and their tangents (k, m, m), Pa.

        The tangent is d conjugate stress / d measure.
        """


class SmallStrain(Kinematics):
    """Small strain: the symmetric displacement gradient; the shape does not change."""

    follows = False

    def matrices(self, gradients: np.ndarray) -> np.ndarray:
        result = gradients[..., :4, :].copy()
        result[..., 3, :] += gradients[..., 4, :]
        return result

    def undeformed(self, elastic_tangent: np.ndarray) -> np.ndarray:
        return elastic_tangent

    def strain(self, measured: np.ndarray) -> np.ndarray:
        return measured

    def conjugate(self, measured: np.ndarray, stress: np.ndarray) -> np.ndarray:
        return stress

    def tangent(
        self, measured: np.ndarray, response: Response, elastic_tangent: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        return response.flowing, response.tangent


class FiniteStrain(Kinematics):
    """Logarithmic strain E = 1/2 ln C, additive in its elastic and plastic part.

    C = F^T F, with F the displacement gradient plus one. The stress T of the material is conjugate
    to
    E. The first Piola-Kirchhoff stress is T : dE/dF (Miehe, Apel and Lambrecht, Comput. Methods
    Appl.
    Mech. Eng. 191 (2002) 5383). Derivatives of E are divided differences of the logarithm at the
    eigenvalues of C, in the basis of its eigenvectors.
    """

    follows = True

    def matrices(self, gradients: np.ndarray) -> np.ndarray:
        return gradients

    def undeformed(self, elastic_tangent: np.ndarray) -> np.ndarray:
        return SYMMETRIC.T @ elastic_tangent @ SYMMETRIC

    def strain(self, measured: np.ndarray) -> np.ndarray:
        return Stretch(measured).strain()

    def conjugate(self, measured: np.ndarray, stress: np.ndarray) -> np.ndarray:
        return Stretch(measured).conjugate(stress)

    def tangent(
        self, measured: np.ndarray, response: Response, elastic_tangent: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        material = np.tile(elastic_tangent, (len(measured), 1, 1))
        material[response.flowing] = response.tangent
        return np.arange(len(measured)), Stretch(measured).tangent(response.stress, material)


KINEMATICS = {"small": SmallStrain, "finite": FiniteStrain}
