# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs of users' input scripts: folders, copies of their files, interruption and continuation."""

from __future__ import annotations

import json
import re
import shutil
import signal
import time
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose
from own_decks import PLAIN, START, finished_run, table

import plastigran as pg
from plastigran.bulk.plan import plan_bulk
from plastigran.bulk.run import run_bulk
from plastigran.bulk.template import write_deck
from plastigran.cli import main
from plastigran.engine.process import PROJECT, EngineError

CANNOT_CONTINUE = (
    r"plain\.in has no setting 'start', so it cannot continue.* `start` .* `checkpoint` .*"
    r"`restart` .* \$\{output\}/checkpoint\.\*\.restart.* `plastigran new-deck`"
)


def write_plain(deck: Path, *replacements: tuple[str, str], head: str = "") -> None:
    """Write the deck `PLAIN` with replaced texts and with `head` as its first lines."""
    text = PLAIN
    for old, new in replacements:
        assert old in text
        text = text.replace(old, new)
    deck.write_text(head + text, encoding="latin-1")


def test_plain_deck_runs_in_its_folder(plain, tmp_path, monkeypatch, capsys):
    """A user's deck runs in its own folder, so LIGGGHTS finds its include files and meshes.

    If the log has no time, it follows from the command `timestep`.
    """
    monkeypatch.chdir(tmp_path)
    assert main(["bulk", str(plain)]) == 0
    assert "no checks were made: the deck has no energy balance" in capsys.readouterr().out
    run = pg.open("results/plain")
    series = run.series
    assert run.deck is None and run.finished
    assert series["step"].tolist() == list(range(0, 1501, 100))
    assert_allclose(series["time"], series["step"] * 1e-7)
    assert series["run"].max() == 1
    # LIGGGHTS truncates the names of both variables to the same letters.
    assert_allclose(series["kinetic_.2"], 2 * series["kinetic_"], rtol=1e-6)
    assert series["kinetic_"].iloc[-1] < series["kinetic_"].iloc[0]
    # Only the folder of the run is written.
    assert {path.name for path in plain.parent.iterdir()} == {"meshes", "plain.in", "properties.in"}


def test_files_of_equal_names_are_all_copied(plain, tmp_path):
    """Included files keep their subfolders; a file from another folder gets a number."""
    folder, shared = plain.parent, tmp_path / "shared.in"
    shared.write_text("variable from_elsewhere index 7\n")
    parts = {
        "parts/plain.in": "include geometry/walls.in\n",
        "geometry/walls.in": "variable of_geometry index 1\n",
        "physics/walls.in": "variable of_physics index 2\n",
        "shared.in": "variable shared_here index 3\n",
    }
    for name, text in parts.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text)
    includes = ("parts/plain.in", "physics/walls.in", "shared.in", f"../{shared.name}")
    write_plain(plain, head="".join(f"include {name}\n" for name in includes))
    run = run_bulk(plain, {}, tmp_path / "run", show=False)
    assert run.series["step"].iloc[-1] == 1500
    copy = run.folder / "deck"
    assert (copy / "plain.in").read_bytes() == plain.read_bytes()
    assert {name: (copy / name).read_text() for name in parts} == parts
    assert (copy / "shared_2.in").read_text() == shared.read_text()


def test_meshes_are_copied_with_the_deck(plain, tmp_path):
    """A copy of a deck has the meshes that it reads, but not those that it writes.

    A setting may contain the name of a mesh.
    """
    shutil.copy(plain.parent / "meshes" / "plate.stl", plain.parent / "written.stl")
    end = "run 500\ndump walls all mesh/stl 100 written.stl\nrun 0\n"
    mesh = ("meshes/plate.stl", "meshes/${mesh}.stl")
    write_plain(plain, mesh, ("run 500\n", end), head="variable mesh index plate\n")
    source = plan_bulk(plain, {}, tmp_path / "run").source
    copy = tmp_path / "copy"
    assert source.copy(copy) == copy / "plain.in"
    files = {str(file.relative_to(copy)) for file in copy.glob("**/*.*")}
    assert files == {"plain.in", "properties.in", "meshes/plate.stl"}


def test_path_selects_the_users_deck_of_a_supplied_name(tmp_path, monkeypatch):
    """A path selects the user's deck, even if a deck of this package has the same name.

    A run of the user's deck cannot continue with the deck of this package, and vice versa.
    """
    monkeypatch.chdir(tmp_path)
    deck = write_deck(Path("hopper"), "thornton", "steel")
    assert plan_bulk("hopper", {}, "supplied").deck_type.__name__ == "Hopper"
    assert main(["bulk", str(deck), "-v", "duration=0.002", "rows=2", "checkpoints=1"]) == 0
    run = pg.open("results/hopper")
    assert run.finished and run.deck is None and run.name == "hopper"
    with pytest.raises(ValueError, match=r"hopper is a run of a user's deck, not of .*hopper"):
        plan_bulk("hopper", {}, "rest", restart="results/hopper")
    record = json.loads((run.folder / "run.json").read_text()) | {"own": False}
    (run.folder / "run.json").write_text(json.dumps(record))
    with pytest.raises(ValueError, match=r"is a run of the package's hopper, not of .*hopper\.in"):
        plan_bulk(deck, {}, "rest", restart="results/hopper")


