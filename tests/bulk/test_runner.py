# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran bulk`: stopping, going on from checkpoints, and what it leaves."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
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
from plastigran.engine.process import EngineError, engines
from plastigran.materials import read_material, write_material
from plastigran.plot import style

#: Long enough to be stopped on the way.
LONG = SHORT_GAS | {"duration": 20000, "rows": 20000, "checkpoints": 5000}


def cut(run: Path, folder: Path, lines: int) -> Path:
    """A run as it looks when killed that many lines of cooling before its end."""
    shutil.copytree(run, folder)
    log = (folder / "log.liggghts").read_text().partition("Loop time")
    cooling = log[2].partition("Loop time")[0].rstrip("\n").splitlines(keepends=True)
    (folder / "log.liggghts").write_text(log[0] + log[1] + "".join(cooling[:-lines])[:-5])
    return folder


def test_package_is_called(tmp_path, monkeypatch):
    """By the deck's name and settings, into results/DECK; the run is read again from there."""
    monkeypatch.chdir(tmp_path)
    settings = {"side": 4, "duration": 2, "rows": 10, "checkpoints": 1, "mixing": 0.1}
    run = pg.bulk("cooling_gas", law="thornton", show=False, **settings)
    assert run.folder == tmp_path / "results" / "cooling_gas" and run.deck.law == "thornton"
    again = pg.open("results/cooling_gas")
    assert again.checks.equals(run.checks) and again.figures.keys() == run.figures.keys()
    assert "run of cooling_gas" in repr(again)


def test_backend_of_matplotlib_is_left_alone():
    line = "import sys, matplotlib, plastigran.bulk, plastigran.bulk.decks as d; "
    line += "[d.deck_class(name) for name in d.deck_names()]; "
    line += "sys.exit('matplotlib.pyplot' in sys.modules)"
    subprocess.run([sys.executable, "-c", line], check=True)


def test_checkpoint_cut_short_is_not_the_newest(short_gas, tmp_path):
    """A checkpoint the log has not come to was being written: the one before is taken."""
    stopped = cut(short_gas, tmp_path / "stopped", lines=8)
    taken = newest_checkpoint(stopped)
    lines = read_series(short_gas)["step"]
    # 25 lines, the last whole one is number 15; there is a checkpoint every other line.
    assert step_of(taken) == lines[14]
    assert (stopped / f"checkpoint.{lines[16]}.restart").exists()


@pytest.mark.parametrize("ranks", [1, 2])
def test_checkpoint_on_a_full_disk_is_not_the_newest(short_gas, ranks, tmp_path):
    """Cut anywhere, by any number of bytes, or filled up with zeros, though the log goes on: the
    one before is taken. Zeros alone after it are ranks without particles. Without checksums, as a
    killed run may leave its checkpoints."""
    folder = tmp_path / "full"
    if ranks == 1:
        shutil.copytree(short_gas, folder)
    else:
        short = SHORT_GAS | {"duration": 2, "rows": 2, "checkpoints": 2}
        run_bulk("cooling_gas", short, folder, ranks, show=False)
    for file in folder.glob(f"{PATTERN}.sha256"):
        file.unlink()
    before, last = sorted(folder.glob(PATTERN), key=step_of)[-2:]
    assert newest_checkpoint(folder) == last
    content = last.read_bytes()
    half = len(content) // 2
    cuts = [content[:kept] for kept in (0, 3, 500, *range(half, len(content), 97))]
    cuts += [content[:-1], content[:half] + bytes(half), content[:half] + bytes(10**6)]
    for cut_short in cuts:
        last.write_bytes(cut_short)
        with pytest.warns(UserWarning, match=f"{last.name} is cut short"):
            assert newest_checkpoint(folder) == before
    last.write_bytes(content + bytes(4 * 3))
    assert newest_checkpoint(folder) == last


