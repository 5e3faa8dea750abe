# SPDX-License-Identifier: GPL-2.0-or-later
"""The folder of a bulk run: its record, the series of its log, the numbers its deck derived.

It holds `run.json` (deck, every setting, ranks, versions), `deck/` (the deck as it ran, with its
includes), the logs, numbered checkpoints, and at the end `series.csv`, `checks.csv` and `figures/`.
"""

from __future__ import annotations

import json
import re
import shutil
import warnings
from itertools import islice
from math import nan
from pathlib import Path
from typing import TextIO

import numpy as np
import pandas as pd

from plastigran.engine.checkpoints import (
    CHECKSUM,
    OF_A_SIGNAL,
    PATTERN,
    checkpoints,
    is_numbered,
    newest_checkpoint,
)
from plastigran.engine.dumps import DumpError, TruncatedFileWarning
from plastigran.engine.log import LOG, find_excess, read_commands, read_thermo
from plastigran.engine.process import EngineError, engines

RECORD = "run.json"
#: The log's lines up to the checkpoint a run went on from.
BEFORE = "before.csv"
SERIES = "series.csv"
CHECKS = "checks.csv"
#: Frames of the grains, which decks append to.
DUMP = "grains.dump"
#: Collision spectra, whose tables the engine adds; it takes those after a checkpoint away itself.
SPECTRA = "collision_spectra.csv"
#: Files of a run, which are removed before another overwrites it, as its checkpoints are.
OWN_FILES = (
    RECORD,
    f"{RECORD}.new",
    BEFORE,
    LOG,
    "screen.txt",
    f"{OF_A_SIGNAL}_*",
    DUMP,
    SPECTRA,
    SERIES,
    CHECKS,
    f"{PATTERN}{CHECKSUM}*",
)

_DERIVED = re.compile(r"^derived (\w+) = (\S+)\s*$", re.MULTILINE)


def read_record(folder: str | Path) -> dict:
    """What `run.json` says. Raises EngineError when there is none, or it is not that of a run."""
    path = Path(folder) / RECORD
    if not path.is_file():
        raise EngineError(f"{folder} holds no {RECORD}; it is not a run of `plastigran bulk`")
    try:
        record = json.loads(path.read_text())
    except ValueError as error:
        raise EngineError(f"{path}: {error}") from None
    except RecursionError:
        raise EngineError(f"{path} is damaged: it is nested too deeply for a record") from None
    kinds = {"deck": str, "values": dict, "settings": dict}
    if not isinstance(record, dict) or not all(
        isinstance(record.get(name), kind) for name, kind in kinds.items()
    ):
        raise EngineError(f"{path} is not the record of a run: it names no deck and settings")
    contents = {"values": str, "settings": str, "versions": str, "derived": int | float}
    contents["excess"] = int | float
    for name, kind in contents.items():
        found = record.get(name, {})
        if not isinstance(found, dict) or not all(isinstance(v, kind) for v in found.values()):
            raise EngineError(f"{path} is damaged: its {name} are not those of a run")
    if not isinstance(record.get("restart"), str | None):
        raise EngineError(f"{path} is damaged: its restart is no folder")
    return record


def write_record(folder: Path, record: dict) -> None:
    """Write `run.json`, whole or not at all."""
    draft = folder / f"{RECORD}.new"
    draft.write_text(json.dumps(record, indent=2) + "\n")
    draft.replace(folder / RECORD)


def prepare_folder(folder: Path, force: bool) -> None:
    """An empty folder for a run; of one that holds a run only that run's own files are removed.

    Raises:
        ValueError: It holds files and `force` is not given, or they are not those of a run, or an
            engine of this machine is writing there.
    """
    if at_work := engines(folder):
        raise ValueError(f"{folder} is being written to by the engine (process {at_work[0]})")
    if folder.exists() and any(folder.iterdir()):
        if not force:
            raise ValueError(
                f"{folder} holds results; choose another folder (--output), or overwrite "
                "them (--force)"
            )
        if not (folder / RECORD).is_file():
            raise ValueError(
                f"{folder} holds files but no {RECORD}; only runs are overwritten by force"
            )
        for file in checkpoints(folder):  # above all: they may be newer than ours
            file.unlink()
        for pattern in OWN_FILES:
            for file in folder.glob(pattern):
                file.unlink()
        for name in ("deck", "figures", "frames"):
            shutil.rmtree(folder / name, ignore_errors=True)
    folder.mkdir(parents=True, exist_ok=True)


