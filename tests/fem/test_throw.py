# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the impact of a sphere on a plane."""

from __future__ import annotations

import pytest
from coarse_sphere import COARSE, ELASTIC, METAL, RADIUS

from plastigran.fem.sphere.throw import throw
from plastigran.fem.theory.hertz import HertzSphere

HERTZ = HertzSphere(ELASTIC, RADIUS)
SPEED = 0.02


def energy(history):
    parts = ["kinetic_energy", "elastic_energy", "plastic_work", "penalty_energy"]
    return history[parts].sum(axis=1)


def test_elastic_sphere_rebounds_with_its_speed(elastic_throw):
    # The contact lasts 30 periods of the fundamental mode, so only 1e-6 of the energy stays in the
    # sphere as vibration.
    assert elastic_throw.coefficient_of_restitution == pytest.approx(1, abs=1e-3)


def test_elastic_impact_lasts_as_long_as_that_of_hertz(elastic_throw):
    assert elastic_throw.contact_time == pytest.approx(HERTZ.duration(SPEED), rel=0.01)


def test_elastic_force_is_that_of_hertz(elastic_throw):
    # A sphere of finite size is stiffer; finer meshes show that the force is 0.3 % larger.
    largest = HERTZ.force(HERTZ.approach_max(SPEED))
    assert elastic_throw.force_max == pytest.approx(largest, rel=0.01)


@pytest.mark.parametrize("kind", ["elastic_throw", "plastic_throw"])
def test_energy_is_kept(kind, request):
    total = energy(request.getfixturevalue(kind).history)
    # The trapezoidal rule conserves energy of linear systems. With 80 steps, contact and plastic
    # flow cause an error of up to 2e-3.
    assert total.max() / total.min() == pytest.approx(1, abs=2e-3)


def test_impulse_of_the_force_turns_the_momentum(plastic_throw):
    history = plastic_throw.history
    force, time = history["force"].to_numpy(), history["time"].to_numpy()
    impulse = sum((force[1:] + force[:-1]) / 2 * (time[1:] - time[:-1]))
    mass = 2 * history["kinetic_energy"].iloc[0] / SPEED**2  # mass of the mesh
    change = (history["velocity"].iloc[-1] + SPEED) * mass
    assert impulse == pytest.approx(change, rel=1e-4)  # forces balance to 1e-5


def test_elastic_plastic_sphere_rebounds_as_the_slow_pressing_says(plastic_throw):
    # The finite elements of Zhang and Vu-Quoc (2002) give 647.8 N. Quasi-static compression to this
    # force gives a restitution of 0.816.
    assert plastic_throw.force_max == pytest.approx(647.8, rel=0.02)
    assert plastic_throw.coefficient_of_restitution == pytest.approx(0.816, rel=0.02)
    assert 0 < plastic_throw.overlap_res < plastic_throw.overlap_max


@pytest.mark.parametrize(
    ("speed", "said"),
    [
        (0.0, "must be positive"),
        (-1.0, "must be positive"),
        (1e4, "speed of sound"),
        (300.0, "1.5 times the radius; the upper limit is 0.4"),
    ],
)
def test_speeds_that_cannot_be_thrown_are_refused(speed, said):
    with pytest.raises(ValueError, match=said):
        throw(METAL, RADIUS, speed, COARSE)
