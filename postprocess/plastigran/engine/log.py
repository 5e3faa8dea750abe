# SPDX-License-Identifier: GPL-2.0-or-later
"""Read the log of LIGGGHTS: progress, thermodynamic output, and errors."""

from __future__ import annotations

import re
import warnings
from dataclasses import dataclass
from math import nan
from pathlib import Path

import numpy as np
import pandas as pd

from plastigran.engine.dumps import DumpError, TruncatedFileWarning

#: Upper bound of steps, 2^63.
LARGEST_STEP = 2.0**63
#: Name of the log in the folder of a run.
LOG = "log.liggghts"

THERMO_COLUMNS = {
    "Step": "step",
    "Dt": "timestep",
    "Time": "time",
    "Atoms": "atoms",
    "KinEng": "kinetic_energy",
    "CPU": "cpu_time",
}
_RUN = re.compile(r"run\s+(\d+)(\s+upto)?\s*$")
#: Line of a deck with several runs, printed before the first.
_PLANNED = re.compile(r"planned steps = (\d+)\s*$")
#: Error line of LIGGGHTS. A deck may also print or echo the word.
_ERROR = re.compile(r"^ERROR(?: on proc \d+)?: .*", re.MULTILINE)
#: Warning of the plugin or launcher, without the place in the source.
_WARNING = re.compile(r"^WARNING: plastigran: (.*?)(?: \(\S+:\d+\))?$", re.M)
#: Machine-readable line of a contact model before its first run.
_LAW = re.compile(r"^plastigran law (\w+)$", re.M)
#: LIGGGHTS echoes a command as typed, then with the values of its variables.
_PAIR_STYLE = re.compile(r"^pair_style\s+([^$\n]+)$", re.M)
_UNITS = re.compile(r"^units\s+(\w+)\s*$", re.M)
#: Machine-readable line at the end of a run.
_EXCESS = re.compile(r"^plastigran range (\w+) contacts=\S+ furthest=(\S+)$", re.M)
_NUMBER = re.compile(r"\d[\d.e+-]*")


def find_excess(text: str) -> dict[str, float]:
    """Return the largest overlap / validity range of each law whose range was exceeded."""
    excess: dict[str, float] = {}
    for law, furthest in _EXCESS.findall(text):
        excess[law] = max(float(furthest), excess.get(law, 0.0))
    return excess


def find_error(text: str) -> str | None:
    """Return the last error line of a log or screen; None without error."""
    return next(reversed(_ERROR.findall(text)), None)


def find_warnings(text: str) -> list[str]:
    """Return the warnings of contact models and launcher in a log, each once, in order."""
    return list(dict.fromkeys(_WARNING.findall(text)))


def worst(found: list[str]) -> list[str]:
    """Return the last of warnings that differ only in numbers, because it is the worst."""
    return list({_NUMBER.sub("", warning): warning for warning in found}.values())


def find_models(text: str) -> list[str]:
    """Return the names of this project's contact models in a log, each once, in order."""
    return list(dict.fromkeys(_LAW.findall(text)))


def find_pair_style(text: str) -> str | None:
    """Return the arguments of the last `pair_style` command in a log; None without one."""
    found = _PAIR_STYLE.findall(text)
    return " ".join(found[-1].split()) if found else None


def find_units(text: str) -> str | None:
    """Return the unit system in a log; None without one."""
    return next(reversed(_UNITS.findall(text)), None)


@dataclass
class Progress:
    """Progress of a run from its log.

    Attributes:
        run: Number of the current `run` command, from 1; 0 before the first.
        first: First step of this command.
        last: Last step of this command.
        step: Step of the newest line.
        timestep: Time step of the newest line [s]; 0 if the log does not show it.
        planned: Total steps of all runs of the deck; 0 if the log does not show it.
        earlier: Steps of completed runs.
    """

    run: int = 0
    first: int = 0
    last: int = 0
    step: int = 0
    timestep: float = 0.0
    planned: int = 0
    earlier: int = 0


