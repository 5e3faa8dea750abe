# SPDX-License-Identifier: GPL-2.0-or-later
"""Help, JSON, dry runs, completion, one-line errors and progress of all commands."""

from __future__ import annotations

import json
import os
import pty
import resource
import shlex
import subprocess
import sys
import termios
from contextlib import suppress

import numpy as np
import pandas as pd
import pytest
from commands import all_commands

from plastigran import laws
from plastigran.bulk.deck import Analysis
from plastigran.bulk.outcome import BulkRun
from plastigran.cli import EXIT_CODES, main, parser
from plastigran.cli.arguments import print_json
from plastigran.cli.commands import doctor
from plastigran.cli.commands.bulk import warnings_of
from plastigran.experiments.central import CentralImpact
from plastigran.progress import ProgressBar


def test_every_command_has_a_valid_example():
    top = parser()
    for command in all_commands(top):
        head, marker, example = command.format_help().partition("example:\n")
        assert marker, command.prog
        assert "-v" in head or "--verbose" in head
        lines = example.replace("\\\n", "").strip().splitlines()
        own = [shlex.split(line.partition(">")[0]) for line in lines]
        assert any(line[: len(command.prog.split())] == command.prog.split() for line in own)
        for words in own:
            top.parse_args(words[1:])  # exits if it is invalid


def test_help_lists_the_exit_codes(capsys):
    with pytest.raises(SystemExit) as stop:
        main(["--help"])
    assert stop.value.code == 0
    said = capsys.readouterr().out
    for code, meaning in EXIT_CODES.items():
        assert f"{code:<4d}{meaning}" in said


def test_tables_as_json(capsys):
    assert main(["laws", "--json"]) == 0
    listed = {row["law"]: row for row in json.loads(capsys.readouterr().out)}
    assert listed.keys() == laws.LAWS.keys()
    assert listed["viscoelastic_hertz"]["constants"][0]["name"] == "dissipativeConstant"
    assert main(["timestep", "--law", "thornton", "--speed", "0.1", "--json"]) == 0
    (row,) = json.loads(capsys.readouterr().out)
    assert row == {"law": "thornton", "timestep": pytest.approx(1.835e-5, rel=1e-2)}
    line = ["timestep", "--law", "thornton", "--speed", "0.1", "--wall", "steel"]
    assert main([*line, "--json"]) == 0
    (softer,) = json.loads(capsys.readouterr().out)
    case = CentralImpact("thornton", 0.1, "aluminium_zv02", 0.1, wall="steel")
    assert softer["timestep"] == case.timestep > row["timestep"]
    assert main([*line, "--geometry", "two_spheres"]) == 1
    assert "wall is steel, but two_spheres has no wall" in capsys.readouterr().err
    assert main(["modes", "--material", "ice", "--radius", "0.01", "--json"]) == 0
    assert {"kind", "degree", "frequency"} <= json.loads(capsys.readouterr().out)[0].keys()


def test_json_has_null_for_unknown_and_infinite_numbers(capsys):
    print_json({"known": [1.5, np.float64(2)], "not": (np.nan, np.inf, -np.inf)})
    assert json.loads(capsys.readouterr().out) == {"known": [1.5, 2.0], "not": [None] * 3}


def test_similar_warnings_are_reported_once_with_the_worst_value(tmp_path):
    """Of warnings that differ only in their numbers, only the one with the worst value is reported.

    Warnings of fixes are included.
    """
    said = [
        "plastigran: model thornton: an overlap of 1.5e-6 m, step 10 (../pair.cpp:12)",
        "plastigran: energy_ledger: an atom was lost (../fix.cpp:1)",
        "plastigran: model thornton: an overlap of 2e-05 m, step 300 (../pair.cpp:12)",
        "Less insertions than requested (../insert.cpp:3)",
        "plastigran: pair_style: contacts continue with other constants: a is now b (../k.cpp:7)",
        "plastigran: fix wall/gran: particle 3 at (0 0 1) touches mesh triangles (../watch.cpp:9)",
        "plastigran: fix floor: contacts start without history (../keeper.cpp:8)",
        "fix particletemplate/sphere: the engine's own (../particle.cpp:8)",
    ]
    (tmp_path / "log.liggghts").write_text("".join(f"WARNING: {line}\n" for line in said))
    run = BulkRun("hopper", tmp_path, None, Analysis(pd.DataFrame()))
    assert warnings_of(run) == [
        "model thornton: an overlap of 2e-05 m, step 300",
        "energy_ledger: an atom was lost",
        "pair_style: contacts continue with other constants: a is now b",
        "fix wall/gran: particle 3 at (0 0 1) touches mesh triangles",
        "fix floor: contacts start without history",
    ]


