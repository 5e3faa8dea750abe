# SPDX-License-Identifier: GPL-2.0-or-later
"""Two bodies in one system of equations: a sphere and the body below it."""

from __future__ import annotations

import numpy as np
from scipy.sparse import block_diag

from plastigran.fem.body.body import Body
from plastigran.fem.material.elastic_plastic import Response, State


class Pair:
    """Sphere and the block below it, with the attributes and methods of one `Body`.

    In all arrays, the values of the sphere come before those of the block. `upward`, `mass` and
    the motion of the center of mass belong to the sphere only. Energies are sums over both bodies.

    Attributes:
        sphere: Upper body.
        block: Lower body.
    """

    def __init__(self, sphere: Body, block: Body) -> None:
        self.sphere, self.block = sphere, block
        self.size = sphere.size + block.size
        for name, shift in {
            "dofs": sphere.size,
            "fixed": sphere.size,
            "vertex_dofs": sphere.size,
            "quads": len(sphere.vertices),
            "vertices": 0,
            "positions": 0,
            "volumes": 0,
            "mass_matrices": 0,
        }.items():
            joined = np.concatenate([getattr(sphere, name), shift + getattr(block, name)])
            setattr(self, name, joined)
        self.mass_matrix = block_diag([sphere.mass_matrix, block.mass_matrix], format="csr")
        self.mass = sphere.mass
        self.upward = np.append(sphere.upward, np.zeros(block.size))
        self.points = self.volumes.size

    def respond(self, displacement: np.ndarray, state: State, duration: float = np.inf) -> Response:
        """Return the material responses of both bodies in one object; see `Body.respond`."""
        above, below = np.split(displacement, [self.sphere.size])
        above_state, below_state = state.split(self.sphere.points)
        upper = self.sphere.respond(above, above_state, duration)
        lower = self.block.respond(below, below_state, duration)
        return Response(
            np.concatenate([upper.stress, lower.stress]),
            upper.state.joined(lower.state),
            np.concatenate([upper.flowing, self.sphere.points + lower.flowing]),
            np.concatenate([upper.tangent, lower.tangent]),
        )

    def internal_force(self, displacement: np.ndarray, stress: np.ndarray) -> np.ndarray:
        """Return the nodal forces of both bodies; see `Body.internal_force`."""
        above, below = np.split(displacement, [self.sphere.size])
        upper, lower = np.split(stress, [self.sphere.points])
        return np.append(
            self.sphere.internal_force(above, upper), self.block.internal_force(below, lower)
        )

    def stiffness(self, displacement: np.ndarray, response: Response) -> np.ndarray:
        """Return the element stiffness matrices of both bodies; see `Body.stiffness`."""
        upper, lower = self._split(displacement, response)
        return np.concatenate([self.sphere.stiffness(*upper), self.block.stiffness(*lower)])

    def elastic_energy(self, displacement: np.ndarray, response: Response) -> float:
        """Return the elastic energy of both bodies, J."""
        upper, lower = self._split(displacement, response)
        return self.sphere.elastic_energy(*upper) + self.block.elastic_energy(*lower)

    def _split(self, displacement: np.ndarray, response: Response):
        """Return two pairs (displacement, response): of the sphere, and of the block."""
        first_below = np.searchsorted(response.flowing, self.sphere.points)
        responses = zip(
            np.split(response.stress, [self.sphere.points]),
            response.state.split(self.sphere.points),
            (response.flowing[:first_below], response.flowing[first_below:] - self.sphere.points),
            np.split(response.tangent, [first_below]),
            strict=True,
        )
        displacements = np.split(displacement, [self.sphere.size])
        return zip(displacements, (Response(*parts) for parts in responses), strict=True)
