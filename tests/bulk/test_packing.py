# SPDX-License-Identifier: GPL-2.0-or-later
"""Random packings: no overlap, inside the container, reproducible."""

from __future__ import annotations

import numpy as np
import pytest

from plastigran.bulk import packing
from plastigran.bulk.packing import random_packing


def in_cube(side):
    """Return two functions for 400 spheres of radius 1 in a cube.

    One draws random centers; the other moves centers so that the spheres are inside the cube.
    """
    return (
        lambda random: random.uniform(0, side, (400, 3)),
        lambda places: np.clip(places, 1, side - 1),
    )


def test_spheres_do_not_overlap_and_are_inside():
    """Spheres of a random packing do not overlap, lie in the container, and depend on the seed.

    The volume fraction is 0.53, between a gas and random close packing.
    """
    side = (4 / 3 * np.pi * 400 / 0.53) ** (1 / 3)
    places = random_packing(1, *in_cube(side), seed=3)
    first, second = np.triu_indices(400, 1)
    assert np.linalg.norm(places[first] - places[second], axis=1).min() > 2
    outside = np.maximum(1 - places, places + 1 - side)
    assert outside.max() < 10 * packing.JITTER * 2  # 10 standard deviations of a move
    assert (random_packing(1, *in_cube(side), seed=3) == places).all()
    assert (random_packing(1, *in_cube(side), seed=4) != places).any()


def test_dense_packing_is_refused(monkeypatch):
    monkeypatch.setattr(packing, "ROUNDS", 50)
    with pytest.raises(ValueError, match=r"400 grains still overlap by .* Lower volume_fraction"):
        random_packing(1, *in_cube(12.5), seed=1)  # a volume fraction of 0.86
