# SPDX-License-Identifier: GPL-2.0-or-later
"""Read the log of LIGGGHTS or LAMMPS: progress, thermodynamic output, warnings and errors."""

from __future__ import annotations

import re
import warnings
from contextlib import suppress
from dataclasses import dataclass
from math import nan
from pathlib import Path

import numpy as np
import pandas as pd

from plastigran.engine.dumps import DumpError, TruncatedFileWarning

#: Upper bound of step numbers, because tables store steps as 64-bit integers.
LARGEST_STEP = 2.0**63
#: File names of the log in the folder of a run, by the name of the host.
LOGS = {"liggghts": "log.liggghts", "lammps": "log.lammps"}
LOG = LOGS["liggghts"]

THERMO_COLUMNS = {
    "Step": "step",
    "Dt": "timestep",
    "Time": "time",
    "Atoms": "atoms",
    "KinEng": "kinetic_energy",
    "CPU": "cpu_time",
}
_RUN = re.compile(r"run\s+(\d+)(\s+upto)?\s*$")
#: Line with the total number of steps, which a deck with several `run` commands prints first.
_PLANNED = re.compile(r"planned steps = (\d+)\s*$")
#: Error line of LIGGGHTS. ERROR must start the line, because a deck may print or echo this word.
_ERROR = re.compile(r"^ERROR(?: on proc \d+)?: .*", re.MULTILINE)
#: Warning of the plugin or launcher, without its position in the source code.
_WARNING = re.compile(r"^WARNING: (?:\S+/)?plastigran: (.*?)(?: \(\S+:\d+\))?$", re.M)
#: Line in which a contact model of this project prints the name of its law before the first run.
_LAW = re.compile(r"^plastigran law (\w+)$", re.M)
#: Echoed pair_style command. LIGGGHTS echoes a command first as typed, then with the values of
#: variables; only the second form matches.
_PAIR_STYLE = re.compile(r"^pair_style\s+([^$\n]+)$", re.M)
_UNITS = re.compile(r"^units\s+(\w+)\s*$", re.M)
#: Line at the end of a run for each law whose validity range was exceeded.
_EXCESS = re.compile(r"^plastigran range (\w+) contacts=\S+ furthest=(\S+)$", re.M)
_NUMBER = re.compile(r"\d[\d.e+-]*")


def log_path(folder: str | Path) -> Path:
    """Return the path of the log in the folder of a run; by default, the path for LIGGGHTS."""
    paths = [Path(folder) / name for name in LOGS.values()]
    return next((path for path in paths if path.is_file()), paths[0])


def find_excess(text: str) -> dict[str, float]:
    """Return the largest overlap / largest valid overlap of each law whose range was exceeded."""
    excess: dict[str, float] = {}
    for law, furthest in _EXCESS.findall(text):
        excess[law] = max(float(furthest), excess.get(law, 0.0))
    return excess


def find_error(text: str) -> str | None:
    """Return the last error message in a log or screen output; None if there is no error."""
    return next(reversed(_ERROR.findall(text)), None)


def find_warnings(text: str) -> list[str]:
    """Return the warnings of the contact models and of the launcher in a log, in order.

    Warnings that differ only in numbers count as one; the last of them is returned.
    """
    distinct = dict.fromkeys(_WARNING.findall(text))
    return list({_NUMBER.sub("", warning): warning for warning in distinct}.values())


def find_models(text: str) -> list[str]:
    """Return the names of this project's contact laws in a log, each once, in order."""
    return list(dict.fromkeys(_LAW.findall(text)))


def find_pair_style(text: str) -> str | None:
    """Return the arguments of the last `pair_style` command in a log; None if there is none."""
    arguments = next(reversed(_PAIR_STYLE.findall(text)), None)
    return arguments and " ".join(arguments.split())


def find_units(text: str) -> str | None:
    """Return the argument of the last `units` command in a log; None if there is none."""
    return next(reversed(_UNITS.findall(text)), None)


@dataclass
class Progress:
    """Progress of LIGGGHTS from its log.

    Attributes:
        run: Number of the current `run` command, from 1; 0 before the first `run` command.
        first: First step of the current `run` command.
        last: Last step of the current `run` command.
        step: Step in the newest line of output.
        timestep: Time step in the newest line of output [s]; 0 if the log does not contain it.
        planned: Total steps of all `run` commands of the deck; 0 if the log does not contain it.
        earlier: Number of steps of all completed `run` commands.
    """

    run: int = 0
    first: int = 0
    last: int = 0
    step: int = 0
    timestep: float = 0.0
    planned: int = 0
    earlier: int = 0


