# SPDX-License-Identifier: GPL-2.0-or-later
"""Meshes of a sphere: eight-node quadrilaterals that a conformal map grades toward the contact.

A half disc of radius R, with its lowest point at the origin, is the image of a quarter plane. The
map is z = 2iR w/(1 + w) with w = exp(s - i theta) and 0 <= theta <= pi/2. The axis is theta = 0,
the circle is theta = pi/2, and the equator is |w| = 1. Near the contact point, the distance from it
is 2R |w|. Rings of equal |w| with equal steps in s and theta give nearly square elements of any
size. One mesh therefore resolves a contact radius of a thousandth of R, without a transition zone.
"""

from __future__ import annotations

from math import log, pi

import attrs
import numpy as np
from skfem import MeshQuad, MeshQuad2

FINE_RATIO = 3.0  # ratio of the step in theta to the step in s for rings at the contact edge
FINE_REACH = 1.3  # radius at which the fine rings end / largest contact radius
GROWTH = 1.25  # largest ratio of consecutive distances between rings outside the fine zone


@attrs.frozen(kw_only=True)
class SphereMesh:
    """Mesh of a sphere or of its lower half.

    Attributes:
        radius: Radius of the sphere, m.
        core: Radius about the contact point inside which elements have equal size, m.
        reach: Largest contact radius of the mesh, m.
        divisions: Number of elements across `core`. A ring has twice as many elements from the axis
            to the circle.
        fineness: Factor that multiplies the number of rings.
        whole: Whether to mesh the whole sphere instead of its lower half.
    """

    radius: float
    core: float
    reach: float
    divisions: int
    fineness: float = 1.0
    whole: bool = True

    def build(self) -> MeshQuad2:
        """Return the mesh in (r, y), m, with axis r = 0 and the contact point at the origin.

        Boundaries are `axis`, `circle` and, for half a sphere, `equator`.
        """
        w, quads = self._quarter_plane()
        corner_points = self._to_sphere(w)
        quads = np.ascontiguousarray(counterclockwise(quads, corner_points).T)
        linear = MeshQuad(np.array([w.real, w.imag]), quads)
        quadratic = MeshQuad2.from_mesh(linear)
        first, second = linear.facets
        facet_middle = self._middle(w[first], w[second])
        facet_points = self._to_sphere(facet_middle)
        # Interpolate the center from the eight nodes, so that the element is isoparametric.
        center = facet_points[linear.t2f].sum(axis=0) / 2 - corner_points[linear.t].sum(axis=0) / 4
        points = np.concatenate([corner_points, facet_points, center])
        on_axis = np.abs(facet_middle.imag) < 1e-12 * np.abs(facet_middle)
        on_circle = np.abs(facet_middle.real) < 1e-12 * np.abs(facet_middle)
        coordinates = np.array([points.real, points.imag])
        coordinates[0, np.abs(coordinates[0]) < 1e-12 * self.radius] = 0.0
        outer = linear.boundary_facets()
        named = {"axis": outer[on_axis[outer]], "circle": outer[on_circle[outer]]}
        if not self.whole:
            named["equator"] = np.setdiff1d(outer, np.concatenate(list(named.values())))
        return MeshQuad2(coordinates, quadratic.t).with_boundaries(named)

    def _middle(self, first: np.ndarray, second: np.ndarray) -> np.ndarray:
        """Return the midpoints (w-plane) of the edges from `first` to `second`.

        Edges are straight in w in the core, in 1/w in the upper half, and in ln w in between.
        """
        # 1/w and ln w are undefined at w = 0, but the core does not use them.
        with np.errstate(invalid="ignore", divide="ignore"):
            middle = first * np.sqrt(second / first)
        core = self.core / (2 * self.radius) * (1 - 1e-9)
        inside = np.minimum(np.abs(first), np.abs(second)) < core
        above = np.maximum(np.abs(first), np.abs(second)) > 1 + 1e-9
        middle[inside] = (first + second)[inside] / 2
        middle[above] = 2 / (1 / first[above] + 1 / second[above])
        return middle

    def _to_sphere(self, w: np.ndarray) -> np.ndarray:
        """Return r + iy for w by the conformal map of this module, mirrored to r >= 0."""
        z = 2j * self.radius * w / (1 + w)
        return np.abs(z.real) + 1j * z.imag

    def _quarter_plane(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the mesh in the plane w of the conformal map.

        The mesh consists of the core, the rings, and for the upper half a disc in 1/w.

        Returns:
            Points w, and indices of the corners of the elements (n, 4).
        """
        disc, disc_quads, rim = quarter_disc(self.divisions)
        angle = np.exp(-1j * np.linspace(0, pi / 2, 2 * self.divisions + 1))
        ends = (self.core, max(FINE_REACH * self.reach, self.core), 2 * self.radius)
        rings = ring_radii(*(end / ends[-1] for end in ends), self.divisions, self.fineness)
        points = [rings[0] * disc.conj(), (rings[1:, None] * angle).ravel()]
        ring_ids = np.vstack(
            [rim, len(disc) + np.arange((len(rings) - 1) * angle.size).reshape(-1, angle.size)]
        )
        quads = [disc_quads, strip_quads(ring_ids)]
        if not self.whole:
            return np.concatenate(points), np.concatenate(quads)
        upper_ids = np.full(len(disc), -1)
        upper_ids[rim] = ring_ids[-1]
        inner = upper_ids < 0
        upper_ids[inner] = sum(map(len, points)) + np.arange(inner.sum())
        # At the top of the sphere, w is infinite. Use a tiny value for 1/w instead of zero.
        points.append(1 / np.where(disc[inner] == 0, 1e-14, disc[inner]))
        quads.append(upper_ids[disc_quads])
        return np.concatenate(points), np.concatenate(quads)


def graded(start: float, fine_end: float, end: float, fine: float, widest: float) -> np.ndarray:
    """Return increasing values from `start` to `end`, such as radii of rings.

    The spacing is `fine` up to `fine_end`. Beyond `fine_end`, the spacing grows by the factor
    GROWTH from value to value, up to `widest`.
    """
    count = max(1, round((fine_end - start) / fine))
    values = list(np.linspace(start, fine_end, count + 1))
    step = fine
    while values[-1] < end - 1e-9:
        step = min(step * GROWTH, widest)
        values.append(values[-1] + step)
    outer = np.array(values[count:])
    outer = fine_end + (outer - fine_end) * ((end - fine_end) / (outer[-1] - fine_end))
    return np.concatenate([values[:count], outer])


def ring_radii(
    core: float, fine_end: float, end: float, divisions: int, fineness: float
) -> np.ndarray:
    """Return the radii of the rings of elements about a contact; rings are fine to `fine_end`."""
    coarse = pi / (4 * divisions) / fineness
    ends = (log(radius) for radius in (core, fine_end, end))
    return np.exp(graded(*ends, coarse / FINE_RATIO, 2 * coarse))


def quarter_disc(divisions: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the mesh of a unit quarter disc: a curved square inside rings.

    Args:
        divisions: Number of elements along a side of the square; the arc has twice as many.

    Returns:
        Points x + iy (n,), corners of the elements (m, 4), and IDs of the points on the circle from
        the real to the imaginary axis (2 divisions + 1,).
    """
    side = np.linspace(0, 1, divisions + 1)
    x, y = np.meshgrid(side, side, indexing="ij")
    largest = np.maximum(x, y)
    with np.errstate(invalid="ignore", divide="ignore"):
        theta = np.where(x >= y, pi / 4 * y / x, pi / 2 - pi / 4 * x / y)
    theta = np.nan_to_num(theta)
    bulge = 0.5 * largest
    square = 0.6 * ((1 - bulge) * (x + 1j * y) + bulge * largest * np.exp(1j * theta))
    ids = np.arange(square.size).reshape(square.shape)
    rim = np.concatenate([ids[-1, :], ids[-2::-1, -1]])
    circle = np.exp(1j * np.linspace(0, pi / 2, 2 * divisions + 1))
    collar = max(2, divisions // 2)
    share = np.linspace(0, 1, collar + 1)[1:, None]
    rings = (1 - share) * square.ravel()[rim] + share * circle
    ring_ids = np.vstack([rim, square.size + np.arange(rings.size).reshape(rings.shape)])
    quads = np.concatenate([strip_quads(ids), strip_quads(ring_ids)])
    return np.concatenate([square.ravel(), rings.ravel()]), quads, ring_ids[-1]


def strip_quads(ids: np.ndarray) -> np.ndarray:
    """Return the corners (m, 4) of the quadrilaterals of a grid; `ids` are its point IDs."""
    corners = [ids[:-1, :-1], ids[1:, :-1], ids[1:, 1:], ids[:-1, 1:]]
    return np.stack(corners, axis=-1).reshape(-1, 4)


def counterclockwise(quads: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Return the quadrilaterals with their corners in counterclockwise order."""
    corner = points[quads]
    diagonals = (corner[:, 2] - corner[:, 0]).conj() * (corner[:, 3] - corner[:, 1])
    return np.where((diagonals.imag < 0)[:, None], quads[:, ::-1], quads)
