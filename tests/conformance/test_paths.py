# SPDX-License-Identifier: GPL-2.0-or-later
"""What every law must obey on any loading path; laws are found, not listed.

A law that depends on the rate of overlap is followed at rate zero, where it must be a total law as
all others; what the rate adds is the matter of its own tests in tests/verification.

Overlaps are scaled by the overlap at yield, forces by the force there, so that one set of paths
reaches every regime of every law for any size and material.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from elastic_contact import NOT_HERTZIAN, mapped_sphere
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import simpson
from scipy.special import lambertw

from plastigran import laws
from plastigran.physics import central

RADIUS = 0.01
LENGTH = 0.1  # of cylinders, and their bodies' thickness; the default of law_between
PAIRS = {
    "aluminium on rigid": laws.combine(
        laws.Body(7e10, 0.3, 1e8, 1.61), laws.Body(1e30, 0.3, 1e30, 1.61)
    ),
    "polymer on steel": laws.combine(laws.Body(2e9, 0.4, 5e7), laws.Body(2.1e11, 0.3, 3e8)),
}
REACH = 500  # overlaps at yield: some 100 forces at yield and more

# Turning points of the overlap over its value at yield, from hardly touching to far beyond.
turning_points = st.lists(
    st.one_of(st.floats(0, 2), st.floats(0, REACH), st.floats(-1, 0)), min_size=1, max_size=8
)


@pytest.fixture(params=sorted(PAIRS))
def pair(request) -> laws.MaterialPair:
    return PAIRS[request.param]


def scales(law_name: str, pair: laws.MaterialPair) -> tuple[float, float]:
    """Overlap and force at the yield of an elastic contact, of spheres or of cylinders."""
    if laws.LAWS[law_name].shape == "cylinder":
        force, overlap, _ = central.line_yield(pair, RADIUS, LENGTH, LENGTH)
        return overlap, force
    overlap = RADIUS * laws.yield_radius_ratio(pair) ** 2
    force = 4 / 3 * pair.youngs_modulus_eff * np.sqrt(RADIUS) * overlap**1.5
    return overlap, force


def on_pairs(law_name: str, law_between) -> list[tuple]:
    """The law between each pair of bodies, with overlap and force at yield."""
    return [(law_between(law_name, pair), *scales(law_name, pair)) for pair in PAIRS.values()]


def elastic(law_name: str, pair: laws.MaterialPair, overlap: np.ndarray) -> dict[str, np.ndarray]:
    """The elastic contact's answer: Hertz's spheres, those of `mdr`, or a line contact by scipy's
    Lambert W."""
    if law_name in NOT_HERTZIAN:
        return mapped_sphere(pair, RADIUS, overlap)
    if laws.LAWS[law_name].shape == "sphere":
        return laws.Hertz(pair).follow(RADIUS, overlap, laws.Hertz.State())
    reach = LENGTH**2 * np.exp(-pair.poissons_ratio / (1 - pair.poissons_ratio)) / RADIUS
    load = overlap / -lambertw(-overlap / reach, -1).real  # F/(pi E* L)
    stiffness = np.pi * pair.youngs_modulus_eff * LENGTH
    return {
        "force": stiffness * load,
        "contact_radius": 2 * np.sqrt(load * RADIUS),
        "elastic_energy": stiffness * load**2 * (2 * np.log(reach / load) - 1) / 4,
        "plastic_work": np.zeros_like(load),
        "viscous_force": np.zeros_like(load),
    }


def path(turns: list[float], points: int = 60) -> np.ndarray:
    """A path through turning points, finely enough for its work to be integrated."""
    legs = [np.linspace(a, b, points) for a, b in zip([0.0, *turns], turns, strict=False)]
    return np.concatenate(legs)


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
        # Rounding of the virgin work, of which plastic work is a difference.
        virgin = (work + answer["elastic_energy"]).max()
        rounding = 1e-13 * max(virgin, force_y * overlap_y)
        assert (np.diff(work) >= -rounding).all()
        assert work.min() >= -rounding


@given(turns=turning_points)
def test_energies_account_for_the_work_done(law_name, law_between, virgin_jumps, turns):
    """Work put in = stored + plastic, at every turning point, so no path returns more than it took.

    The work is the integral of the law's own force, by Simpson's rule on 300 intervals a leg, which
    ends where the virgin force jumps and where reloading meets the virgin force again; other kinks
    of the force inside a leg limit it to 1e-4 of the largest energy met.
    """
    for pair_name, pair in PAIRS.items():
        overlap_y, force_y = scales(law_name, pair)
        law = law_between(law_name, pair)
        state = law.State()
        done = largest = 0.0
        at = peak = 0.0
        for turn in np.array(turns) * overlap_y:
            edges = [peak, *(x for jump in virgin_jumps(law_name, pair_name) for x in jump[:2])]
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
    """A total law: neither repeated calls nor stops on the way change it. 1e-11 of the peak force
    is rounding through the unloading curve's 3/2 power."""
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
def test_reloading_retraces_unloading_then_the_virgin_curve(law_name, law_between, top, low):
    for law, overlap_y, _ in on_pairs(law_name, law_between):
        state = law.State()
        peak = law.respond(RADIUS, top * overlap_y, state).force
        down = np.linspace(top, low * top, 30) * overlap_y
        unloading = law.follow(RADIUS, down, state)["force"]
        reloading = law.follow(RADIUS, down[::-1].copy(), state)["force"][::-1]
        assert reloading == pytest.approx(unloading, rel=1e-12, abs=1e-12 * peak)
        beyond = np.linspace(1.01, 2, 10) * top * overlap_y
        virgin = law.follow(RADIUS, beyond, law.State())["force"]
        assert law.follow(RADIUS, beyond, state)["force"] == pytest.approx(virgin, rel=1e-11)


