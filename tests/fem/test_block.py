# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the meshes of a half space."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from attrs import evolve

from plastigran.fem.body.body import Body
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.mesh.block import HalfBlock, TrackBlock

METAL = ElasticPlastic(youngs_modulus=70e9, poissons_ratio=0.3, density=2699.0)
LENGTH, SIZE = 1e-3, 1.0
HALF = HalfBlock(core=1e-3, reach=3e-3, size=SIZE)
TRACK = TrackBlock(half_length=0.02, element=2e-3, depth=5e-3, size=SIZE)


@pytest.mark.parametrize(
    ("block", "length", "volume"),
    [
        (HALF, LENGTH, LENGTH * pi / 4 * SIZE**2),
        (HALF, None, 2 / 3 * pi * SIZE**3),
        (TRACK, LENGTH, LENGTH * pi / 2 * SIZE**2),
    ],
)
def test_elements_fill_the_block(block, length, volume):
    body = Body(block.build(), METAL, length)
    assert body.volumes.min() > 0
    # The base is a polygon of at least 12 sides per right angle instead of an arc, so the volume is
    # up to 0.3 % smaller.
    assert body.volumes.sum() == pytest.approx(volume, rel=5e-3)
    assert body.mass == pytest.approx(body.volumes.sum() * METAL.density, rel=1e-3)


@pytest.mark.parametrize("block", [HALF, TRACK])
def test_boundaries_lie_where_their_names_say(block):
    mesh = block.build()

    def points(name):
        return mesh.p[:, np.unique(mesh.facets[:, mesh.boundaries[name]])]

    assert np.all(points("surface")[1] == 0)
    assert np.hypot(*points("base")) == pytest.approx(SIZE, rel=1e-3)
    assert mesh.p[1].max() == 0
    if "axis" in mesh.boundaries:
        assert np.all(points("axis")[0] == 0)
    assert sum(map(len, mesh.boundaries.values())) == len(mesh.boundary_facets())


def test_the_base_is_held():
    body = Body(TRACK.build(), METAL, LENGTH)
    held = body.locations[:, body.fixed]
    assert np.hypot(*held).min() == pytest.approx(SIZE, rel=5e-3)


@pytest.mark.parametrize(
    ("kind", "changed", "said"),
    [
        (HALF, {"size": 2e-3}, "size is 0.002"),
        (HALF, {"core": 0.0}, "core is 0"),
        (TRACK, {"element": 0.1}, "element is 0.1"),
        (TRACK, {"size": 0.01}, "size is 0.01"),
    ],
)
def test_blocks_that_cannot_be_are_refused(kind, changed, said):
    with pytest.raises(ValueError, match=said):
        evolve(kind, **changed)
