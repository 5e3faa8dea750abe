# SPDX-License-Identifier: GPL-2.0-or-later
"""Decks of the user's own: the template, and input scripts that know nothing of this package."""

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

import plastigran as pg
from plastigran.bulk.plan import plan_bulk
from plastigran.bulk.run import run_bulk
from plastigran.bulk.template import SPEED, write_deck
from plastigran.bulk.vtk import time_of
from plastigran.cli import main
from plastigran.contact import Contact
from plastigran.engine.log import read_thermo
from plastigran.engine.process import EngineError
from plastigran.materials import read_material
from plastigran.plot.frame_files import find_frames

PROJECT = Path(__file__).parents[2]
#: A sphere falls on a plane and a mesh beside the deck; no variable, no dt, long names in the log.
PLAIN = """
# Stoß einer Kugel
units si
atom_style granular
boundary f f f
newton off
communicate single vel yes
region box block -0.05 0.05 -0.05 0.05 -0.01 0.05 units box
create_box 1 box
neighbor 0.002 bin
include properties.in
pair_style gran model thornton tangential history
pair_coeff * *
fix plate all mesh/surface file meshes/plate.stl type 1 scale 0.008 rotate axis 0 1 0 angle 90
fix floor all wall/gran model thornton tangential history mesh n_meshes 1 meshes plate
create_atoms 1 single 0 0 0.00501
set group all diameter 0.01 density 7850
velocity all set 0 0 -0.1
fix integrate all nve/sphere
variable kinetic_of_all equal ke
variable kinetic_of_all_twice equal 2*ke
timestep 1.0e-7
thermo_style custom step atoms ke v_kinetic_of_all v_kinetic_of_all_twice
thermo 100
run 1000
run 500
"""
PROPERTIES = """
fix m1 all property/global youngsModulus peratomtype 2.1e11
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global yieldStrength peratomtype 3.0e8
fix m4 all property/global coefficientFriction peratomtypepair 1 0.3
"""
#: Columns of the energy ledger in a log.
LEDGER = ("v_kinetic", "v_elastic", "v_plastic", "v_friction", "v_viscous", "v_drift")


def own_run(folder: Path, log: str) -> Path:
    """A folder as a finished run of a deck without a class leaves it, with that log."""
    folder.mkdir()
    record = {"deck": "mine", "own": True, "values": {}, "settings": {}}
    (folder / "run.json").write_text(json.dumps(record))
    (folder / "log.liggghts").write_text(log)
    (folder / "series.csv").write_text("step\n")
    return folder


def table(columns: str, *rows: str) -> str:
    """What the engine writes to the log in one run."""
    return "\n".join((f"Step {columns}", *rows, "Loop time of 1\n"))


@pytest.fixture
def plain(tmp_path) -> Path:
    """A deck in a folder with white space in its name, its include and mesh beside it."""
    folder = tmp_path / "my decks"
    (folder / "meshes").mkdir(parents=True)
    template = write_deck(tmp_path / "template", "thornton", "steel")
    (template.parent / "plate.stl").rename(folder / "meshes" / "plate.stl")
    (folder / "properties.in").write_text(PROPERTIES)
    (folder / "plain.in").write_text(PLAIN, encoding="latin-1")
    return folder / "plain.in"


def test_a_plain_deck_runs_where_it_lies(plain, tmp_path, monkeypatch, capsys):
    """Includes and meshes are found from the deck's place, from any folder; time comes from its
    timestep command; both runs are kept; results lie in the present folder."""
    monkeypatch.chdir(tmp_path)
    assert main(["bulk", str(plain)]) == 0
    assert "nothing was checked: the deck keeps no energy balance" in capsys.readouterr().out
    run = pg.open("results/plain")
    series = run.series
    assert run.deck is None and run.finished
    assert series["step"].tolist() == list(range(0, 1501, 100))
    assert_allclose(series["time"], series["step"] * 1e-7)
    assert series["run"].max() == 1
    # The log cuts both variables' names to the same letters.
    assert_allclose(series["kinetic_.2"], 2 * series["kinetic_"], rtol=1e-6)
    assert series["kinetic_"].iloc[-1] < series["kinetic_"].iloc[0]
    # Nothing but the run's folder is written.
    assert sorted(path.name for path in plain.parent.iterdir()) == [
        "meshes", "plain.in", "properties.in",
    ]  # fmt: skip


