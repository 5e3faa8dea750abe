# SPDX-License-Identifier: GPL-2.0-or-later
"""Fixtures for the tests of loading paths: material pairs, and the jumps of a law's force."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from pairs import PAIRS, RADIUS, scales

from plastigran import laws


@pytest.fixture(params=sorted(PAIRS))
def pair(request) -> laws.MaterialPair:
    return PAIRS[request.param]


@pytest.fixture(scope="session")
def jumps_of_first_loading(law_between):
    """Return a function that finds the jumps of a law's force during first loading.

    `jumps_of_first_loading(name, pair)` returns, for each jump, the overlaps [m] just before and
    behind it and the relative change of the force. The two overlaps differ by 1e-12 of their value.
    The search covers eight decades of overlap in coarse steps of 5e-4, relative to the overlap. If
    the force is smooth, its relative changes in neighboring coarse steps differ by about 1e-5. A
    jump adds 2e-4 or more. Where the changes differ, the search repeats the coarse step in fine
    steps of 5e-5. In a fine step, a smooth force changes by at most 1e-4. The force of a cylinder
    changes by at most 3e-4, because its slope grows fivefold at yield.
    """

    @cache
    def find(law_name: str, pair_name: str) -> list[tuple[float, float, float]]:
        law = law_between(law_name, PAIRS[pair_name])
        largest = 2e-4 if law.shape == "sphere" else 3e-4
        overlap_y, _ = scales(law_name, PAIRS[pair_name])

        def steps(overlap: np.ndarray) -> np.ndarray:
            return np.diff(np.log(law.follow(RADIUS, overlap)["force"]))

        def narrowed(before: float, after: float) -> tuple[float, float, float]:
            while after > before * (1 + 1e-12):
                points = np.linspace(before, after, 11)
                at = np.abs(steps(points)).argmax()
                before, after = points[at], points[at + 1]
            return before, after, float(np.expm1(steps(np.array([before, after]))[0]))

        overlap = np.geomspace(1e-3, 1e5, 40_001) * overlap_y
        change = steps(overlap)
        uneven = np.abs(np.diff(change)) > largest / 4
        suspect = np.abs(change) > 20 * largest  # finds two equal jumps in neighboring steps
        suspect[1:] |= uneven
        suspect[:-1] |= uneven
        found = []
        for at in np.flatnonzero(suspect):
            points = np.geomspace(overlap[at], overlap[at + 1], 11)
            jumps = np.flatnonzero(np.abs(steps(points)) > largest)
            found += [narrowed(points[jump], points[jump + 1]) for jump in jumps]
        return found

    return find
