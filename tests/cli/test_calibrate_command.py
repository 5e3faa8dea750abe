# SPDX-License-Identifier: GPL-2.0-or-later
"""The command `calibrate`."""

from __future__ import annotations

import json
from functools import partial

import pytest

import plastigran as pg
from plastigran.calibration.expected_errors import DEFAULT_LAW
from plastigran.cli import main
from plastigran.engine.deck import property_name
from plastigran.fem.settings import Settings

STEEL = ["calibrate", "--young", "206e9", "--poisson", "0.3", "--density", "7850"]
DROPS = "drop_height, rebound_height\n0.05, 0.0215\n0.10, 0.0385\n0.20, 0.0680\n"


@pytest.fixture
def drops(tmp_path):
    path = tmp_path / "drops.csv"
    path.write_text(DROPS)
    return path


@pytest.fixture
def coarse(monkeypatch, tmp_path):
    """Use coarse finite elements that take a second or two, with a cache in a temporary folder."""
    monkeypatch.setenv("PLASTIGRAN_CACHE", str(tmp_path / "cache"))
    coarse = partial(Settings, divisions=3, fineness=0.5)
    monkeypatch.setattr("plastigran.calibration.finite_elements.Settings", coarse)


def test_json_has_the_numbers_of_the_function(capsys):
    assert main([*STEEL, "--hardness", "45HRC", "--json"]) == 0
    numbers = json.loads(capsys.readouterr().out)
    found = pg.calibrate(youngs_modulus=206e9, poissons_ratio=0.3, density=7850, hardness="45HRC")
    assert numbers == json.loads(json.dumps(found.to_dict()))
    least, largest = numbers["yield_strength_interval"]
    assert least < numbers["yield_strength"] < largest


def test_printed_lines_can_be_used_in_a_deck(capsys, tmp_path):
    """`calibrate` prints a material file that can be read, and deck lines with all properties."""
    file = tmp_path / "spring.in"
    assert main([*STEEL, "--hardness", "45HRC", "--output", str(file)]) == 0
    printed = capsys.readouterr().out
    assert pg.material(file).name == "spring"
    said, written = printed.split("Material file:\n")
    assert file.read_text() == written
    assert f"pair_style gran model {DEFAULT_LAW} tangential history" in said
    for name in ("youngs_modulus", "poissons_ratio", "yield_strength"):
        value = getattr(pg.material(file), name)
        line = f"fix {name} all property/global {property_name(name)} peratomtype {value:.6g}\n"
        assert line in said


def test_drops_have_a_figure(capsys, tmp_path, drops):
    figure = tmp_path / "drops.png"
    line = [*STEEL, "--drop", str(drops), "--law", "thornton", "--figure", str(figure), "--json"]
    assert main(line) == 0
    numbers = json.loads(capsys.readouterr().out)
    assert numbers["law"] == "thornton"
    assert numbers["source"].startswith(
        "3 drops of the metal on a rigid plate, by the law thornton"
    )
    assert figure.read_bytes().startswith(b"\x89PNG")


def test_materials_of_ball_and_plate(capsys, drops):
    """`--ball` and `--plate` set the materials of a drop test; the weaker body yields.

    The yield speed v_Y is that of this pair of bodies.
    """
    found = {}
    for bodies in (["--plate", "metal"], ["--ball", "alumina"], ["--plate", "alumina"], []):
        line = [*STEEL, "--drop", str(drops), "--law", "thornton", *bodies, "--json"]
        assert main(line) == 0
        numbers = json.loads(capsys.readouterr().out)
        found[" ".join(bodies)] = numbers["yield_strength"]
        slowest = numbers["speed_ratio"][0] * numbers["yield_speed"]
        assert slowest == pytest.approx((2 * 9.81 * 0.05) ** 0.5, rel=1e-3)
    # v_Y^2 is proportional to sigma_Y^5/(E*^4 m). A pair with smaller E* needs less strength for
    # the same v/v_Y.
    assert found["--plate metal"] == pytest.approx(found[""] * 2**-0.8, rel=0.01)
    alumina = pg.material("alumina")
    steel_modulus, alumina_modulus = 206e9 / 0.91, alumina.youngs_modulus / (1 - 0.22**2)
    softening = 1 / (1 + steel_modulus / alumina_modulus)
    assert found["--plate alumina"] == pytest.approx(found[""] * softening**0.8, rel=0.01)
    assert main([*STEEL, "--drop", str(drops), "--law", "thornton", "--plate", "metal"]) == 0
    assert "m/s for drops of the metal on the metal\n" in capsys.readouterr().out
    lighter = (alumina.density / 7850) ** 0.2
    assert found["--ball alumina"] == pytest.approx(found["--plate alumina"] * lighter, rel=0.01)


