# SPDX-License-Identifier: GPL-2.0-or-later
"""The hopper meshes are closed, have the stated sizes, and are smooth surfaces for LIGGGHTS."""

from __future__ import annotations

import re
from collections import Counter
from math import pi

import make_hopper
import numpy as np
import pytest

from plastigran.engine.process import PROJECT


@pytest.mark.parametrize("size", make_hopper.ORIFICES)
def test_surface_has_two_openings_only(size):
    """Every edge belongs to two triangles, except at the orifice and the top, where edges form
    circles.
    """
    corners = np.round(make_hopper.triangles(size), 9)
    edges = Counter(
        frozenset(map(tuple, (triangle[k], triangle[k - 1])))
        for triangle in corners
        for k in range(3)
    )
    rims = [np.array(list(edge)) for edge, count in edges.items() if count == 1]
    assert set(edges.values()) == {1, 2} and len(rims) == 2 * make_hopper.SEGMENTS
    for height, diameter in ((0, size), (make_hopper.HEIGHT, make_hopper.BARREL)):
        rim = [edge for edge in rims if np.allclose(edge[:, 2], height)]
        area = sum(abs(np.linalg.det(edge[:, :2])) / 2 for edge in rim)
        assert area == pytest.approx(pi / 4 * diameter**2, rel=1e-8)


@pytest.mark.parametrize("size", make_hopper.ORIFICES)
def test_facets_are_smooth_for_liggghts(size):
    """The mesh option `curvature` is large enough to make the hopper a smooth surface in LIGGGHTS.

    Contact history passes between facets whose angle is below `curvature` [degrees]. Otherwise, a
    yielding grain on their edge creates energy. The corners of all triangles have larger angles.
    """
    deck = (PROJECT / "inputs" / "bulk" / "hopper" / "walls_liggghts.in").read_text()
    curvature = float(re.search(r"hopper_\S+ .* curvature (\S+)", deck)[1])
    # Facets of the barrel meet at an angle of 360/SEGMENTS degrees, facets of the cone at a smaller
    # one.
    assert curvature > 360 / make_hopper.SEGMENTS
    corners = make_hopper.triangles(size)
    for k in range(3):
        a, b = corners[:, k - 1] - corners[:, k], corners[:, k - 2] - corners[:, k]
        lengths = np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1)
        angles = np.degrees(np.arccos((a * b).sum(axis=1) / lengths))
        assert angles.min() > curvature
