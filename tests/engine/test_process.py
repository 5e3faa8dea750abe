# SPDX-License-Identifier: GPL-2.0-or-later
"""`run_deck` quotes errors of LIGGGHTS, stops after a time limit, and leaves no process behind."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from plastigran.cli import main
from plastigran.engine.process import EngineStopped, engines, inputs_folder, run_deck
from plastigran.experiments.collision import measure

SHORT = """
# An ERROR in a comment is not an error of the run.
variable output index .
variable inputs index inputs
units si
atom_style granular
newton off
region box block 0 1 0 1 0 1 units box
create_box 1 box
"""
#: A deck that runs for hours.
ENDLESS = (
    SHORT
    + """
communicate single vel yes
neighbor 0.001 bin
fix youngs all property/global youngsModulus peratomtype 5e6
fix poisson all property/global poissonsRatio peratomtype 0.3
fix strength all property/global yieldStrength peratomtype 1e5
pair_style gran model thornton tangential off
pair_coeff * *
create_atoms 1 single 0.5 0.5 0.5
set group all diameter 0.005 density 1500
fix integrate all nve/sphere
timestep 1e-6
thermo 100000
thermo_modify flush yes
run 1000000000
"""
)


@pytest.fixture
def deck(tmp_path):
    """Write a deck and return its path."""

    def write(text: str) -> Path:
        (tmp_path / "deck.in").write_text(text)
        return tmp_path / "deck.in"

    return write


def test_the_word_error_in_a_comment_is_no_error(deck, tmp_path):
    assert "An ERROR in a comment" in run_deck(deck(SHORT), {}, tmp_path)


@pytest.mark.parametrize("ranks", [1, 2])
def test_the_error_is_quoted(deck, ranks, tmp_path):
    with pytest.raises(EngineStopped, match=r"deck.in: ERROR: Unknown command: mistake \(.*log: "):
        run_deck(deck(SHORT + "mistake\n"), {}, tmp_path, ranks)


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_run_that_takes_too_long_is_stopped(deck, ranks, tmp_path):
    with pytest.raises(EngineStopped, match=r"deck.in: stopped after 0.5 s"):
        run_deck(deck(ENDLESS), {}, tmp_path, ranks, timeout=0.5)
    assert not engines(tmp_path)


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("sent", [signal.SIGTERM, signal.SIGKILL, signal.SIGHUP])
def test_liggghts_ends_with_the_process_that_started_it(deck, ranks, sent, tmp_path):
    """LIGGGHTS ends if a signal ends the Python process that started it.

    The Python process ignores SIGINT, as a job in the background of a shell does.
    """
    script = "import signal, sys; from plastigran.engine.process import run_deck\n"
    script += "signal.signal(signal.SIGHUP, signal.SIG_DFL)\n"
    script += "run_deck(sys.argv[1], {}, sys.argv[2], int(sys.argv[3]), timeout=None)"
    words = [sys.executable, "-c", script, deck(ENDLESS), tmp_path, str(ranks)]
    python = subprocess.Popen(
        words, preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN)
    )
    try:
        # Python alone takes a minute to start on a busy machine.
        wait_until(lambda: at_work(tmp_path) or python.poll() is not None, seconds=300)
        assert len(engines(tmp_path)) == (1 if ranks == 1 else 3)
    finally:
        python.send_signal(sent)
        python.wait()
    wait_until(lambda: not engines(tmp_path))


def at_work(folder: Path) -> bool:
    log = folder / "log.liggghts"
    return log.exists() and "Step" in log.read_text(errors="replace")


def wait_until(true, seconds: float = 60) -> None:
    deadline = time.monotonic() + seconds
    while not true():
        assert time.monotonic() < deadline
        time.sleep(0.02)


@pytest.mark.parametrize("ranks", [1, 2])
def test_paths_may_hold_spaces(ranks, tmp_path, monkeypatch):
    """Paths of input scripts and results may have spaces, at which LIGGGHTS itself would split
    them."""
    inputs = tmp_path / "my inputs"
    inputs.symlink_to(inputs_folder())
    monkeypatch.setenv("PLASTIGRAN_INPUTS", str(inputs))
    folder = tmp_path / "my results"
    run_deck("collision/two_spheres.in", {}, folder, ranks)
    assert (folder / "trajectory.dump").stat().st_size > 1000
    other = tmp_path / "results"  # LIGGGHTS runs in another folder, as for a user's deck
    run_deck("collision/two_spheres.in", {}, other, ranks, working_folder=tmp_path)
    assert (other / "trajectory.dump").stat().st_size > 1000


def test_commands_of_a_dry_run_can_be_typed(tmp_path, monkeypatch, capsys):
    inputs, folder = tmp_path / "my inputs", tmp_path / "my results"
    inputs.symlink_to(inputs_folder())
    monkeypatch.setenv("PLASTIGRAN_INPUTS", str(inputs))
    line = ["impact", "--law", "thornton", "--speed", "0.1", "--output", str(folder), "--dry-run"]
    assert main(line) == 0
    *typed, last = capsys.readouterr().out.splitlines(keepends=True)
    assert last == "1 runs; nothing was started\n" and not folder.exists()
    done = subprocess.run(["sh", "-ec", "".join(typed)], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr
    (trajectory,) = folder.glob("runs/0000_*/trajectory.dump")
    assert measure(trajectory).coefficient_of_restitution < 1