def test_runs_that_count_steps_anew_are_all_kept(plain, tmp_path):
    """Of the step that ends one run and begins the next there is one line."""
    text = PLAIN.replace("run 500", "run 200\nreset_timestep 0\nrun 500")
    plain.write_text(text, encoding="latin-1")
    series = run_bulk(plain, {}, tmp_path / "run", show=False).series
    first, last = list(range(0, 1201, 100)), list(range(0, 501, 100))
    assert series["step"].tolist() == first + last
    assert series["run"].tolist() == [0] * 11 + [1] * 2 + [2] * 6


def test_the_ledger_is_checked_over_every_run(tmp_path):
    """Here the second, whose steps are those of the first, has lost energy."""
    ledger = " ".join(LEDGER)
    log = table(f"Time {ledger}", "0 0 1 0 0 0 0 0", "10 1e-5 0.5 0 0.5 0 0 0")
    log += table(f"Time {ledger}", "0 0 0.5 0 0.5 0 0 0", "10 1e-5 0.2 0 0.4 0 0 0.4")
    run = pg.open(own_run(tmp_path / "run", log))
    assert run.checks["value"].tolist() == pytest.approx([0.4, 0.1])
    assert not run.passed


def test_the_ledger_is_checked_for_each_simulation_of_a_deck(tmp_path):
    """`clear` begins another, with nothing lost and a time step of its own."""
    ledger = " ".join(LEDGER)
    first = "timestep 1e-6\n" + table(ledger, "0 1 0 0 0 0 0", "10 0.5 0 0.5 0 0 0")
    second = table(ledger, "10 4 0 0 0 0 0", "20 3 0 1 0 0 0.04")
    run = pg.open(own_run(tmp_path / "run", f"{first}clear\ntimestep 2e-6\n{second}"))
    assert run.checks["value"].tolist() == pytest.approx([0.01, 0])
    assert run.series["simulation"].tolist() == [0, 0, 1, 1]
    assert_allclose(run.series["time"], np.array([0, 10, 10, 30]) * 1e-6)
    assert "time" not in pg.open(own_run(tmp_path / "unsaid", f"{first}clear\n{second}")).series


def test_a_run_that_goes_on_after_a_clear_keeps_its_ledger(tmp_path):
    """What goes on belongs to the last simulation, whose energy it has lost; `run 0` before."""
    ledger = " ".join(LEDGER)
    first = table(f"Time {ledger}", "0 0 1 0 0 0 0 0", "10 1e-5 0.5 0 0.5 0 0 0")
    second = table(f"Time {ledger}", "0 0 2 0 0 0 0 0", "20 2e-5 1 0 1 0 0 0")
    before = pg.open(own_run(tmp_path / "before", f"{first}clear\n{second}")).series
    assert before["simulation"].tolist() == [0, 0, 1, 1]
    log = table(f"Time {ledger}", "20 2e-5 1 0 1 0 0 0")
    log += table(f"Time {ledger}", "20 2e-5 1 0 1 0 0 0", "40 4e-5 0.1 0 1 0 0 0.9")
    folder = own_run(tmp_path / "run", log)
    before.to_csv(folder / "before.csv", index=False)
    run = pg.open(folder)
    assert run.checks["value"].tolist() == pytest.approx([0.45, 0])
    assert not run.passed
    assert run.series["simulation"].tolist() == [0, 0, 1, 1, 1]
    assert_allclose(np.diff(run.series["time"].iloc[2:]), 2e-5)
    assert run.notes == [
        "the energy balance restarts at each `clear`. All parts are checked; the last one is drawn"
    ]