def read_series(folder: str | Path) -> pd.DataFrame:
    """The log of a run from step 0 on, whatever checkpoints it went on from.

    Returns:
        One row a line: `step`, `time` [s] from step 0, then the deck's columns in SI units. Of a
        deck without a class every run is there, by number in `run`, and `time` where the log has
        it or `timestep` commands of the deck give it, on from run to run. Where the deck has a
        `clear` command, `simulation` counts what it has begun anew.

    Raises:
        DumpError: There is no log, or it shows nothing yet.
    """
    folder, parts = Path(folder), []
    if (before := folder / BEFORE).exists():
        try:
            parts.append(pd.read_csv(before).astype({"step": int}))
        except (KeyError, ValueError) as error:
            raise DumpError(f"{before} is damaged: {error}") from None
    try:
        parts.append(_read_own_log(folder) if _is_own(folder) else _read_log(folder))
    except DumpError:
        if not parts:  # else the run was stopped before its first line
            raise
    parts = [part for part in parts if len(part)] or parts[-1:]
    if len(parts) == 2 and _is_own(folder):
        parts = _joined_times(*_joined_simulations(*parts))
    series = _once_a_step(pd.concat(parts, ignore_index=True))
    only_one = "simulation" in series and not series["simulation"].any()
    return series.drop(columns="simulation") if only_one else series


def _once_a_step(series: pd.DataFrame) -> pd.DataFrame:
    """One line of a step where one run ends and the next begins, or goes on from its checkpoint.

    It is the earlier one: while setting up, meshes know no forces. What it lacks, because a deck
    has asked for other columns since, is the later one's. Steps may be counted anew.
    """
    told_by = series[["step", "simulation"] if "simulation" in series else ["step"]]
    steps = (told_by != told_by.shift()).any(axis="columns").cumsum()
    return series.groupby(steps).first().reset_index(drop=True)


def rows_up_to(series: pd.DataFrame, step: int) -> pd.DataFrame:
    """The rows of a series up to the last that a checkpoint of a step comes after."""
    (reached,) = np.nonzero(series["step"] <= step)
    return series.iloc[: reached.max(initial=-1) + 1]


def _is_own(folder: Path) -> bool:
    return (folder / RECORD).is_file() and bool(read_record(folder).get("own"))


def _read_thermo(folder: Path) -> pd.DataFrame:
    if not (folder / LOG).is_file():
        raise DumpError(f"{folder} holds no {LOG}")
    with warnings.catch_warnings():
        # The run was stopped: its end is known.
        warnings.simplefilter("ignore", TruncatedFileWarning)
        return read_thermo(folder / LOG)


def _joined_simulations(before: pd.DataFrame, after: pd.DataFrame) -> list[pd.DataFrame]:
    """A log and the one that goes on from it, whose first simulation is the other's last."""
    before = before.assign(simulation=before.get("simulation", 0))
    begun = before["simulation"].iloc[-1]
    return [before, after.assign(simulation=after["simulation"] + begun)]


def _joined_times(before: pd.DataFrame, after: pd.DataFrame) -> list[pd.DataFrame]:
    """A log and the one that goes on from it, the time too; without it where one has none.

    The engine's time begins anew at a checkpoint.
    """
    if not ("time" in before and "time" in after):
        return [series.drop(columns="time", errors="ignore") for series in (before, after)]
    begins = before["time"].iloc[-1]
    gap = after["step"].iloc[0] - before["step"].iloc[-1]
    steps = after.groupby("run")["step"].diff()
    if gap > 0 and (steps > 0).any():  # a checkpoint may lie between two lines of the log before
        line = (steps > 0).idxmax()
        begins += gap * (after["time"].diff() / steps)[line]
    return [before, after.assign(time=after["time"] + (begins - after["time"].iloc[0]))]