def test_force_is_continuous_along_the_virgin_curve(law_name, virgin_jumps, declared_jumps):
    """No jump over eight decades, apart from those a law declares, at their place and size."""
    overlap_y, _ = scales(law_name, PAIRS["aluminium on rigid"])
    found = virgin_jumps(law_name, "aluminium on rigid")
    declared = declared_jumps[law_name]
    seen = [jump for jump in declared if abs(jump[1]) > 2e-4]
    assert len(found) == len(seen), found
    for (place, _, size), (declared_place, declared_size) in zip(found, seen, strict=True):
        assert place / overlap_y == pytest.approx(declared_place, rel=2e-3)
        assert size == pytest.approx(declared_size, abs=2e-4)
    # Another pair's jumps lie elsewhere, and may lie beyond the reach; there are no more of them.
    assert len(virgin_jumps(law_name, "polymer on steel")) <= len(declared)


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
    way_back = np.linspace(way_back[0], way_back[end], 20_001)  # finer where there is a force
    force = law.follow(RADIUS, way_back, state)["force"]
    assert np.abs(np.diff(force)).max() < 1e-3 * peak


def test_elastic_impact_returns_everything(law_name, law_between, pair):
    overlap_y, _ = scales(law_name, pair)
    law = law_between(law_name, pair)
    overlap = np.array([0.5 * overlap_y])
    expected = elastic(law_name, pair, overlap)
    answer = law.follow(RADIUS, overlap, law.State())
    assert answer["plastic_work"] == 0
    for name in ("force", "contact_radius", "elastic_energy"):
        assert answer[name] == pytest.approx(expected[name], rel=1e-13), name


def test_unyielding_bodies_are_elastic(law_name, law_between):
    """Yield strength to infinity: the elastic contact to rounding, for hard impacts too."""
    strong = laws.combine(laws.Body(7e10, 0.3, 1e20), laws.Body(7e10, 0.3, 1e20))
    law = law_between(law_name, strong)
    overlap = np.geomspace(1e-12, 1e-3, 50)
    expected = elastic(law_name, strong, overlap)
    for name, values in law.follow(RADIUS, overlap, law.State()).items():
        assert values == pytest.approx(expected[name], rel=1e-14), name


@given(speed_ratio=st.floats(1e-3, 300))
def test_restitution_lies_between_zero_and_one(law_name, law_between, speed_ratio):
    for pair in PAIRS.values():
        law = law_between(law_name, pair)
        overlap_y, force_y = scales(law_name, pair)
        speed = speed_ratio * np.sqrt(force_y * overlap_y / 1e-3)  # some yield speed, to 5 %
        found = law.central_impact(RADIUS, 1e-3, speed)
        assert 0 < found.coefficient_of_restitution <= 1 + 1e-9
        assert 0 <= found.overlap_res < found.overlap_max