def test_a_run_that_counted_its_steps_anew_is_not_gone_on_with(tmp_path):
    """Which checkpoint is the newest cannot be told by its number."""
    deck = write_deck(tmp_path / "falling", "thornton", "soft_granules")
    folder = own_run(tmp_path / "run", f"{table('Atoms', '0 5')}reset_timestep 0\n")
    record = json.loads((folder / "run.json").read_text()) | {"deck": "falling"}
    (folder / "run.json").write_text(json.dumps(record))
    with pytest.raises(EngineError, match=r"contains `reset_timestep`.* checkpoint=FILE"):
        run_bulk(deck, {}, tmp_path / "rest", restart=folder, show=False)


def test_what_only_the_later_line_of_a_step_has_is_kept(tmp_path):
    """Between two runs a deck may ask for other columns."""
    log = table("Atoms", "0 5") + table("Atoms KinEng", "0 6 2", "10 6 3")
    series = pg.open(own_run(tmp_path / "run", log)).series
    assert series["atoms"].tolist() == [5, 6] and series["kinetic_energy"].tolist() == [2, 3]


@pytest.mark.parametrize("columns", ["", "dt", "time"])
def test_time_goes_on_where_steps_do_not(columns, plain, tmp_path):
    """Other time steps, steps counted anew; with a remark, an empty whole part, a variable; by the
    log's columns or by what the commands say."""
    runs = """
    timestep 1e-6   # s
    run 200
    timestep ${twice}
    run 200
    reset_timestep 0
    timestep .000003
    run 200
    """
    text = PLAIN.partition("timestep")[0] + "variable twice equal 2e-6\n"
    text += f"thermo_style custom step {columns} atoms\nthermo 100\n{runs}"
    plain.write_text(text, encoding="latin-1")
    series = run_bulk(plain, {}, tmp_path / "run", show=False).series
    assert_allclose(series["time"], np.array([0, 100, 200, 400, 600, 600, 900, 1200]) * 1e-6)


@pytest.mark.parametrize(
    "unknown",
    ["", "timestep ${mine}\n", "timestep 1e-6\nfix a all dt/reset 1 1e-9 1e-6 1e-9 units box\n"],
)
def test_a_run_whose_time_step_is_unknown_has_no_time(unknown, tmp_path):
    """Its ledger is checked all the same; a run of no steps takes no time with any step."""
    ledger = table(" ".join(LEDGER), "0 1 0 0 0 0 0", "10 0.5 0 0.5 0 0 0")
    run = pg.open(own_run(tmp_path / "unknown", unknown + ledger))
    assert "time" not in run.series and run.passed and len(run.checks) == 2
    assert not run.figures and any("log has no time" in note for note in run.notes)
    known = table("Atoms", "0 1") + "timestep 1e-6\n" + ledger
    run = pg.open(own_run(tmp_path / "known", known))
    assert_allclose(run.series["time"], [0, 1e-5])
    assert run.figures and not run.notes


def test_a_time_step_that_varies_within_a_run_gives_no_time(tmp_path):
    log = table("Dt", "0 1e-6", "10 2e-6", "20 2e-6")
    assert "time" not in pg.open(own_run(tmp_path / "run", log)).series


@pytest.mark.parametrize("known", ["before", "after", "both"])
def test_time_of_a_run_gone_on_is_known_where_both_logs_have_it(known, tmp_path):
    log = table("Atoms", "10 5", "20 5")
    folder = own_run(tmp_path / "run", log if known == "before" else f"timestep 1e-6\n{log}")
    before = "step,atoms\n10,5\n" if known == "after" else "step,time,atoms\n10,1,5\n"
    (folder / "before.csv").write_text(before)
    series = pg.open(folder).series
    assert series["step"].tolist() == [10, 20]
    if known == "both":
        assert_allclose(series["time"], [1, 1 + 1e-5], rtol=1e-9)
    else:
        assert "time" not in series