def _read_own_log(folder: Path) -> pd.DataFrame:
    series = _read_thermo(folder)
    commands = read_commands(folder / LOG)
    series["simulation"] = [commands[run].simulation for run in series["run"]]
    time = _summed_time(series, [run.timestep for run in commands])
    if time.notna().all():
        series["time"] = time
    else:
        series = series.drop(columns="time", errors="ignore")
    return series.rename(columns=lambda name: name.removeprefix("v_"))


def _summed_time(series: pd.DataFrame, said: list[float]) -> pd.Series:
    """Time of every line [s], run after run: a run may count its steps anew, and have a time step
    of its own.

    Args:
        series: As `read_thermo` gives it.
        said: Time step of each run [s], for those without a column of it or of the time.
    """
    times, end = pd.Series(nan, series.index), None
    for number, run in series.groupby("run"):
        time = _time_of_run(run, said[number])
        times[run.index] = time if end is None else time + (end - time.iloc[0])
        end = times[run.index[-1]]
    return times


def _time_of_run(run: pd.DataFrame, said: float) -> pd.Series:
    """Time of a run's lines [s]; nan where it cannot be known."""
    if "time" in run and run["time"].notna().all():
        return run["time"]
    if "timestep" in run and run["timestep"].notna().all():
        said = run["timestep"].iloc[0] if run["timestep"].nunique() == 1 else nan
    begins = run["step"].iloc[0]
    passed = run["step"] - begins
    began = begins * said if begins else 0.0
    return began + (passed * said).where(passed > 0, 0.0)


def _read_log(folder: Path) -> pd.DataFrame:
    log = _read_thermo(folder)
    series = log[log["run"] == log["run"].max()].drop(columns="run").reset_index(drop=True)
    series.insert(1, "time", series["step"] * series.pop("timestep"))
    return series.rename(columns=lambda name: name.removeprefix("v_"))


def all_derived(folder: str | Path) -> dict[str, float]:
    """What a run's deck has printed as `derived NAME = VALUE`; a run gone on has its start's too.

    Raises:
        EngineError: The folder holds no run.
    """
    log = Path(folder) / LOG
    printed = _DERIVED.findall(log.read_text(errors="replace")) if log.exists() else []
    earlier = read_record(folder).get("derived", {})
    return earlier | {name: float(value) for name, value in printed}


def all_excess(folder: str | Path) -> dict[str, float]:
    """What `find_excess` reads of a run's log, and of those of the runs it continues.

    Raises:
        EngineError: The folder holds no run.
    """
    log = Path(folder) / LOG
    excess = find_excess(log.read_text(errors="replace")) if log.exists() else {}
    for law, furthest in read_record(folder).get("excess", {}).items():
        excess[law] = max(furthest, excess.get(law, 0.0))
    return excess


def read_derived(folder: str | Path, name: str) -> float:
    """One of `all_derived`. Raises ValueError when it was not printed."""
    try:
        return all_derived(folder)[name]
    except KeyError:
        raise ValueError(f"{folder}: its log says no `derived {name} = `") from None


def carry_files(earlier: Path, folder: Path, last: int) -> None:
    """Copy what the engine adds to: collision spectra of an earlier run, and its whole frames
    before a step.
    """
    if (earlier / SPECTRA).exists():
        shutil.copy(earlier / SPECTRA, folder)
    if not (earlier / DUMP).exists():
        return
    with open(earlier / DUMP) as dump, open(folder / DUMP, "w") as kept:
        while frame := _next_frame(dump):
            if int(frame[1]) < last:
                kept.writelines(frame)


def _next_frame(dump: TextIO) -> list[str]:
    """Lines of the next frame of a dump: nine of head, then the atoms; none where it is cut."""
    head = list(islice(dump, 9))
    if len(head) < 9:
        return []
    frame = head + list(islice(dump, int(head[3])))
    return frame if len(frame) == 9 + int(head[3]) and frame[-1].endswith("\n") else []


def restart_point(folder: Path, record: dict) -> Path:
    """The newest whole checkpoint of a run; of one stopped before its first, where it began.

    Raises:
        EngineError: There is none.
    """
    try:
        return newest_checkpoint(folder)
    except EngineError:
        began = Path(record["values"].get("checkpoint", "none"))
        if not (began.is_file() and is_numbered(began)):
            raise
        return began