def test_going_on_with_another_timestep_is_refused(short_gas, tmp_path):
    with pytest.raises(
        ValueError,
        match=r"4e-08, but the run to continue has 8.0e-8.* may change only checkpoints, contact_h",
    ):
        run_bulk("cooling_gas", {"timestep": 4e-8}, tmp_path / "rest", restart=short_gas)
    assert not (tmp_path / "rest").exists()


def test_no_checkpoint_is_said(tmp_path):
    """The log has not come to the first; the second is cut."""
    (tmp_path / "checkpoint.100.restart").write_bytes(b"half")
    with pytest.raises(EngineError, match="no whole checkpoint"):
        newest_checkpoint(tmp_path)
    (tmp_path / "checkpoint.0.restart").write_bytes(b"half")
    with (
        pytest.warns(UserWarning, match="cut short"),
        pytest.raises(EngineError, match="no whole checkpoint"),
    ):
        newest_checkpoint(tmp_path)


def test_a_file_that_is_no_checkpoint_is_left_alone(short_gas, tmp_path):
    """Of a name that has no step: it is not gone on from, and force does not remove it."""
    folder = tmp_path / "run"
    shutil.copytree(short_gas, folder)
    newest = newest_checkpoint(folder)
    for name in ("checkpoint.old.restart", "checkpoint.999999999.old.restart"):
        shutil.copy(newest, folder / name)
    assert newest_checkpoint(folder) == newest
    run_bulk("cooling_gas", SHORT_GAS, folder, force=True, show=False)
    assert (folder / "checkpoint.old.restart").exists()


def test_checkpoints_beyond_the_log_are_named(short_gas, tmp_path):
    """The newest whole one; a log that is cut or missing does not reach it."""
    folder = tmp_path / "run"
    shutil.copytree(short_gas, folder)
    before, last = sorted(folder.glob(PATTERN), key=step_of)[-2:]
    for file in sorted(folder.glob(PATTERN), key=step_of)[:-2]:
        file.unlink()
    last.write_bytes(b"half")
    log = folder / "log.liggghts"
    lines = read_series(short_gas)["step"]
    text = log.read_text()
    log.write_text(text[: text.rindex(f"\n{lines[3]:8d} ") + 1])
    with pytest.raises(EngineError, match=rf"{log} ends at step {lines[2]}.* {before.name}"):
        newest_checkpoint(folder)
    log.write_text("LIGGGHTS\n")
    with pytest.raises(EngineError, match=rf"{log} shows no step.* {before.name}"):
        newest_checkpoint(folder)
    log.unlink()
    with pytest.raises(EngineError, match=rf"{log} is missing.* {before.name}"):
        newest_checkpoint(folder)


@pytest.fixture
def start(start_plastigran):
    """Starts a long run by the command line and waits for its second checkpoint."""

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
def test_interrupt_stops_every_rank_and_keeps_what_is_written(start, ranks, sent, tmp_path):
    run = start(tmp_path / "run", ranks)
    assert len(engines(tmp_path / "run")) == (1 if ranks == 1 else 3)
    run.send_signal(sent)
    _, message = run.communicate(timeout=60)
    assert run.returncode == 130
    assert f"stopped; continue from its newest checkpoint with --restart {tmp_path}" in message
    assert not engines(tmp_path / "run")
    assert newest_checkpoint(tmp_path / "run").stat().st_size > 0
    assert read_series(tmp_path / "run")["atoms"].eq(125).all()


def test_killed_engine_is_said_and_goes_on_from_its_newest_checkpoint(start, tmp_path):
    run = start(tmp_path / "run", ranks=2)
    os.kill(max(engines(tmp_path / "run")), signal.SIGKILL)  # a rank: they start after mpirun
    _, message = run.communicate(timeout=60)
    assert run.returncode == 1 and "cooling_gas.in" in message
    assert "LIGGGHTS was ended by SIGKILL" in message
    assert f"continue from its newest checkpoint with --restart {tmp_path}" in message
    assert not engines(tmp_path / "run")
    before = read_series(tmp_path / "run")
    checkpoint = newest_checkpoint(tmp_path / "run")
    # Two lines more: the settings that say where it ends may change.
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


