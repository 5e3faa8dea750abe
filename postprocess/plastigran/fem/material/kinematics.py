# SPDX-License-Identifier: GPL-2.0-or-later
"""How strains follow from displacements: small strain, or finite strain in logarithms.

Displacement gradients are columns (rr, yy, tt, ry, yr), ry the slope of the first displacement
along the second coordinate. A material is asked at strains (rr, yy, tt, ry) with the engineering
shear strain, whatever the kinematics.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np

from plastigran.fem.material.elastic_plastic import Response
from plastigran.fem.material.stretch import Stretch

# Small strain over displacement gradient.
SYMMETRIC = np.array([[1.0, 0, 0, 0, 0], [0, 1.0, 0, 0, 0], [0, 0, 1.0, 0, 0], [0, 0, 0, 1.0, 1.0]])


class Kinematics(Protocol):
    """From displacement gradients to what the material is asked, and back to forces.

    Attributes:
        follows: Whether the area and place of a surface follow its displacement.
    """

    follows: bool

    def matrices(self, gradients: np.ndarray) -> np.ndarray:
        """Measured quantities over nodal displacements (..., m, 16), of displacement gradients
        over nodal displacements (..., 5, 16).
        """

    def undeformed(self, elastic_tangent: np.ndarray) -> np.ndarray:
        """Tangent (m, m) of the undeformed body, Pa, of the material's (4, 4)."""

    def strain(self, measured: np.ndarray) -> np.ndarray:
        """Strain (n, 4) of measured quantities (n, m).

        Raises:
            InvertedError: There is none.
        """

    def conjugate(self, measured: np.ndarray, stress: np.ndarray) -> np.ndarray:
        """Stress (n, m), Pa, that does work on the measured quantities, of the material's
        (n, 4).
        """

    def tangent(
        self, measured: np.ndarray, response: Response, elastic_tangent: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Points (k,) whose tangent is not that of the undeformed body, and d conjugate stress /
        d measured there (k, m, m), Pa.
        """


class SmallStrain(Kinematics):
    """Strain is the symmetric part of the displacement gradient; the shape does not change."""

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
    """Strain is E = 1/2 ln C, additive in its elastic and plastic part, C = F^T F the stretch
    squared, F the displacement gradient and one.

    The material's stress T does work on E; the first Piola-Kirchhoff stress is T : dE/dF (Miehe,
    Apel and Lambrecht, Comput. Methods Appl. Mech. Eng. 191 (2002) 5383). Derivatives of E are
    divided differences of the logarithm at the eigenvalues of C, in its eigenvectors.
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
