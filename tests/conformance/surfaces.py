# SPDX-License-Identifier: GPL-2.0-or-later
"""Triangulated surfaces for decks with mesh walls: arrays of corners, shape (n, 3, 3) [m]."""

from __future__ import annotations

import numpy as np


def pipe(facets: int, radius: float, length: float) -> np.ndarray:
    """Return a pipe along y around the origin; `radius` is the distance of its facets from the
    axis."""
    ends = 2 * np.pi * (np.arange(facets + 1) + 0.5) / facets
    corners = radius / np.cos(np.pi / facets) * np.array([np.sin(ends), -np.cos(ends)]).T
    return _strips(np.array([np.insert(corners, 1, y, axis=1) for y in (-length / 2, length / 2)]))


def bowl(rings: int, sectors: int, radius: float) -> np.ndarray:
    """Return the lower half of a sphere around the origin; the nodes lie on the sphere."""
    polar = np.linspace(0, np.pi / 2, rings + 1)
    around = 2 * np.pi * np.arange(sectors + 1) / sectors
    direction = np.array([np.cos(around), np.sin(around)]).T
    flat = np.sin(polar)[:, None, None] * direction
    height = np.broadcast_to(-np.cos(polar)[:, None, None], (*flat.shape[:2], 1))
    triangles = _strips(radius * np.concatenate([flat, height], axis=2))
    sides = np.linalg.norm(triangles - np.roll(triangles, 1, axis=1), axis=2)
    # Omit the triangles at the pole that have a side of length zero.
    return triangles[sides.min(axis=1) > 1e-9 * radius]


def cone(facets: int, low: float, high: float) -> np.ndarray:
    """Return the inside of a cone of 45 degrees about z, between two radii."""
    angles = np.linspace(0, 2 * np.pi, facets + 1)
    rings = [
        np.stack([r * np.cos(angles), r * np.sin(angles), r + 0 * angles], 1) for r in (low, high)
    ]
    return _strips(np.array(rings))


def folded_plate(
    angle: float, size: float, pieces: int = 1, near: tuple[float, ...] = ()
) -> np.ndarray:
    """Return two squares: one in z = 0, and one beyond x = 0 that is turned upward.

    Args:
        angle: Angle of the fold [degrees]; negative if the square turns downward.
        size: Side of each square [m].
        pieces: Number of pieces into which each square is cut along the edge.
        near: Distances from the edge at which each square is cut parallel to the edge [m].
    """
    turn = np.radians(angle)
    sides = np.array([[-1.0, 0.0], [np.cos(turn), np.sin(turn)]])
    cuts = np.array([*sorted(near), size])[:, np.newaxis]
    across = np.concatenate([cuts[::-1] * sides[0], [[0.0, 0.0]], cuts * sides[1]])
    along = np.linspace(-size / 2, size / 2, pieces + 1)
    return _strips(np.array([np.insert(across, 1, y, axis=1) for y in along]))


def corner(size: float) -> np.ndarray:
    """Return the three inner faces of a cube's corner, in x = 0, y = 0 and z = 0."""
    square = _strips(np.array([[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 0]]]) * size)
    return np.concatenate([np.roll(square, shift, axis=2) for shift in range(3)])


def _strips(points: np.ndarray) -> np.ndarray:
    """Return the triangles between neighboring points of a grid, shape (rows, columns, 3)."""
    a, b, c, d = points[:-1, :-1], points[:-1, 1:], points[1:, :-1], points[1:, 1:]
    both = [np.stack(corners, axis=2).reshape(-1, 3, 3) for corners in ((a, b, d), (a, d, c))]
    return np.concatenate(both)