def test_a_checkpoint_between_two_lines_of_the_log_has_its_time(tmp_path):
    log = "timestep 1e-6\n" + table("Atoms", "15 5", "25 5")
    folder = own_run(tmp_path / "run", log)
    (folder / "before.csv").write_text("step,time,atoms\n0,0,5\n10,1e-5,5\n")
    assert_allclose(pg.open(folder).series["time"], [0, 1e-5, 1.5e-5, 2.5e-5])


def test_a_log_that_ends_before_its_first_line_has_an_empty_series(tmp_path):
    folder = own_run(tmp_path / "run", "timestep 1e-6\nStep Atoms\n")
    assert pg.open(folder).series.empty
    (folder / "before.csv").write_text("step,time,atoms\n0,0,5\n10,1e-5,5\n")
    assert pg.open(folder).series["step"].tolist() == [0, 10]


def test_frames_of_steps_counted_anew_have_the_later_time(tmp_path):
    """The engine wrote them over those of the run before."""
    log = table("Time", "0 0", "10 1", "20 2") + table("Time", "0 2", "10 3")
    run = pg.open(own_run(tmp_path / "run", log))
    assert [time_of(run, step) for step in (0, 5, 10, 20)] == [2, 2.5, 3, 2]


def test_files_of_one_name_are_all_kept(plain, tmp_path):
    """In their subfolders; the deck's own name among them, and one from elsewhere. What ran is what
    was given."""
    folder = plain.parent
    shared = tmp_path / "shared.in"
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
    text = "".join(f"include {name}\n" for name in ("parts/plain.in", "physics/walls.in"))
    text += f"include shared.in\ninclude ../{shared.name}\n{PLAIN}"
    plain.write_text(text, encoding="latin-1")
    run = run_bulk(plain, {}, tmp_path / "run", show=False)
    assert run.series["step"].iloc[-1] == 1500
    kept = run.folder / "deck"
    assert (kept / "plain.in").read_bytes() == plain.read_bytes()
    assert {name: (kept / name).read_text() for name in parts} == parts
    assert (kept / "shared_2.in").read_text() == shared.read_text()


def test_meshes_are_kept_with_the_deck(plain, tmp_path):
    """Beside the script and by a setting; what a deck writes is not."""
    written = plain.parent / "written.stl"
    shutil.copy(plain.parent / "meshes" / "plate.stl", written)
    text = PLAIN.replace("meshes/plate.stl", "meshes/${mesh}.stl")
    text = f"variable mesh index plate\n{text}dump walls all mesh/stl 100 written.stl\nrun 0\n"
    plain.write_text(text, encoding="latin-1")
    source = plan_bulk(plain, {}, tmp_path / "run").source
    assert source.copy(tmp_path / "copy") == tmp_path / "copy" / "plain.in"
    kept = {str(file.relative_to(tmp_path / "copy")) for file in tmp_path.glob("copy/**/*.*")}
    assert kept == {"plain.in", "properties.in", "meshes/plate.stl"}


def test_a_deck_called_as_one_of_the_package_is_the_users_own(tmp_path, monkeypatch, capsys):
    """By its path; its run is opened as such, and the other's is not gone on with."""
    monkeypatch.chdir(tmp_path)
    deck = write_deck(Path("hopper"), "thornton", "steel")
    assert plan_bulk("hopper", {}, "shipped").deck_type.__name__ == "Hopper"
    short = ["-v", "duration=0.002", "rows=2", "checkpoints=1"]
    assert main(["bulk", str(deck), *short]) == 0
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
def test_any_file_given_by_its_path_is_a_deck(file, name, plain, monkeypatch):
    """Beside it or elsewhere, with a dot or without; results/NAME tells it from others."""
    monkeypatch.chdir(plain.parent)
    plain.rename(file)
    for given in (file, f"./{file}", Path(file).absolute()):
        source = plan_bulk(given, {}, "run").source
        assert source.path == plain.parent / file and source.name == name
    assert main(["bulk", f"./{file}"]) == 0
    assert pg.open(f"results/{name}").finished
    assert pg.bulk(file, show=False, force=True).folder == plain.parent / "results" / name


