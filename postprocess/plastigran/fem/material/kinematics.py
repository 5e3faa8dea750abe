# SPDX-License-Identifier: GPL-2.0-or-later
"""Relation between displacements and strains: small strain, or finite logarithmic strain.

Displacement gradients are columns (rr, yy, tt, ry, yr). For example, ry is the derivative of the
radial displacement with respect to y, and tt is the circumferential component. A "measure" is the
quantity from which strains are computed. The material model always uses strains (rr, yy, tt, ry)
with engineering shear strain.
"""

from __future__ import annotations

import numpy as np

from plastigran.fem.material.elastic_plastic import Response
from plastigran.fem.material.stretch import Stretch

# Matrix from displacement gradients (rr, yy, tt, ry, yr) to small strains.
SYMMETRIC = np.array([[1.0, 0, 0, 0, 0], [0, 1.0, 0, 0, 0], [0, 0, 1.0, 0, 0], [0, 0, 0, 1.0, 1.0]])


class SmallStrain:
    """Small strain: the strain measure is the symmetric part of the displacement gradient.

    Attributes:
        surface_moves: Whether displacements change the area and position of a surface.
    """

    surface_moves = False

    def matrices(self, gradients: np.ndarray) -> np.ndarray:
        """Return matrices from nodal displacements to strain measures (..., m, 16).

        `gradients` (..., 5, 16) are the matrices from nodal displacements to displacement
        gradients.
        """
        result = gradients[..., :4, :].copy()
        result[..., 3, :] += gradients[..., 4, :]
        return result

    def undeformed(self, elastic_tangent: np.ndarray) -> np.ndarray:
        """Return the tangent of the undeformed body for the strain measure (m, m), Pa.

        `elastic_tangent` is the elastic tangent of the material (4, 4), Pa.
        """
        return elastic_tangent

    def strain(self, measure: np.ndarray) -> np.ndarray:
        """Return strains (n, 4) for strain measures (n, m).

        Raises:
            InvertedError: The material is turned inside out.
        """
        return measure

    def conjugate(self, measure: np.ndarray, stress: np.ndarray) -> np.ndarray:
        """Return the stresses (n, m), Pa, that are work-conjugate to the strain measures.

        `stress` contains the stresses of the material model (n, 4), Pa.
        """
        return stress

    def tangent(
        self, measure: np.ndarray, response: Response, elastic_tangent: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return the tangents of all points at which the tangent has changed by deformation.

        Returns:
            Indices of these points (k,), and their tangents d(conjugate stress)/d(measure)
            (k, m, m), Pa.
        """
        return response.flowing, response.tangent


class FiniteStrain(SmallStrain):
    """Logarithmic strain E = 1/2 ln C; the strain measure is the displacement gradient.

    C = F^T F, where the deformation gradient F is the unit tensor plus the displacement gradient. E
    is the sum of an elastic and a plastic part. The stress T of the material is conjugate to E. The
    first Piola-Kirchhoff stress is T : dE/dF (Miehe, Apel and Lambrecht, Comput. Methods Appl.
    Mech. Eng. 191 (2002) 5383). Derivatives of E are divided differences of the logarithm at the
    eigenvalues of C, in the basis of its eigenvectors.
    """

    surface_moves = True

    def matrices(self, gradients: np.ndarray) -> np.ndarray:
        return gradients

    def undeformed(self, elastic_tangent: np.ndarray) -> np.ndarray:
        return SYMMETRIC.T @ elastic_tangent @ SYMMETRIC

    def strain(self, measure: np.ndarray) -> np.ndarray:
        return Stretch(measure).strain()

    def conjugate(self, measure: np.ndarray, stress: np.ndarray) -> np.ndarray:
        return Stretch(measure).conjugate(stress)

    def tangent(
        self, measure: np.ndarray, response: Response, elastic_tangent: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        material = np.tile(elastic_tangent, (len(measure), 1, 1))
        material[response.flowing] = response.tangent
        return np.arange(len(measure)), Stretch(measure).tangent(response.stress, material)


KINEMATICS = {"small": SmallStrain, "finite": FiniteStrain}
