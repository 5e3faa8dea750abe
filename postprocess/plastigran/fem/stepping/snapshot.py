# SPDX-License-Identifier: GPL-2.0-or-later
"""Snapshots: stress, strain and displacement fields of an equilibrium."""

from __future__ import annotations

import attrs
import numpy as np

from plastigran.fem.body.body import Body
from plastigran.fem.body.pair import Pair
from plastigran.fem.contact.plane import RigidPlane
from plastigran.fem.stepping.increment import Equilibrium

YIELDED = 1e-4  # accumulated plastic strain above which a point counts as yielded


@attrs.frozen
class Snapshot:
    """Fields of a body at one time.

    Attributes:
        force: Contact force, N.
        radii: Mean distance of each element edge of the surface from the axis (n_edges,), m.
        pressure: Mean pressure on each of these edges (n_edges,), Pa.
        positions: (r, y) of the Gauss points (points, 2), m.
        mises: Von Mises stress at the Gauss points (points,), Pa. In finite strain, it is computed
            from the stress that is conjugate to the logarithmic strain.
        plastic_strain: Accumulated plastic strain at the Gauss points (points,).
        vertices: (r, y) of the corner nodes in the undeformed body (n_vertices, 2), m.
        quads: Corners of each element (n_elements, 4); its four Gauss points are consecutive.
        displacement: Displacements of the corner nodes (n_vertices, 2), m.
    """

    force: float
    radii: np.ndarray
    pressure: np.ndarray
    positions: np.ndarray
    mises: np.ndarray
    plastic_strain: np.ndarray
    vertices: np.ndarray
    quads: np.ndarray
    displacement: np.ndarray


def energies(body: Body | Pair, state: Equilibrium) -> dict[str, float]:
    """Return the elastic energy, the plastic work and the penalty energy of the contact, J."""
    return {
        "elastic_energy": body.elastic_energy(state.displacement, state.response),
        "plastic_work": float(state.response.state.work @ body.volumes.ravel()),
        "penalty_energy": state.touch.stored,
    }


def snapshot(body: Body | Pair, plane: RigidPlane, state: Equilibrium) -> Snapshot:
    """Return the fields of an equilibrium."""
    return Snapshot(
        state.touch.force,
        *plane.profile(state.touch),
        body.positions.reshape(-1, 2),
        mises_stress(state.response.stress),
        state.response.state.accumulated,
        body.vertices,
        body.quads,
        state.displacement[body.vertex_dofs],
    )


def mises_stress(stress: np.ndarray) -> np.ndarray:
    """Return the von Mises stress (n,) of stresses (rr, yy, tt, ry) (n, 4), Pa."""
    radial, axial, hoop, shear = stress.T
    differences = (radial - axial) ** 2 + (axial - hoop) ** 2 + (hoop - radial) ** 2
    return np.sqrt(differences / 2 + 3 * shear**2)


def at_vertices(snapshot: Snapshot, values: np.ndarray) -> np.ndarray:
    """Return values at the corner nodes (n_vertices,) from values at the Gauss points (points,).

    Each element at a corner node contributes the value at its Gauss point closest to the node. The
    result is the mean of these values.
    """
    quads = snapshot.quads
    points = snapshot.positions.reshape(len(quads), -1, 2)
    corners = snapshot.vertices[quads]
    distances = np.linalg.norm(corners[:, :, None] - points[:, None], axis=-1)
    nearest = np.take_along_axis(values.reshape(len(quads), -1), distances.argmin(axis=2), axis=1)
    return np.bincount(quads.ravel(), nearest.ravel()) / np.bincount(quads.ravel())