def test_a_name_of_the_package_is_its_deck_whatever_lies_here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("hopper").write_text("units si\n")
    assert plan_bulk("hopper", {}, "run").deck_type.__name__ == "Hopper"
    assert plan_bulk("./hopper", {}, "run").deck_type is None
    for missing in ("./in.drop", "drop.in", "decks/drop"):
        with pytest.raises(EngineError, match=f"no input script {missing}"):
            plan_bulk(missing, {}, "run")


def test_a_stopped_deck_leaves_nothing_where_it_lies(plain, tmp_path, start_plastigran):
    """The engine's restart file of that moment goes to the results; another run's stays."""
    plain.write_text(PLAIN.replace("run 500", "run 50000000"), encoding="latin-1")
    other = plain.parent / "restart_forced_liggghts_7.data"
    other.write_text("Left by another run.")
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


def test_a_finished_run_takes_nothing_of_another(plain, tmp_path):
    """Not even what another has left at the same step."""
    other = plain.parent / "restart_forced_liggghts_1500.data"
    other.write_text("Left by another run.")
    run_bulk(plain, {}, tmp_path / "run", show=False)
    assert other.exists()


def test_the_readmes_deck_does_as_it_says(tmp_path):
    """Two thirds become plastic work; 2 mJ of 33 either way, for the balls' paths are chaotic."""
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


def test_a_plain_deck_cannot_go_on(plain, tmp_path):
    """Whatever restart files it has; what it needs is said."""
    text = PLAIN.replace("run 1000", "restart 500 mine.*\nrun 1000")
    plain.write_text(text, encoding="latin-1")
    run_bulk(plain, {}, tmp_path / "run", show=False)
    assert (plain.parent / "mine.500").exists()
    said = r"plain\.in has no setting 'start', so it cannot continue.* `start` .* `checkpoint` .*"
    said += r"`restart` .* \$\{output\}/checkpoint\.\*\.restart.* `plastigran new-deck`"
    with pytest.raises(ValueError, match=said):
        run_bulk(plain, {}, tmp_path / "rest", restart=tmp_path / "run", show=False)
    part = np.array([3.0, 0.1, 0.2])  # of one particle
    file = tmp_path / "run" / "checkpoint.1000.restart"
    file.write_bytes(np.int32(len(part)).tobytes() + part.tobytes())
    with pytest.raises(ValueError, match=said):
        run_bulk(plain, {}, tmp_path / "rest", restart=tmp_path / "run", show=False)


def test_a_deck_that_writes_no_checkpoints_is_told_how(plain, tmp_path):
    """It has the settings, but its restart files are called otherwise."""
    text = f"variable start index fresh\nvariable checkpoint index none\n{PLAIN}"
    plain.write_text(text, encoding="latin-1")
    run_bulk(plain, {}, tmp_path / "run", show=False)
    said = r"no whole checkpoint .*: .*`restart` .* \$\{output\}/checkpoint\.\*\.restart"
    with pytest.raises(EngineError, match=said):
        plan_bulk(plain, {}, tmp_path / "rest", restart=tmp_path / "run")


def test_a_deck_stopped_before_its_first_checkpoint_goes_on_from_where_it_began(plain, tmp_path):
    """From a file that is called as checkpoints are; another's step is not known."""
    text = f"variable start index fresh\nvariable checkpoint index none\n{PLAIN}"
    plain.write_text(text, encoding="latin-1")
    folder = own_run(tmp_path / "run", "LIGGGHTS\n")
    for name in ("checkpoint.1000.restart", "mine.500"):
        began = tmp_path / name
        began.touch()
        values = {"start": "checkpoint", "checkpoint": str(began)}
        record = {"deck": "plain", "own": True, "values": values, "settings": values}
        (folder / "run.json").write_text(json.dumps(record))
        if name == "mine.500":
            with pytest.raises(EngineError, match="no whole checkpoint"):
                plan_bulk(plain, {}, tmp_path / "rest", restart=folder)
        else:
            assert plan_bulk(plain, {}, tmp_path / "rest", restart=folder).checkpoint == began


