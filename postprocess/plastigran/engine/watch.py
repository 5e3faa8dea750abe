# SPDX-License-Identifier: GPL-2.0-or-later
"""Start a long run of the engine, show how far it is, and stop it with all its ranks."""

from __future__ import annotations

import ctypes
import re
import signal
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from tqdm import tqdm

from plastigran.engine.process import check_finished, command, surroundings

#: Seconds an engine has to finish its step and close its files when asked to stop.
GRACE = 10.0

_RUN = re.compile(r"run\s+(\d+)(\s+upto)?\s*$")


@dataclass
class Progress:
    """How far a run is, by its log.

    Attributes:
        run: Number of the present `run` command, from 1; 0 before the first.
        first: Step it began with.
        last: Step it will end with.
        step: Step of the newest line.
        time_step: Of the newest line [s]; 0 when the log does not show it.
    """

    run: int = 0
    first: int = 0
    last: int = 0
    step: int = 0
    time_step: float = 0.0


class LogFollower:
    """Reads a growing log, each line once and only when it is whole."""

    def __init__(self, log: Path) -> None:
        self.log = log
        self.progress = Progress()
        self._offset = 0
        self._asked: tuple[int, bool] = (0, False)  # steps of the `run` command, upto
        self._columns: list[str] = []
        self._begun = False

    def read(self) -> Progress:
        """Take in what the log has gained."""
        if not self.log.exists():
            return self.progress
        with open(self.log, "rb") as file:
            file.seek(self._offset)
            text = file.read()
        whole = text.rfind(b"\n") + 1
        self._offset += whole
        for line in text[:whole].decode(errors="replace").splitlines():
            self._take(line)
        return self.progress

    def _take(self, line: str) -> None:
        words = line.split()
        if found := _RUN.match(line):
            self._asked = int(found[1]), bool(found[2])
        elif words[:1] == ["Step"]:
            self._columns, self._begun = words, False
        elif line.startswith("Loop time of"):
            self._columns = []
        elif self._columns and len(words) == len(self._columns) and words[0].isdigit():
            step, progress = int(words[0]), self.progress
            if not self._begun:
                steps, upto = self._asked
                progress.run, progress.first = progress.run + 1, step
                progress.last = steps if upto else step + steps
                self._begun = True
            progress.step = step
            if "Dt" in self._columns:
                progress.time_step = float(words[self._columns.index("Dt")])


def run_watched(
    deck: Path,
    variables: Mapping[str, object],
    folder: Path,
    ranks: int = 1,
    show: bool = True,
    interval: float = 0.2,
) -> None:
    """Run a deck to its end, with a progress bar.

    Whatever ends this function early, Ctrl-C or an error, stops mpirun and its ranks first; what
    they have written stays.

    Args:
        deck: The input script.
        variables: Values for its settings.
        folder: Where results go; it exists.
        ranks: MPI ranks.
        show: Show the bar when standard error is a terminal.
        interval: Seconds between looks at the log.

    Raises:
        EngineError: The engine stopped with an error.
    """
    follower = LogFollower(folder / "log.liggghts")
    bar = tqdm(desc=deck.stem, unit="step", unit_scale=True, disable=None if show else True)
    # A session of its own keeps the terminal's Ctrl-C from the engine: it is stopped from here,
    # once, whether the signal came from a terminal or from another process.
    with open(folder / "screen.txt", "w") as screen:
        engine = subprocess.Popen(
            command(deck, variables, folder, ranks),
            **surroundings(folder, screen),
            start_new_session=True,
            preexec_fn=_end_with_parent,
        )
    try:
        while True:
            try:
                returncode = engine.wait(interval)
                break
            except subprocess.TimeoutExpired:
                _show(bar, follower)
        _show(bar, follower)
    finally:
        bar.close()
        stop(engine)
    check_finished(deck.name, returncode, folder)


def _end_with_parent() -> None:
    """In the engine's process, before it starts: SIGTERM when Python is killed (Linux' prctl)."""
    ctypes.CDLL(None).prctl(1, signal.SIGTERM)  # PR_SET_PDEATHSIG


def _show(bar: tqdm, follower: LogFollower) -> None:
    before = follower.progress.run
    progress = follower.read()
    if not progress.run:
        return
    bar.set_postfix_str(f"t = {progress.step * progress.time_step:.3g} s", refresh=False)
    if progress.run != before:
        bar.reset(progress.last - progress.first)
    bar.update(progress.step - progress.first - bar.n)


def engines(folder: Path) -> list[int]:
    """Process ids of mpirun and the engines at work for a folder, on this machine."""
    log, found = str(folder / "log.liggghts").encode(), []
    for process in Path("/proc").glob("[0-9]*"):
        try:
            words = (process / "cmdline").read_bytes().split(b"\0")
        except OSError:
            continue  # it has ended
        if log in words:
            found.append(int(process.name))
    return found


def stop(engine: subprocess.Popen) -> None:
    """Ask an engine, or mpirun and through it every rank, to stop; kill it after `GRACE`."""
    if engine.poll() is not None:
        return
    engine.terminate()
    try:
        engine.wait(GRACE)
    finally:
        if engine.poll() is None:
            engine.kill()  # ranks end when they find mpirun gone
            engine.wait()
