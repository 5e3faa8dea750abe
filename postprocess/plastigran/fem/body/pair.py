# SPDX-License-Identifier: GPL-2.0-or-later
"""Two bodies in one system of equations: a sphere and the body below it."""

from __future__ import annotations

import numpy as np
from scipy.sparse import block_diag

from plastigran.fem.body.body import Body
from plastigran.fem.material.elastic_plastic import Response, State


class Pair:
    """Sphere and the body below it, with the interface of one body for `Equations`.

    Degrees of freedom, elements and Gauss points of the sphere come first. `upward`, `mass` and the
    motion of the center of mass are those of the sphere. Energies are those of both bodies.

    Attributes:
        sphere: Upper body.
        block: Lower body.
        dofs, size, vertex_dofs, vertices, quads, positions, volumes, mass_matrices, mass_matrix,
        mass, upward, held: As of `Body`.
    """

    def __init__(self, sphere: Body, block: Body) -> None:
        self.sphere, self.block = sphere, block
        bodies = (sphere, block)
        shift = sphere.size
        self.size = shift + block.size
        self.dofs = np.concatenate([sphere.dofs, shift + block.dofs])
        self.held = np.concatenate([sphere.held, shift + block.held])
        self.vertex_dofs = np.concatenate([sphere.vertex_dofs, shift + block.vertex_dofs])
        self.vertices = np.concatenate([body.vertices for body in bodies])
        self.quads = np.concatenate([sphere.quads, len(sphere.vertices) + block.quads])
        self.positions = np.concatenate([body.positions for body in bodies])
        self.volumes = np.concatenate([body.volumes for body in bodies])
        self.mass_matrices = np.concatenate([body.mass_matrices for body in bodies])
        self.mass_matrix = block_diag([body.mass_matrix for body in bodies], format="csr")
        self.mass = sphere.mass
        self.upward = np.append(sphere.upward, np.zeros(block.size))

    @property
    def points(self) -> int:
        """Number of Gauss points."""
        return self.volumes.size

    def respond(self, displacement: np.ndarray, state: State, duration: float = np.inf) -> Response:
        """See `Body.respond`."""
        cut = self.sphere.points
        above, below = np.split(displacement, [self.sphere.size])
        upper = self.sphere.respond(above, state.between(0, cut), duration)
        lower = self.block.respond(below, state.between(cut, None), duration)
        return Response(
            np.concatenate([upper.stress, lower.stress]),
            upper.state.joined(lower.state),
            np.concatenate([upper.flowing, cut + lower.flowing]),
            np.concatenate([upper.tangent, lower.tangent]),
        )

    def internal_force(self, displacement: np.ndarray, stress: np.ndarray) -> np.ndarray:
        """See `Body.internal_force`."""
        above, below = np.split(displacement, [self.sphere.size])
        upper, lower = np.split(stress, [self.sphere.points])
        return np.append(
            self.sphere.internal_force(above, upper), self.block.internal_force(below, lower)
        )

    def stiffness(self, displacement: np.ndarray, response: Response) -> np.ndarray:
        """See `Body.stiffness`."""
        above, below = np.split(displacement, [self.sphere.size])
        upper, lower = self._answers(response)
        return np.concatenate(
            [self.sphere.stiffness(above, upper), self.block.stiffness(below, lower)]
        )

    def elastic_energy(self, displacement: np.ndarray, response: Response) -> float:
        """Return the elastic energy, J."""
        above, below = np.split(displacement, [self.sphere.size])
        upper, lower = self._answers(response)
        return self.sphere.elastic_energy(above, upper) + self.block.elastic_energy(below, lower)

    def _answers(self, response: Response) -> tuple[Response, Response]:
        cut = self.sphere.points
        upper = response.flowing < cut
        return (
            Response(
                response.stress[:cut],
                response.state.between(0, cut),
                response.flowing[upper],
                response.tangent[upper],
            ),
            Response(
                response.stress[cut:],
                response.state.between(cut, None),
                response.flowing[~upper] - cut,
                response.tangent[~upper],
            ),
        )