def test_killed_python_takes_the_engine_along(start, tmp_path):
    run = start(tmp_path / "run", ranks=2)
    run.kill()
    run.communicate(timeout=60)
    deadline = time.monotonic() + 30
    while engines(tmp_path / "run"):
        assert time.monotonic() < deadline, "the engine runs on"
        time.sleep(0.05)


def test_going_on_at_the_end_is_said(short_gas, tmp_path, capsys):
    line = ["bulk", "cooling_gas", "--restart", str(short_gas), "--output", str(tmp_path / "rest")]
    assert main(line) == 0
    message = f"{short_gas} has reached its end, so there was nothing to compute"
    assert message in capsys.readouterr().out


def test_killed_before_its_first_checkpoint_goes_on_from_where_it_began(short_gas, tmp_path):
    """A run stopped twice, the second time at once: nothing of the first is lost."""
    first = cut(short_gas, tmp_path / "first", lines=8)
    second = tmp_path / "second"
    run_bulk("cooling_gas", {}, second, restart=first, show=False)
    for file in second.glob(PATTERN):
        file.unlink()
    (second / "log.liggghts").write_text("LIGGGHTS\n")
    run_bulk("cooling_gas", {}, tmp_path / "third", restart=second, show=False)
    expected, series = read_series(short_gas), read_series(tmp_path / "third")
    assert (series["kinetic_energy"] == expected["kinetic_energy"]).all()


def test_a_folder_is_locked_until_figures_are_written(tmp_path, monkeypatch):
    """Another run that would overwrite it by force is refused, and deletes nothing."""
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


def test_a_record_nested_too_deeply_is_named(tmp_path, capsys):
    (tmp_path / "run.json").write_text("[" * 100_000 + "]" * 100_000)
    line = ["bulk", "cooling_gas", "--restart", str(tmp_path), "--output", str(tmp_path / "rest")]
    assert main(line) == 1
    assert "run.json is damaged: it is nested too deeply" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("line", "message"),
    [
        (["cooling_gass"], "no deck 'cooling_gass'; there are "),
        (["cooling_gas", "-v", "siide=3"], "has no setting 'siide'; it takes law"),
        (["cooling_gas", "--restart", "/nowhere"], "contains no run.json"),
        (["cooling_gas", "-v", "ledger=ON"], "ledger is 'ON', possible values are off, on"),
        (["bed_impact", "-v", "target=Plate"], "target is 'Plate', possible values are bed, plate"),
    ],
)
def test_wrong_words_are_named(line, message, tmp_path, capsys):
    assert main(["bulk", *line, "--output", str(tmp_path / "run")]) == 1
    assert message in capsys.readouterr().err


def test_materials_are_looked_for_from_the_present_folder(tmp_path, monkeypatch):
    """The engine runs elsewhere and is told the whole path; a link where that has white space."""
    folder = tmp_path / "my metals"
    folder.mkdir()
    write_material(read_material("soft_granules"), folder / "mine.in", "As soft as they are.")
    monkeypatch.chdir(folder)
    settings = SHORT_GAS | {"materials": ".", "material": "mine", "duration": 2, "checkpoints": 1}
    run = run_bulk("cooling_gas", settings, tmp_path / "run", show=False)
    assert run.finished and run.deck.material == "mine"


def test_a_setting_without_a_value_is_named(capsys):
    with pytest.raises(SystemExit):
        main(["bulk", "cooling_gas", "-v", "side"])
    assert "'side' is not name=value" in capsys.readouterr().err


def test_going_on_in_the_same_folder_is_refused(short_gas):
    with pytest.raises(ValueError, match="is the run to continue"):
        run_bulk("cooling_gas", {}, short_gas, restart=short_gas, force=True)
    assert newest_checkpoint(short_gas).exists()


def test_progress_is_read_from_whole_lines_only(tmp_path):
    """Two runs, the second `upto`; a line still being written does not count."""
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
