# SPDX-License-Identifier: GPL-2.0-or-later
"""Run-time checks: a failing run stops and names the particle, its place and a remedy.

A time step that is too long gives a warning before the run, or at the first contact that needs a
shorter step.
"""

from __future__ import annotations

import re
from math import pi, sqrt
from pathlib import Path

import pytest
from deck_text import error_of, head, material, run_text

from plastigran import laws
from plastigran.physics import central

RADIUS, GAP = 0.0025, 0.01
BODY = laws.Body(youngs_modulus=5e6, poissons_ratio=0.3, yield_strength=1e5)
DENSITY = 1500
MASS = 4 / 3 * pi * RADIUS**3 * DENSITY

DECK = (
    head("-0.1 0.1 -0.1 0.1 -0.1 0.1", skin=0.001)
    + material(5e6, 1e5)
    + """
neigh_modify    delay 0
pair_style      gran model thornton tangential off {settings}
pair_coeff      * *
{grains}
set group all diameter 0.005 density 1500
fix floor all wall/gran model thornton tangential off primitive type 1 zplane 0.0 {settings}
fix integrate   all nve/sphere
timestep        {timestep}
thermo          100
{more}
run             {steps}
"""
)


def deck(grains: list[tuple], **changes) -> str:
    values = {"timestep": 1e-5, "settings": "", "more": "", "steps": 2000} | changes
    lines = "\n".join(f"create_atoms 1 single {x} {y} {z}" for x, y, z in grains)
    return DECK.format(grains=lines, **values)


def run(folder: Path, grains: list[tuple], ranks: int = 1, **changes) -> str:
    return run_text(folder, deck(grains, **changes), ranks)


def stopped(folder: Path, grains: list[tuple], ranks: int = 1, **changes) -> str:
    return error_of(folder, deck(grains, **changes), ranks)


@pytest.mark.parametrize("ranks", [1, 2])
def test_force_that_is_nan(ranks, tmp_path):
    """A run stops at a force that is NaN, here because the center of a grain lies in a wall."""
    grains = [(0.05, 0.01, 0.05), (0.04, 0.02, 0)]
    message = stopped(tmp_path, grains, ranks=ranks, settings="overlap_limit 2")
    assert (
        "particle 2 at (0.04 0.02 0) has a force that is NaN or infinite. Check for particles"
        in message
    )


def test_velocity_that_is_nan(tmp_path):
    """A run stops at a velocity that is not finite; the message has the last finite position.

    A force of 1e300 N acts from step 500.
    """
    more = "variable wild equal 1e300*(step>500)\nfix wild all addforce v_wild 0 0"
    message = stopped(tmp_path, [(0, 0, 0.05)], more=more)
    assert "particle 1 at (0 0 0.05) has a velocity that is NaN or infinite" in message


@pytest.mark.parametrize("ranks", [1, 2])
def test_overlap(ranks, tmp_path):
    """A run stops if two grains overlap by more than one radius, unless `overlap_limit` allows it.

    The overlap is 1.04 radii. On two ranks, it lies across the border between them.
    """
    grains = [(0, -0.48 * RADIUS, 0.05), (0, 0.48 * RADIUS, 0.05)]
    message = stopped(tmp_path, grains, ranks=ranks)
    assert re.search(r"particle [12] at \(0 \S+ 0.05\) and particle [12] at", message)
    assert "by 1.04 times the smaller radius; overlap_limit is 1." in message
    run(tmp_path, grains, ranks=ranks, settings="overlap_limit 1.2", steps=1)


@pytest.mark.parametrize("limit", ["0", "-0.5", "3"])
def test_overlap_limit_out_of_range(limit, tmp_path):
    message = stopped(tmp_path, [(0, 0, 0.05)], settings=f"overlap_limit {limit}")
    assert "overlap_limit is" in message and "must be above 0 and at most 2" in message


def test_overlap_with_a_wall(tmp_path):
    message = stopped(tmp_path, [(0, 0, 0.06 * RADIUS)], settings="overlap_limit 0.9")
    assert (
        "particle 1 at (0 0 0.00015) and a wall overlap by 0.94 times the smaller radius" in message
    )


def test_particle_that_outruns_its_contacts(tmp_path):
    message = stopped(tmp_path, [(0, 0, 0.05)], more=f"velocity all set {1.5 * RADIUS / 1e-5} 0 0")
    assert "particle 1 at (0.00375 0 0.05) moved 1.5 times its radius in one step" in message
    assert "timestep" in message


@pytest.mark.parametrize("ranks", [1, 2])
def test_lost_particle(ranks, tmp_path):
    """A lost particle stops a run with `lost error`; by default, LIGGGHTS deletes the particle."""
    grains = [(0, 0, 0.05), (-0.09, 0.03, 0.05)]
    away = "velocity all set -100 0 0\n"
    changes = {"ranks": ranks, "steps": 100}
    message = stopped(tmp_path, grains, more=away + "thermo_modify lost error", **changes)
    assert re.search(
        r"particle 2 at \(-0\.1\S* 0.03 0.05\) leaves the box at its lower x side", message
    )
    assert "thermo_modify lost ignore" in message
    run(tmp_path, grains, more=away, **changes)


