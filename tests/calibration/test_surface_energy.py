# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the surface energy from pull-off forces and sticking speeds."""

from __future__ import annotations

import json
from math import pi

import pytest

import plastigran as pg
from plastigran.calibration import calibrate_adhesion
from plastigran.calibration.surface_energy import pull_off_after
from plastigran.cli import main
from plastigran.materials import Material

POWDER = Material("powder", 1.2e9, 0.3, 1350.0, yield_strength=22e6)
RADIUS = 2.45e-6
LAWS = ["jkr", "thornton_ning_1998"]
BODIES = [
    {"b": pg.RIGID, "radius_other": None},
    {"b": POWDER, "radius_other": RADIUS},
    {"b": "steel", "radius_other": 1e-5},
]
CALL = ["calibrate", "--young", "1.2e9", "--poisson", "0.3", "--density", "1350"]


def bodies_in_contact(law, gamma, b, radius_other):
    other = {"radius_other": radius_other, "surface_energy": gamma}
    return pg.Contact(law, POWDER, b, radius=RADIUS, **other)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("bodies", BODIES)
@pytest.mark.parametrize("gamma", [1e-3, 0.2])
def test_the_sticking_speed_of_a_law_gives_its_surface_energy(law, bodies, gamma):
    """Calibration with the sticking speed of a law returns the surface energy of this law.

    The relative tolerance is 1e-9, because both numerical searches end at 1e-12.
    """
    contact = bodies_in_contact(law, gamma, **bodies)
    speed = contact.sticking_speed
    found = calibrate_adhesion(POWDER, radius=RADIUS, sticking_speed=speed, law=law, **bodies)
    assert found.surface_energy == pytest.approx(gamma, rel=1e-9, abs=0)
    assert found.sticking_speed == pytest.approx(speed, rel=1e-9, abs=0)


@pytest.mark.parametrize("load", [0.0, 2e-6, 2e-5])
@pytest.mark.parametrize("gamma", [1e-3, 0.2])
def test_the_pull_off_force_after_a_load_gives_the_surface_energy(load, gamma):
    """Calibration with the pull-off force after a load returns the surface energy of the law.

    The pull-off force is the lowest force of an unloading at 1e5 points, which resolve it to a
    relative error of 4e-7.
    """
    contact = bodies_in_contact("thornton_ning_1998", gamma, **BODIES[0])
    state, law, top = contact.law.State(), contact.law, 1e-12
    while law.respond(contact.radius_eff, top).force < load:
        top *= 1.0005
    load = max(law.respond(contact.radius_eff, top, state).force, 0.0)
    lowest = -law.pull_off_distance(contact.radius_eff)
    points = [top + (lowest - top) * k / 100000 for k in range(100001)]
    force = -law.follow(contact.radius_eff, points, state)["force"].min()
    assert pull_off_after(contact, load) == pytest.approx(force, rel=5e-7, abs=0)
    found = calibrate_adhesion(
        POWDER, radius=RADIUS, pull_off_force=force, load=load, law="thornton_ning_1998"
    )
    assert found.surface_energy == pytest.approx(gamma, rel=6e-7, abs=0)


@pytest.mark.parametrize("bodies", BODIES)
def test_jkr_has_closed_forms(bodies):
    """For the law `jkr`, calibration agrees with the closed forms.

    With the surface energy Gamma, the pull-off force is 3/2 pi Gamma R*, and the sticking speed is
    proportional to Gamma^(5/6).
    """
    radius_eff = 1 / (1 / RADIUS + 1 / (bodies["radius_other"] or 1e300))
    force = 1.5 * pi * 0.1 * radius_eff
    found = calibrate_adhesion(POWDER, radius=RADIUS, pull_off_force=force, **bodies)
    assert found.surface_energy == pytest.approx(0.1, rel=1e-12)
    assert found.pull_off_force == pytest.approx(force, rel=1e-12, abs=0)
    assert found.sensitivity == pytest.approx(1, rel=1e-9)
    by_speed = calibrate_adhesion(
        POWDER, radius=RADIUS, sticking_speed=2 * found.sticking_speed, **bodies
    )
    assert by_speed.surface_energy == pytest.approx(0.1 * 2**1.2, rel=1e-9)
    assert by_speed.sensitivity == pytest.approx(1.2, rel=1e-9)


