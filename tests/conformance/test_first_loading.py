# SPDX-License-Identifier: GPL-2.0-or-later
"""During first loading, the force jumps only where a law declares it, unloading starts at the
loading curve, and every option conserves energy.
"""

from __future__ import annotations

import numpy as np
import pytest
from pairs import PAIRS, RADIUS, scales

from plastigran import laws
from plastigran.physics import central


def test_force_is_continuous_during_first_loading(law_name, jumps_of_first_loading, declared_jumps):
    """Over eight decades of overlap, the force jumps only at the declared overlaps and by the
    declared amounts.
    """
    overlap_y, _ = scales(law_name, PAIRS["aluminium on rigid"])
    found = jumps_of_first_loading(law_name, "aluminium on rigid")
    declared = declared_jumps[law_name]
    seen = [jump for jump in declared if abs(jump[1]) > 2e-4]
    assert len(found) == len(seen), found
    for (place, _, size), (declared_place, declared_size) in zip(found, seen, strict=True):
        assert place / overlap_y == pytest.approx(declared_place, rel=2e-3)
        assert size == pytest.approx(declared_size, abs=2e-4)
    # Another pair has its jumps at other overlaps. Some may lie beyond the search, but none are
    # added.
    assert len(jumps_of_first_loading(law_name, "polymer on steel")) <= len(declared)


@pytest.mark.parametrize("top", [1e-3, 0.9, 1.1, 10, 300])
def test_force_is_continuous_where_unloading_begins_and_ends(law_name, law_between, pair, top):
    overlap_y, _ = scales(law_name, pair)
    law = law_between(law_name, pair)
    state = law.State()
    peak = law.respond(RADIUS, top * overlap_y, state).force
    just_below = law.respond(RADIUS, top * overlap_y * (1 - 1e-12), state).force
    assert just_below == pytest.approx(peak, rel=1e-9)
    way_back = np.linspace(top, 0, 2001) * overlap_y
    force = law.follow(RADIUS, way_back, state)["force"]
    end = int((force == 0).argmax())
    assert end > 0 and (force[end:] == 0).all()
    # Take smaller steps where the force is not zero.
    way_back = np.linspace(way_back[0], way_back[end], 20_001)
    force = law.follow(RADIUS, way_back, state)["force"]
    assert np.abs(np.diff(force)).max() < 1e-3 * peak


def test_energies_go_on_where_tables_end(law_name, law_between, pair):
    """Energies remain consistent with the force where the tables of a law end.

    The tables end at 2^14 times the overlap at yield. Near this overlap, elastic energy plus
    plastic work increases by the work of the force.

    The quadrature needs a range without kinks; the nearest kink is at 2^14.5. The relative
    tolerance is 1e-9, because the increase is a difference of energies some 100 times as large,
    which the tables give to 3e-14.
    """
    overlap_y, _ = scales(law_name, pair)
    law = law_between(law_name, pair)
    edges = np.geomspace(2**13.5, 2**14.4, 101) * overlap_y
    nodes, weights = np.polynomial.legendre.leggauss(8)
    half, middle = np.diff(edges) / 2, (edges[1:] + edges[:-1]) / 2
    points = middle[:, None] + half[:, None] * nodes
    force = law.follow(RADIUS, points.ravel(), law.State())["force"].reshape(points.shape)
    answer = law.follow(RADIUS, edges, law.State())
    grown = np.diff(answer["elastic_energy"] + answer["plastic_work"])
    assert grown == pytest.approx(half * (force @ weights), rel=1e-9)


def test_energy_guard_is_what_keeps_restitution_below_one():
    """Without energy guard, Stronge's law predicts a restitution of 1.06; with it, at most 1."""
    pair = PAIRS["aluminium on rigid"]
    speed = 1.5 * central.yield_speed(pair, RADIUS, 1e-3)
    kept = laws.Stronge(pair).central_impact(RADIUS, 1e-3, speed)
    published = laws.Stronge(pair, energy_guard="off").central_impact(RADIUS, 1e-3, speed)
    assert published.coefficient_of_restitution == pytest.approx(1.0597, abs=2e-3)
    assert kept.coefficient_of_restitution <= 1 + 1e-12


def test_every_choice_of_every_option_keeps_the_energy(law_name, law_between):
    """For every choice of every option, plastic work does not decrease during first loading."""
    pair = PAIRS["aluminium on rigid"]
    overlap_y, force_y = scales(law_name, pair)
    law_class = laws.LAWS[law_name]
    for option in law_class.options():
        for choice in option["choices"]:
            if option["name"] == "energy_guard":
                continue
            law = law_between(law_name, pair, **{option["name"]: choice})
            x = np.geomspace(0.5, 2e4, 3000) * overlap_y
            work = law.follow(RADIUS, x, law.State())["plastic_work"]
            assert (np.diff(work) >= -1e-12 * np.maximum(work[1:], force_y * overlap_y)).all()
    with pytest.raises(ValueError, match="no constant 'colour'"):
        law_class(pair, colour="red")
