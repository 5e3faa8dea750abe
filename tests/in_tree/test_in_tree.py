# SPDX-License-Identifier: GPL-2.0-or-later
"""Models in LIGGGHTS' source tree give the same results as the plugin, and can be installed."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest
from engine_laws import IN_TREE_LAWS, MODELS

from plastigran import laws
from plastigran.engine.dumps import read_dump
from plastigran.engine.log import read_thermo
from plastigran.engine.process import command, inputs_folder
from plastigran.experiments.collide import IMPACTS
from plastigran.experiments.collision import measure
from plastigran.materials import has_surface_energy

TESTS = Path(__file__).parents[1]
PROJECT = TESTS.parent
INSTALL = PROJECT / "contact_models/in_tree/install.sh"
PLUGIN = PROJECT / "build/liggghts-plastigran"
COMBINATIONS = len(
    re.findall(
        "^[A-Z]",
        (PROJECT / "contact_models/liggghts/plugin/combinations.txt").read_text(),
        re.MULTILINE,
    )
)
# Relative tolerance. LIGGGHTS with the models in its source tree and the plugin contain the same
# files, compiled with different optimization and data layout. Round-off therefore differs and may
# accumulate to 1e-12 in 1e4 steps. A wrong property, history value or combination would have a much
# larger effect.
TOLERANCE = 1e-12


def run(program, deck: Path, variables: dict[str, object], folder: Path):
    """Run a deck in a new folder with a LIGGGHTS program."""
    folder.mkdir(parents=True)
    words = [str(program), *command(deck, variables, folder)[1:]]
    return subprocess.run(words, cwd=folder, capture_output=True, text=True, errors="replace")


def run_both(in_tree, deck: Path, variables: dict[str, object], folder: Path) -> tuple[Path, Path]:
    """Run a deck with the in-tree build and with the plugin; return the folders of both runs."""
    folders = folder / "in_tree", folder / "plugin"
    for program, place in zip((in_tree, PLUGIN), folders, strict=True):
        done = run(program, deck, variables, place)
        assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-3000:]
    return folders


@pytest.mark.parametrize(
    ("law", "deck"),
    [
        (law, f"{deck}.in")
        for law in IN_TREE_LAWS
        for deck in IMPACTS[laws.LAWS[law].shape].geometries
    ],
)
def test_restitution_is_that_of_the_plugin(in_tree, law, deck, tmp_path):
    variables = {"law": law, "dissipative_constant": 3e-5}
    if has_surface_energy(law):
        variables["surface_energy"] = 10.0
    folders = run_both(in_tree, inputs_folder() / "collision" / deck, variables, tmp_path)
    ours, plugin = (
        measure(folder / "trajectory.dump").coefficient_of_restitution for folder in folders
    )
    assert ours == pytest.approx(plugin, rel=TOLERANCE, abs=0)
    # The law is compiled in, so LIGGGHTS does not use the generic class.
    assert "not located in any whitelist" not in (folders[0] / "log.liggghts").read_text()


LEDGER, HEAT, SPECTRA = (TESTS / name / "decks" for name in ("ledger", "heat", "spectra"))


@pytest.mark.parametrize(
    ("deck", "variables"),
    [
        (LEDGER / "impact.in", {"decks": LEDGER, "geometry": "mesh"}),
        (HEAT / "impact.in", {"decks": LEDGER, "heat_decks": HEAT, "geometry": "mesh"}),
        (SPECTRA / "gas.in", {"decks": SPECTRA}),
    ],
    ids=["energy balance", "heat", "collision spectra"],
)
def test_outputs_are_those_of_the_plugin(in_tree, deck, variables, tmp_path):
    """The in-tree build and the plugin give the same energies, heat and collision spectra.

    Energies and heat are from an oblique impact on a mesh, the spectra from a gas.
    """
    ours, plugin = (
        read_thermo(folder / "log.liggghts")
        for folder in run_both(in_tree, deck, variables, tmp_path)
    )
    assert list(ours) == list(plugin)
    energy_balance = deck.parent == LEDGER
    if energy_balance:
        for term in ("plastic", "friction"):
            assert plugin[term].iloc[-1] > 1e-3 * plugin["kinetic"].iloc[0]
    for name in plugin:  # 1e-9: round-off of hundreds of steps
        scale = plugin[name].abs().max()
        allowed = TOLERANCE * plugin["kinetic"].iloc[0] if energy_balance else 1e-9 * scale
        expected = pytest.approx(plugin[name].to_numpy(), rel=1e-9, abs=allowed)
        assert ours[name].to_numpy() == expected, name


def test_a_combination_of_any_models_is_that_of_the_plugin(in_tree, tmp_path):
    """A combination of models that is not in combinations.txt gives the results of the plugin.

    LIGGGHTS uses the generic class for such combinations.
    """
    deck = TESTS / "conformance/decks/slide.in"
    variables = {"law": "thornton", "spin": -50.0}
    ours, plugin = (
        read_dump(folder / "trajectory.dump").iloc[-1]
        for folder in run_both(in_tree, deck, variables | {"rolling": "epsd"}, tmp_path)
    )
    assert ours.to_numpy() == pytest.approx(plugin.to_numpy(), rel=TOLERANCE)
    assert run(PLUGIN, deck, variables, tmp_path / "plain").returncode == 0
    assert ours["omegaz"] != read_dump(tmp_path / "plain" / "trajectory.dump").iloc[-1]["omegaz"]


def make_tree(folder: Path) -> Path:
    """Make a folder that install.sh accepts as LIGGGHTS' sources."""
    sources = folder / "tree/src"
    sources.mkdir(parents=True)
    for name in ["Make.sh", "contact_models.h", "normal_model_base.h"]:
        (sources / name).touch()
    (sources / "version_liggghts.txt").write_text("3.8.0\n")
    return sources.parent


