# SPDX-License-Identifier: GPL-2.0-or-later
"""Committed meshes are what the scripts beside them make."""

from __future__ import annotations

import shutil
import subprocess
import sys

import pytest

from plastigran.engine.process import inputs_folder

FOLDER = inputs_folder() / "meshes"
SCRIPTS = sorted(FOLDER.glob("make_*.py"))


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda script: script.stem)
def test_committed_mesh_is_its_scripts(script, tmp_path):
    for file in (script, FOLDER / "stl.py"):
        shutil.copy(file, tmp_path)
    subprocess.run([sys.executable, tmp_path / script.name], check=True)
    made = sorted(tmp_path.glob("*.stl"))
    assert made
    for mesh in made:
        assert mesh.read_text() == (FOLDER / mesh.name).read_text()


@pytest.mark.parametrize("orifice", ["wide", "1.2", "9", "nan"])
def test_hopper_with_an_impossible_orifice_is_refused(orifice, tmp_path):
    for name in ("make_hopper.py", "stl.py"):
        shutil.copy(FOLDER / name, tmp_path)
    line = [sys.executable, tmp_path / "make_hopper.py", orifice]
    done = subprocess.run(line, capture_output=True, text=True)
    assert done.returncode == 1
    assert f"orifice {orifice}: it must be a number above 1.4, at most 8" in done.stderr
    assert not list(tmp_path.glob("*.stl"))
