# SPDX-License-Identifier: GPL-2.0-or-later
"""The deck that `plastigran new-deck` writes: it runs, continues and keeps its energy balance."""

from __future__ import annotations

import re

import pytest
from numpy.testing import assert_allclose

from plastigran.bulk.run import run_bulk
from plastigran.bulk.template import SPEED, write_deck
from plastigran.cli import main
from plastigran.contact import Contact
from plastigran.materials import read_material
from plastigran.plot.frame_files import find_frames

#: Settings of the shortest run.
ONE_ROW = {"duration": 0.001, "rows": 1, "checkpoints": 1}


def test_template_runs_and_continues(tmp_path, capsys):
    """The deck of `new-deck` runs, and a continued run equals an uninterrupted one."""
    folder = tmp_path / "mine"
    assert main(["new-deck", str(folder), "--law", "kogut_etsion"]) == 0
    capsys.readouterr()
    deck = folder / "mine.in"
    short = {"duration": 0.12, "rows": 12, "checkpoints": 3, "frames": 2}
    whole = run_bulk(deck, short, tmp_path / "whole", show=False)
    assert whole.passed and "ledger" in whole.figures and len(whole.checks) == 2
    assert whole.series["plastic"].iloc[-1] > 0
    assert len(find_frames(tmp_path / "whole")) >= 2
    half = tmp_path / "half"
    run_bulk(deck, short | {"duration": 0.08, "rows": 8, "checkpoints": 2}, half, show=False)
    rest = run_bulk(deck, short, tmp_path / "rest", restart=half, show=False)
    assert rest.series["step"].tolist() == whole.series["step"].tolist()
    for column in ("time", "kinetic", "plastic"):
        assert_allclose(rest.series[column], whole.series[column], rtol=1e-9, atol=1e-15)
    line = ["bulk", str(deck), "--restart", str(whole.folder), "--output", str(tmp_path / "more")]
    assert main(line) == 0
    assert "whole has reached its end, so there was nothing to compute" in capsys.readouterr().out


def test_default_template_stays_within_the_range_of_its_law(tmp_path):
    """In the default template, falling grains yield but stay within the range of the law."""
    assert main(["new-deck", str(tmp_path / "mine")]) == 0
    run = run_bulk(tmp_path / "mine" / "mine.in", {}, tmp_path / "run", show=False)
    assert run.passed and run.series["plastic"].iloc[-1] > 0
    assert "the validity range of the law" not in (tmp_path / "run" / "log.liggghts").read_text()


def test_falls_beyond_the_range_of_the_law_are_noted(tmp_path, capsys):
    """`new-deck` prints a note for a soft material whose falling grains exceed the range of the
    law."""
    assert main(["new-deck", str(tmp_path / "hard")]) == 0
    assert "note" not in capsys.readouterr().out
    assert main(["new-deck", str(tmp_path / "soft"), "--material", "soft_granules"]) == 0
    note = capsys.readouterr().out.split("note: ")[1]
    assert "overlap then is 6.2 times the largest valid overlap of universal" in note
    assert "Use one of ghaednia, ghaednia_2019, jackson_green" in note


@pytest.mark.parametrize("radius", [0.001, 0.005])
def test_time_step_is_the_recommended_one_for_the_radius(radius, tmp_path):
    line = ["new-deck", str(tmp_path / "mine"), "--law", "thornton", "--radius", str(radius)]
    assert main([*line, "--material", "soft_granules"]) == 0
    run = run_bulk(tmp_path / "mine" / "mine.in", ONE_ROW, tmp_path / "run", show=False)
    granules = read_material("soft_granules")
    contact = Contact("thornton", granules, granules, radius=radius, radius_other=radius)
    recommended = float(contact.timestep(SPEED))
    log = (run.folder / "log.liggghts").read_text()
    (step,) = re.findall(r"^timestep +([\d.e-]+) ", log, re.MULTILINE)[-1:]
    assert 0.5 * recommended < float(step) <= recommended  # rounded down to one digit


def test_template_takes_all_constants_of_the_material(tmp_path):
    """The deck uses all constants of the material file: the log of LIGGGHTS states them."""
    material = tmp_path / "rated.in"
    material.write_text(
        "variable youngs_modulus index 5e6\nvariable poissons_ratio index 0.3\n"
        "variable density index 1500\nvariable yield_strength index 1e5\n"
        "variable yield_pressure_factor index 1.5\nvariable tangent_modulus index 4e4\n"
        "variable rate_coefficient index 0.014\n"
    )
    deck = write_deck(tmp_path / "mine", "universal", material)
    run_bulk(deck, ONE_ROW, tmp_path / "run", show=False)
    log = (tmp_path / "run" / "log.liggghts").read_text()
    assert "yield pressure 150000 Pa, rate coefficient 0.014" in log
    assert "tangent modulus 40000 Pa" in log


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("mine", "mine already exists. Choose another name"),
        ("a\nb", "contains white space"),
        ("a%b", "'a%b' contains white space, % or *"),
        ("new --law hertz", "hertz is LIGGGHTS' own model and has no"),
        ("fresh", "'fresh' is the name of another file"),
        ("steel --material steel", "both called 'steel'"),
        ("new --law lim_stronge", "'lim_stronge' is not a law for spheres"),
        (
            "new --law jkr",
            "law 'jkr' needs constants of the pair of bodies, which the deck does not define",
        ),
        (
            "new --law walton_braun",
            "law 'walton_braun' needs constants of the pair of bodies, which the deck does not",
        ),
        ("new --radius 0.05", "radius is 0.05; it must lie from 0.0005 to 0.006"),
    ],
)
def test_impossible_templates_are_refused(line, message, tmp_path, capsys):
    (tmp_path / "mine").mkdir()
    folder, *options = line.split(" ")
    assert main(["new-deck", str(tmp_path / folder), *options]) == 1
    assert message in capsys.readouterr().err