def test_step_is_compared_with_known_times(tmp_path):
    """One log line compares the time step with three times, to two digits.

    These are the Rayleigh time, Hertz' contact time and the recommended time step of the law.
    The Rayleigh time is pi R/c. The wave speed is c = (0.8766 + 0.1631 nu) (G/rho)^(1/2) in
    Bergmann's approximation. For nu = 0.3, it is within 0.2 % of the exact 0.9274 (G/rho)^(1/2).
    """
    speed, step = 0.3, 1e-6
    text = run(tmp_path, [(0, 0, GAP)], more=f"velocity all set 0 0 -{speed}", timestep=step)
    pair = laws.combine(BODY, BODY)
    rayleigh = pi * RADIUS / 0.9274 * sqrt(DENSITY * 2 * 1.3 / 5e6)
    hertz = central.hertz_duration(RADIUS, MASS, pair.youngs_modulus_eff, speed)
    law = laws.Thornton(pair).recommended_timestep(RADIUS, MASS, speed)
    line = re.search(
        r"time step 1e-06: (\S+) of the Rayleigh time, (\S+) of the shortest Hertz contact "
        r"time at the current speeds, (\S+) of the recommended time step\n",
        text,
    )
    shares = [float(share) for share in line.groups()]
    assert shares == pytest.approx([step / rayleigh, step / hertz, step / law], rel=0.06)


def test_contacts_at_the_start_of_a_run_count(tmp_path):
    """Contacts at the start of a run also determine the recommended time step in the log.

    A grain at rest overlaps a wall. The log recommends the time step for an impact that would reach
    this overlap.
    """
    overlap, step = 0.2 * RADIUS, 1e-7
    text = run(tmp_path, [(0, 0, RADIUS - overlap)], timestep=step, steps=1)
    law = laws.Thornton(laws.combine(BODY, BODY))
    loading = law.respond(RADIUS, overlap, law.State())
    speed = sqrt(2 * (loading.elastic_energy + loading.plastic_work) / MASS)
    share = float(
        re.search(r" (\S+) of the recommended time step for the stiffest contact\n", text)[1]
    )
    assert share == pytest.approx(step / law.recommended_timestep(RADIUS, MASS, speed), rel=0.06)


@pytest.mark.parametrize("ranks", [1, 2])
def test_contact_shows_that_the_step_is_too_long(ranks, tmp_path):
    """A warning during the run reports a contact that needs a shorter time step.

    A grain falls from rest, so the check of the time step at the start gives no warning. At the
    impact, the log recommends the time step of the law for its speed. The run checks overlaps each
    time they grow by 10 %, so the recommended time step may be up to 5 % too long.
    """
    speed = 0.5
    law = laws.Thornton(laws.combine(BODY, BODY))
    expected = law.recommended_timestep(RADIUS, MASS, speed)
    gravity = f"fix gravity all gravity {speed**2 / 2 / (GAP - RADIUS)} vector 0 0 -1"
    changes = {"more": gravity, "steps": 4000, "ranks": ranks}
    text = run(tmp_path, [(0, 0, GAP)], timestep=2 * expected, **changes)
    assert "impacts at the current speeds" not in text
    reports = re.findall(
        r"too long for the contact of particle 1 with a wall at \(0 0 0.002\d+\)\. An impact at "
        r"the speed (\S+) would reach the same overlap\. The time step is (\S+) times the "
        r"recommended .* Use `timestep (\S+)`",
        text,
    )
    assert len(reports) == 1
    assert float(reports[0][0]) == pytest.approx(speed, rel=0.1)
    assert float(reports[0][1]) == pytest.approx(2, rel=0.05)
    assert float(reports[0][2]) == pytest.approx(expected, rel=0.05)
    assert "WARNING" not in run(tmp_path, [(0, 0, GAP)], timestep=0.9 * expected, **changes)


@pytest.mark.parametrize("factor", [0.9, 2])
def test_adhesive_contacts_are_checked_when_they_unload(factor, tmp_path):
    """The time step of an adhesive contact is checked when the contact begins to unload.

    A grain falls from rest. While the contact loads, it passes the overlaps of slower impacts.
    These need a shorter time step with adhesion, but they give no warning. At the largest overlap,
    the warning names the time step of this impact. The tolerance is that of the test without
    adhesion.
    """
    speed, energy = 0.5, 0.5
    law = laws.ADHESIVE_LAWS["thornton"](laws.combine(BODY, BODY), surface_energy=energy)
    recommended = law.recommended_timestep(RADIUS, MASS, speed)
    assert law.recommended_timestep(RADIUS, MASS, 0.1 * speed) < 0.5 * recommended
    step, fall = factor * recommended, GAP - RADIUS
    text = run(
        tmp_path,
        [(0, 0, GAP)],
        settings="adhesion jkr",
        more=f"fix gamma all property/global surfaceEnergy peratomtypepair 1 {energy}\n"
        f"fix gravity all gravity {speed**2 / 2 / fall} vector 0 0 -1",
        timestep=step,
        steps=int(2.4 * fall / speed / step),
    )
    reports = re.findall(r"contact of particle 1 .* Use `timestep (\S+)`", text)
    assert len(reports) == (factor > 1)
    assert all(float(report) == pytest.approx(recommended, rel=0.05) for report in reports)
