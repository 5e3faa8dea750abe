# SPDX-License-Identifier: GPL-2.0-or-later
"""A body that is hit by a rigid cylinder; one system of equations contains both."""

from __future__ import annotations

import numpy as np
from scipy.sparse import block_diag, identity
from skfem import MeshQuad2

from plastigran.fem.body.body import Body
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.material.kinematics import SmallStrain


class StruckBody(Body):
    """Body in plane strain that is hit by a rigid cylinder.

    In the plane, the cylinder is a circle. Its center adds two degrees of freedom.

    Attributes:
        center: Degrees of freedom of the center of the circle (2,).
        center_mass: Mass of the cylinder, kg.
    """

    def __init__(
        self,
        mesh: MeshQuad2,
        material: ElasticPlastic,
        length: float,
        center_mass: float,
        kinematics: SmallStrain | None = None,
    ) -> None:
        super().__init__(mesh, material, length, kinematics)
        self.center = self.size + np.arange(2)
        self.center_mass = center_mass
        self.size += 2
        self.mass_matrix = block_diag([self.mass_matrix, center_mass * identity(2)], format="csr")
        if "axis" in mesh.boundaries:
            self.fixed = np.append(self.fixed, self.center[0])
