# SPDX-License-Identifier: GPL-2.0-or-later
"""A run far beyond the range of its law fails: in its summary, its JSON and its report."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from plastigran.bulk.checks import EXCESS
from plastigran.bulk.run import run_bulk
from plastigran.cli import main
from plastigran.engine.log import find_excess
from plastigran.report.page.collect import collect
from plastigran.report.page.render import make_section, write_report

#: A heavy ball lands on a soft grain on a floor.
DECK = """
units si
atom_style granular
boundary f f f
newton off
communicate single vel yes
region box block -0.02 0.02 -0.02 0.02 -0.002 0.05 units box
create_box 1 box
neighbor 0.001 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 5.0e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global yieldStrength peratomtype 1.0e5
pair_style gran model universal tangential off energy_ledger on
pair_coeff * *
fix floor all wall/gran model universal tangential off primitive type 1 zplane 0.0 energy_ledger on
create_atoms 1 single 0 0 {low} units box
create_atoms 1 single 0 0 0.01201 units box
group ball id 2
set group all diameter 0.002 density 1500
set group ball diameter 0.02 density {density}
velocity ball set 0 0 {velocity}
fix integrate all nve/sphere
timestep 5e-7
thermo 100
include energy_ledger.in
run {steps}
"""


def write(folder: Path, **values: float) -> Path:
    deck = folder / "crush.in"
    deck.write_text(DECK.format(**{"low": 0.001} | values))
    ledger = Path(__file__).parents[2] / "inputs" / "energy_ledger.in"
    (folder / "energy_ledger.in").write_text(ledger.read_text())
    return deck


def test_a_run_far_beyond_the_range_fails(tmp_path, capsys):
    """A run fails if a contact far exceeds the validity range of its law.

    The overlap is a third of the radius, 15 times the overlap at the end of the range, a/R = 0.1.
    """
    line = ["bulk", str(write(tmp_path, density=8000, velocity=-5, steps=200))]
    line += ["--output", str(tmp_path / "run")]
    assert main(line) == 1
    output = capsys.readouterr()
    assert output.out.startswith(
        "NO  largest overlap, divided by the largest valid overlap of universal: "
    )
    assert "largest overlap, divided by the largest valid overlap of universal" in output.err
    assert main([*line, "--force", "--json"]) == 1
    first = json.loads(capsys.readouterr().out)["checks"][0]
    assert first["name"] == "largest overlap, divided by the largest valid overlap of universal"
    assert first["value"] > EXCESS == first["limit"] and not first["passed"]
    section = make_section(collect([tmp_path / "run"])[0])
    assert section.state == "failed" and section.checks[0]["name"] == first["name"]
    assert any("exceeded the validity range of the law" in warning for warning in section.warnings)


def test_the_range_is_that_of_all_runs_and_simulations():
    """The excess of a law is the largest value that the log reports in any of its runs.

    The excess is the largest overlap divided by the largest valid overlap of the law.
    """
    lines = "plastigran range universal contacts=1 furthest={}\n"
    text = (
        lines.format(30) + lines.format(1.2) + "plastigran range thornton contacts=2 furthest=3\n"
    )
    assert find_excess(text) == {"universal": 30, "thornton": 3}


def test_contacts_that_go_deeper_in_a_later_run_count(tmp_path):
    """Compressing the grain in one run or in two gives the same excess.

    The excess is overlap / largest valid overlap; the tolerance 1e-9 is the precision of the log.
    """
    whole, split = (
        run_bulk(
            write(tmp_path, density=8000, velocity=-5, steps=steps), {}, tmp_path / name, show=False
        )
        for name, steps in (("whole", "250"), ("split", "60\nrun 190"))
    )
    assert "plastigran range" in (split.folder / "log.liggghts").read_text().split("run 190")[0]
    assert whole.checks["value"].iloc[0] > EXCESS
    assert split.checks["value"].iloc[0] == pytest.approx(whole.checks["value"].iloc[0], rel=1e-9)


def test_elastic_contacts_beyond_the_range_give_a_warning(tmp_path):
    deck = write(tmp_path, density=8000, velocity=-5, steps=250)
    deck.write_text(deck.read_text().replace("peratomtype 1.0e5", "peratomtype 5.0e6"))
    log = (run_bulk(deck, {}, tmp_path / "run", show=False).folder / "log.liggghts").read_text()
    assert "contacts=0" in log
    assert ": contacts have exceeded the validity range of the law" in log


def test_the_range_is_in_the_log_before_a_run_ends(tmp_path):
    """The log has the excess before the line `Loop time`, which a killed run lacks."""
    deck = write(tmp_path, density=8000, velocity=-1, steps=1500)
    log = (run_bulk(deck, {}, tmp_path / "run", show=False).folder / "log.liggghts").read_text()
    assert find_excess(log.split("Loop time")[0])["universal"] > 5


def test_a_continued_run_keeps_the_largest_excess(tmp_path):
    deck = write(tmp_path, density=8000, velocity=-5, steps=200)
    text = deck.read_text()
    grains = text[text.index("create_atoms") : text.index("fix integrate")]
    box = text[text.index("region box") : text.index("neighbor ")]
    (tmp_path / "grains.fresh").write_text(box)
    (tmp_path / "grains.checkpoint").write_text("read_restart ${checkpoint}\n")
    (tmp_path / "more.fresh").write_text(grains)
    (tmp_path / "more.checkpoint").write_text("timestep 5e-7\n")
    text = text.replace(box, "include grains.${start}\n").replace(grains, "include more.${start}\n")
    text = text.replace("run 200", "restart 200 ${output}/checkpoint.*.restart\nrun ${steps} upto")
    start = "variable start index fresh\nvariable checkpoint index none\nvariable steps index 200\n"
    deck.write_text(start + text)
    first = run_bulk(deck, {}, tmp_path / "first", show=False)
    rest = run_bulk(deck, {"steps": 210}, tmp_path / "rest", restart=first.folder, show=False)
    limit = first.checks["value"].iloc[0]
    assert limit > EXCESS and rest.checks["value"].iloc[0] >= limit


def test_a_run_without_contacts_passes_no_check(tmp_path):
    """A run in which no grains touch passes no check, and the report states the reason."""
    deck = write(tmp_path, density=8000, velocity=1, low=0.001005, steps=10)
    assert main(["bulk", str(deck), "--output", str(tmp_path / "run")]) == 0
    section = make_section(collect([tmp_path / "run"])[0])
    assert section.state == "done" and not section.checks
    assert any("Check whether grains touched" in line for line in section.notes)
    page = write_report([tmp_path / "run"], tmp_path / "page.html").read_text()
    assert "Check whether grains touched" in page and "checks passed" not in page


@pytest.mark.parametrize("text", ["", "step\n"])
def test_an_emptied_series_is_named(text, tmp_path):
    deck = write(tmp_path, density=100, velocity=-0.1, steps=2000)
    assert main(["bulk", str(deck), "--output", str(tmp_path / "run")]) == 0
    (tmp_path / "run" / "series.csv").write_text(text)
    section = make_section(collect([tmp_path / "run"])[0])
    assert any("series.csv is empty" in line for line in section.missing)
    assert section.checks
