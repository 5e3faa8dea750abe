# SPDX-License-Identifier: GPL-2.0-or-later
"""The mesh files of the decks equal the output of the scripts that create them."""

from __future__ import annotations

import shutil
import subprocess
import sys

import pytest

from plastigran.engine.process import inputs_folder

FOLDER = inputs_folder() / "meshes"
SCRIPTS = sorted(FOLDER.glob("make_*.py"))


@pytest.fixture
def elsewhere(tmp_path):
    """Copy of the folder with the scripts that create meshes, without the meshes."""
    without = shutil.ignore_patterns("*.stl")
    return shutil.copytree(inputs_folder(), tmp_path / "inputs", ignore=without) / "meshes"


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda script: script.stem)
def test_committed_mesh_is_its_scripts(script, elsewhere):
    subprocess.run([sys.executable, elsewhere / script.name], check=True)
    made = sorted(elsewhere.glob("*.stl"))
    assert made
    for mesh in made:
        assert mesh.read_text() == (FOLDER / mesh.name).read_text()


@pytest.mark.parametrize("orifice", ["wide", "1.2", "9", "nan"])
def test_hopper_with_an_impossible_orifice_is_refused(orifice, elsewhere):
    line = [sys.executable, elsewhere / "make_hopper.py", orifice]
    done = subprocess.run(line, capture_output=True, text=True)
    assert done.returncode == 1
    assert f"orifice is {orifice}; it must be a number above 1.4 and at most 8" in done.stderr
    assert not list(elsewhere.glob("*.stl"))
