# SPDX-License-Identifier: GPL-2.0-or-later
"""A body in eight-node elements: strains, forces, stiffness and mass.

scikit-fem gives mesh, shape functions, numbering and the mass matrix. Strains and stiffness are
batched matrix products over the elements, four Gauss points each.
"""

from __future__ import annotations

import numpy as np
from skfem import Basis, BilinearForm, ElementQuadS2, ElementVector, MeshQuad2
from skfem.helpers import dot

from plastigran.fem.material import ElasticPlastic, Response
from plastigran.fem.section import Axisymmetric, Section

STIFFNESS_ORDER = 3  # two by two Gauss points: no locking when plastic flow keeps the volume
MASS_ORDER = 5  # three by three: with two by two the mass matrix would be singular
HELD = {"axis": "u^1", "equator": "u^2", "base": ["u^1", "u^2"]}  # on each boundary that is there


class Body:
    """Mesh and metal of one body.

    Attributes:
        mesh: In (r, y), m.
        material: The metal.
        section: What the mesh stands for, out of its plane.
        dofs: Degrees of freedom of each element (n_elements, 16), r and y of each node in turn.
        size: Number of degrees of freedom.
        vertex_dofs: Degrees of freedom of the elements' corners, r and y (n_vertices, 2).
        positions: Of the Gauss points (n_elements, 4, 2), m.
        volumes: Of the Gauss points, over the section (n_elements, 4), m3.
        elastic_stiffness: Of each element (n_elements, 16, 16), N/m.
        mass_matrices: Of each element (n_elements, 16, 16), kg.
        mass_matrix: Consistent, kg.
        mass: kg.
        upward: One at each vertical degree of freedom.
        held: Degrees of freedom that do not move.
    """

    def __init__(
        self, mesh: MeshQuad2, material: ElasticPlastic, section: Section | None = None
    ) -> None:
        self.mesh = mesh
        self.material = material
        self.section = section = section or Axisymmetric()
        vector = Basis(mesh, ElementVector(ElementQuadS2()), intorder=STIFFNESS_ORDER)
        scalar = vector.with_element(ElementQuadS2())
        self.dofs = np.ascontiguousarray(vector.element_dofs.T)
        self.vertex_dofs = vector.nodal_dofs.T.copy()
        self.size = vector.N
        self.locations = vector.doflocs
        radius, height = scalar.global_coordinates()
        self.positions = np.stack([radius, height], axis=-1)
        radius = np.asarray(radius)
        self.volumes = np.ascontiguousarray(section.thickness(radius) * vector.dx)
        self._strains = _strain_matrices(scalar, section.hoop(radius))
        self.elastic_stiffness = self._stiffness(
            np.broadcast_to(material.elastic_tangent, (*self.volumes.shape, 4, 4)),
            slice(None),
        )
        mass_basis = Basis(mesh, ElementVector(ElementQuadS2()), intorder=MASS_ORDER)
        per_length = material.density * section.thickness(mass_basis.global_coordinates()[0])
        masses = _mass.coo_data(mass_basis, per_length=per_length)
        self.mass_matrices = np.ascontiguousarray(masses.tolocal())
        self.mass_matrix = masses.tocsr()
        upward = np.zeros(self.size)
        upward[self.dofs[:, 1::2].ravel()] = 1.0
        self.upward = upward
        self.mass = upward @ self.mass_matrix @ upward
        self.held = self._held(vector)

    def _held(self, basis: Basis) -> np.ndarray:
        """Degrees of freedom that HELD names on the boundaries of the mesh."""
        named = HELD.keys() & self.mesh.boundaries.keys()
        return np.concatenate([basis.get_dofs(name).all(HELD[name]) for name in sorted(named)])

    @property
    def points(self) -> int:
        """Number of Gauss points."""
        return self.volumes.size

    def strain(self, displacement: np.ndarray) -> np.ndarray:
        """(points, 4) at displacements (size,), m."""
        return (self._strains @ displacement[self.dofs][:, :, None]).reshape(-1, 4)

    def internal_force(self, stress: np.ndarray) -> np.ndarray:
        """Nodal forces (size,), N, of stresses (points, 4), Pa."""
        weighted = (stress.reshape(*self.volumes.shape, 4) * self.volumes[:, :, None]).reshape(
            len(self.dofs), 1, -1
        )
        nodal = (weighted @ self._strains).ravel()
        return np.bincount(self.dofs.ravel(), nodal, minlength=self.size)

    def stiffness(self, response: Response) -> np.ndarray:
        """Element stiffnesses (n_elements, 16, 16), N/m: only those that flow are made anew."""
        result = self.elastic_stiffness.copy()
        points = self.volumes.shape[1]
        elements = np.unique(response.flowing // points)
        place = np.full(len(self.dofs), -1)
        place[elements] = np.arange(elements.size)
        tangent = np.tile(self.material.elastic_tangent, (elements.size, points, 1, 1))
        tangent[place[response.flowing // points], response.flowing % points] = response.tangent
        result[elements] = self._stiffness(tangent, elements)
        return result

    def _stiffness(self, tangent: np.ndarray, elements: np.ndarray | slice) -> np.ndarray:
        matrices = self._strains[elements]
        count = len(matrices)
        by_point = matrices.reshape(count, self.volumes.shape[1], 4, matrices.shape[-1])
        stressed = (tangent * self.volumes[elements][:, :, None, None]) @ by_point
        return matrices.transpose(0, 2, 1) @ stressed.reshape(matrices.shape)


def _strain_matrices(scalar: Basis, hoop: np.ndarray) -> np.ndarray:
    """Strain over nodal displacement (n_elements, 4 points * 4 strains, 16)."""
    nodes = len(scalar.basis)
    elements, points = hoop.shape
    matrices = np.zeros((elements, points, 4, 2 * nodes))
    for node, (shape,) in enumerate(scalar.basis):
        gradient = shape.grad
        matrices[:, :, 0, 2 * node] = gradient[0]
        matrices[:, :, 1, 2 * node + 1] = gradient[1]
        matrices[:, :, 2, 2 * node] = np.asarray(shape) * hoop
        matrices[:, :, 3, 2 * node] = gradient[1]
        matrices[:, :, 3, 2 * node + 1] = gradient[0]
    return matrices.reshape(elements, points * 4, 2 * nodes)


@BilinearForm
def _mass(u, v, w):
    return w.per_length * dot(u, v)