class LogFollower:
    """Reads a growing log; each line once and only when it is complete."""

    def __init__(self, log: Path) -> None:
        self.log = log
        self.progress = Progress()
        self._offset = 0
        self._asked: tuple[int, bool] = (0, False)  # steps of the `run` command, whether upto
        self._columns: list[str] = []
        self._begun = False

    def read(self) -> Progress:
        """Read the new lines of the log."""
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
        elif found := _PLANNED.match(line):
            self.progress.planned = int(found[1])
        elif words[:1] == ["Step"]:
            self._columns, self._begun = words, False
        elif line.startswith("Loop time of"):
            self._columns = []
        elif self._columns and len(words) == len(self._columns) and words[0].isdigit():
            step, progress = int(words[0]), self.progress
            if not self._begun:
                steps, upto = self._asked
                progress.earlier += progress.step - progress.first
                progress.run, progress.first = progress.run + 1, step
                progress.last = steps if upto else step + steps
                self._begun = True
            progress.step = step
            if "Dt" in self._columns:
                progress.timestep = float(words[self._columns.index("Dt")])


def read_thermo(path: str | Path) -> pd.DataFrame:
    """Read the thermodynamic output of a log file.

    Args:
        path: Log file.

    Returns:
        One row per output line: `run` (0, 1, … in the order of the `run` commands), then the
            columns of the log, with common ones renamed by `THERMO_COLUMNS`.

    Raises:
        DumpError: The log has no thermodynamic output, or a step is not a whole number.
    """
    path = Path(path)
    tables, header, rows, whole = [], None, [], True
    run = -1
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            words = line.split()
            if words[:1] == ["Step"]:
                header, rows, whole = words, [], False
                run += 1
                tables.append((run, header, rows))
            elif header and line.startswith("Loop time of"):
                header, whole = None, True
            elif header and len(words) == len(header) and line.endswith("\n"):
                try:
                    rows.append([float(word) for word in words])
                except ValueError:
                    continue  # a message between two rows
    if not tables:
        raise DumpError(f"{path}: no thermodynamic output (no line starting with 'Step')")
    if not whole:
        warnings.warn(
            f"{path} ends within run {run}; the rows before the end were read",
            TruncatedFileWarning,
            stacklevel=2,
        )
    frames = []
    for number, names, values in tables:
        frame = pd.DataFrame(values, columns=_distinct(names))
        frame.insert(0, "run", number)
        frames.append(frame)
    table = pd.concat(frames, ignore_index=True)
    for step in table["step"][~(table["step"].abs() < LARGEST_STEP) | (table["step"] % 1 != 0)]:
        raise DumpError(f"{path} is damaged: a line has step {step:g}, which is too large")
    return table.astype({"step": np.int64})


@dataclass(frozen=True)
class RunCommands:
    """Effect of the commands before a run.

    Attributes:
        timestep: Time step [s]; NaN if unknown, or if LIGGGHTS may change it.
        simulation: Number of earlier `clear` commands.
    """

    timestep: float
    simulation: int


def read_commands(path: str | Path) -> list[RunCommands]:
    """Return the effect of commands on each run of a log, in the order of `read_thermo`."""
    timestep, changes, simulation, found = nan, False, 0, []
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            words = line.split("#")[0].split()
            if words[:1] == ["Step"]:
                found.append(RunCommands(nan if changes else timestep, simulation))
            elif words[:1] == ["timestep"]:
                timestep = _number(words[1:])  # the value of the variable is in the next line
            elif words[:1] == ["fix"] and words[3:4] == ["dt/reset"]:
                changes = True
            elif words == ["clear"]:
                timestep, changes, simulation = nan, False, simulation + 1
    return found


def _number(words: list[str]) -> float:
    """Return the only number in the words of a command; NaN if there is none or several."""
    try:
        (word,) = words
        return float(word.strip("\"'"))
    except ValueError:
        return nan


def _distinct(names: list[str]) -> list[str]:
    """Return distinct column names; LIGGGHTS truncates long ones, and equal ones get a number."""
    seen: dict[str, int] = {}
    columns = []
    for name in (THERMO_COLUMNS.get(name, name) for name in names):
        seen[name] = seen.get(name, 0) + 1
        columns.append(name if seen[name] == 1 else f"{name}.{seen[name]}")
    return columns
