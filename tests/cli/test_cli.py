# SPDX-License-Identifier: GPL-2.0-or-later
"""Commands as a user types them."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pandas as pd
import pytest
from commands import exit_code

from plastigran import laws
from plastigran.__main__ import start
from plastigran.cli import main
from plastigran.engine.deck import property_name
from plastigran.engine.process import inputs_folder
from plastigran.materials import read_material
from plastigran.usable_laws import laws_for


def test_impact_writes_table_and_figures(tmp_path, capsys):
    folder = tmp_path / "impacts"
    line = ["impact", "--law", "all", "--speed", "0.02", "0.2", "--output", str(folder)]
    assert main(line) == 0
    table = pd.read_csv(folder / "impacts.csv")
    aluminium = read_material("aluminium_zv02")
    possible = [law for law in laws_for("sphere") if not aluminium.missing(law)]
    assert sorted(table["law"].unique()) == sorted(possible)
    assert len(table) == 2 * len(possible)
    assert "viscoelastic_hertz" not in possible
    off = table["coefficient_of_restitution"] / table["coefficient_of_restitution_predicted"] - 1
    assert off.abs().max() < 1e-3
    for name in ("restitution", "loops"):
        assert (folder / f"{name}.png").read_bytes().startswith(b"\x89PNG")
        assert "<svg" in (folder / f"{name}.svg").read_text()[:1000]
    assert "vu_quoc_zhang" in capsys.readouterr().out

    line = ["impact", "--law", "thornton", "--speed", "0.1", "--output", str(folder)]
    assert main(line) == 1
    assert "another folder with --output, or overwrite them with --force" in capsys.readouterr().err
    assert len(pd.read_csv(folder / "impacts.csv")) == len(table)
    assert main([*line, "--force"]) == 0
    assert pd.read_csv(folder / "impacts.csv")["law"].tolist() == ["thornton"]


def test_materials_and_geometries(tmp_path, capsys):
    folder = tmp_path / "impacts"
    line = ["impact", "--law", "thornton", "--speeds", "0.01", "1", "--points", "3"]
    line += ["--material", "steel", "aluminium_zv02", "--geometry", "two_spheres"]
    assert main([*line, "--radius", "0.005", "--output", str(folder)]) == 0
    table = pd.read_csv(folder / "impacts.csv")
    assert set(table["material"]) == {"steel", "aluminium_zv02"}
    assert table["speed"].tolist()[:3] == pytest.approx([0.01, 0.1, 1])


def test_chung_ooi_writes_a_table_and_a_figure_each(tmp_path, capsys):
    line = ["chung-ooi", "--benchmark", "2", "7", "--steps", "200", "--output", str(tmp_path)]
    assert main(line) == 0
    assert pd.read_csv(tmp_path / "agreement.csv")["benchmark"].tolist() == [2, 7]
    for number, impacts in ((2, 2), (7, 14)):
        assert len(pd.read_csv(tmp_path / f"benchmark_{number}.csv")) == impacts
        assert (tmp_path / f"benchmark_{number}.png").read_bytes().startswith(b"\x89PNG")
    assert "Largest deviations from theory" in capsys.readouterr().out
    assert main(line) == 1
    assert "overwrite them with --force" in capsys.readouterr().err


def test_laws_lists_every_law_with_its_constants(capsys):
    assert main(["laws", "all"]) == 0
    said = capsys.readouterr().out
    assert main(["laws"]) == 0
    assert said == capsys.readouterr().out
    assert "\nEvery law needs youngsModulus [Pa]" in said and "Further constants:\n" in said
    for name, law in laws.LAWS.items():
        assert name in said and law.source in said and law.range in said
        for constant in law.parameters():
            assert property_name(constant["name"]) in said


def test_a_command_loads_only_its_module():
    """A command does not import the slow modules of other commands, such as finite elements."""
    code = "import sys; from plastigran.cli import main; main(['laws']); print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert not {"matplotlib", "scipy.optimize", "skfem"} & set(done.stdout.split())


def test_modes(capsys):
    """`modes` prints the fundamental modes of the ice sphere of docs/elastic_sphere.md."""
    assert main(["modes", "--material", "ice", "--radius", "0.01", "--degree", "2"]) == 0
    lines = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert lines[1][:3] == ["toroidal", "2", "0"]
    assert lines[2][:3] == ["spheroidal", "2", "0"]
    assert float(lines[2][5]) == pytest.approx(85418.7)


def test_timestep_of_every_law_reports_laws_that_are_left_out(capsys):
    line = ["timestep", "--law", "all", "--speed", "0.1", "--material", "aluminium_zv02"]
    assert main(line) == 0
    said = capsys.readouterr()
    aluminium = read_material("aluminium_zv02")
    assert [row.split()[0] for row in said.out.splitlines()] == laws_for("sphere", [aluminium])
    assert "left out, because the material does not define their constants: visc" in said.err
    assert "omitted: laws for cylinders. Use --geometry cylinder_wall" in said.err
    line = [*line[:-1], "glass_kp10", "--radius", "1e-5", "--geometry", "cylinder_wall"]
    assert main(line) == 0
    assert [row.split()[0] for row in capsys.readouterr().out.splitlines()] == laws_for("cylinder")


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("impact --law hook", "no law 'hook'. Available laws: brake_2012, "),
        ("impact --material cheese", "no material 'cheese'. Available materials: alumina, "),
        ("timestep --speed 1 --law x", "no law 'x'"),
        ("timestep --speed 1 --law all hook", "no law 'hook'"),
        ("impact --law lim_stronge", "lim_stronge is a law for cylinders"),
        ("impact --law thornton --speed 300", "no contact law is valid beyond 0.3"),
        ("impact --speed 1 --speeds 1 2", "--speeds defines a range of values, but --speed gives"),
        ("impact --points 0", "argument --points: 0 is not allowed; use 1 or more"),
        ("impact --jobs -1", "argument --jobs: -1 is not allowed; use 1 or more"),
        ("impact --jobs two", "'two' is not a whole number"),
        *((f"impact --radius={value}", value) for value in ("-1", "0", "fast", "nan", "inf")),
    ],
)
def test_wrong_values_are_named(line, message, tmp_path, capsys):
    output = ["--output", str(tmp_path)] if line.startswith("impact") else []
    code, error = exit_code([*line.split(), *output]), capsys.readouterr().err
    assert message in error
    assert code == (2 if error.startswith("usage:") else 1)


def test_an_impact_beyond_the_range_of_its_law_is_reported(tmp_path, capsys):
    line = ["impact", "--law", "vu_quoc_zhang", "--speed", "0.02", "0.2"]
    assert main([*line, "--output", str(tmp_path / "out")]) == 0
    assert "outside the range of vu_quoc_zhang (F <= 41 P_Y" in capsys.readouterr().out
    assert pd.read_csv(tmp_path / "out" / "impacts.csv")["in_range"].tolist() == [True, False]


def test_the_material_that_leaves_the_range_is_named(tmp_path, capsys):
    line = ["impact", "--law", "universal", "--speed", "2", "--radius", "0.0025"]
    line += ["--material", "steel_bearing", "steel", "--output", str(tmp_path / "out")]
    assert main(line) == 0
    said = [row for row in capsys.readouterr().out.splitlines() if "outside the range" in row]
    assert len(said) == 1 and said[0].endswith("with steel: 2 m/s and faster")


def test_a_material_file_outside_the_inputs(tmp_path):
    """LIGGGHTS gets the constants of the file, although the package has a material of this name."""
    steel = (inputs_folder() / "materials" / "steel.in").read_text()
    own = tmp_path / "steel.in"
    own.write_text(steel.replace("3.0e8", "3.0e9"))
    line = ["impact", "--law", "thornton", "--speed", "0.1", "--material", str(own)]
    assert main([*line, "--output", str(tmp_path / "out")]) == 0
    row = pd.read_csv(tmp_path / "out" / "impacts.csv").iloc[0]
    assert row["coefficient_of_restitution"] == pytest.approx(
        row["coefficient_of_restitution_predicted"], rel=1e-3
    )


@pytest.mark.parametrize("sent", [signal.SIGINT, signal.SIGTERM])
def test_an_interrupt_while_the_command_loads(sent, monkeypatch, capsys):
    # Background jobs of a shell ignore SIGINT, so the test sets the default handler.
    before = {signal.SIGTERM: signal.getsignal(signal.SIGTERM)}
    before[signal.SIGINT] = signal.signal(signal.SIGINT, signal.default_int_handler)
    monkeypatch.setattr("plastigran.cli.main", lambda: signal.raise_signal(sent))
    try:
        assert start() == 130
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    assert capsys.readouterr().err == "plastigran: stopped\n"


@pytest.mark.parametrize("sent", [signal.SIGINT, signal.SIGTERM])
def test_an_interrupt_keeps_finished_results(sent, start_plastigran, tmp_path):
    """Ctrl-C, or SIGTERM from a batch system, stops `impact`; the table keeps the finished rows.

    No further simulation starts.
    """
    line = ["impact", "--law", "thornton", "--points", "300", "--jobs", "1", "--output", tmp_path]
    run = start_plastigran(*line)
    table = tmp_path / "impacts.csv"
    while not table.exists():
        assert run.poll() is None
        time.sleep(0.05)
    os.killpg(run.pid, sent)
    _, said = run.communicate(timeout=30)
    assert run.returncode == 130
    assert "stopped; finished runs are in" in said
    assert 1 <= len(pd.read_csv(table)) < 250
    assert len(list((tmp_path / "runs").iterdir())) < 250


def test_missing_engine_is_named(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("PLASTIGRAN_ENGINE", str(tmp_path / "none"))
    assert main(["impact", "--speed", "0.1", "--output", str(tmp_path / "out")]) == 1
    assert "LIGGGHTS is not at" in capsys.readouterr().err


def test_console_script():
    done = subprocess.run(
        [Path(sys.executable).parent / "plastigran", "--help"],
        capture_output=True,
        text=True,
        check=True,
    )
    listed = ("bulk", "impact", "rod", "laws", "timestep", "modes", "chung-ooi", "cylinder", "demo")
    for command in listed:
        assert command in done.stdout