@pytest.mark.parametrize(
    ("file", "name"),
    [("in.fall", "fall"), ("x.txt", "x"), ("x.IN", "x"), ("fall", "fall"), ("a.0.5.in", "a.0.5")],
)
def test_any_path_is_a_deck(file, name, plain, monkeypatch):
    monkeypatch.chdir(plain.parent)
    plain.rename(file)
    for path in (file, f"./{file}", Path(file).absolute()):
        source = plan_bulk(path, {}, "run").source
        assert source.path == plain.parent / file and source.name == name
    assert main(["bulk", f"./{file}"]) == 0
    assert pg.open(f"results/{name}").finished
    assert pg.bulk(file, show=False, force=True).folder == plain.parent / "results" / name


def test_supplied_name_selects_the_supplied_deck(tmp_path, monkeypatch):
    """A deck name without a path selects the deck of this package, even if such a file exists."""
    monkeypatch.chdir(tmp_path)
    Path("hopper").write_text("units si\n")
    assert plan_bulk("hopper", {}, "run").deck_type.__name__ == "Hopper"
    assert plan_bulk("./hopper", {}, "run").deck_type is None
    for missing in ("./in.drop", "drop.in", "decks/drop"):
        with pytest.raises(EngineError, match=f"the input script {missing} does not exist"):
            plan_bulk(missing, {}, "run")


def test_stopped_run_leaves_no_file_beside_the_deck(plain, tmp_path, start_plastigran):
    """The restart file of the stopped run moves to its results; those of other runs stay."""
    write_plain(plain, ("run 500", "run 50000000"))
    (plain.parent / "restart_forced_liggghts_7.data").write_text("Left by another run.")
    files = set(plain.parent.iterdir())
    folder = tmp_path / "run"
    run = start_plastigran("bulk", plain, "--output", folder)
    log = folder / "log.liggghts"
    while not (log.exists() and " 1600 " in log.read_text(encoding="latin-1")):
        assert run.poll() is None, run.stderr.read()
        time.sleep(0.05)
    run.send_signal(signal.SIGINT)
    run.communicate(timeout=60)
    assert run.returncode == 130
    assert set(plain.parent.iterdir()) == files
    assert list(folder.glob("restart_forced_*"))


def test_finished_run_takes_no_restart_file_of_another(plain, tmp_path):
    other = plain.parent / "restart_forced_liggghts_1500.data"  # last step of the run
    other.write_text("Left by another run.")
    run_bulk(plain, {}, tmp_path / "run", show=False)
    assert other.exists()


def test_readmes_deck_has_the_energies_of_the_readme(tmp_path):
    """The tolerance is 2 mJ of 33 mJ, because the paths of the balls are chaotic."""
    readme = (PROJECT / "README.md").read_text()
    deck = tmp_path / "deck.in"
    text = re.search(r"^```\n(units si\n.*?)```", readme, re.DOTALL | re.MULTILINE)[1]
    deck.write_text(text.replace("inputs/energy_ledger.in", "energy_ledger.in"))
    shutil.copy(PROJECT / "inputs" / "energy_ledger.in", tmp_path)
    run = run_bulk(deck, {}, tmp_path / "run", show=False)
    assert run.passed and len(run.checks) == 2
    end = run.series.iloc[-1]
    assert run.series[["kinetic", "gravity"]].iloc[0].sum() == pytest.approx(33e-3, abs=0.5e-3)
    assert end["plastic"] == pytest.approx(21e-3, abs=2e-3)
    assert end["friction"] == pytest.approx(5e-3, abs=2e-3)
    assert abs(end["drift"]) < 1e-6 * 33e-3


def test_plain_deck_cannot_continue(plain, tmp_path):
    """A deck without the settings `start` and `checkpoint` cannot continue.

    Restart files with other names are not used. The message states what the deck needs.
    """
    write_plain(plain, ("run 1000", "restart 500 mine.*\nrun 1000"))
    run_bulk(plain, {}, tmp_path / "run", show=False)
    assert (plain.parent / "mine.500").exists()
    particle = np.array([3.0, 0.1, 0.2])
    file = tmp_path / "run" / "checkpoint.1000.restart"
    for content in (b"", np.int32(len(particle)).tobytes() + particle.tobytes()):
        file.write_bytes(content)
        with pytest.raises(ValueError, match=CANNOT_CONTINUE):
            plan_bulk(plain, {}, tmp_path / "rest", restart=tmp_path / "run")


