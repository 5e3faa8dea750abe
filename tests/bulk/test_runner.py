# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran bulk` runs decks, stops, continues from checkpoints, and refuses wrong arguments."""

from __future__ import annotations

import os
import signal
import subprocess
import threading
import time
from pathlib import Path

import pytest
from bulk_settings import SHORT_GAS

import plastigran as pg
from plastigran.bulk.run import run_bulk
from plastigran.bulk.series import read_series
from plastigran.cli import main
from plastigran.engine.checkpoints import PATTERN, newest_checkpoint, step_of
from plastigran.engine.log import LogFollower
from plastigran.engine.process import engines
from plastigran.materials import read_material, write_material
from plastigran.plot import style

#: Settings of a run that lasts long enough to be stopped.
LONG = SHORT_GAS | {"duration": 20000, "rows": 20000, "checkpoints": 5000}


def test_package_is_called(tmp_path, monkeypatch):
    """`pg.bulk` runs a deck, and `pg.open` reads the run again from results/DECK."""
    monkeypatch.chdir(tmp_path)
    settings = {"side": 4, "duration": 2, "rows": 10, "checkpoints": 1, "mixing": 0.1}
    run = pg.bulk("cooling_gas", law="thornton", show=False, **settings)
    assert run.folder == tmp_path / "results" / "cooling_gas" and run.deck.law == "thornton"
    again = pg.open("results/cooling_gas")
    assert again.checks.equals(run.checks) and again.figures.keys() == run.figures.keys()
    assert "run of cooling_gas" in repr(again)


def test_continuing_with_another_timestep_is_refused(short_gas, tmp_path):
    with pytest.raises(
        ValueError,
        match=r"4e-08, but the run to continue has 8.0e-8.* may change only checkpoints, contact_h",
    ):
        run_bulk("cooling_gas", {"timestep": 4e-8}, tmp_path / "rest", restart=short_gas)
    assert not (tmp_path / "rest").exists()


@pytest.fixture
def start(start_plastigran):
    """`start(folder, ranks)` starts a long run and waits for its second checkpoint."""

    def begin(folder: Path, ranks: int) -> subprocess.Popen:
        values = [f"{name}={value}" for name, value in LONG.items()]
        line = ["bulk", "cooling_gas", "--ranks", ranks, "--output", folder, "-v", *values]
        run = start_plastigran(*line)
        while len(list(folder.glob(PATTERN))) < 2:
            assert run.poll() is None, run.stderr.read()
            time.sleep(0.05)
        return run

    return begin


@pytest.mark.parametrize(("ranks", "sent"), [(1, signal.SIGTERM), (2, signal.SIGINT)])
def test_interrupt_stops_every_rank_and_keeps_the_files(start, ranks, sent, tmp_path):
    run = start(tmp_path / "run", ranks)
    assert len(engines(tmp_path / "run")) == (1 if ranks == 1 else 3)
    run.send_signal(sent)
    _, message = run.communicate(timeout=60)
    assert run.returncode == 130
    assert f"stopped; to continue from the newest checkpoint, use --restart {tmp_path}" in message
    assert not engines(tmp_path / "run")
    assert newest_checkpoint(tmp_path / "run").stat().st_size > 0
    assert read_series(tmp_path / "run")["atoms"].eq(125).all()


def test_run_continues_after_a_kill_of_liggghts(start, tmp_path):
    run = start(tmp_path / "run", ranks=2)
    # Kill the newest process. It is a rank, because mpirun starts first.
    os.kill(max(engines(tmp_path / "run")), signal.SIGKILL)
    _, message = run.communicate(timeout=60)
    assert run.returncode == 1 and "cooling_gas.in" in message
    assert "LIGGGHTS was stopped by the signal SIGKILL" in message
    assert f"to continue from the newest checkpoint, use --restart {tmp_path}" in message
    assert not engines(tmp_path / "run")
    before = read_series(tmp_path / "run")
    checkpoint = newest_checkpoint(tmp_path / "run")
    # A continued run may change the settings that determine its end. It adds two log lines.
    lines = int(before["step"].iloc[1])
    rows = step_of(checkpoint) // lines + 2
    values = {"duration": rows, "rows": rows, "checkpoints": 1}
    rest = tmp_path / "rest"
    run_bulk("cooling_gas", values, rest, ranks=2, restart=tmp_path / "run", show=False)
    series = read_series(rest)
    assert series["step"].is_monotonic_increasing and series["step"].is_unique
    assert series["step"].iloc[-1] == rows * lines
    kept = series[series["step"] < step_of(checkpoint)]
    assert kept["kinetic_energy"].tolist() == before["kinetic_energy"].tolist()[: len(kept)]


def test_liggghts_ends_with_a_killed_python(start, tmp_path):
    run = start(tmp_path / "run", ranks=2)
    run.kill()
    run.communicate(timeout=60)
    deadline = time.monotonic() + 30
    while engines(tmp_path / "run"):
        assert time.monotonic() < deadline, "LIGGGHTS still runs"
        time.sleep(0.05)


