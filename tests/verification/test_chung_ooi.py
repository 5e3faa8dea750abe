# SPDX-License-Identifier: GPL-2.0-or-later
"""The benchmark impacts of Chung & Ooi (2011) in the engine: against theory, and our models with
unyielding bodies against the engine's own hertz."""

from __future__ import annotations

from functools import cache

import numpy as np
import pandas as pd
import pytest
from attrs import astuple, evolve
from elastic_contact import NOT_HERTZIAN

from plastigran import laws
from plastigran.engine.deck import index_variables
from plastigran.engine.dumps import read_dump
from plastigran.engine.process import run_deck
from plastigran.experiments.chung_ooi import BenchmarkImpact, folder
from plastigran.experiments.chung_ooi.comparison import motion
from plastigran.experiments.runs import sweep
from plastigran.materials import RIGID, laws_for
from plastigran.physics import central
from plastigran.physics.oblique import Motion, ObliqueImpact

LAW = "vu_quoc_zhang"
#: Laws that yield, and are the engine's hertz for bodies that do not.
HERTZIAN = [
    name for name in laws_for("sphere") if laws.LAWS[name].yields and name not in NOT_HERTZIAN
]


def sweeps(number: int) -> list[list[BenchmarkImpact]]:
    """The impacts of a benchmark, one list a sweep."""
    found: dict[tuple, list[BenchmarkImpact]] = {}
    for case in BenchmarkImpact.cases():
        if case.benchmark == number:
            found.setdefault((case.material, case.modulus_ratio), []).append(case)
    return list(found.values())


