# SPDX-License-Identifier: GPL-2.0-or-later
"""The benchmark impacts of Chung & Ooi (2011) in LIGGGHTS, compared with theory."""

from __future__ import annotations

from functools import cache

import pytest
from attrs import astuple, evolve
from chung_ooi_cases import few, steps

from plastigran.engine.deck import index_variables
from plastigran.engine.dumps import read_dump
from plastigran.engine.process import run_deck
from plastigran.experiments.chung_ooi import BenchmarkImpact, folder
from plastigran.experiments.chung_ooi.comparison import motion
from plastigran.experiments.runs import sweep


@pytest.fixture(scope="session")
def tables(tmp_path_factory):
    """Results of a few impacts of each benchmark, by its number."""

    @cache
    def run(number: int):
        place = tmp_path_factory.mktemp("chung_ooi")
        return sweep(few(number), place, jobs=1, progress=False).table

    return run


def test_all_eight_are_there():
    """There is one deck per benchmark, each deck has sweeps, and all decks have the same
    dashpot.
    """
    decks = {path.stem: index_variables(path) for path in folder().glob("*.in")}
    assert sorted(int(name[0]) for name in decks) == list(range(1, 9))
    assert {case.deck_name for case in BenchmarkImpact.cases()} == set(decks)
    assert {deck["options"] for deck in decks.values()} == {
        "viscous_damping on tangential_damping off"
    }


@pytest.mark.parametrize("number", [1, 2])
def test_elastic_normal_impact_is_hertzian(tables, number):
    """Elastic normal impacts (benchmarks 1 and 2) agree with Hertz' theory.

    With 1000 steps, force, overlap and duration have relative errors of 2e-6, of second order in
    the step. The force is sampled per step, so its maximum is up to (pi/2000)^2/2 = 1e-6 too low.
    Restitution is 1 within 1e-7.
    """
    table = tables(number)
    for name in ("force_max", "overlap_max", "contact_time"):
        assert table[name].to_numpy() == pytest.approx(table[f"{name}_predicted"], rel=2e-6), name
    assert table["coefficient_of_restitution"].to_numpy() == pytest.approx(1, rel=1e-7)


def test_restitution_of_the_dashpot(tables):
    """Restitution follows the closed form of a dashpot that never pulls. The relative tolerance is
    5e-4: the dashpot force begins as the fourth root of the overlap, which 1000 steps resolve with
    this error.
    """
    table = tables(3)
    assert table["coefficient_of_restitution"].to_numpy() == pytest.approx(
        table["coefficient_of_restitution_predicted"], rel=5e-4
    )


def test_a_dashpot_that_pulls_gives_what_is_asked(tmp_path):
    """LIGGGHTS' hertz, whose dashpot may pull until the overlap ends, has the given restitution.
    The relative tolerance is 5e-4, the error of 1000 steps.
    """
    for asked in (0.4, 0.8):
        run_deck(
            "collision/chung_ooi/3_restitution.in",
            {"law": "hertz", "options": "limitForce off", "coefficient_of_restitution": asked},
            tmp_path / str(asked),
        )
        after = motion(read_dump(tmp_path / str(asked) / "trajectory.dump"), -1)
        assert after.normal / 3.9 == pytest.approx(asked, rel=5e-4)


def test_benchmarks_with_restitution_one_half_have_it():
    """The decks set the dashpot so that the restitution is 0.5, and 0.98 in benchmark 4."""
    for case in BenchmarkImpact.cases():
        if case.benchmark in (4, 6, 7, 8):
            expected = 0.98 if case.benchmark == 4 else 0.5
            assert case.impact().restitution() == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("number", [4, 5, 6, 8])
def test_oblique_impact_is_spring_and_slider(tables, number):
    """Oblique impacts agree with the theory of a tangential spring and a slider.

    The surface speed after the impact agrees to 1e-3 of its change during full sliding. With 1000
    steps, this is the first-order error of the time at which the spring begins to slide.
    """
    table = tables(number)
    off = table["surface_speed"] - table["surface_speed_predicted"]
    assert (off.abs() / table["surface_speed_scale"]).max() < 1e-3
    assert not table["slides"].all()
    assert table["slides"].any()


@pytest.mark.parametrize(("number", "tolerance"), [(4, 2e-3), (5, 1e-2), (6, 2e-2), (8, 2e-2)])
def test_sliding_is_rigid_body_theory(tables, number, tolerance):
    """If a contact slides throughout, the motion after the impact is that of rigid-body theory.

    The test compares tangential speed, spin and surface speed. The tolerances cover the effects of
    a finite contact. The lever arm is R - overlap/2, and the spring must be stretched before it
    slides, while a dashpot acts at once.
    """
    table = tables(number).query("slides")
    for name, arm in (("surface_speed", 1), ("speed_along", 1), ("spin_after", table["radius"])):
        off = (table[name] - table[f"{name}_rigid"]).abs() * arm
        assert (off / table["surface_speed_scale"]).max() < tolerance, name


def test_equal_spheres_spinning_against_each_other_do_not_notice(tables):
    """In benchmark 7, the surfaces of both spheres have the same velocity where they touch.

    So spins and paths change only by round-off.
    """
    table = tables(7)
    assert table["spin_after"].to_numpy() == pytest.approx(table["value"], rel=1e-14)
    assert table["spin_after_other"].to_numpy() == pytest.approx(table["value"], rel=1e-14)
    assert table["speed_along"].abs().max() < 1e-15


def test_unequal_spheres_keep_momentum(tmp_path):
    """Momentum along y and angular momentum about z of the pair are conserved, because the lever
    arms of friction add up to the distance of the centers. The tolerance is round-off, divided by
    the change that friction causes.
    """
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


def test_decks_start_as_theory_takes_them(tmp_path):
    """The first frame of each deck has the motion, radius and mass that the theory uses."""
    for number in range(1, 9):
        case = few(number)[0]
        trajectory = steps(case, tmp_path / case.deck_name)
        first, impact = trajectory.iloc[0], case.impact()
        assert astuple(motion(trajectory, 0)) == pytest.approx(astuple(impact.before), rel=1e-14)
        assert (first["radius"], first["mass"]) == pytest.approx((impact.radius, impact.mass))


def test_a_knob_no_deck_has_is_named():
    with pytest.raises(ValueError, match=r"6_spin_on_plane\.in has no variable angle"):
        evolve(few(6)[0], knob="angle").impact()
