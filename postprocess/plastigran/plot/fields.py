# SPDX-License-Identifier: GPL-2.0-or-later
"""Draw quadrilateral meshes, and fields on such meshes. Fields can be mirrored at the axis."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.contour import ContourSet
from matplotlib.tri import Triangulation


def draw_mesh(axes: Axes, points: np.ndarray, quads: np.ndarray, **style: object) -> None:
    """Draw the edges of quadrilaterals with mid-side nodes. Each edge is a parabola.

    Args:
        axes: Axes to draw in.
        points: Coordinates of the nodes (n, 2), in the units of the axes.
        quads: Indices of the nodes of each element (m, 8): four corners, then four mid-side nodes.
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
    """Draw contours of a field that is given at the vertices of a quadrilateral mesh.

    Args:
        axes: Axes to draw in.
        vertices: Coordinates of the vertices (n, 2), in the units of the axes.
        quads: Indices of the corners of each quadrilateral (m, 4).
        values: Values at the vertices (n,).
        levels: Levels of the contours, increasing.
        mirror: Whether to draw also the mirror image of the field at negative first coordinates.
        filled: Whether to fill the space between levels instead of drawing lines.
        style: Keywords of matplotlib's tricontourf or tricontour.

    Returns:
        The contours, from which a color bar can be made.
    """
    # Split each quadrilateral along a diagonal. For a smooth field, the choice of the diagonal does
    # not matter.
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    if mirror:
        count = len(vertices)
        vertices = np.concatenate([vertices, vertices * [-1, 1]])
        triangles = np.concatenate([triangles, count + triangles[:, ::-1]])
        values = np.concatenate([values, values])
    triangulation = Triangulation(*vertices.T, triangles)
    draw = axes.tricontourf if filled else axes.tricontour
    return draw(triangulation, values, levels=levels, **style)
