# SPDX-License-Identifier: GPL-2.0-or-later
"""The commands `fem` and `calibrate`."""

from __future__ import annotations

import argparse
import json
import re
from functools import partial

import pytest

from plastigran.cli import main
from plastigran.cli.metal import add_metal, add_plane, plane
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.material.hardening import LinearHardening
from plastigran.fem.settings import Settings

METAL = ["--young", "70e9", "--poisson", "0.3", "--yield", "1e8"]
DENSE = [*METAL, "--density", "2700"]
SOFT_PLANE = ["--plane-young", "1e9"]
GLASS = ["--young", "79.5e9", "--poisson", "0.23", "--density", "2500"]
ICE = ["--young", "9.3e9", "--poisson", "0.25", "--density", "900", "--radius", "0.01"]
CYLINDER = ["--radius", "1e-5", "--length", "1e-4", "--mass", "1.59e-6", "--thickness", "1e-4"]
ELASTIC = [*GLASS, "--elastic", "--speed", "1"]
FEW = {"divisions": 3, "fineness": 0.5, "steps_of_contact": 40}


@pytest.fixture(autouse=True)
def cache_of_its_own(tmp_path, monkeypatch):
    monkeypatch.setenv("PLASTIGRAN_CACHE", str(tmp_path))


@pytest.fixture
def coarse(monkeypatch):
    """Use coarse finite elements; a computation takes a second or two."""
    monkeypatch.setattr("plastigran.cli.metal.Settings", partial(Settings, **FEW))


def test_press_below_yield_says_so_and_gives_everything_back(capsys):
    assert main(["fem", "press", *METAL, "--force-ratio", "0.5", "--json"]) == 0
    printed = capsys.readouterr()
    assert "is below the yield force" in printed.err
    (unloading,) = json.loads(printed.out)["unloadings"]
    # The tolerance covers the error of the integrated work: below yield, a load step is 40 % of the
    # largest force.
    assert unloading["coefficient_of_restitution"] == pytest.approx(1, abs=5e-3)


def test_half_space_has_the_numbers_given_and_else_those_of_the_sphere():
    parser = argparse.ArgumentParser()
    add_metal(parser)
    add_plane(parser)
    own = parser.parse_args([*METAL, "--plane-young", "2e9", "--plane-yield", "5e7"])
    assert plane(own) == ElasticPlastic(
        youngs_modulus=2e9, poissons_ratio=0.3, density=2700.0, hardening=LinearHardening(5e7)
    )
    elastic = parser.parse_args([*METAL, *SOFT_PLANE, "--plane-poisson", "0.2"])
    assert plane(elastic) == ElasticPlastic(youngs_modulus=1e9, poissons_ratio=0.2, density=2700.0)
    assert plane(parser.parse_args(METAL)) is None


def test_vibrating_sphere_names_its_modes(capsys):
    line = ["fem", "vibrate", "--young", "6e6", "--poisson", "0.25", "--density", "900"]
    assert main([*line, "--radius", "0.01", "--speed", "5", "--transits", "12", "--json"]) == 0
    printed = capsys.readouterr()
    assert "small strain is accurate up to 0.1" in printed.err
    numbers = json.loads(printed.out)
    modes = numbers["modes"]
    assert (modes["kind"][0], modes["degree"][0]) == ("spheroidal", 2)
    assert modes["measured"] == pytest.approx(modes["frequency"], rel=2e-3)
    # The contact radius exceeds a third of the sphere's radius. The contact lasts only two periods
    # of the fundamental mode, so the sphere keeps vibrating.
    assert 0.98 < numbers["coefficient_of_restitution"] < 0.995


