# SPDX-License-Identifier: GPL-2.0-or-later
"""A body that is hit by a rigid one, in one system of equations."""

from __future__ import annotations

import numpy as np
from scipy.sparse import block_diag, identity
from skfem import MeshQuad2

from plastigran.fem.body.body import Body
from plastigran.fem.body.section import Section
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.material.kinematics import Kinematics


class StruckBody(Body):
    """Body, and the center of a circle as two further degrees of freedom.

    Attributes:
        centre: Degrees of freedom of the center (2,).
        centre_mass: Mass of the circle, kg.
    """

    def __init__(
        self,
        mesh: MeshQuad2,
        material: ElasticPlastic,
        section: Section,
        centre_mass: float,
        kinematics: Kinematics | None = None,
    ) -> None:
        super().__init__(mesh, material, section, kinematics)
        self.centre = self.size + np.arange(2)
        self.centre_mass = centre_mass
        self.size += 2
        self.mass_matrix = block_diag([self.mass_matrix, centre_mass * identity(2)], format="csr")
        if "axis" in mesh.boundaries:
            self.held = np.append(self.held, self.centre[0])
