# SPDX-License-Identifier: GPL-2.0-or-later
"""The in-tree route: the models in LIGGGHTS' own sources give what the plugin gives."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from plastigran import laws
from plastigran.engine.process import command, inputs_folder
from plastigran.experiments.collide import IMPACTS
from plastigran.experiments.collision import measure

PROJECT = Path(__file__).parents[2]
INSTALL = PROJECT / "contact_models/in_tree/install.sh"
PLUGIN = PROJECT / "build/liggghts-plastigran"
MODELS = {
    match[2]: match[1]
    for header in sorted((PROJECT / "contact_models/liggghts/models").glob("*.h"))
    for match in re.finditer(r"^NORMAL_MODEL\((\w+), *(\w+),", header.read_text(), re.MULTILINE)
}
# Both programs compile the same files, with other optimisation and another layout of the
# engine's data. Rounding may differ, and some 1e4 steps may add it up to 1e-12; a property, a
# history value or a combination that went astray changes far earlier digits.
TOLERANCE = 1e-12


def collide(program, deck: str, law: str, output: Path):
    """Run a collision deck; what it did, and its log."""
    output.mkdir()
    log = output / "log.liggghts"
    script = inputs_folder() / "collision" / deck
    words = command(script, {"law": law, "dissipative_constant": 3e-5}, output)
    words[0] = program
    run = subprocess.run(words, cwd=output, capture_output=True, text=True, errors="replace")
    assert run.returncode == 0, run.stdout[-3000:] + run.stderr[-3000:]
    return measure(output / "trajectory.dump"), log.read_text()


@pytest.mark.parametrize(
    ("law", "deck"),
    [(law, f"{deck}.in") for law in MODELS for deck in IMPACTS[laws.LAWS[law].shape].geometries],
)
def test_restitution_is_the_plugins(in_tree, law, deck, tmp_path):
    ours, log = collide(in_tree, deck, law, tmp_path / "in_tree")
    plugin, _ = collide(PLUGIN, deck, law, tmp_path / "plugin")
    assert ours.coefficient_of_restitution == pytest.approx(
        plugin.coefficient_of_restitution, rel=TOLERANCE, abs=0
    )
    assert "not located in any whitelist" not in log  # compiled in, not the generic class


@pytest.fixture
def bare_tree(tmp_path):
    """A folder that looks like LIGGGHTS' sources to install.sh."""
    sources = tmp_path / "tree/src"
    sources.mkdir(parents=True)
    for name in ["Make.sh", "contact_models.h", "normal_model_base.h"]:
        (sources / name).touch()
    (sources / "version_liggghts.txt").write_text("3.8.0\n")
    return sources.parent


def install(tree: Path):
    return subprocess.run([INSTALL, tree], capture_output=True, text=True)


def contents(tree: Path):
    """Time and text of every file, by its path below src/."""
    sources = tree / "src"
    return {
        path.relative_to(sources).as_posix(): (path.stat().st_mtime_ns, path.read_text())
        for path in sources.rglob("*")
        if path.is_file()
    }


def test_every_model_is_installed(bare_tree):
    assert install(bare_tree).returncode == 0
    files = contents(bare_tree)
    _, whitelist = files["style_contact_model_user.whitelist"]
    for law, identifier in MODELS.items():
        assert {f"plastigran/laws/{law}.h", f"normal_model_{law}.h"} <= set(files)
        assert whitelist.count(f"GRAN_MODEL({identifier}, ") == 9
    names = {Path(name).name for name in files}
    assert not {"any_law.h", "registration.cpp", "plugin.cpp", "energy_ledger.h"} & names


def test_every_include_of_ours_is_installed(bare_tree):
    """A file is included by its way from the including one: the engine's builds know no other."""
    install(bare_tree)
    files = contents(bare_tree)
    included = [
        (bare_tree / "src" / name).parent / way
        for name, (_, text) in files.items()
        for way in re.findall(r'^#include "(.*)"', text, re.MULTILINE)
        if "plastigran/" in way or "liggghts/" in way
    ]
    assert len(included) > len(files)
    assert [path for path in included if not path.exists()] == []


def test_installing_twice_changes_nothing(bare_tree):
    install(bare_tree)
    before = contents(bare_tree)
    assert install(bare_tree).returncode == 0
    assert contents(bare_tree) == before


def test_lines_of_the_user_stay(bare_tree):
    whitelist = bare_tree / "src/style_contact_model_user.whitelist"
    theirs = "GRAN_MODEL(HERTZ, TANGENTIAL_OFF, COHESION_OFF, ROLLING_OFF, SURFACE_DEFAULT)"
    whitelist.write_text(theirs)  # no newline at the end
    install(bare_tree)
    assert whitelist.read_text().splitlines()[0] == theirs


def test_another_folder_is_refused_by_name(tmp_path):
    refusal = install(tmp_path)
    assert refusal.returncode != 0
    assert f"{tmp_path} is not a LIGGGHTS source tree" in refusal.stderr
    assert not list(tmp_path.iterdir())


def test_files_of_others_are_not_overwritten(bare_tree):
    (bare_tree / "src/range_watch.cpp").write_text("// a fork's own\n")
    before = contents(bare_tree)
    refusal = install(bare_tree)
    assert refusal.returncode != 0
    assert "range_watch.cpp" in refusal.stderr
    assert contents(bare_tree) == before


def test_cmake_component_installs_the_same(bare_tree, tmp_path):
    install(bare_tree)
    by_script = {name: data for name, (_, data) in contents(bare_tree).items()}
    other = tmp_path / "by_cmake"
    shutil.copytree(bare_tree, other)
    for name, (_, text) in contents(other).items():
        if "plastigran" in text or name.endswith(".whitelist"):
            (other / "src" / name).unlink()
    component = ["cmake", "--install", PROJECT / "build", "--component", "in-tree"]
    subprocess.run([*component, "--prefix", other / "src"], check=True, capture_output=True)
    assert {name: data for name, (_, data) in contents(other).items()} == by_script
