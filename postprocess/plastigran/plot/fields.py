# SPDX-License-Identifier: GPL-2.0-or-later
"""Meshes of quadrilaterals and fields on them, seen on both sides of an axis of symmetry."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.contour import ContourSet
from matplotlib.tri import Triangulation


def draw_mesh(axes: Axes, points: np.ndarray, quads: np.ndarray, **style: object) -> None:
    """Edges of quadrilaterals with nodes in the middles of their sides, which are parabolas.

    Args:
        axes: They are drawn in.
        points: Nodes (n, 2), in the units of the axes.
        quads: Nodes of each (m, 8): four corners, then the middles of the sides that follow each.
        style: Keywords of matplotlib's LineCollection.
    """
    corners, middles = quads[:, :4], quads[:, 4:]
    sides = np.stack([corners, middles, np.roll(corners, -1, axis=1)], axis=-1).reshape(-1, 3)
    _, first = np.unique(middles, return_index=True)
    x = np.linspace(-1, 1, 9)
    shapes = np.array([x * (x - 1) / 2, 1 - x**2, x * (x + 1) / 2])
    curves = np.einsum("kx,skc->sxc", shapes, points[sides[first]])
    axes.add_collection(LineCollection(curves, **{"colors": "0.4", "lw": 0.4, **style}))


def draw_field(
    axes: Axes,
    vertices: np.ndarray,
    quads: np.ndarray,
    values: np.ndarray,
    levels: np.ndarray,
    mirror: bool = True,
    filled: bool = True,
    **style: object,
) -> ContourSet:
    """A field as contours.

    Args:
        axes: It is drawn in.
        vertices: (n, 2), in the units of the axes.
        quads: Corners of each quadrilateral (m, 4).
        values: At the vertices (n,).
        levels: Of the contours, increasing.
        mirror: Draw it at negative first coordinates, too.
        filled: Fill between the levels instead of lines on them.
        style: Keywords of matplotlib's tricontourf or tricontour.

    Returns:
        The contours, for a colour bar.
    """
    # Either diagonal of a quadrilateral serves: the fields are smooth over it.
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    if mirror:
        count = len(vertices)
        vertices = np.concatenate([vertices, vertices * [-1, 1]])
        triangles = np.concatenate([triangles, count + triangles[:, ::-1]])
        values = np.concatenate([values, values])
    triangulation = Triangulation(*vertices.T, triangles)
    draw = axes.tricontourf if filled else axes.tricontour
    return draw(triangulation, values, levels=levels, **style)