class LogFollower:
    """Reader of a growing log. Every line is read once, as soon as the line is complete."""

    def __init__(self, log: Path) -> None:
        self.log = log
        self.progress = Progress()
        self._offset = 0
        # Number of steps of the last `run` command, and whether it has the keyword upto.
        self._steps, self._upto = 0, False
        self._columns: list[str] = []
        self._run_has_lines = False

    def read(self) -> Progress:
        """Read the new lines of the log, and return the updated progress."""
        if not self.log.exists():
            return self.progress
        with open(self.log, "rb") as file:
            file.seek(self._offset)
            text = file.read()
        complete = text.rfind(b"\n") + 1
        self._offset += complete
        for line in text[:complete].decode(errors="replace").splitlines():
            self._read_line(line)
        return self.progress

    def _read_line(self, line: str) -> None:
        words = line.split()
        if command := _RUN.match(line):
            self._steps, self._upto = int(command[1]), bool(command[2])
        elif planned := _PLANNED.match(line):
            self.progress.planned = int(planned[1])
        elif words[:1] == ["Step"]:
            self._columns, self._run_has_lines = words, False
        elif line.startswith("Loop time of"):
            self._columns = []
        elif self._columns and len(words) == len(self._columns) and words[0].isdigit():
            self._read_row(dict(zip(self._columns, words, strict=True)))

    def _read_row(self, row: dict[str, str]) -> None:
        step, progress = int(row["Step"]), self.progress
        if not self._run_has_lines:
            progress.earlier += progress.step - progress.first
            progress.run, progress.first = progress.run + 1, step
            progress.last = self._steps if self._upto else step + self._steps
            self._run_has_lines = True
        progress.step = step
        progress.timestep = float(row.get("Dt", progress.timestep))


@dataclass
class LoggedRun:
    """Thermodynamic output of one `run` command in a log.

    Attributes:
        columns: Names of the columns.
        rows: Values in each complete line of output.
        timestep: Time step [s]; NaN if unknown, or if LIGGGHTS may change it.
        simulation: Number of `clear` commands before the `run` command. Each `clear` starts a new
            simulation.
        finished: Whether the log contains the end of the `run` command.
    """

    columns: list[str]
    rows: list[list[float]]
    timestep: float
    simulation: int
    finished: bool = False


def read_runs(path: str | Path) -> list[LoggedRun]:
    """Read the thermodynamic output of each `run` command in a log, in order."""
    runs: list[LoggedRun] = []
    timestep, adaptive, simulation = nan, False, 0
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            words = line.split("#")[0].split()
            if words[:1] == ["Step"]:
                runs.append(LoggedRun(words, [], nan if adaptive else timestep, simulation))
            elif runs and not runs[-1].finished and line.startswith("Loop time of"):
                runs[-1].finished = True
            elif words[:1] == ["timestep"]:
                # For a variable, the result is NaN; the next line of the log contains its value.
                timestep = _number(words[1:])
            elif words[:1] == ["fix"] and words[3:4] == ["dt/reset"]:
                adaptive = True
            elif words == ["clear"]:
                timestep, adaptive, simulation = nan, False, simulation + 1
            elif runs and not runs[-1].finished and len(words) == len(runs[-1].columns):
                if line.endswith("\n"):
                    with suppress(ValueError):  # ignore messages between two lines of output
                        runs[-1].rows.append([float(word) for word in words])
    return runs


def read_thermo(path: str | Path) -> pd.DataFrame:
    """Read the thermodynamic output of a log file.

    Returns:
        One row per output line. The columns are `run` (0, 1, … in the order of the `run` commands)
        and the columns of the log. `THERMO_COLUMNS` lists the columns that get a new name.

    Raises:
        DumpError: The log has no thermodynamic output, or a step is not a whole number.

    Warns:
        TruncatedFileWarning: The log ends within a run; the complete rows are returned.
    """
    return thermo_table(path, read_runs(path))


def thermo_table(path: str | Path, runs: list[LoggedRun]) -> pd.DataFrame:
    """Return the table of `read_thermo` for the result of `read_runs`.

    Errors and warnings are as for `read_thermo`.
    """
    if not runs:
        raise DumpError(f"{path}: no thermodynamic output (no line starting with 'Step')")
    if not runs[-1].finished:
        warnings.warn(
            f"{path} ends within run {len(runs) - 1}; the rows before the end were read",
            TruncatedFileWarning,
            stacklevel=3,
        )
    tables = [pd.DataFrame(run.rows, columns=_distinct(run.columns)) for run in runs]
    for number, table in enumerate(tables):
        table.insert(0, "run", number)
    table = pd.concat(tables, ignore_index=True)
    for step in table["step"][~(table["step"].abs() < LARGEST_STEP) | (table["step"] % 1 != 0)]:
        raise DumpError(f"{path} is damaged: a line has step {step:g}, not an integer below 2^63")
    return table.astype({"step": np.int64})


def _number(words: list[str]) -> float:
    """Return the number that is the only word in a list; NaN for any other list."""
    try:
        (word,) = words
        return float(word.strip("\"'"))
    except ValueError:
        return nan


def _distinct(names: list[str]) -> list[str]:
    """Return distinct column names: repeated names get a number.

    LIGGGHTS truncates long names, so columns may have the same name.
    """
    columns: list[str] = []
    counts: dict[str, int] = {}
    for name in (THERMO_COLUMNS.get(name, name) for name in names):
        counts[name] = counts.get(name, 0) + 1
        columns.append(name if counts[name] == 1 else f"{name}.{counts[name]}")
    return columns
