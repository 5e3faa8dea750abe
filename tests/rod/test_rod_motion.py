# SPDX-License-Identifier: GPL-2.0-or-later
"""The equations of motion of the oblique rod, compared with independent results and closed
forms."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from scipy.integrate import cumulative_trapezoid

from plastigran import laws
from plastigran.experiments.rod import RodImpact
from plastigran.experiments.rod.paper import MeasuredRun, paper_rods
from plastigran.physics import rod_steps
from plastigran.physics.rod import Rod
from plastigran.physics.rod_motion import RodMotion, simulate

STEEP, FLAT = paper_rods()
PAIR = RodImpact("hertz", 1.0).pair
CASES = list(pd.read_csv(Path(__file__).parent / "rod_gcm15.csv", comment="#").itertuples())


def law_of(name: str, **options: str):
    """Return a law for the contact between the rod and the flat of the paper."""
    return RodImpact(name, 1.0).contact_law(**options)


@pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case.law}-{case.speed:g}")
def test_independent_results(case):
    """Impacts of the rod agree with independent results, which are in rod_gcm15.csv.

    The relative tolerance is 1e-5, because this table has six digits. The energy guard does not
    change the results.
    """
    found = simulate(STEEP, law_of(case.law), case.speed)
    for name in case._fields[3:]:
        assert getattr(found, name) == pytest.approx(getattr(case, name), rel=1e-5), name


def test_effective_mass_of_the_tip():
    """The effective mass of the tip follows from 1/m_eff = 1/m + x_c (x_c - mu y_c)/I.

    (x_c, y_c) is the vector between tip and center of mass, and I the moment of inertia. The
    expected values are calculated by hand to six digits.
    """
    assert STEEP.mass_eff == pytest.approx(0.201260, rel=3e-6)
    assert FLAT.mass_eff == pytest.approx(0.130322, rel=3e-6)


@pytest.mark.parametrize("rod", paper_rods(), ids=lambda rod: f"{rod.angle:g}")
def test_frozen_geometry(rod, rod_law):
    """The rod agrees with a central impact of the effective mass of its tip.

    The central impact neglects gravity and rotation during contact. To first order, its error is at
    most the angle by which the rod turns plus the relative change of its speed by gravity during
    the contact. This is 0.6 % for the softest laws.
    """
    for speed in (0.5, 4.0):
        law = law_of(rod_law)
        frozen = law.central_impact(rod.tip_radius, rod.mass_eff, speed)
        spin = rod.angular_velocity(rod.mass_eff * speed * (1 + frozen.coefficient_of_restitution))
        found = simulate(rod, law, speed)
        added = (abs(spin) + rod.gravitational_acceleration / speed) * found.contact_time
        assert added < 0.01
        assert found.coefficient_of_restitution == pytest.approx(
            frozen.coefficient_of_restitution, rel=added
        )
        assert found.angular_velocity == pytest.approx(spin, rel=added)


@pytest.mark.parametrize("tangential", [None, *laws.TANGENTIAL_LAWS])
def test_energy_balance(tangential, rod_law):
    """Without gravity, the lost kinetic energy equals plastic work plus friction work. The relative
    tolerance is 1e-5, because friction work is the quadrature of 460 or more rows.

    A tangential law stores and returns energy in the impact at 75 degrees. It never returns more
    energy than it has received.
    """
    rod = Rod(gravitational_acceleration=0)
    law = law_of(rod_law)
    if tangential:
        rod = Rod(angle=75, coefficient_of_friction=0.3, gravitational_acceleration=0)
        friction = laws.TANGENTIAL_LAWS[tangential](rod.coefficient_of_friction)
        found = rod_steps.simulate_in_steps(rod, law, 2.0, friction)
    else:
        found = simulate(rod, law, 2.0)
    h = found.history
    state = law.State()
    law.respond(rod.tip_radius, found.overlap_max, state)
    plastic = law.respond(rod.tip_radius, found.overlap_res, state).plastic_work
    work = cumulative_trapezoid(-h["friction_force"] * h["slip_velocity"], h["time"])
    rubbed = work[-1]
    last = h.iloc[-1]
    left = 0.5 * rod.mass * (last["velocity_x"] ** 2 + last["velocity_y"] ** 2)
    left += 0.5 * rod.inertia * last["angular_velocity"] ** 2
    given = 0.5 * rod.mass * 2.0**2
    assert rubbed > 0 and (work >= 0).all()
    assert not tangential or (np.diff(work) < 0).any()
    assert left + plastic + rubbed == pytest.approx(given, rel=1e-5)


def test_measured_run():
    """The velocities that the paper measured for one impact give a rotation of -19.52 rad/s.

    The paper measured -19.67 rad/s. Both values give a restitution of 0.50 to 0.51, while the paper
    quotes 0.43 for 45°.
    """
    run = MeasuredRun()
    assert STEEP.angular_velocity(run.impulse(STEEP)) == pytest.approx(-19.522, abs=1e-3)
    assert run.coefficient_of_restitution(STEEP) == pytest.approx(0.502, abs=1e-3)
    full = STEEP.mass_eff * -run.velocity_before
    by_spin = run.angular_velocity / STEEP.angular_velocity(full) - 1
    assert by_spin == pytest.approx(0.513, abs=1e-3)


def test_a_law_above_the_experiment_at_17_degrees():
    """At 17.2 degrees, Kogut and Etsion's law gives a higher restitution than the experiment.

    The law gives 0.579 at 0.5 m/s, where 0.55 was measured. The paper claims that all laws give
    less than the measured values.
    """
    found = simulate(FLAT, law_of("kogut_etsion"), 0.5)
    assert found.coefficient_of_restitution == pytest.approx(0.579, abs=1e-3)


@pytest.mark.parametrize("spring", [False, True])
def test_upright_rod_is_a_central_impact(spring, rod_law):
    """An upright rod has a central impact with its whole mass, without slip and rotation."""
    rod = Rod(angle=90, gravitational_acceleration=0)
    law = law_of(rod_law)
    found = simulate(rod, law, 1.0, PAIR.shear_modulus_eff if spring else None)
    central = law.central_impact(rod.tip_radius, rod.mass, 1.0)
    assert found.coefficient_of_restitution == pytest.approx(
        central.coefficient_of_restitution, rel=1e-6
    )
    assert found.overlap_max == pytest.approx(central.overlap_max, rel=1e-6)
    assert abs(found.angular_velocity) < 1e-9


def test_friction_holds_a_steep_rod():
    """At 80°, the tip sticks, because sticking needs a friction force below 0.5 F_n.

    This force is x_c y_c/(I/m + y_c^2) F_n = 0.127 F_n, with the normal force F_n, the vector
    (x_c, y_c) between tip and center of mass, and the moment of inertia I.
    """
    rod = Rod(angle=80, coefficient_of_friction=0.5)
    h = simulate(rod, law_of("thornton"), 1.0).history.iloc[1:-1]
    x_c, y_c = rod.arm
    ratio = x_c * y_c / (rod.inertia / rod.mass + y_c**2)
    assert (h["friction_force"] / h["force"]).to_numpy() == pytest.approx(ratio, rel=2e-3)
    assert h["slip_velocity"].abs().max() < 1e-6


def test_the_papers_rods_slide_throughout():
    for rod in paper_rods():
        h = simulate(rod, law_of("ghaednia"), 1.0).history.iloc[1:-1]
        assert (h["friction_force"] / h["force"]).to_numpy() == pytest.approx(
            rod.coefficient_of_friction
        )
        assert (h["slip_velocity"] < 0).all()


def test_a_rod_that_does_not_rebound_is_an_error(monkeypatch):
    """A rod that does not rebound gives an error.

    With 400 times its weight, the rod stays down; its tip oscillates on the unloading curve.
    """
    rod = Rod(angle=90, gravitational_acceleration=4e3)
    law = law_of("thornton")
    with pytest.raises(ValueError, match="keeps its tip in contact"):
        simulate(rod, law, 0.05)
    monkeypatch.setattr(rod_steps, "MOST_STEPS", 2000)
    with pytest.raises(ValueError, match="keeps its tip in contact"):
        rod_steps.simulate_in_steps(rod, law, 0.05, laws.Incremental(0.1))


def test_reloading_follows_the_unloading_curve():
    """Below the largest overlap of the tip, unloading and reloading have the same force.

    Trial steps of the integrator beyond the largest overlap do not change the contact history.
    """
    rod = Rod(angle=90)
    body = RodMotion(rod, law_of("thornton"), 0.05, None)
    down = [0, -2e-5, 0, 0, -0.05, 0, 0]
    body.turn_back(down)
    deepest = body.contact(down).force
    there = [body.contact([0, -depth, 0, 0, 0.01, 0, 0]).force for depth in (1.9e-5, 1.8e-5)]
    back = [body.contact([0, -depth, 0, 0, -0.01, 0, 0]).force for depth in (1.8e-5, 1.9e-5)]
    assert there == back[::-1]
    assert 0 < there[1] < there[0] < deepest == body.contact(down).force
    assert body.contact([0, -3e-5, 0, 0, -0.01, 0, 0]).force > deepest
    assert body.contact(down).force == deepest


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"angle": 0}, "angle is 0"),
        ({"angle": 91}, "angle is 91"),
        ({"mass": -1}, "mass is -1"),
        ({"coefficient_of_friction": -0.1}, "coefficient_of_friction is -0.1"),
        ({"tip_radius": 0.2}, "length is 0.3048 m; it must exceed the diameter of the tip"),
        ({"angle": 17.2, "coefficient_of_friction": 5}, "would jam the rod"),
    ],
)
def test_impossible_rods_are_refused(change, said):
    with pytest.raises(ValueError, match=said):
        Rod(**change)


def test_bad_laws_and_speeds_are_refused():
    with pytest.raises(ValueError, match="no law 'cheese'"):
        law_of("cheese")
    with pytest.raises(ValueError, match="lim_stronge is a law for cylinders"):
        law_of("lim_stronge")
    with pytest.raises(ValueError, match="energy_guard is 'maybe'"):
        law_of("ghaednia", energy_guard="maybe")
    with pytest.raises(ValueError, match="speed is 0"):
        simulate(STEEP, law_of("thornton"), 0)


def test_the_table_has_every_law_of_the_paper():
    assert {case.law for case in CASES} == {
        "brake_2012", "brake_2015", "ghaednia", "jackson_green", "kogut_etsion",
        "kogut_komvopoulos", "stronge", "thornton", "ye_komvopoulos",
    }  # fmt: skip


def test_a_law_that_depends_on_the_rate_is_refused():
    law = laws.ViscoelasticHertz(PAIR, dissipative_constant=1e-5)
    with pytest.raises(ValueError, match="viscoelastic_hertz depends on the overlap rate"):
        simulate(STEEP, law, 1.0)