def test_deck_without_checkpoints_cannot_continue(plain, tmp_path):
    """A deck cannot continue if it has the settings for it, but no `restart` command."""
    write_plain(plain, head=START)
    run_bulk(plain, {}, tmp_path / "run", show=False)
    message = r"no complete checkpoint .*: .*`restart` .* \$\{output\}/checkpoint\.\*\.restart"
    with pytest.raises(EngineError, match=message):
        plan_bulk(plain, {}, tmp_path / "rest", restart=tmp_path / "run")


def test_run_that_restarted_its_step_count_cannot_continue(tmp_path):
    """A run with `reset_timestep` cannot continue: steps do not show the newest checkpoint."""
    deck = write_deck(tmp_path / "falling", "thornton", "soft_granules")
    log = f"{table('Atoms', '0 5')}reset_timestep 0\n"
    folder = finished_run(tmp_path / "run", log, deck="falling")
    with pytest.raises(EngineError, match=r"contains `reset_timestep`.* checkpoint=FILE"):
        plan_bulk(deck, {}, tmp_path / "rest", restart=folder)


def test_run_without_checkpoints_continues_from_its_own_start(plain, tmp_path):
    """The run continues from the file from which it started, if the name of the file has a step."""
    write_plain(plain, head=START)
    for name in ("checkpoint.1000.restart", "mine.500"):
        start = tmp_path / name
        start.touch()
        values = {"start": "checkpoint", "checkpoint": str(start)}
        record = {"deck": "plain", "values": values, "settings": values}
        folder = finished_run(tmp_path / f"run_{name}", "LIGGGHTS\n", **record)
        if name == "mine.500":
            with pytest.raises(EngineError, match="no complete checkpoint"):
                plan_bulk(plain, {}, tmp_path / "rest", restart=folder)
        else:
            assert plan_bulk(plain, {}, tmp_path / "rest", restart=folder).checkpoint == start


def test_unknown_setting_is_refused(plain, tmp_path):
    message = r"plain\.in has no setting 'radius'; the deck has none. A setting is a line `variable"
    with pytest.raises(ValueError, match=message):
        plan_bulk(plain, {"radius": 1}, tmp_path / "run")


def test_misspelt_law_is_refused(plain, tmp_path):
    """A misspelt law in a setting or in the model line is refused.

    LIGGGHTS' own models and models of the user are accepted.
    """
    template = write_deck(tmp_path / "falling", "thornton", "steel")
    message = r"{}\.in: contact model '{}' is unknown\. Use {}"
    with pytest.raises(ValueError, match=message.format("falling", "universl", "universal")):
        plan_bulk(template, {"law": "universl"}, tmp_path / "run")
    write_plain(plain, ("model thornton", "model thorton"))
    with pytest.raises(ValueError, match=message.format("plain", "thorton", "thornton")):
        plan_bulk(plain, {}, tmp_path / "run")
    write_plain(plain, ("model thornton", "model  thornton2"))
    with pytest.warns(
        UserWarning, match=r"model .thornton2. is unknown\. Use thornton.*Ignore this"
    ):
        plan_bulk(plain, {}, tmp_path / "run")
    for model in ("hertz/stiffness", "thornton_ning", "${own}"):
        write_plain(plain, ("model thornton", f"model {model}"))
        plan_bulk(plain, {}, tmp_path / "run")


@pytest.mark.parametrize("ranks", [1, 2])
def test_overlapping_spheres_pass_the_checks(ranks, tmp_path):
    """A run whose spheres overlap beyond yield at the start passes the checks.

    Its plastic work starts above zero and does not decrease; the spheres push each other apart.
    """
    deck = tmp_path / "overlap.in"
    deck.write_text(
        (PROJECT / "tests" / "ledger" / "decks" / "set_types.in")
        .read_text()
        .replace("${inputs}", str(PROJECT / "inputs"))
        .replace("variable inputs     index inputs\n", "")
        .replace("run             20\n${change}\nrun             20", "run 2000")
    )
    run = run_bulk(deck, {}, tmp_path / "run", ranks, show=False)
    assert run.passed and len(run.checks) == 2
    assert run.series["plastic"].iloc[0] > 0 and run.series["kinetic"].iloc[-1] > 0


def test_run_without_contacts_has_a_note(tmp_path):
    """A run in which no grains touch has a note, because its energy balance shows nothing.

    In the template, the grains fall 60 mm before they touch.
    """
    deck = write_deck(tmp_path / "falling", "thornton", "steel")
    run = run_bulk(deck, {"duration": 0.002}, tmp_path / "run", show=False)
    assert any("Check whether grains touched" in note for note in run.notes)


def test_deck_that_includes_itself_is_refused(tmp_path):
    deck = tmp_path / "round.in"
    deck.write_text("include round.in\n")
    with pytest.raises(EngineError, match="Check whether a file includes itself"):
        plan_bulk(deck, {}, tmp_path / "run")