@pytest.fixture
def bare_tree(tmp_path):
    return make_tree(tmp_path)


def install(tree: Path):
    return subprocess.run([INSTALL, tree], capture_output=True, text=True)


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """A source tree with the models of this project; tests must not change it."""
    tree = make_tree(tmp_path_factory.mktemp("installed"))
    assert install(tree).returncode == 0
    return tree


@pytest.fixture
def installed_copy(installed, tmp_path):
    """A copy of `installed`; the files keep their modification times."""
    return shutil.copytree(installed, tmp_path / "tree")


def contents(tree: Path):
    """Return the modification time [ns] and text of every file, by its path in src/."""
    sources = tree / "src"
    return {
        path.relative_to(sources).as_posix(): (path.stat().st_mtime_ns, path.read_text())
        for path in sources.rglob("*")
        if path.is_file()
    }


def test_every_model_is_installed(installed):
    files = contents(installed)
    _, registered = files["registered.inc"]
    for law in MODELS:
        assert {f"plastigran/laws/{law}.h", f"law_{law}.cpp"} <= set(files)
        assert f"LAW({law})\n" in registered
    assert registered.count("COMBINATION(") == COMBINATIONS
    names = {Path(name).name for name in files}
    assert {"registration.cpp", "any_model.cpp", "energy_ledger.cpp"} <= names
    assert not {"plugin.cpp", "main.cpp"} & names
    assert not any("@" in text for name, (_, text) in files.items() if name.startswith("law_"))


def test_every_include_of_ours_is_installed(installed):
    """Every header of this project that an installed file includes is installed.

    Paths are relative to the including file, because builds of LIGGGHTS set no include path.
    """
    files = contents(installed)
    included = [
        (installed / "src" / name).parent / path
        for name, (_, text) in files.items()
        for path in re.findall(r'^#include "(.*)"', text, re.MULTILINE)
        if "plastigran/" in path or "liggghts/" in path
    ]
    assert len(included) > len(files)
    assert [path for path in included if not path.exists()] == []


def test_installing_twice_changes_nothing(installed_copy):
    before = contents(installed_copy)
    assert install(installed_copy).returncode == 0
    assert contents(installed_copy) == before


def test_files_of_an_earlier_version_are_removed(installed_copy):
    law = installed_copy / "src/law_of_an_earlier_version.cpp"
    law.write_text("// of plastigran\n")
    with open(installed_copy / "src/plastigran_files.txt", "a") as files:
        files.write(f"./{law.name}\n")
    assert install(installed_copy).returncode == 0
    assert not law.exists()


def test_a_model_of_a_fork_with_the_same_name_stays(bare_tree):
    """If a fork of LIGGGHTS has its own model with the name of a law, this model stays.

    It also stays in the list of models to compile.
    """
    model = bare_tree / "src/normal_model_stronge.h"
    model.write_text("// of a fork\nNORMAL_MODEL(STRONGE,stronge,77)\n")
    whitelist = bare_tree / "src/style_contact_model_user.whitelist"
    whitelist.write_text("GRAN_MODEL(STRONGE, TANGENTIAL_OFF)\n")
    before = contents(bare_tree)
    assert install(bare_tree).returncode == 0
    after = contents(bare_tree)
    assert {name: after[name] for name in before} == before


def test_another_folder_is_refused_by_name(tmp_path):
    done = install(tmp_path)
    assert done.returncode != 0
    assert f"{tmp_path} is not a LIGGGHTS source tree" in done.stderr
    assert not list(tmp_path.iterdir())


def test_files_of_others_are_not_overwritten(bare_tree):
    (bare_tree / "src/range_check.cpp").write_text("// of a fork\n")
    before = contents(bare_tree)
    done = install(bare_tree)
    assert done.returncode != 0
    assert "range_check.cpp" in done.stderr
    assert contents(bare_tree) == before


def test_cmake_component_installs_the_same(installed, bare_tree):
    by_script = {name: data for name, (_, data) in contents(installed).items()}
    component = ["cmake", "--install", PROJECT / "build", "--component", "in-tree"]
    subprocess.run([*component, "--prefix", bare_tree / "src"], check=True, capture_output=True)
    assert {name: data for name, (_, data) in contents(bare_tree).items()} == by_script
