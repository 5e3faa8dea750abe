# SPDX-License-Identifier: GPL-2.0-or-later
"""Properties that every law must have on any loading path.

The tests run for every law without adhesion that begins with an elastic contact. A rate-dependent
law is followed at rate zero, where it must be path-explicit like all other laws. Tests in
tests/verification check the effect of its rate.

Overlaps are scaled by the overlap at yield, and forces by the force at yield. So one set of paths
reaches every regime of every law, for any size and material.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pairs import PAIRS, RADIUS, scales
from scipy.integrate import simpson

REACH = 500  # largest overlap / overlap at yield; the force exceeds 100 yield forces

# Turning points of a path, divided by the overlap at yield, from separation to far beyond yield.
turning_points = st.lists(
    st.one_of(st.floats(0, 2), st.floats(0, REACH), st.floats(-1, 0)), min_size=1, max_size=8
)


@cache
def on_pairs(law_name: str, law_between) -> list[tuple]:
    """Return the law for each pair of bodies, with overlap and force at yield."""
    return [(law_between(law_name, pair), *scales(law_name, pair)) for pair in PAIRS.values()]


def path(turns: list[float], points: int = 60) -> np.ndarray:
    """Return a path through turning points, with steps that are small enough to integrate the
    work.
    """
    legs = [np.linspace(a, b, points) for a, b in zip([0.0, *turns], turns, strict=False)]
    return np.concatenate(legs)


@given(turns=turning_points)
def test_force_is_finite_and_never_pulls(law_name, law_between, turns):
    for law, overlap_y, _ in on_pairs(law_name, law_between):
        answer = law.follow(RADIUS, path(turns) * overlap_y)
        for name, values in answer.items():
            assert np.isfinite(values).all(), name
        assert (answer["force"] >= 0).all()
        assert (answer["contact_radius"] >= 0).all()
        assert (answer["elastic_energy"] >= 0).all()
        apart = path(turns) <= 0
        assert (answer["force"][apart] == 0).all()


@given(turns=turning_points)
def test_plastic_work_never_decreases(law_name, law_between, turns):
    for law, overlap_y, force_y in on_pairs(law_name, law_between):
        answer = law.follow(RADIUS, path(turns) * overlap_y)
        work = answer["plastic_work"]
        # Largest energy of first loading. The plastic work is a difference of two such energies, so
        # their round-off limits its accuracy.
        fresh = (work + answer["elastic_energy"]).max()
        rounding = 1e-13 * max(fresh, force_y * overlap_y)
        assert (np.diff(work) >= -rounding).all()
        assert work.min() >= -rounding


@given(turns=turning_points)
def test_energies_account_for_the_work_done(law_name, law_between, jumps_of_first_loading, turns):
    """At every turning point, the work done equals stored energy plus plastic work, so no path
    returns more energy than it took.

    The work is the integral of the force, by Simpson's rule with 300 intervals per leg. Legs end
    where the force jumps and where reloading reaches the loading curve again. Other kinks of the
    force inside a leg cause errors of up to 1e-4 of the largest energy on the path.
    """
    for pair_name, pair in PAIRS.items():
        overlap_y, force_y = scales(law_name, pair)
        law = law_between(law_name, pair)
        state = law.State()
        done = largest = 0.0
        at = peak = 0.0
        for turn in np.array(turns) * overlap_y:
            edges = [
                peak,
                *(x for jump in jumps_of_first_loading(law_name, pair_name) for x in jump[:2]),
            ]
            ends = np.sort([at, *(x for x in edges if min(at, turn) < x < max(at, turn)), turn])
            ends = ends if turn > at else ends[::-1]
            for leg in np.linspace(ends[:-1], ends[1:], 601).T:
                answer = law.follow(RADIUS, leg, state)
                done += float(simpson(answer["force"], dx=leg[1] - leg[0]))
            stored = answer["elastic_energy"][-1] + answer["plastic_work"][-1]
            largest = max(largest, stored, force_y * overlap_y)
            assert done == pytest.approx(stored, abs=1e-4 * largest)
            assert done >= -1e-4 * largest
            at, peak = turn, max(turn, peak)


@given(turns=turning_points, repeats=st.integers(1, 4))
def test_answer_does_not_depend_on_how_often_it_is_asked(law_name, law_between, turns, repeats):
    """Repeated calls and intermediate points do not change the response. Forces agree to 1e-11 of
    the largest force, because of round-off of the power 3/2 in the unloading curve.
    """
    for law, overlap_y, _ in on_pairs(law_name, law_between):
        fine, often, coarse = law.State(), law.State(), law.State()
        forces, again = [], []
        for overlap in path(turns, 20) * overlap_y:
            once = law.respond(RADIUS, overlap, fine)
            forces.append(once.force)
            for _ in range(repeats):
                repeated = law.respond(RADIUS, overlap, often)
            again.append(repeated.force)
        peaks = np.maximum.accumulate(forces)
        assert (
            np.abs(np.subtract(again, forces)) <= np.maximum(1e-12 * np.abs(forces), 1e-11 * peaks)
        ).all()
        peak = peaks[-1]
        for turn in turns:
            direct = law.respond(RADIUS, turn * overlap_y, coarse)
        assert direct.force == pytest.approx(once.force, rel=1e-12, abs=1e-11 * peak)
        assert direct.plastic_work == pytest.approx(
            once.plastic_work, rel=1e-10, abs=1e-12 * peak * overlap_y
        )


@given(top=st.floats(1e-3, REACH), low=st.floats(0, 1))
def test_reloading_retraces_unloading_then_the_loading_curve(law_name, law_between, top, low):
    for law, overlap_y, _ in on_pairs(law_name, law_between):
        state = law.State()
        peak = law.respond(RADIUS, top * overlap_y, state).force
        down = np.linspace(top, low * top, 30) * overlap_y
        unloading = law.follow(RADIUS, down, state)["force"]
        reloading = law.follow(RADIUS, down[::-1].copy(), state)["force"][::-1]
        assert reloading == pytest.approx(unloading, rel=1e-12, abs=1e-12 * peak)
        beyond = np.linspace(1.01, 2, 10) * top * overlap_y
        fresh = law.follow(RADIUS, beyond, law.State())["force"]
        assert law.follow(RADIUS, beyond, state)["force"] == pytest.approx(fresh, rel=1e-11)


@given(speed_ratio=st.floats(1e-3, 300))
def test_restitution_lies_between_zero_and_one(law_name, law_between, speed_ratio):
    for pair in PAIRS.values():
        law = law_between(law_name, pair)
        overlap_y, force_y = scales(law_name, pair)
        # The square root is the yield speed within 5 %.
        speed = speed_ratio * np.sqrt(force_y * overlap_y / 1e-3)
        found = law.central_impact(RADIUS, 1e-3, speed)
        assert 0 < found.coefficient_of_restitution <= 1 + 1e-9
        assert 0 <= found.overlap_res < found.overlap_max
