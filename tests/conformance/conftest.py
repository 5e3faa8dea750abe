# SPDX-License-Identifier: GPL-2.0-or-later
"""What the tests of the laws' paths share: the bodies, and where a law's force jumps."""

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
def virgin_jumps(law_between):
    """Finds where a law's virgin force jumps, `virgin_jumps(name, pair)`: of each jump the overlaps
    [m] right before and behind it, 1e-12 of them apart, and the change as a share of the force.

    Seen over eight decades in steps of 5e-5: a smooth force moves by twice that or less; a
    cylinder's, whose slope jumps up by 5 at yield for this thickness, by six times. Such steps are
    taken only where a step of 5e-4 does not move the force as its neighbours do: a jump to be found
    moves it by 2e-4 or more, and a smooth force changes its slope by 1e-5 from step to step.
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
        suspect = np.abs(change) > 20 * largest  # a jump beside another like it is even
        suspect[1:] |= uneven
        suspect[:-1] |= uneven
        found = []
        for at in np.flatnonzero(suspect):
            points = np.geomspace(overlap[at], overlap[at + 1], 11)
            jumps = np.flatnonzero(np.abs(steps(points)) > largest)
            found += [narrowed(points[jump], points[jump + 1]) for jump in jumps]
        return found

    return find