def middles(number: int) -> list[BenchmarkImpact]:
    """One impact of each sweep of a benchmark: the middle of it, where springs stick and slide."""
    return [sweep[len(sweep) // 2] for sweep in sweeps(number)]


def few(number: int) -> list[BenchmarkImpact]:
    """The second, middle and last impact of each sweep of a benchmark, as far as there are."""
    return [
        sweep[k]
        for sweep in sweeps(number)
        for k in sorted({min(1, len(sweep) - 1), len(sweep) // 2, len(sweep) - 1})
    ]


def steps(case: BenchmarkImpact, folder) -> pd.DataFrame:
    """Every step of an impact in the engine."""
    case.execute(folder)
    return read_dump(folder / "trajectory.dump")


@pytest.fixture(scope="session")
def tables(tmp_path_factory):
    """Results of a few impacts of a benchmark, by its number: run once."""

    @cache
    def run(number: int):
        place = tmp_path_factory.mktemp("chung_ooi")
        return sweep(few(number), place, jobs=1, progress=False).table

    return run


def test_all_eight_are_there():
    """One deck a benchmark, every deck swept, and all of them with the same dashpot."""
    decks = {path.stem: index_variables(path) for path in folder().glob("*.in")}
    assert sorted(int(name[0]) for name in decks) == list(range(1, 9))
    assert {case.deck_name for case in BenchmarkImpact.cases()} == set(decks)
    assert {deck["options"] for deck in decks.values()} == {
        "viscous_damping on tangential_damping off"
    }


@pytest.mark.parametrize("number", [1, 2])
def test_elastic_normal_impact_is_hertzian(tables, number):
    """Peak force, overlap and duration of 1000 steps: 2e-6, of second order in the step; the peak
    force is a step's, so up to (pi/2000)^2/2 = 1e-6 below the curve's. Energy is kept to 1e-7."""
    table = tables(number)
    for name in ("force_max", "overlap_max", "contact_time"):
        assert table[name].to_numpy() == pytest.approx(table[f"{name}_predicted"], rel=2e-6), name
    assert table["coefficient_of_restitution"].to_numpy() == pytest.approx(1, rel=1e-7)


def test_restitution_of_the_dashpot(tables):
    """The closed form of a dashpot that never pulls. 5e-4: the dashpot's force begins with the
    fourth root of the overlap, which 1000 steps see with this error."""
    table = tables(3)
    assert table["coefficient_of_restitution"].to_numpy() == pytest.approx(
        table["coefficient_of_restitution_predicted"], rel=5e-4
    )


def test_a_dashpot_that_pulls_gives_what_is_asked(tmp_path):
    """The engine's hertz, left to pull until the overlap is gone: e itself. 5e-4: as above."""
    for asked in (0.4, 0.8):
        run_deck(
            "collision/chung_ooi/3_restitution.in",
            {"law": "hertz", "options": "limitForce off", "coefficient_of_restitution": asked},
            tmp_path / str(asked),
        )
        after = motion(read_dump(tmp_path / str(asked) / "trajectory.dump"), -1)
        assert after.normal / 3.9 == pytest.approx(asked, rel=5e-4)


def test_benchmarks_with_restitution_one_half_have_it():
    """The decks ask the dashpot for what makes the outcome 0.5, and 0.98 in benchmark 4."""
    for case in BenchmarkImpact.cases():
        if case.benchmark in (4, 6, 7, 8):
            expected = 0.98 if case.benchmark == 4 else 0.5
            assert case.impact().restitution() == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("number", [4, 5, 6, 8])
def test_oblique_impact_is_spring_and_slider(tables, number):
    """Speed of the surfaces after the impact, over what sliding throughout changes it by.

    1e-3 for 1000 steps: where within a step the spring begins to slide is of first order.
    """
    table = tables(number)
    off = table["surface_speed"] - table["surface_speed_predicted"]
    assert (off.abs() / table["surface_speed_scale"]).max() < 1e-3
    assert not table["slides"].all()
    assert table["slides"].any()


@pytest.mark.parametrize(("number", "tolerance"), [(4, 2e-3), (5, 1e-2), (6, 2e-2), (8, 2e-2)])
def test_sliding_is_rigid_body_theory(tables, number, tolerance):
    """Of the speed along the surface, the spin and the surface speed, what friction changes.

    The tolerances are what a finite contact differs by: its arm is R - overlap/2, and while a
    dashpot starts the force at once, the spring must be stretched first.
    """
    table = tables(number).query("slides")
    for name, arm in (("surface_speed", 1), ("speed_along", 1), ("spin_after", table["radius"])):
        off = (table[name] - table[f"{name}_rigid"]).abs() * arm
        assert (off / table["surface_speed_scale"]).max() < tolerance, name


def test_equal_spheres_spinning_against_each_other_do_not_notice(tables):
    """Their surfaces move alike: spins and lines stay, to rounding."""
    table = tables(7)
    assert table["spin_after"].to_numpy() == pytest.approx(table["value"], rel=1e-14)
    assert table["spin_after_other"].to_numpy() == pytest.approx(table["value"], rel=1e-14)
    assert table["speed_along"].abs().max() < 1e-15


def test_unequal_spheres_keep_momentum(tmp_path):
    """Momentum along y, and angular momentum about z, of the pair: rounding, over what friction
    moves. The arms of the friction add up to the distance of the centres, so both are kept."""
    case = evolve(few(8)[0], value=5.0)
    trajectory = steps(case, tmp_path)
    step = trajectory["step"]
    first, last = (trajectory[step == step.iloc[k]] for k in (0, -1))

    def momentum(bodies):
        return (bodies["mass"] * bodies["vy"]).sum()

    def angular(bodies):
        orbital = bodies["mass"] * (bodies["x"] * bodies["vy"] - bodies["y"] * bodies["vx"])
        return (orbital + 0.4 * bodies["mass"] * bodies["radius"] ** 2 * bodies["omegaz"]).sum()

    moved = abs(last["mass"].iloc[0] * last["vy"].iloc[0])
    assert moved > 0
    assert abs(momentum(last) - momentum(first)) < 1e-12 * moved
    assert abs(angular(last) - angular(first)) < 1e-11 * moved * first["radius"].iloc[0]


def assert_same_steps(case: BenchmarkImpact, law: str, place, steps_per_contact: int = 250) -> None:
    """Every step of every column as the engine's hertz: 1e-13 of the column's largest value, for
    rounding in another order (1e-15 was found)."""
    ours, stock = (
        steps(evolve(case, law=name, steps_per_contact=steps_per_contact), place / name)
        for name in (law, "hertz")
    )
    assert len(ours) == len(stock)
    for column in stock.columns:
        scale = np.abs(stock[column].to_numpy()).max()
        off = np.abs(ours[column].to_numpy() - stock[column].to_numpy()).max()
        assert off <= 1e-13 * scale, (case, column)


@pytest.mark.parametrize("number", range(1, 9))
def test_unyielding_model_is_the_engines_hertz(number, tmp_path):
    """On planes and between spheres, damped and undamped, sticking and sliding."""
    for k, case in enumerate(middles(number)):
        assert_same_steps(case, LAW, tmp_path / str(k))


@pytest.mark.parametrize("law", HERTZIAN)
@pytest.mark.parametrize("number", [4, 8])
def test_every_unyielding_law_is_the_engines_hertz(law, number, tmp_path):
    """On a plane and between spheres, where the tangential spring sticks and slides in turn."""
    knob = 15.0 if number == 4 else 2.0
    assert_same_steps(evolve(few(number)[0], value=knob), law, tmp_path)


def test_tangential_dashpot_is_the_engines(tmp_path):
    """Left on, as by default: as in the engine's hertz, which does not hold it to mu F, so that a
    sliding sphere loses over a tenth more than mu times the normal impulse."""
    case = evolve(few(6)[0], value=5.0)
    found = {}
    for law, options in ((LAW, "viscous_damping on"), ("hertz", "limitForce on")):
        variables = {**case.variables(), "law": law, "options": options}
        run_deck("collision/chung_ooi/6_spin_on_plane.in", variables, tmp_path / law)
        found[law] = motion(read_dump(tmp_path / law / "trajectory.dump"), -1)
    assert astuple(found[LAW]) == pytest.approx(astuple(found["hertz"]), rel=1e-13)
    assert found[LAW].along / case.impact().rigid_sliding().along > 1.1


def test_decks_start_as_theory_takes_them(tmp_path):
    """The motion in the first frame is the case's, and so are radius and mass."""
    for number in range(1, 9):
        case = few(number)[0]
        trajectory = steps(case, tmp_path / case.deck_name)
        first, impact = trajectory.iloc[0], case.impact()
        assert astuple(motion(trajectory, 0)) == pytest.approx(astuple(impact.before), rel=1e-14)
        assert (first["radius"], first["mass"]) == pytest.approx((impact.radius, impact.mass))


def test_spring_and_slider_without_friction_or_slip():
    """No friction leaves the tangential motion alone; rolling surfaces stay as they are."""
    pair = laws.combine(laws.Body(7e10, 0.3, 1e30, 1.61), RIGID)
    before = Motion(normal=1.0, along=0.3, spin=5.0)
    smooth = ObliqueImpact(pair, 0.01, 1.0, 0.0, 0.7, before)
    after = smooth.spring_slider()
    assert (after.along, after.spin) == pytest.approx((0.3, 5.0), rel=1e-12)
    assert after.normal == pytest.approx(central.restitution_without_pull(0.7), rel=1e-8)


@pytest.mark.parametrize(("poissons_ratio", "gained"), [(0.1, 0.030), (0.23, 0.004), (0.3, -0.030)])
def test_sticking_spring_gains_or_loses_energy(poissons_ratio, gained):
    """A spring that hardly slides: energy along the surface gained by the impact, over what it had.

    The force is k_t(a) times the path, not the sum of its increments: its work depends on when the
    path was made, for the stiffness grows as the contact does and shrinks with it. Whether the
    spring pays back more than was put in depends on how many of its swings fit in the contact, thus
    on k_t over the normal stiffness, 2 (1 - nu)/(2 - nu): it gains for small nu, loses for 0.3.

    5e-4 for the digits given, which are the equations' own.
    """
    pair = laws.combine(laws.Body(7e10, poissons_ratio, 1e30, 1.61), RIGID)
    impact = ObliqueImpact(pair, 0.01, 1.0, 50.0, 1.0, Motion(normal=1.0, along=0.3, spin=0.0))
    after = impact.spring_slider()
    energy = 0.5 * after.along**2 + 0.5 * 0.4 * (0.01 * after.spin) ** 2
    assert energy / (0.5 * 0.3**2) - 1 == pytest.approx(gained, abs=5e-4)
    # What friction gives to spin it takes from the motion along, at the arm R - overlap/2: up to
    # 0.55 % short of R while 2.5 * 0.17 m/s go to and fro.
    assert after.spin * 0.01 == pytest.approx(2.5 * (after.along - 0.3), abs=2.5e-3)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"coefficient_of_restitution": 0.0}, "coefficient_of_restitution is 0"),
        ({"coefficient_of_friction": -1.0}, "coefficient_of_friction is -1"),
        ({"mass": 0.0}, "mass is 0"),
        ({"before": Motion(-1.0, 0.0, 0.0)}, "closing speed is -1"),
    ],
)
def test_impossible_impacts_are_named(change, said):
    impact = few(6)[0].impact()
    with pytest.raises(ValueError, match=said):
        evolve(impact, **change)


def test_a_knob_no_deck_has_is_named():
    with pytest.raises(ValueError, match=r"6_spin_on_plane\.in has no variable angle"):
        evolve(few(6)[0], knob="angle").impact()