def test_an_unknown_setting_is_refused(plain, tmp_path):
    said = r"plain\.in has no setting 'radius'; it has none. A setting is a line `variable"
    with pytest.raises(ValueError, match=said):
        run_bulk(plain, {"radius": 1}, tmp_path / "run", show=False)


def test_a_law_misspelt_is_named_before_anything_runs(plain, tmp_path):
    """In a setting or in the line itself; a model of the engine's own is taken."""
    template = write_deck(tmp_path / "falling", "thornton", "steel")
    with pytest.raises(
        ValueError,
        match=r"falling\.in: no contact model 'universl'. Possible misspelling of universal",
    ):
        run_bulk(template, {"law": "universl"}, tmp_path / "run", show=False)
    text = plain.read_text(encoding="latin-1")
    plain.write_text(text.replace("model thornton", "model thorton"), encoding="latin-1")
    with pytest.raises(
        ValueError, match=r"plain\.in: no contact model 'thorton'. Possible misspelling of thornton"
    ):
        run_bulk(plain, {}, tmp_path / "run", show=False)
    assert not (tmp_path / "run").exists()
    plain.write_text(text.replace("model thornton", "model  thornton2"), encoding="latin-1")
    with pytest.warns(
        UserWarning, match="model .thornton2.. Possible misspelling of thornton.* is used as it is"
    ):
        plan_bulk(plain, {}, tmp_path / "run")
    for stock in ("hertz/stiffness", "thornton_ning", "${own}"):
        plain.write_text(text.replace("model thornton", f"model {stock}"), encoding="latin-1")
        plan_bulk(plain, {}, tmp_path / "run")


def test_columns_of_one_name_are_numbered(tmp_path):
    """The engine cuts long names, to the same letters here."""
    log = tmp_path / "log"
    log.write_text("Step kinetic_ kinetic_\n0 1 2\n10 3 4\nLoop time of 1\n")
    table = read_thermo(log)
    assert table["kinetic_"].tolist() == [1, 3] and table["kinetic_.2"].tolist() == [2, 4]


def test_the_template_runs_keeps_its_ledger_and_goes_on(tmp_path, capsys):
    """Frames can be drawn, the ledger is checked, and a run gone on is that of one go."""
    folder = tmp_path / "mine"
    assert main(["new-deck", str(folder), "--law", "kogut_etsion"]) == 0
    capsys.readouterr()
    deck = folder / "mine.in"
    short = {"duration": 0.12, "rows": 12, "checkpoints": 3, "frames": 2}
    whole = run_bulk(deck, short, tmp_path / "whole", show=False)
    assert whole.passed and "ledger" in whole.figures and len(whole.checks) == 2
    assert whole.series["plastic"].iloc[-1] > 0
    assert len(find_frames(tmp_path / "whole")) >= 2
    half = tmp_path / "half"
    run_bulk(deck, short | {"duration": 0.08, "rows": 8, "checkpoints": 2}, half, show=False)
    rest = run_bulk(deck, short, tmp_path / "rest", restart=half, show=False)
    assert rest.series["step"].tolist() == whole.series["step"].tolist()
    for column in ("time", "kinetic", "plastic"):
        assert_allclose(rest.series[column], whole.series[column], rtol=1e-9, atol=1e-15)
    line = ["bulk", str(deck), "--restart", str(whole.folder), "--output", str(tmp_path / "more")]
    assert main(line) == 0
    assert "whole has reached its end, so there was nothing to compute" in capsys.readouterr().out


def test_the_default_template_stays_within_the_range_of_its_law(tmp_path):
    """Grains of the default material yield when they fall, and no contact leaves the range."""
    assert main(["new-deck", str(tmp_path / "mine")]) == 0
    run = run_bulk(tmp_path / "mine" / "mine.in", {}, tmp_path / "run", show=False)
    assert run.passed and run.series["plastic"].iloc[-1] > 0
    assert "beyond the law's range" not in (tmp_path / "run" / "log.liggghts").read_text()