@pytest.mark.parametrize(
    ("line", "said"),
    [
        (
            ["fem", "press", *METAL, "--force-ratio", "3", "2"],
            "2 follows 3, but ratios must increase",
        ),
        (["fem", "press", *METAL, "--hardening", "-3", "--force-ratio", "3"], "modulus is -3"),
        (["fem", "throw", *METAL, "--speed", "900"], "speed of sound"),
        (["fem", "throw", *METAL, "--speed", "100"], "radius; the upper limit is 0.4"),
        (["fem", "press", *METAL[:4], "--elastic", "--force-ratio", "3"], "neither body yields"),
        (
            ["fem", "throw", *ELASTIC, "--hardening", "1e8"],
            "--hardening is 1e+08, but --yield is missing",
        ),
        (
            ["fem", "throw", *METAL, "--speed", "1", "--plane-yield", "1e8"],
            "but --plane-young is missing",
        ),
        (
            ["fem", "throw", *METAL, "--speed", "1", "--plane-young", "1e9", "--finite-strain"],
            "on a half space it must be small",
        ),
        (
            ["fem", "throw", *METAL, "--speed", "1", *SOFT_PLANE, "--plane-hardening", "1e8"],
            "--plane-yield is missing",
        ),
        (["fem", "vibrate", *METAL[:4], "--speed", "900"], "speed of sound"),
        (["fem", "vibrate", *METAL[:4], "--speed", "500"], "radius; the upper limit is 0.5"),
        (["calibrate", "--fem", *DENSE, "--range", "1e6"], "radius; the upper limit is 0.4"),
        (["calibrate", *DENSE, "--range", "1.2"], "needs at least 3 times the yield force"),
    ],
)
def test_bad_input_is_refused_with_its_limit(line, said, capsys):
    assert main(line) == 1
    assert said in capsys.readouterr().err


def test_a_cylinder_strikes_a_body(capsys):
    assert (
        main(["fem", "cylinder", *GLASS, "--elastic", *CYLINDER, "--speed", "0.1", "--json"]) == 0
    )
    numbers = json.loads(capsys.readouterr().out)
    # Waves in the struck body reduce the rebound speed by 1e-3. The body is hundreds of times
    # lighter than the cylinder.
    assert numbers["coefficient_of_restitution"] == pytest.approx(1, abs=5e-3)
    assert len(numbers["history"]["force"]) > 100


def test_a_slow_cylinder_is_said_not_to_reach_yield(capsys, coarse):
    line = ["fem", "cylinder", *GLASS, "--yield", "2.41e9", *CYLINDER, "--json"]
    assert main([*line, "--speed", "0.02"]) == 0
    assert "speed 0.02 m/s is too low for yield" in capsys.readouterr().err


def test_finite_strain_of_a_cylinder_needs_no_warning(capsys, coarse):
    line = ["fem", "cylinder", *GLASS, "--yield", "2.41e9", *CYLINDER, "--json"]
    assert main([*line, "--speed", "1", "--finite-strain"]) == 0
    printed = capsys.readouterr()
    # Lines with "so far" are the progress of the computation.
    assert [line for line in printed.err.splitlines() if " so far" not in line] == []
    # The depth is 0.100 um with default settings; here, elements are as wide as a third of the
    # contact.
    assert json.loads(printed.out)["residual_depth"] == pytest.approx(0.1e-6, rel=0.1)


@pytest.mark.parametrize(
    ("line", "printed"),
    [
        (["press", *METAL, "--force-ratio", "0.5"], r"force +18\.319 +N\n(.+\n)*residual_approach"),
        (
            ["throw", *METAL, "--speed", "0.002"],
            r"nodal_restitution +[01]\.\d+ +restitution from the mean velocity",
        ),
        (["vibrate", *ICE, "--speed", "1", "--transits", "2"], r"timestep +\S+ +s\n(.*\n)+modes\n"),
        (
            ["cylinder", *GLASS, "--elastic", *CYLINDER, "--speed", "0.1"],
            r"residual_depth +\S+ +m\n",
        ),
    ],
)
def test_numbers_are_printed_with_their_units(line, printed, capsys, coarse):
    assert main(["fem", *line]) == 0
    assert re.search(printed, capsys.readouterr().out)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (["--speed", "1", "--sliding-speed", "-1"], "sliding_speed is -1"),
        (["--speed", "1", "--coefficient-of-friction", "3"], "coefficient_of_friction is 3"),
        (["--speed", "30"], "times the radius"),
    ],
)
def test_a_cylinder_that_cannot_strike_is_refused(given, said, capsys):
    assert main(["fem", "cylinder", *METAL, *CYLINDER, *given]) == 1
    assert said in capsys.readouterr().err
