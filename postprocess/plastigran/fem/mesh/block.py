# SPDX-License-Identifier: GPL-2.0-or-later
"""Meshes of a half space under a contact; the surface is y = 0.

The element size grows with the distance from the contact. A body that is a thousand times larger
therefore needs only a few more rings of elements. The far boundary, `base`, is a fixed arc.
"""

from __future__ import annotations

from math import asinh, pi

import attrs
import numpy as np
from skfem import MeshQuad, MeshQuad2

from plastigran.declared import number, require, whole
from plastigran.fem.mesh.sphere import (
    FINE_REACH,
    counterclockwise,
    graded,
    quarter_disc,
    ring_radii,
    strip_quads,
)

WIDEST_RING = 0.4  # largest difference in s between two rings; see TrackBlock for s


@attrs.frozen(kw_only=True)
class HalfBlock:
    """Mesh for a symmetric load on a half space: rings about the contact point, for x >= 0.

    Raises:
        ValueError: A field is not positive, or `size` ends within the fine zone.
    """

    core: float = number("radius inside which elements have equal size", "m", 0)
    reach: float = number("largest contact radius of the mesh", "m", 0)
    size: float = number("radius of the base", "m", 0)
    divisions: int = whole(
        "number of elements across the core, the part with elements of equal size", 2, default=6
    )
    fineness: float = number(
        "factor that multiplies the number of rings of elements", "-", 0.1, 10, default=1.0
    )

    def __attrs_post_init__(self) -> None:
        require(self, "size", lower=self._fine)

    @property
    def _fine(self) -> float:
        """Radius at which the fine rings end, m."""
        return max(FINE_REACH * self.reach, self.core)

    def build(self) -> MeshQuad2:
        """Return the mesh in (x, y), m, x >= 0, with boundaries `axis`, `surface` and `base`."""
        disc, disc_quads, rim = quarter_disc(self.divisions)
        angle = np.exp(-1j * np.linspace(0, pi / 2, 2 * self.divisions + 1))
        ends = (length / self.core for length in (self.core, self._fine, self.size))
        rings = ring_radii(*ends, self.divisions, self.fineness)
        outer = (rings[1:, None] * angle).ravel()
        ids = np.vstack([rim, len(disc) + np.arange(outer.size).reshape(-1, angle.size)])
        quads = np.concatenate([disc_quads, strip_quads(ids)])
        return _mesh(self.core * np.concatenate([disc.conj(), outer]), quads)


@attrs.frozen(kw_only=True)
class TrackBlock:
    """Mesh of a half space for a sliding contact: elliptic rings about the track of the contact.

    With z = x + iy and the half length c of the track, the rings are lines of equal s in
    z = c cosh(s + i theta). The ring s = 0 is the track -c < x < c on the surface. Far from the
    track, the rings are circles.

    Raises:
        ValueError: A field is not positive, or `size` ends within the fine zone.
    """

    half_length: float = number("half length of the track of the sliding contact", "m", 0)
    element: float = number("element length in the middle of the track of the contact", "m", 0)
    depth: float = number("depth to which elements have equal size", "m", 0)
    size: float = number("radius of the base", "m", 0)

    def __attrs_post_init__(self) -> None:
        require(self, "size", lower=self.half_length + self.depth)
        require(self, "element", lower=0, upper=self.half_length)

    def build(self) -> MeshQuad2:
        """Return the mesh in (x, y), m, with boundaries `surface` and `base`."""
        angles = np.linspace(0, pi, round(pi * self.half_length / self.element) + 1)
        ends = (0.0, *(asinh(depth / self.half_length) for depth in (self.depth, self.size)))
        rings = graded(*ends, angles[1] - angles[0], WIDEST_RING)
        points = np.cosh(rings[:, None] - 1j * angles)
        ids = np.arange(points.size).reshape(points.shape)
        return _mesh(self.half_length * points.ravel(), strip_quads(ids))


def _mesh(points: np.ndarray, quads: np.ndarray) -> MeshQuad2:
    """Return a mesh of straight-sided elements with named boundaries.

    Args:
        points: Corner points x + iy, m.
        quads: Indices of the four corners of each element.
    """
    size = np.abs(points).max()
    coordinates = np.array([points.real, points.imag])
    coordinates[np.abs(coordinates) < 1e-12 * size] = 0.0
    quads = np.ascontiguousarray(counterclockwise(quads, points).T)
    mesh = MeshQuad2.from_mesh(MeshQuad(coordinates, quads))
    outer = mesh.boundary_facets()
    first, second = mesh.p[:, mesh.facets[:, outer]].transpose(1, 0, 2)
    on = {"axis": (first[0] == 0) & (second[0] == 0), "surface": (first[1] == 0) & (second[1] == 0)}
    on["base"] = ~(on["axis"] | on["surface"])
    return mesh.with_boundaries({name: outer[here] for name, here in on.items() if here.any()})