def test_continuing_a_finished_run_computes_nothing(short_gas, tmp_path, capsys):
    line = ["bulk", "cooling_gas", "--restart", str(short_gas), "--output", str(tmp_path / "rest")]
    assert main(line) == 0
    message = f"{short_gas} has reached its end, so there was nothing to compute"
    assert message in capsys.readouterr().out


def test_run_killed_before_its_first_checkpoint_continues_from_its_start(
    short_gas, cut_log, tmp_path
):
    """A continued run that was killed before its own first checkpoint can continue again.

    It starts from the checkpoint of the first run, and the series is complete.
    """
    first = cut_log(lines=8)
    second = tmp_path / "second"
    run_bulk("cooling_gas", {}, second, restart=first, show=False)
    for file in second.glob(PATTERN):
        file.unlink()
    (second / "log.liggghts").write_text("LIGGGHTS\n")
    run_bulk("cooling_gas", {}, tmp_path / "third", restart=second, show=False)
    expected, series = read_series(short_gas), read_series(tmp_path / "third")
    assert (series["kinetic_energy"] == expected["kinetic_energy"]).all()


def test_folder_is_locked_until_figures_are_written(tmp_path, monkeypatch):
    """A second run into the folder is refused, even with `force`, until the figures are written.

    The refused run deletes nothing.
    """
    refused = []

    def save(figure, path, *arguments):
        def run_again():
            with pytest.raises(ValueError, match="run is in use by another plastigran command"):
                run_bulk("cooling_gas", SHORT_GAS, tmp_path / "run", force=True, show=False)
            refused.append(path)

        other = threading.Thread(target=run_again)
        other.start()
        other.join()
        return style_save(figure, path, *arguments)

    style_save = style.save
    monkeypatch.setattr("plastigran.bulk.run.style.save", save)
    run = run_bulk("cooling_gas", SHORT_GAS, tmp_path / "run", show=False)
    assert len(refused) == len(run.figures) > 0
    for name in run.figures:
        assert (tmp_path / "run" / "figures" / f"{name}.png").stat().st_size > 0


def test_record_nested_too_deeply_is_refused(tmp_path, capsys):
    (tmp_path / "run.json").write_text("[" * 100_000 + "]" * 100_000)
    line = ["bulk", "cooling_gas", "--restart", str(tmp_path), "--output", str(tmp_path / "rest")]
    assert main(line) == 1
    assert "run.json is damaged: the JSON is nested too deeply" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("line", "message"),
    [
        (["cooling_gass"], "no deck 'cooling_gass'. Available decks: "),
        (["cooling_gas", "-v", "siide=3"], "has no setting 'siide'; the deck has law"),
        (["cooling_gas", "--restart", "/nowhere"], "contains no run.json"),
        (["cooling_gas", "-v", "ledger=ON"], "ledger is 'ON', possible values are off, on"),
        (["bed_impact", "-v", "target=Plate"], "target is 'Plate', possible values are bed, plate"),
    ],
)
def test_wrong_words_are_refused(line, message, tmp_path, capsys):
    assert main(["bulk", *line, "--output", str(tmp_path / "run")]) == 1
    assert message in capsys.readouterr().err


def test_materials_are_found_from_the_current_folder(tmp_path, monkeypatch):
    """LIGGGHTS runs in another folder, so it gets the absolute path, or a link if the path has
    white space.
    """
    folder = tmp_path / "my metals"
    folder.mkdir()
    write_material(read_material("soft_granules"), folder / "mine.in", "As soft as they are.")
    monkeypatch.chdir(folder)
    settings = SHORT_GAS | {"materials": ".", "material": "mine", "duration": 2, "checkpoints": 1}
    run = run_bulk("cooling_gas", settings, tmp_path / "run", show=False)
    assert run.finished and run.deck.material == "mine"


def test_setting_without_a_value_is_refused(capsys):
    with pytest.raises(SystemExit):
        main(["bulk", "cooling_gas", "-v", "side"])
    assert "'side' is not name=value" in capsys.readouterr().err


def test_continuing_in_the_same_folder_is_refused(short_gas):
    with pytest.raises(ValueError, match="is the run to continue"):
        run_bulk("cooling_gas", {}, short_gas, restart=short_gas, force=True)
    assert newest_checkpoint(short_gas).exists()


def test_progress_is_read_from_whole_lines_only(tmp_path):
    """Progress counts the steps in complete log lines of two runs; the second one uses `upto`."""
    log, follower = tmp_path / "log", LogFollower(tmp_path / "log")
    assert follower.read().run == 0
    with open(log, "w") as file:

        def seen(text: str) -> tuple[int, int, int, int]:
            file.write(text)
            file.flush()
            p = follower.read()
            return p.run, p.first, p.last, p.step

        assert seen("run $(v_n)\nrun 300\nStep Dt Atoms \n 100 2e-6 5\n") == (1, 100, 400, 100)
        assert seen(" 200 2e-6 5\n 30") == (1, 100, 400, 200)
        assert seen("0 2e-6 5\nWARNING: 1 2\nLoop time of 3 on 1\n 7 8 9\n") == (1, 100, 400, 300)
        assert seen("run 900 upto\nStep Dt Atoms\n 300 2e-6 5\n") == (2, 300, 900, 300)
        assert follower.progress.timestep == 2e-6
