# SPDX-License-Identifier: GPL-2.0-or-later
"""The wheel works in an environment without LIGGGHTS and without the source tree.

The environment uses the libraries of the environment that runs the tests. `./run wheel` creates
another environment with downloaded libraries, and passes it in $PLASTIGRAN_WHEEL_VENV.
"""

from __future__ import annotations

import ast
import json
import os
import site
import subprocess
import sys
import venv
import zipfile
from fcntl import LOCK_EX, flock
from importlib.metadata import packages_distributions, requires, version
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from plastigran.engine.process import PROJECT

#: First cells of a notebook without LIGGGHTS.
NOTEBOOK = """
import numpy as np, plastigran as pg
from plastigran.physics.modes import sphere_modes
from plastigran.fem.theory.hertz import HertzSphere

assert pg.__file__.startswith(__import__("sys").prefix), pg.__file__
steel = pg.material("steel")
contact = pg.Contact("universal", steel, pg.RIGID, radius=5e-3)
path = contact.path(np.linspace(0, 2e-6, 50))
metal = pg.calibrate(youngs_modulus=206e9, poissons_ratio=0.3, density=7850, hardness="45HRC")
print(contact.restitution(0.1), path["force"].max(), metal.material.yield_strength)
path.plot("overlap", "force").figure.savefig("path.png")
try:
    pg.collide("thornton", 0.1, steel, radius=5e-3)
except Exception as error:
    print(error)
"""


def free_of_the_project() -> dict[str, str]:
    """Return environment variables without paths to LIGGGHTS or to the folder of this project."""
    variables = {k: v for k, v in os.environ.items() if not k.startswith(("PLASTIGRAN", "PYTHON"))}
    return variables | {"PATH": "/usr/bin:/bin", "MPLBACKEND": "agg"}


@pytest.fixture(scope="session")
def wheel(tmp_path_factory) -> Path:
    """The wheel; it is built in the build folder of the installed package."""
    folder = tmp_path_factory.mktemp("wheel")
    build = ["pip", "wheel", "-q", "--no-build-isolation", "--no-deps", "--no-index"]
    with open(PROJECT / "build" / "wheel.lock", "w") as lock:
        flock(lock, LOCK_EX)
        subprocess.run([sys.executable, "-m", *build, "-w", folder, PROJECT], check=True)
    (made,) = folder.glob("*.whl")
    return made


@pytest.fixture(scope="session")
def here(wheel, tmp_path_factory) -> Path:
    """Folder of an environment in which the wheel is installed."""
    if clean := os.environ.get("PLASTIGRAN_WHEEL_VENV"):
        return Path(clean)
    folder = tmp_path_factory.mktemp("environment")
    venv.create(folder, with_pip=False, symlinks=True)
    target = next(folder.glob("lib/python*/site-packages"))
    install = ["install", "-q", "--no-deps", "--no-index", wheel]
    subprocess.run(
        [sys.executable, "-m", "pip", "--python", folder / "bin/python", *install], check=True
    )
    # Python searches the folders of a .pth file after the folder of the wheel. It ignores .pth
    # files in these folders, one of which has the path to the folder of this project.
    (target / "libraries.pth").write_text("\n".join(site.getsitepackages()) + "\n")
    return folder


@pytest.fixture
def run(here, tmp_path):
    """`run(program, *words)` runs a program of the environment in an empty folder."""

    def start(program: str, *words: str) -> subprocess.CompletedProcess:
        line = [here / "bin" / program, *words]
        return subprocess.run(
            line, cwd=tmp_path, env=free_of_the_project(), capture_output=True, text=True
        )

    return start


def test_one_wheel_serves_every_python_from_3_11(wheel):
    assert wheel.name.startswith(f"plastigran-{version('plastigran')}-cp311-abi3-")
    inside = zipfile.ZipFile(wheel).namelist()
    for name in ("laws.abi3.so", "laws.pyi", "py.typed", "inputs/materials/steel.in"):
        assert f"plastigran/{name}" in inside
    assert not [name for name in inside if name.startswith(("tests/", "contact_models/"))]


def test_all_imported_libraries_are_required():
    """Each imported library is a dependency, or a dependency of an extra."""
    required = {canonicalize_name(Requirement(line).name) for line in requires("plastigran")}
    distributions, missing = packages_distributions(), set()
    for path in (PROJECT / "postprocess" / "plastigran").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            names += [node.module] if isinstance(node, ast.ImportFrom) and not node.level else []
            for name in {name.partition(".")[0] for name in names} - sys.stdlib_module_names:
                providers = set(map(canonicalize_name, distributions.get(name, [name])))
                if not providers & (required | {"plastigran"}):
                    missing.add((path.name, name))
    assert missing == set()


def test_laws(run):
    done = run("plastigran", "laws")
    assert done.returncode == 0, done.stderr
    assert "universal" in done.stdout


def test_impact_by_theory(run, tmp_path):
    line = ["--law", "all", "--material", "steel", "--radius", "0.005", "--points", "4"]
    done = run("plastigran", "impact", *line, "--theory", "--output", "out", "--json")
    assert done.returncode == 0, done.stderr
    assert len({row["law"] for row in json.loads(done.stdout)["table"]}) > 10
    assert (tmp_path / "out" / "restitution.png").exists()


def test_calibrate(run):
    metal = ["--young", "206e9", "--poisson", "0.3", "--density", "7850", "--hardness", "45HRC"]
    done = run("plastigran", "calibrate", *metal, "--json")
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["yield_strength"] == pytest.approx(1.685e9, rel=1e-3)


@pytest.mark.parametrize(
    "line", ["impact --law thornton", "bulk hopper", "rod --law thornton", "demo", "doctor"]
)
def test_a_command_without_liggghts_names_the_remedy_in_one_line(run, line):
    done = run("plastigran", *line.split())
    assert done.returncode == 1
    assert done.stderr.count("\n") == 1, done.stderr
    assert "LIGGGHTS" in done.stderr
    assert "./run setup" in done.stderr + done.stdout


def test_a_notebook(run, tmp_path):
    done = run("python", "-c", NOTEBOOK)
    assert done.returncode == 0, done.stderr
    assert "LIGGGHTS is missing: liggghts-plastigran is not on PATH" in done.stdout
    assert (tmp_path / "path.png").exists()