def test_impact_by_theory_needs_no_engine(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("PLASTIGRAN_ENGINE", str(tmp_path / "none"))
    line = ["impact", "--law", "thornton", "universal", "--speed", "0.02", "0.2", "--theory"]
    line += ["--output", str(tmp_path / "out")]
    assert main([*line, "--jobs", "2"]) == 1
    message = "--jobs is 2, but --theory does not start LIGGGHTS. Remove --jobs"
    assert message in capsys.readouterr().err
    assert main([*line, "--dry-run"]) == 1
    assert "--theory needs no LIGGGHTS" in capsys.readouterr().err
    assert main([*line, "--json"]) == 0
    table = json.loads(capsys.readouterr().out)["table"]
    assert [(row["law"], row["speed"]) for row in table] == [
        ("thornton", 0.02),
        ("thornton", 0.2),
        ("universal", 0.02),
        ("universal", 0.2),
    ]
    assert all(0 < row["coefficient_of_restitution"] < 1 for row in table)
    for name in ("restitution", "loops"):
        assert (tmp_path / "out" / f"{name}.png").read_bytes().startswith(b"\x89PNG")
    assert main(line) == 1
    assert "or overwrite them with --force" in capsys.readouterr().err
    assert main([*line, "--force"]) == 0


def test_dry_runs_print_commands_and_write_nothing(tmp_path, capsys):
    folder = tmp_path / "with a space"
    line = ["--output", str(folder), "--dry-run"]
    assert main(["bulk", "cooling_gas", "--ranks", "2", "-v", "side=4", *line]) == 0
    place, typed, _ = capsys.readouterr().out.splitlines()
    # If the path of the input scripts has a space, a command between `mkdir` and `cd` creates a
    # link to them.
    steps = shlex.split(place)
    assert steps[:4] == ["mkdir", "-p", str(folder), "&&"]
    assert steps[-2:] == ["cd", str(folder)]
    words = shlex.split(typed)
    assert words[:4] == ["mpirun", "--oversubscribe", "-np", "2"]
    assert words[-3:] == ["-var", "side", "4"]
    assert main(["bulk", "ball_impact", *line]) == 0
    needed = f"reads initial positions, which `bulk` writes to {folder} first"
    assert needed in capsys.readouterr().out
    assert main(["impact", "--law", "thornton", "--points", "3", *line]) == 0
    assert "3 runs; nothing was started" in capsys.readouterr().out
    assert not folder.exists()


def test_a_limit_of_file_sizes_names_the_folder(tmp_path, capsys):
    """The message for a file above the size limit names the folder; Python's own names no file."""
    output = tmp_path / "out"
    line = ["impact", "--law", "thornton", "--theory", "--speed", "1", "--output", str(output)]
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, limits[1]))
    try:
        assert main(line) == 1
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    said = capsys.readouterr().err
    assert f"cannot write a file in {output}: File too large. Free space there" in said


def test_a_material_file_without_its_suffix_gets_a_hint(tmp_path, monkeypatch, capsys):
    (tmp_path / "own.in").write_text("")
    monkeypatch.chdir(tmp_path)
    assert main(["modes", "--material", "./own", "--radius", "1"]) == 1
    assert (
        "no material './own'. To use the file in this folder, give its full name own.in."
        in capsys.readouterr().err
    )


def test_an_internal_error_is_one_line_and_with_v_a_trace(monkeypatch, capsys):
    monkeypatch.setattr("plastigran.cli.commands.modes.sphere_modes", lambda *_: 1 / 0)
    line = ["modes", "--material", "ice", "--radius", "0.1"]
    assert main(line) == 70
    said = capsys.readouterr().err
    assert said.startswith(
        "plastigran: internal error, ZeroDivisionError: division by zero. Repeat"
    )
    assert said.count("\n") == 1
    assert main([*line, "-v"]) == 70
    assert "Traceback" in capsys.readouterr().err


@pytest.mark.parametrize("shell", ["bash", "zsh"])
def test_completion_has_every_command(shell, capsys):
    assert main(["completion", shell]) == 0
    script = capsys.readouterr().out
    for command in all_commands(parser()):
        assert command.prog.split()[-1] in script
    assert "--dry-run" in script


