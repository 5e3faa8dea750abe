# SPDX-License-Identifier: GPL-2.0-or-later
"""A body of eight-node elements: strains, forces, stiffness and mass.

scikit-fem provides the mesh, the shape functions, the numbering and the mass matrix. Strains and
stiffness matrices are computed by matrix products for all elements at once, with four Gauss points
per element.
"""

from __future__ import annotations

from math import pi

import numpy as np
from skfem import Basis, BilinearForm, ElementQuadS2, ElementVector, MeshQuad2
from skfem.helpers import dot

from plastigran.fem.material.elastic_plastic import ElasticPlastic, Response, State
from plastigran.fem.material.kinematics import SmallStrain

# Integration order for 2 x 2 Gauss points. They avoid locking in volume-preserving plastic flow.
STIFFNESS_ORDER = 3
MASS_ORDER = 5  # order for 3 x 3 Gauss points; with 2 x 2, the mass matrix would be singular
# Displacement components that are zero on each boundary of the mesh.
FIXED = {"axis": "u^1", "equator": "u^2", "base": ["u^1", "u^2"]}


class Body:
    """Mesh and material of one body.

    Attributes:
        mesh: Mesh in (r, y), m.
        material: Material.
        length: Length out of the plane in plane strain, m; None for a full ring about the axis.
        kinematics: Relation between displacements and strains (small or finite strain).
        dofs: Degrees of freedom of each element (n_elements, 16), r and y of each node in turn.
        size: Number of degrees of freedom.
        locations: (r, y) of each degree of freedom (2, size), m.
        vertex_dofs: Degrees of freedom of the corner nodes, r and y (n_vertices, 2).
        positions: (r, y) of the Gauss points (n_elements, 4, 2), m.
        volumes: Volumes of the Gauss points (n_elements, 4), m3.
        elastic_stiffness: Stiffness matrix of each element (n_elements, 16, 16), N/m.
        mass_matrices: Mass matrix of each element (n_elements, 16, 16), kg.
        mass_matrix: Consistent mass matrix, kg.
        mass: Mass, kg.
        upward: 1 at each vertical degree of freedom, 0 at all others (size,).
        fixed: Fixed degrees of freedom.
    """

    def __init__(
        self,
        mesh: MeshQuad2,
        material: ElasticPlastic,
        length: float | None = None,
        kinematics: SmallStrain | None = None,
    ) -> None:
        self.mesh, self.material, self.length = mesh, material, length
        self.kinematics = kinematics = kinematics or SmallStrain()
        vector = Basis(mesh, ElementVector(ElementQuadS2()), intorder=STIFFNESS_ORDER)
        scalar = vector.with_element(ElementQuadS2())
        self.dofs = np.ascontiguousarray(vector.element_dofs.T)
        self.vertex_dofs = vector.nodal_dofs.T.copy()
        self.size = vector.N
        self.locations = vector.doflocs
        radius, height = scalar.global_coordinates()
        self.positions = np.stack([radius, height], axis=-1)
        radius = np.asarray(radius)
        self.volumes = np.ascontiguousarray(self.thickness(radius) * vector.dx)
        gradients = _gradient_matrices(scalar, 1 / radius if length is None else 0 * radius)
        # Matrices from nodal displacements to strain measures (n_elements, 4 * n_components, 16).
        self._matrices = kinematics.matrices(gradients).reshape(len(self.dofs), -1, 16)
        self._undeformed = kinematics.undeformed(material.elastic_tangent)
        self.elastic_stiffness = self._stiffness(
            np.broadcast_to(self._undeformed, (*self.volumes.shape, *self._undeformed.shape)),
            slice(None),
        )
        mass_basis = Basis(mesh, ElementVector(ElementQuadS2()), intorder=MASS_ORDER)
        per_area = material.density * self.thickness(mass_basis.global_coordinates()[0])
        masses = _mass.coo_data(mass_basis, per_area=per_area)
        self.mass_matrices = np.ascontiguousarray(masses.tolocal())
        self.mass_matrix = masses.tocsr()
        self.upward = np.zeros(self.size)
        self.upward[self.dofs[:, 1::2].ravel()] = 1.0
        self.mass = self.upward @ self.mass_matrix @ self.upward
        boundaries = sorted(FIXED.keys() & mesh.boundaries.keys())
        self.fixed = np.concatenate([vector.get_dofs(name).all(FIXED[name]) for name in boundaries])

    def thickness(self, first: np.ndarray) -> np.ndarray:
        """Return the thickness out of the plane, m, at first coordinates (r or x), m.

        For a ring about the axis, this is the circumference.
        """
        return 2 * pi * first if self.length is None else np.full_like(first, self.length)

    @property
    def points(self) -> int:
        """Number of Gauss points."""
        return self.volumes.size

    @property
    def vertices(self) -> np.ndarray:
        """Undeformed positions (r, y) of the corner nodes (n_vertices, 2), m."""
        return self.mesh.p[:, : self.mesh.nvertices].T

    @property
    def quads(self) -> np.ndarray:
        """Corners of each element (n_elements, 4)."""
        return self.mesh.t[:4].T

    def respond(self, displacement: np.ndarray, state: State, duration: float = np.inf) -> Response:
        """Return the material response at displacements (size,), m, the end of an increment.

        `state` is the material state at the start of the increment; `duration` is in s.

        Raises:
            InvertedError: The displacements turn an element inside out.
        """
        return self.material.respond(self.strain(displacement), state, duration)

    def strain(self, displacement: np.ndarray) -> np.ndarray:
        """Return the strains at the Gauss points (points, 4) for displacements (size,), m.

        Raises:
            InvertedError: The displacements turn an element inside out.
        """
        return self.kinematics.strain(self._measure(displacement))

    def internal_force(self, displacement: np.ndarray, stress: np.ndarray) -> np.ndarray:
        """Return the nodal forces (size,), N, that balance the stresses (points, 4), Pa.

        `displacement` contains the displacements (size,), m.
        """
        conjugate = self.kinematics.conjugate(self._measure(displacement), stress)
        weighted = conjugate.reshape(*self.volumes.shape, -1) * self.volumes[:, :, None]
        nodal = weighted.reshape(len(self.dofs), 1, -1) @ self._matrices
        return np.bincount(self.dofs.ravel(), nodal.ravel(), minlength=self.size)

    def stiffness(self, displacement: np.ndarray, response: Response) -> np.ndarray:
        """Return element stiffness matrices (n_elements, 16, 16), N/m, for displacements, m.

        Only elements whose tangent differs from that of the undeformed body are computed; all
        others keep their elastic matrix.
        """
        changed, changed_tangent = self.kinematics.tangent(
            self._measure(displacement), response, self.material.elastic_tangent
        )
        points = self.volumes.shape[1]
        elements, row = np.unique(changed // points, return_inverse=True)
        tangent = np.tile(self._undeformed, (elements.size, points, 1, 1))
        tangent[row, changed % points] = changed_tangent
        result = self.elastic_stiffness.copy()
        result[elements] = self._stiffness(tangent, elements)
        return result

    def elastic_energy(self, displacement: np.ndarray, response: Response) -> float:
        """Return the elastic energy of the body, J."""
        elastic = self.strain(displacement) - response.state.plastic_strain
        return float(np.sum(response.stress * elastic, axis=1) @ self.volumes.ravel() / 2)

    def _measure(self, displacement: np.ndarray) -> np.ndarray:
        measure = self._matrices @ displacement[self.dofs][:, :, None]
        return measure.reshape(self.points, -1)

    def _stiffness(self, tangent: np.ndarray, elements: np.ndarray | slice) -> np.ndarray:
        matrices = self._matrices[elements]
        by_point = matrices.reshape(*tangent.shape[:3], matrices.shape[-1])
        stressed = (tangent * self.volumes[elements][:, :, None, None]) @ by_point
        return matrices.transpose(0, 2, 1) @ stressed.reshape(matrices.shape)


def _gradient_matrices(scalar: Basis, hoop: np.ndarray) -> np.ndarray:
    """Return matrices from nodal displacements to displacement gradients (n_elements, 4, 5, 16).

    The gradients at each of the four Gauss points are (rr, yy, tt, ry, yr); tt is the hoop strain.
    """
    matrices = np.zeros((*hoop.shape, 5, 2 * len(scalar.basis)))
    for node, (shape,) in enumerate(scalar.basis):
        along_r, along_y = shape.grad
        matrices[:, :, 0, 2 * node] = matrices[:, :, 4, 2 * node + 1] = along_r
        matrices[:, :, 1, 2 * node + 1] = matrices[:, :, 3, 2 * node] = along_y
        matrices[:, :, 2, 2 * node] = np.asarray(shape) * hoop
    return matrices


@BilinearForm
def _mass(u, v, w):
    return w.per_area * dot(u, v)
