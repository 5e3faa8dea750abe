# SPDX-License-Identifier: GPL-2.0-or-later
"""Fields of a snapshot for figures."""

from __future__ import annotations

import numpy as np

from plastigran.fem.stepping.snapshot import Snapshot


def at_vertices(snapshot: Snapshot, values: np.ndarray) -> np.ndarray:
    """Return values (points,) of the Gauss points at the element corners (n_vertices,).

    Each corner has the mean of the closest Gauss points of its elements, so no value is
    extrapolated.
    """
    quads = snapshot.quads
    points = snapshot.positions.reshape(len(quads), -1, 2)
    corners = snapshot.vertices[quads]
    apart = np.linalg.norm(corners[:, :, None] - points[:, None], axis=-1)
    nearest = np.take_along_axis(values.reshape(len(quads), -1), apart.argmin(axis=2), axis=1)
    count = np.bincount(quads.ravel())
    return np.bincount(quads.ravel(), nearest.ravel()) / count