def test_bash_completes(capsys):
    assert main(["completion", "bash"]) == 0
    script = capsys.readouterr().out
    asked = 'COMP_WORDS=(plastigran timestep --geom); COMP_CWORD=2; COMP_TYPE=9; COMP_LINE="x"\n'
    told = "_shtab_plastigran plastigran --geom timestep\necho ${COMPREPLY[@]}\n"
    done = subprocess.run(
        ["bash"], input=script + asked + told, capture_output=True, text=True, check=True
    )
    assert done.stdout.split()[-1] == "--geometry"


def test_doctor_runs_an_impact(capsys):
    """`doctor` runs its test impact on one MPI rank and on two, if all parts are installed."""
    assert main(["doctor", "--json"]) == 0
    found = {row["name"]: row for row in json.loads(capsys.readouterr().out)}
    assert {found[name]["state"] for name in ("engine", "plugin", "impact", "MPI")} == {"ok"}
    assert "LIGGGHTS-PUBLIC 3.8.0: restitution 0.42" in found["impact"]["said"]


def test_doctor_reports_a_missing_engine(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("PLASTIGRAN_ENGINE", str(tmp_path / "none"))
    assert main(["doctor"]) == 1
    said = capsys.readouterr()
    assert (
        f"lacks   engine      LIGGGHTS is not at {tmp_path / 'none'}. Run `./run setup` to build it"
        in said.out
    )
    assert "failed check: engine. Apply the remedy" in said.err


def test_doctor_does_not_need_lammps(monkeypatch):
    assert doctor.lammps().state == "ok"
    monkeypatch.setenv("PLASTIGRAN_LAMMPS", "/does/not/exist")
    assert doctor.lammps().state == "without"


def test_doctor_reports_a_missing_library(monkeypatch):
    asked = ["numpy>=2", "no-such-library>=1", 'also-missing>=3; extra == "test"']
    monkeypatch.setattr(doctor, "requires", lambda name: asked)
    found = doctor.libraries()
    assert (found.state, found.said) == ("lacks", "no-such-library is not installed")
    assert found.remedy == "pip install no-such-library"
    monkeypatch.undo()
    found = doctor.libraries()
    assert found.state == "ok"
    assert {"plotly", "jinja2", "pillow"} <= {said.split()[0] for said in found.said.split(", ")}


@pytest.mark.engine
def test_doctor_finds_a_plugin_of_another_version(monkeypatch):
    monkeypatch.setattr(doctor, "TOLERANCE", 1e-9)  # LIGGGHTS then appears to differ from theory
    found = {finding.name: finding for finding in doctor.examine()}
    assert found["impact"].state == "lacks"
    assert "by theory" in found["impact"].said
    assert "MPI" not in found


def test_progress_in_a_pipe_is_lines_and_nothing_for_short_work(monkeypatch, capsys):
    with ProgressBar(total=4, desc="brief") as bar:
        bar.update(4)
    assert capsys.readouterr().err == ""
    monkeypatch.setattr("plastigran.progress.FIRST", 0.0)
    monkeypatch.setattr("plastigran.progress.EVERY", 0.0)
    with ProgressBar(total=4, desc="impact", unit="impacts") as bar:
        for _ in range(4):
            bar.update()
    lines = capsys.readouterr().err.splitlines()
    assert lines[-1].startswith("impact: 4/4 impacts, 00:0")
    assert not any("\r" in line or "\x1b" in line for line in lines)


BAR = "from plastigran.progress import ProgressBar as Bar; [*Bar('abc', desc='here')]"


@pytest.mark.parametrize("line", [["-m", "plastigran", "impact", "--help"], ["-c", BAR]])
def test_no_output_has_colours(line):
    """Help and progress bars have no colors, even on a terminal with FORCE_COLOR."""
    ours, theirs = pty.openpty()
    termios.tcsetwinsize(theirs, (24, 80))
    run = [sys.executable, *line]
    wanted = {"PATH": os.environ["PATH"], "TERM": "xterm-256color", "FORCE_COLOR": "1"}
    with os.fdopen(ours, "rb", buffering=0) as terminal:
        started = subprocess.Popen(run, stdin=theirs, stdout=theirs, stderr=theirs, env=wanted)
        os.close(theirs)
        said = b""
        with suppress(OSError):  # reading fails when the terminal closes
            while more := terminal.read(65536):
                said += more
        assert started.wait() == 0
    assert b"default 0.1" in said or b"here: 100%" in said
    assert b"\x1b" not in said