def test_flattening_increases_the_pull_off_force():
    """A plastically flattened contact needs less surface energy for the same pull-off force.

    Without a load, the contact is elastic, and the surface energy is that of the law `jkr`.
    """
    find = {"radius": RADIUS, "pull_off_force": 2e-6, "law": "thornton_ning_1998"}
    gammas = [calibrate_adhesion(POWDER, load=load, **find).surface_energy for load in (0, 1e-5)]
    elastic = calibrate_adhesion(POWDER, radius=RADIUS, pull_off_force=2e-6).surface_energy
    assert gammas[0] == pytest.approx(elastic, rel=1e-9)
    assert gammas[1] < 0.8 * gammas[0]


def test_command_prints_lines_of_a_deck_and_writes_a_material(capsys, tmp_path):
    file = tmp_path / "grain.in"
    line = [*CALL, "--pull-off", "2.4e-6", "--radius", "2.5e-6", "--output", str(file)]
    assert main(line) == 0
    printed = capsys.readouterr().out
    gamma = 2.4e-6 / (1.5 * pi * 2.5e-6)
    assert f"surface energy      {gamma:.4g} J/m2" in printed
    assert f"surfaceEnergy peratomtypepair 1 {gamma:.6g}\n" in printed
    assert "pair_style gran model jkr tangential history" in printed
    assert pg.material(file).surface_energy == pytest.approx(gamma, rel=1e-11)
    line = [*CALL, "--sticking-speed", "1", "--radius", "2.45e-6", "--plate", "steel"]
    line += ["--law", "thornton_ning_1998", "--yield", "22e6", "--json"]
    assert main(line) == 0
    numbers = json.loads(capsys.readouterr().out)
    found = calibrate_adhesion(
        POWDER, "steel", radius=RADIUS, sticking_speed=1.0, law="thornton_ning_1998"
    )
    assert numbers["surface_energy"] == pytest.approx(found.surface_energy, rel=1e-12)


FORCE, SPEED = ["--pull-off", "1e-6"], ["--sticking-speed", "1"]
SMALL, YIELDING = ["--radius", "1e-6"], ["--law", "thornton_ning_1998"]


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (FORCE, "--pull-off and --sticking-speed need --radius"),
        ([*SMALL, "--sticking-speed", "1e5"], "sticking_speed is 100000 m/s; with jkr"),
        ([*SMALL, "--pull-off", "1"], "pull_off_force is 1 N; with jkr, the surface energy"),
        ([*SMALL, *FORCE, "--law", "hertz"], "law hertz has no surface energy. Use one"),
        ([*SMALL, *FORCE, "--law", "luding_2008"], "law luding_2008 has no surface energy"),
        ([*SMALL, *FORCE, *YIELDING], "law thornton_ning_1998 yields, so it needs --yield"),
        (
            [*SMALL, *FORCE, "--load", "1"],
            "load is 1, but has no effect, because jkr does not yield",
        ),
        ([*SMALL, *SPEED, "--load", "1"], "--load is 1, but has no effect without"),
        (
            [*SMALL, *FORCE, *YIELDING, "--yield", "1e7", "--load", "1"],
            "load is 1 N; the bodies would overlap by more than R*",
        ),
        ([*SMALL, *FORCE, "--ball", "steel"], "--ball is steel, but has no effect without a "),
        (
            ["--yield", "1e7", "--radius-other", "1"],
            "--radius-other is 1, but has no effect without --pull",
        ),
        (["--yield", "1e7", *YIELDING], "it must be a law for yielding spheres, without"),
        ([], "no measurement given; exactly one of --yield, --hardness"),
        (["--yield", "1e7", "--hardness", "20"], "--yield and --hardness given; exactly one of"),
    ],
)
def test_bad_input_is_one_line(given, message, capsys):
    assert main([*CALL, *given]) == 1
    error = capsys.readouterr().err
    assert message in error
    assert error.count("\n") == 1


@pytest.mark.parametrize("value", ["-1", "0", "nan"])
def test_measurements_are_positive(value, capsys):
    with pytest.raises(SystemExit):
        main([*CALL, *SMALL, "--pull-off", value])
    assert "--pull-off: " in capsys.readouterr().err
    with pytest.raises(ValueError, match=r"pull_off_force is .*; it must be positive and finite"):
        calibrate_adhesion(POWDER, radius=RADIUS, pull_off_force=float(value))
    with pytest.raises(ValueError, match="exactly one of pull_off_force and sticking_speed"):
        calibrate_adhesion(POWDER, radius=RADIUS)
