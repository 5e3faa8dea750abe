# SPDX-License-Identifier: GPL-2.0-or-later
"""The command line as a user types it."""

from __future__ import annotations

import subprocess
import sys

import pandas as pd
import pytest

from plastigran import laws
from plastigran.cli import main


def test_impact_writes_table_and_figures(tmp_path, capsys):
    folder = tmp_path / "impacts"
    line = ["impact", "--law", "all", "--speed", "0.02", "0.2", "--output", str(folder)]
    assert main(line) == 0
    table = pd.read_csv(folder / "impacts.csv")
    assert len(table) == 2 * len(laws.LAWS)
    off = table["coefficient_of_restitution"] / table["coefficient_of_restitution_predicted"] - 1
    assert off.abs().max() < 1e-3
    for name in ("restitution", "loops"):
        assert (folder / f"{name}.png").read_bytes().startswith(b"\x89PNG")
        assert "<svg" in (folder / f"{name}.svg").read_text()[:1000]
    assert "vu_quoc_zhang" in capsys.readouterr().out

    assert main(line) == 1
    assert "holds results; choose another --output, or add --force" in capsys.readouterr().err
    assert main([*line, "--force"]) == 0


def test_materials_and_geometries(tmp_path, capsys):
    folder = tmp_path / "impacts"
    line = ["impact", "--law", "thornton", "--speeds", "0.01", "1", "--points", "3"]
    line += ["--material", "steel", "aluminium_zv02", "--geometry", "two_spheres"]
    assert main([*line, "--radius", "0.005", "--output", str(folder)]) == 0
    table = pd.read_csv(folder / "impacts.csv")
    assert set(table["material"]) == {"steel", "aluminium_zv02"}
    assert table["speed"].tolist()[:3] == pytest.approx([0.01, 0.1, 1])


def test_laws_lists_every_law_with_its_constants(capsys):
    assert main(["laws"]) == 0
    said = capsys.readouterr().out
    for name, law in laws.LAWS.items():
        assert name in said and law.source in said and law.range in said
        for constant in law.parameters():
            assert constant["property"] in said


def test_timestep(capsys):
    assert main(["timestep", "--law", "thornton", "--speed", "0.1"]) == 0
    assert float(capsys.readouterr().out.split()[1]) == pytest.approx(1.835e-5, rel=1e-2)


@pytest.mark.parametrize(
    ("line", "said"),
    [
        (["impact", "--law", "hook"], "no law 'hook'; there are hertz, "),
        (["impact", "--material", "cheese"], "no material 'cheese'; there are aluminium_zv02, "),
        (["timestep", "--speed", "1", "--law", "x"], "no law 'x'"),
    ],
)
def test_wrong_words_are_named(line, said, capsys):
    assert main(line) == 1
    assert said in capsys.readouterr().err


@pytest.mark.parametrize("value", ["-1", "0", "fast", "nan", "inf"])
def test_numbers_out_of_range_are_named(value, capsys):
    with pytest.raises(SystemExit) as stop:
        main(["impact", f"--radius={value}"])
    assert stop.value.code == 2
    assert value in capsys.readouterr().err


def test_missing_engine_is_named(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("PLASTIGRAN_ENGINE", str(tmp_path / "none"))
    assert main(["impact", "--speed", "0.1", "--output", str(tmp_path / "out")]) == 1
    assert "no engine at" in capsys.readouterr().err


def test_finished_impacts_survive_a_failure(tmp_path, capsys):
    """One impact fails (a time step nobody can integrate); the others' rows are written."""
    from plastigran.impact import Impact, plan, sweep

    impacts = plan(["thornton"], [0.05, 0.1], ["aluminium_zv02"], 0.1)

    class Broken(Impact):
        def run(self, folder, *_args, **_keys):
            raise ValueError("broken on purpose")

    broken = Broken("thornton", 0.2, impacts[0].material, 0.1)
    with pytest.raises(ValueError, match="on purpose"):
        sweep([*impacts, broken], tmp_path, progress=False)
    assert sorted(pd.read_csv(tmp_path / "impacts.csv")["speed"]) == [0.05, 0.1]


def test_console_script():
    done = subprocess.run(
        [sys.executable, "-m", "plastigran.cli", "--help"],
        capture_output=True,
        text=True,
        check=True,
    )
    for command in ("impact", "laws", "timestep", "demo"):
        assert command in done.stdout
