# SPDX-License-Identifier: GPL-2.0-or-later
"""Impacts of adhesive spheres on the command line, below and above the sticking speed."""

from __future__ import annotations

import json

import numpy as np
import pytest

from plastigran.cli import main
from plastigran.experiments.central import CentralImpact
from plastigran.physics.adhesion import jkr_sticking_speed

POWDER = """
variable youngs_modulus index 1.2e9
variable poissons_ratio index 0.3
variable density        index 1350
variable yield_strength index 22e6
"""
RADIUS, GAMMA = 2.5e-6, 0.2
#: Sticking speed of the sphere on a rigid wall [m/s].
STICKING = jkr_sticking_speed(GAMMA, RADIUS, 1.2e9 / 0.91, 4 / 3 * np.pi * RADIUS**3 * 1350)
LAWS = ["--law", "jkr", "thornton_ning_1998", "universal", "--surface-energy", str(GAMMA)]


@pytest.fixture
def call(tmp_path):
    powder = tmp_path / "powder.in"
    powder.write_text(POWDER)
    folder = tmp_path / "results"
    return ["impact", "--material", str(powder), "--radius", str(RADIUS), "--output", str(folder)]


def test_impacts_stick_and_rebound(call, capsys):
    speeds = [0.7 * STICKING, 1.3 * STICKING, 4 * STICKING]
    assert main([*call, *LAWS, "--speed", *map(str, speeds), "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)["table"]
    assert len(rows) == 9
    for row in rows:
        measured, predicted = (
            row[f"coefficient_of_restitution{suffix}"] for suffix in ("", "_predicted")
        )
        # The recommended time step allows an error of restitution of 1e-3; the largest here is
        # 1.1e-3.
        assert measured == pytest.approx(predicted, abs=2e-3)
        assert row["overlap_res"] == pytest.approx(row["overlap_res_predicted"], rel=1e-2)
        assert row["surface_energy"] == GAMMA
        assert (measured == 0) == (predicted == 0) == (row["contact_time"] is None)
    elastic = [row["coefficient_of_restitution"] for row in rows if row["law"] == "jkr"]
    assert elastic == pytest.approx([0, (1 - 1.3**-2) ** 0.5, (1 - 4**-2) ** 0.5], abs=2e-3)


def test_the_remark_has_the_sticking_speed_of_each_sphere(call, capsys):
    """For two spheres, the output has the sticking speed as closing speed and for each sphere.

    R*, m* and E* of two equal spheres are half of their values at a rigid wall.
    """
    half = jkr_sticking_speed(GAMMA, RADIUS / 2, 0.6e9 / 0.91, 2 / 3 * np.pi * RADIUS**3 * 1350) / 2
    assert main([*call, *LAWS, "--speed", "0.1", "--geometry", "two_spheres", "--theory"]) == 0
    printed = capsys.readouterr().out
    stick = "Powder, 0.2 J/m2: the coefficient of restitution is 0 where the bodies stick. "
    stick += "The largest closing speed at which they stick is"
    assert f"jkr, {stick} {2 * half:.4g} m/s ({half:.4g} m/s for each sphere)" in printed
    assert f"thornton_ning_1998, {stick}" in printed
    assert main([*call, *LAWS, "--speed", "0.1", "--theory", "--force"]) == 0
    on_wall = stick.replace("Powder", "Powder, on a rigid wall")
    assert f"jkr, {on_wall} {STICKING:.4g} m/s" in capsys.readouterr().out


def test_bodies_that_always_stick_have_a_table(tmp_path, capsys):
    line = ["impact", "--law", "jkr", "--material", "steel", "--radius", "1e-9", "--theory"]
    line += ["--surface-energy", "5", "--speed", "1", "--output", str(tmp_path / "out")]
    assert main(line) == 0
    printed = capsys.readouterr().out
    assert "The sticking speed is unknown: the bodies stick even at 100 m/s" in printed


@pytest.mark.filterwarnings("default:surface_energy of material")
def test_surface_energy_of_the_material(call, tmp_path, capsys):
    """`--surface-energy` replaces the surface energy of the material file; `mdr` ignores both.

    A warning names laws that ignore the value of the material file.
    """
    (tmp_path / "powder.in").write_text(POWDER + "variable surface_energy index 0.1\n")
    rows, warnings = [], []
    for option in ([], ["--surface-energy", "0.1", "0.2"]):
        line = [*call, "--law", "jkr", "mdr", *option, "--speed", "1", "--theory", "--json"]
        assert main([*line, "--force"]) == 0
        printed = capsys.readouterr()
        rows += json.loads(printed.out)["table"]
        warnings.append(printed.err)
    idle = "surface_energy of material powder is 0.1 J/m2, but has no effect in"
    assert f"{idle} mdr. Use a law with adhesion" in warnings[0]
    assert "has no effect" not in warnings[1]
    assert [row["surface_energy"] for row in rows] == [0.1, None, 0.1, 0.2, None]
    jkr = [row["coefficient_of_restitution"] for row in rows if row["law"] == "jkr"]
    assert jkr[0] == jkr[1] > jkr[2]
    assert main([*call, "--law", "jkr", "universal", "--speed", "1", "--dry-run"]) == 0
    remedy = "universal. Give --surface-energy 0.1 to switch on adhesion in laws that support it\n"
    assert f"{idle} {remedy}" in capsys.readouterr().err
    body = ["--material", call[2], "--radius", str(RADIUS), "--speed", "1"]
    assert main(["timestep", "--law", "universal", *body]) == 0
    assert f"{idle} {remedy}" in capsys.readouterr().err
    assert main(["oblique", *body, "--friction", "0.1", "--points", "1"]) == 0
    assert "has no effect: oblique impacts are computed without" in capsys.readouterr().err


@pytest.mark.parametrize("mode", ["--theory", "--dry-run"])
def test_a_rate_coefficient_is_refused_with_adhesion(call, mode, tmp_path, capsys):
    """A rate coefficient is refused with adhesion, except for `jkr`, which ignores it."""
    (tmp_path / "powder.in").write_text(POWDER)
    rated = tmp_path / "rated.in"
    rated.write_text(POWDER + "variable rate_coefficient index 0.02\n")
    message = "{}: rate_coefficient is 0.02; it must be 0 with adhesion"
    line = ["--surface-energy", "0.1", "--speed", "1", mode]
    call[2] = str(rated)
    for law in ("universal", "thornton_ning_1998"):
        assert main([*call, "--law", law, *line]) == 1
        assert message.format(law) in capsys.readouterr().err
    assert main([*call, "--law", "jkr", *line]) == 0


def test_timestep_is_the_step_that_the_plugin_recommends(tmp_path, capsys):
    body = ["--surface-energy", "0.5", "--material", "steel", "--radius", "1e-5", "--speed", "0.5"]
    assert main(["timestep", "--law", "universal", *body, "--json"]) == 0
    (row,) = json.loads(capsys.readouterr().out)
    case = CentralImpact("universal", 0.5, "steel", 1e-5, surface_energy=0.5)
    case.run(tmp_path, timestep=0.99 * row["timestep"])
    assert "0.99 of the recommended time step" in (tmp_path / "log.liggghts").read_text()


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (["--law", "jkr"], "law jkr needs surface_energy, which material powder does not define"),
        (["--law", "mdr", "--surface-energy", "1"], "mdr has no surface energy. Use one"),
        (["--law", "walton_braun"], "needs loading_stiffness, which materials cannot define"),
    ],
)
def test_bad_input(call, given, message, capsys):
    assert main([*call, *given, "--theory"]) == 1
    assert message in capsys.readouterr().err