def test_finite_elements_fit_the_constants_and_have_a_figure(capsys, tmp_path, coarse):
    line = ["calibrate", "--young", "70e9", "--poisson", "0.3", "--density", "2700"]
    line += ["--yield", "1e8", "--range", "41"]
    figure = tmp_path / "fem.png"
    assert main([*line, "--law", "thornton", "--figure", str(figure), "--json"]) == 0
    numbers = json.loads(capsys.readouterr().out)
    # The reference values are from fine elements. Coarse elements have an error of 5 % in the
    # contact radius, and the curvature coefficient depends on its square.
    assert numbers["contact_radius_coefficient"] == pytest.approx(0.025534, rel=0.05)
    assert numbers["curvature_coefficient"] == pytest.approx(0.010643, rel=0.10)
    assert numbers["force_max"] == pytest.approx(41 * numbers["yield_force"], rel=1e-6)
    assert figure.stat().st_size > 10000


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (["--hardness", "9000"], "hardness is 9000; it must lie from 5 to 2000"),
        (["--hardness", "72HRC"], "hardness is 72; it must lie from 20 to 68"),
        (["--yield", "250"], "yield_strength is 250 Pa; with youngs_modulus 2.06e+11 Pa it must"),
        (["--leeb", "1000"], "only a lower bound"),
        (["--hardness", "200", "--figure", "x.png"], "no effect without --drop or --fem"),
        (
            ["--hardness", "200", "--ball", "steel"],
            "--ball is steel, but has no effect without --drop",
        ),
        (
            ["--yield", "3e8", "--ball-radius", "0.01"],
            "--ball-radius is 0.01, but has no effect without --drop",
        ),
        (
            ["--yield", "3e8", "--plate", "rigid"],
            "--plate is rigid, but has no effect without --drop",
        ),
        (
            ["--yield", "3e8", "--scatter", "0.1"],
            "--scatter is 0.1, but has no effect without --drop or --leeb",
        ),
        (["--yield", "3e8", "--radius", "0.2"], "--radius is 0.2, but has no effect without --fem"),
        (["--yield", "3e8", "--finite-strain"], "--finite-strain has no effect without --fem"),
        (["--yield", "3e8", "--force"], "--force is given, but has no effect without --output"),
        (["--hardness", "200", "--output", "metal.txt"], "must end in .in"),
        (["--drop", "nowhere.csv"], "plastigran: the file nowhere.csv does not exist"),
        (["--hardness", "200", "--law", "hertz"], "law is 'hertz'"),
    ],
)
def test_bad_input_is_one_line(given, said, capsys):
    assert main([*STEEL, *given]) == 1
    error = capsys.readouterr().err
    assert said in error
    assert error.count("\n") == 1


def test_a_material_s_file_is_not_overwritten(tmp_path, capsys):
    file = tmp_path / "steel.in"
    file.write_text("mine")
    assert main([*STEEL, "--hardness", "200", "--output", str(file)]) == 1
    assert "exists. Use --force to overwrite it" in capsys.readouterr().err
    assert file.read_text() == "mine"
    assert main([*STEEL, "--hardness", "200", "--output", str(file), "--force"]) == 0
    assert pg.material(file).density == 7850


def test_two_measurements_are_refused(capsys):
    with pytest.raises(SystemExit):
        main([*STEEL, "--hardness", "200", "--leeb", "500"])
    assert "not allowed with argument" in capsys.readouterr().err