@pytest.mark.parametrize("radius", [0.001, 0.005])
def test_the_template_takes_a_radius(radius, tmp_path):
    """Grains have it, and the step is the one recommended for it."""
    line = ["new-deck", str(tmp_path / "mine"), "--law", "thornton", "--radius", str(radius)]
    assert main([*line, "--material", "soft_granules"]) == 0
    deck = tmp_path / "mine" / "mine.in"
    run = run_bulk(
        deck, {"duration": 0.001, "rows": 1, "checkpoints": 1}, tmp_path / "run", show=False
    )
    granules = read_material("soft_granules")
    contact = Contact("thornton", granules, granules, radius=radius, radius_other=radius)
    recommended = float(contact.timestep(SPEED))
    log = (run.folder / "log.liggghts").read_text()
    (step,) = re.findall(r"^timestep +([\d.e-]+) ", log, re.MULTILINE)[-1:]
    assert 0.5 * recommended < float(step) <= recommended  # rounded down to one digit


def test_a_radius_that_does_not_fit_is_refused(tmp_path):
    with pytest.raises(ValueError, match=r"radius is 0.05; it must lie from 0.0005 to 0.006"):
        write_deck(tmp_path / "mine", "thornton", "steel", radius=0.05)


@pytest.mark.parametrize("ranks", [1, 2])
def test_spheres_that_overlap_at_the_start_pass_the_checks(ranks, tmp_path):
    """Beyond yield, with nothing but their overlap to move them: plastic work does not fall."""
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


def test_a_run_without_contacts_says_so(tmp_path):
    """Its ledger closes on nothing; the grains of the template fall 60 mm first."""
    deck = write_deck(tmp_path / "falling", "thornton", "steel")
    run = run_bulk(deck, {"duration": 0.002}, tmp_path / "run", show=False)
    assert any("Did grains meet?" in note for note in run.notes)


def test_the_template_refuses(tmp_path, capsys):
    (tmp_path / "mine").mkdir()
    for line, said in (
        ([str(tmp_path / "mine")], "mine exists. Choose another name"),
        ([str(tmp_path / "a b")], "'a b' contains white space"),
        ([str(tmp_path / "a%b")], "'a%b' contains white space, % or *"),
        ([str(tmp_path / "new"), "--law", "hertz"], "hertz is LIGGGHTS' own model without"),
        ([str(tmp_path / "fresh")], "'fresh' is the name of another file"),
        ([str(tmp_path / "steel"), "--material", "steel"], "both called 'steel'"),
        ([str(tmp_path / "new"), "--law", "lim_stronge"], "'lim_stronge' is not a law for spheres"),
    ):
        assert main(["new-deck", *line]) == 1
        assert said in capsys.readouterr().err


def test_the_template_takes_all_that_the_material_has(tmp_path):
    """The log says the constants of the contact."""
    material = tmp_path / "rated.in"
    material.write_text(
        "variable youngs_modulus index 5e6\nvariable poissons_ratio index 0.3\n"
        "variable density index 1500\nvariable yield_strength index 1e5\n"
        "variable yield_pressure_factor index 1.5\nvariable tangent_modulus index 4e4\n"
        "variable rate_coefficient index 0.014\n"
    )
    deck = write_deck(tmp_path / "mine", "universal", material)
    run_bulk(deck, {"duration": 1e-3, "rows": 1, "checkpoints": 1}, tmp_path / "run", show=False)
    said = (tmp_path / "run" / "log.liggghts").read_text()
    assert "yield pressure 150000 Pa, rate coefficient 0.014" in said
    assert "tangent modulus 40000 Pa" in said


def test_a_deck_that_includes_itself_is_refused(tmp_path):
    deck = tmp_path / "round.in"
    deck.write_text("include round.in\n")
    with pytest.raises(EngineError, match="Check whether a file includes itself"):
        run_bulk(deck, {}, tmp_path / "run", show=False)
