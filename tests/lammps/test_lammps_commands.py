# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the commands that start LAMMPS, and of the LAMMPS scripts in inputs/lammps."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest

from plastigran.cli import main
from plastigran.engine.process import PROJECT

LAMMPS = [sys.executable, "-m", "plastigran", "lammps"]


@pytest.mark.parametrize("script", sorted((PROJECT / "inputs" / "lammps").glob("*.in")))
def test_input_scripts_run_on_two_ranks(script, tmp_path):
    line = [*LAMMPS, "-in", script, "--ranks", "2", "-var", "inputs", PROJECT / "inputs"]
    line += ["-var", "steps", "10"] if "variable steps index" in script.read_text() else []
    subprocess.run(line, cwd=tmp_path, check=True, capture_output=True)
    assert "Loop time" in (tmp_path / "log.lammps").read_text()


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("-in none.in", "the input script none.in does not exist"),
        (f"-in {PROJECT}/inputs/lammps/balls.in --ranks 0", "--ranks is 0; it must be 1 or more"),
    ],
)
def test_a_wrong_command_line_is_refused(words, message, capsys):
    assert main(["lammps", *words.split()]) == 1
    assert message in capsys.readouterr().err


def test_a_missing_plugin_is_named(monkeypatch, tmp_path, capsys):
    monkeypatch.setenv("PLASTIGRAN_LAMMPS_PLUGIN", str(tmp_path / "none.so"))
    assert main(["lammps", "-in", f"{PROJECT}/inputs/lammps/balls.in"]) == 1
    assert f"the LAMMPS plugin is not at {tmp_path / 'none.so'}" in capsys.readouterr().err


def test_impacts_record_their_host(tmp_path, capsys):
    words = "impact --host lammps --law thornton --material steel --radius 0.005 --speed 0.1"
    line = [*words.split(), "--output", str(tmp_path / "impacts")]
    assert main([*line, "--dry-run"]) == 0
    commands = capsys.readouterr().out
    assert main(line) == 0
    record = json.loads((tmp_path / "impacts" / "study.json").read_text())
    assert record["settings"]["host"] == record["versions"]["host"] == "lammps"
    assert "plastigranplugin.so sha256" in record["versions"]["plugin"]
    (run,) = (tmp_path / "impacts" / "runs").iterdir()
    trajectory = (run / "trajectory.dump").read_bytes()
    subprocess.run(commands.partition("1 runs")[0], shell=True, check=True, capture_output=True)
    assert (run / "trajectory.dump").read_bytes() == trajectory
    assert main([*line, "--force", "--geometry", "sphere_mesh"]) == 1
    assert "geometry is sphere_mesh; in LAMMPS, it must be one of" in capsys.readouterr().err
