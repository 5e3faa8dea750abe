# SPDX-License-Identifier: GPL-2.0-or-later
"""The in-tree route: the models in LIGGGHTS' own sources give what the plugin gives."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from plastigran import laws
from plastigran.engine.dumps import read_dump
from plastigran.engine.log import read_thermo
from plastigran.engine.process import command, inputs_folder
from plastigran.experiments.collide import IMPACTS
from plastigran.experiments.collision import measure

PROJECT = Path(__file__).parents[2]
INSTALL = PROJECT / "contact_models/in_tree/install.sh"
PLUGIN = PROJECT / "build/liggghts-plastigran"
MODELS = re.findall(
    r"^([a-z]\w*) ",
    (PROJECT / "contact_models/liggghts/plugin/laws.txt").read_text(),
    re.MULTILINE,
)
COMBINATIONS = len(
    re.findall(
        "^[A-Z]",
        (PROJECT / "contact_models/liggghts/plugin/combinations.txt").read_text(),
        re.MULTILINE,
    )
)
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


def test_the_ledger_is_the_plugins(in_tree, tmp_path):
    """Every account of an oblique impact on a mesh: its plastic work, its friction, its springs."""
    decks = PROJECT / "tests/ledger/decks"
    tables = []
    for program in (in_tree, PLUGIN):
        folder = tmp_path / Path(program).name
        folder.mkdir()
        words = command(decks / "impact.in", {"decks": decks, "geometry": "mesh"}, folder)
        words[0] = str(program)
        run = subprocess.run(words, cwd=folder, capture_output=True, text=True, errors="replace")
        assert run.returncode == 0, run.stdout[-3000:] + run.stderr[-3000:]
        tables.append(read_thermo(folder / "log.liggghts"))
    ours, plugins = tables
    began = plugins["kinetic"].iloc[0]
    for entry in ("plastic", "friction"):
        assert plugins[entry].iloc[-1] > 1e-3 * began
    assert list(ours) == list(plugins)
    for entry in ours:  # the accounts add up some hundred steps
        assert ours[entry].to_numpy() == pytest.approx(
            plugins[entry].to_numpy(), rel=1e-9, abs=TOLERANCE * began
        )


def test_heat_and_spectra_are_the_plugins(in_tree, tmp_path):
    """Of an oblique impact on a mesh, and of a gas."""
    heat, ledger, spectra = (
        PROJECT / "tests" / room / "decks" for room in ("heat", "ledger", "spectra")
    )
    decks = {
        heat / "impact.in": {"decks": ledger, "heat_decks": heat, "geometry": "mesh"},
        spectra / "gas.in": {"decks": spectra},
    }
    for deck, variables in decks.items():
        tables = []
        for program in (in_tree, str(PLUGIN)):
            folder = tmp_path / deck.stem / Path(program).name
            folder.mkdir(parents=True)
            words = command(deck, variables, folder)
            words[0] = program
            run = subprocess.run(
                words, cwd=folder, capture_output=True, text=True, errors="replace"
            )
            assert run.returncode == 0, run.stdout[-3000:] + run.stderr[-3000:]
            tables.append(read_thermo(folder / "log.liggghts"))
        ours, plugins = tables
        assert list(ours) == list(plugins)
        for entry in plugins:  # sums over some hundred steps
            scale = plugins[entry].abs().max()
            assert ours[entry].to_numpy() == pytest.approx(
                plugins[entry].to_numpy(), rel=1e-9, abs=1e-9 * scale
            ), entry


def slide(program, folder: Path, **variables: str):
    """The conformance suite's oblique impact of a spinning sphere; its end, or what was said."""
    folder.mkdir()
    deck = PROJECT / "tests/conformance/decks/slide.in"
    words = command(deck, {"law": "thornton", "spin": -50.0, **variables}, folder)
    words[0] = program
    run = subprocess.run(words, cwd=folder, capture_output=True, text=True, errors="replace")
    if run.returncode:
        return run.stdout + run.stderr
    return read_dump(folder / "trajectory.dump").iloc[-1]


def test_a_combination_of_any_models_is_the_plugins(in_tree, tmp_path):
    """Models that are not among the usual ones are compiled once, for all combinations."""
    ours, plugin = (
        slide(program, tmp_path / name, rolling="epsd")
        for program, name in ((in_tree, "in_tree"), (PLUGIN, "plugin"))
    )
    assert ours.to_numpy() == pytest.approx(plugin.to_numpy(), rel=TOLERANCE)
    assert ours["omegaz"] != slide(PLUGIN, tmp_path / "plain")["omegaz"]


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
    _, registered = files["registered.inc"]
    for law in MODELS:
        assert {f"plastigran/laws/{law}.h", f"law_{law}.cpp"} <= set(files)
        assert f"LAW({law})\n" in registered
    assert registered.count("COMBINATION(") == COMBINATIONS
    names = {Path(name).name for name in files}
    assert {"registration.cpp", "any_model.cpp", "energy_ledger.cpp"} <= names
    assert not {"plugin.cpp", "main.cpp"} & names
    assert not any("@" in text for name, (_, text) in files.items() if name.startswith("law_"))


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


def test_what_an_earlier_version_left_is_cleared(bare_tree):
    assert install(bare_tree).returncode == 0
    law = bare_tree / "src/law_one_of_before.cpp"
    law.write_text("// of plastigran\n")
    with open(bare_tree / "src/plastigran_files.txt", "a") as files:
        files.write(f"./{law.name}\n")
    assert install(bare_tree).returncode == 0
    assert not law.exists()


def test_a_model_of_a_fork_with_the_name_of_ours_stays(bare_tree):
    """Also in the list for the engine to compile."""
    model = bare_tree / "src/normal_model_stronge.h"
    model.write_text("// a fork's own\nNORMAL_MODEL(STRONGE,stronge,77)\n")
    whitelist = bare_tree / "src/style_contact_model_user.whitelist"
    whitelist.write_text("GRAN_MODEL(STRONGE, TANGENTIAL_OFF)\n")
    before = contents(bare_tree)
    assert install(bare_tree).returncode == 0
    after = contents(bare_tree)
    assert {name: after[name] for name in before} == before


def test_another_folder_is_refused_by_name(tmp_path):
    refusal = install(tmp_path)
    assert refusal.returncode != 0
    assert f"{tmp_path} is not a LIGGGHTS source tree" in refusal.stderr
    assert not list(tmp_path.iterdir())


def test_files_of_others_are_not_overwritten(bare_tree):
    (bare_tree / "src/range_check.cpp").write_text("// a fork's own\n")
    before = contents(bare_tree)
    refusal = install(bare_tree)
    assert refusal.returncode != 0
    assert "range_check.cpp" in refusal.stderr
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
