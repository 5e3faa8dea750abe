# SPDX-License-Identifier: GPL-2.0-or-later
"""Another project can use the installed headers of the laws."""

from __future__ import annotations

import io
import os
import subprocess
from pathlib import Path

import pandas as pd
import pytest

import plastigran as pg
from plastigran.engine.process import PROJECT

COLOURLESS = os.environ | {"CLICOLOR_FORCE": "0"}


def cmake(*words: object) -> subprocess.CompletedProcess:
    line = ["cmake", *map(str, words)]
    return subprocess.run(line, capture_output=True, text=True, env=COLOURLESS)


def install(component: str, prefix: Path) -> None:
    done = cmake("--install", PROJECT / "build", "--component", component, "--prefix", prefix)
    assert done.returncode == 0, done.stderr


@pytest.fixture(scope="module")
def prefix(tmp_path_factory) -> Path:
    """Folder of the installed headers, whose path has a space."""
    folder = tmp_path_factory.mktemp("installed") / "a prefix"
    install("laws", folder)
    return folder


def test_the_example_project_finds_and_uses_them(prefix, tmp_path):
    configure = ["-S", PROJECT / "examples" / "cmake", "-B", tmp_path / "build", "-G", "Ninja"]
    done = cmake(*configure, f"-DCMAKE_PREFIX_PATH={prefix}")
    assert done.returncode == 0, done.stderr
    done = cmake("--build", tmp_path / "build")
    assert done.returncode == 0, done.stdout
    program = subprocess.run([tmp_path / "build" / "restitution"], capture_output=True, text=True)
    found = pd.read_csv(io.StringIO(program.stdout))
    ball = pg.Contact("universal", "steel", pg.RIGID, radius=5e-3)
    expected = ball.law.central_impact(ball.radius_eff, ball.mass_eff, found["speed"].to_numpy())
    # The program is compiled without optimization, so round-off differs.
    assert found["coefficient_of_restitution"].to_numpy() == pytest.approx(
        expected.coefficient_of_restitution, rel=1e-9
    )


def test_a_version_of_another_kind_is_refused(prefix, tmp_path):
    (tmp_path / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.18)\nproject(theirs LANGUAGES CXX)\n"
        "find_package(plastigran 7 REQUIRED)\n"
    )
    done = cmake("-S", tmp_path, "-B", tmp_path / "build", f"-DCMAKE_PREFIX_PATH={prefix}")
    assert done.returncode != 0
    assert 'compatible with requested version "7"' in " ".join(done.stderr.split())


def test_plugin_and_launcher_run_from_where_they_are_installed(tmp_path, monkeypatch):
    install("plugin", tmp_path / "opt")
    monkeypatch.setenv("PLASTIGRAN_ENGINE", str(tmp_path / "opt" / "bin" / "liggghts-plastigran"))
    loaded = subprocess.run(
        ["ldd", tmp_path / "opt/bin/liggghts-plastigran"], capture_output=True, text=True
    )
    assert str(tmp_path / "opt/lib/libplastigran.so") in loaded.stdout.replace("bin/../", "")
    runs = pg.collide("thornton", 0.1, "steel", radius=5e-3)
    (row,) = runs.table.to_dict("records")
    # The recommended time step allows an error of restitution of 1e-3.
    assert row["coefficient_of_restitution"] == pytest.approx(
        row["coefficient_of_restitution_predicted"], rel=1e-3
    )