def test_energy_guard_is_what_keeps_restitution_below_one():
    """Without it Stronge's law, as published, returns up to 6 % more speed than it took."""
    pair = PAIRS["aluminium on rigid"]
    speed = 1.5 * central.yield_speed(pair, RADIUS, 1e-3)
    kept = laws.Stronge(pair).central_impact(RADIUS, 1e-3, speed)
    published = laws.Stronge(pair, energy_guard="off").central_impact(RADIUS, 1e-3, speed)
    assert published.coefficient_of_restitution == pytest.approx(1.0597, abs=2e-3)
    assert kept.coefficient_of_restitution <= 1 + 1e-12


def test_every_choice_of_every_option_keeps_the_energy(law_name, law_between):
    """Plastic work grows along the virgin curve whatever reading is chosen."""
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


def test_pair_is_the_same_in_either_order():
    soft, hard = laws.Body(7e10, 0.33, 1e8), laws.Body(2.1e11, 0.28, 9e8)
    one, other = laws.combine(soft, hard), laws.combine(hard, soft)
    for name in ("youngs_modulus_eff", "shear_modulus_eff", "yield_pressure", "yield_strength"):
        assert getattr(one, name) == getattr(other, name), name
    assert one.yield_pressure == 1e8 * laws.hertz_yield_pressure_factor(0.33)
    assert one.poissons_ratio == 0.33
    assert one.youngs_modulus == 7e10
    # What the weaker body brings beside its strength.
    rated = laws.Body(7e10, 0.33, 1e8, tangent_modulus=1e9, rate_coefficient=0.02, reference_rate=3)
    pair = laws.combine(hard, rated)
    assert pair == laws.combine(rated, hard)
    assert (pair.tangent_modulus, pair.rate_coefficient, pair.reference_rate) == (1e9, 0.02, 3)
    # The same yield pressure made two ways: still one answer.
    tied = laws.Body(7e10, 0.2, 8e7, 2.0), laws.Body(7e10, 0.3, 1e8, 1.6)
    assert laws.combine(*tied) == laws.combine(*tied[::-1])
    for other in (laws.Body(2e11, 0.33, 1e8), rated):  # of the same yield pressure as `soft`
        assert laws.combine(soft, other) == laws.combine(other, soft)


@pytest.mark.parametrize(
    ("poissons_ratio", "factor"),
    [(0.25, 1.554347), (0.30, 1.612797), (0.35, 1.674110), (0.40, 1.738481)],
)
def test_yield_pressure_factor(poissons_ratio, factor):
    """Hertz-von Mises onset, by maximising the shear on the axis to seven digits."""
    assert laws.hertz_yield_pressure_factor(poissons_ratio) == pytest.approx(factor, rel=5e-7)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"yield_strength": 0}, r"yield_strength is 0; it must be positive and finite \[Pa\]"),
        ({"yield_strength": float("nan")}, r"yield_strength is nan"),
        ({"youngs_modulus": -1}, r"youngs_modulus is -1"),
        ({"poissons_ratio": 0.51}, r"poissons_ratio is 0.51; it must be above -1 and at most 0.5"),
        ({"poissons_ratio": -1}, r"poissons_ratio is -1"),
        ({"yield_pressure_factor": -2}, r"yield_pressure_factor is -2; it must be between 0.5 and"),
        ({"tangent_modulus": 7e10}, r"tangent_modulus is 7e\+10; it must be 0 or more and less"),
        ({"tangent_modulus": -1}, r"tangent_modulus is -1; .* youngs_modulus, 7e\+10 \[Pa\]"),
        ({"rate_coefficient": 1.1}, r"rate_coefficient is 1.1; it must be between 0 and 1 \[-\]"),
        ({"reference_rate": 0}, r"reference_rate is 0; it must be positive and finite \[1/s\]"),
    ],
)
def test_materials_out_of_range_are_refused(given, said):
    constants = {"youngs_modulus": 7e10, "poissons_ratio": 0.3, "yield_strength": 1e8} | given
    with pytest.raises(ValueError, match=said):
        laws.Body(**constants)
