# SPDX-License-Identifier: GPL-2.0-or-later
"""Folder of a bulk run: its record, the series of its log, and numbers that its deck derived.

It contains `run.json` (deck, settings, ranks, versions), `deck/` (the deck as it ran, with its
includes), the logs, numbered checkpoints, and after the run `series.csv`, `checks.csv` and
`figures/`.
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
#: Rows of the earlier run up to the checkpoint from which this run continues.
BEFORE = "before.csv"
SERIES = "series.csv"
CHECKS = "checks.csv"
#: Frames of the grains, to which decks append.
DUMP = "grains.dump"
#: Collision spectra; LIGGGHTS appends tables and removes those after a checkpoint itself.
SPECTRA = "collision_spectra.csv"
#: Files of a run, which are removed together with its checkpoints before it is overwritten.
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
    """Read `run.json`.

    Raises:
        EngineError: The file is missing, is not valid JSON, or is not the record of a run.
    """
    path = Path(folder) / RECORD
    if not path.is_file():
        raise EngineError(f"{folder} contains no {RECORD}; it is not a run of `plastigran bulk`")
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
            raise EngineError(f"{path} is damaged: entry {name} has a wrong type")
    if not isinstance(record.get("restart"), str | None):
        raise EngineError(f"{path} is damaged: entry restart must be a folder")
    return record


def write_record(folder: Path, record: dict) -> None:
    """Write `run.json` completely or not at all."""
    draft = folder / f"{RECORD}.new"
    draft.write_text(json.dumps(record, indent=2) + "\n")
    draft.replace(folder / RECORD)


def prepare_folder(folder: Path, force: bool) -> None:
    """Create the folder of a run, or remove the files of an earlier run from it. Other files stay.

    Raises:
        ValueError: The folder contains files and `force` is not given; the files are not those of a
            run; or LIGGGHTS is writing there.
    """
    if at_work := engines(folder):
        raise ValueError(
            f"{folder} is in use by LIGGGHTS (process {at_work[0]}). Wait for the "
            "run to end, stop it, or choose another --output"
        )
    if folder.exists() and any(folder.iterdir()):
        if not force:
            raise ValueError(
                f"{folder} holds results; choose another folder (--output), or overwrite "
                "them (--force)"
            )
        if not (folder / RECORD).is_file():
            raise ValueError(
                f"{folder} contains files but no {RECORD}, so --force does not overwrite it. "
                "Choose another --output"
            )
        # first, because they could be newer than those of this run
        for file in checkpoints(folder):
            file.unlink()
        for pattern in OWN_FILES:
            for file in folder.glob(pattern):
                file.unlink()
        for name in ("deck", "figures", "frames"):
            shutil.rmtree(folder / name, ignore_errors=True)
    folder.mkdir(parents=True, exist_ok=True)


def read_series(folder: str | Path) -> pd.DataFrame:
    """Read the log of a run from step 0, including the earlier parts of a continued run.

    Returns:
        One row per line: `step`, `time` [s] from step 0, then the deck's columns in SI units. For a
        user's deck, column `run` numbers its runs. `time` is then there if the log has it, or if
        `timestep` commands give it; it continues over all runs. If the deck has a `clear` command,
        `simulation` numbers the parts between them.

    Raises:
        DumpError: The log is missing or has no rows.
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
        if not parts:  # otherwise the run was stopped before its first line
            raise
    parts = [part for part in parts if len(part)] or parts[-1:]
    if len(parts) == 2 and _is_own(folder):
        parts = _joined_times(*_joined_simulations(*parts))
    series = _once_a_step(pd.concat(parts, ignore_index=True))
    only_one = "simulation" in series and not series["simulation"].any()
    return series.drop(columns="simulation") if only_one else series


def _once_a_step(series: pd.DataFrame) -> pd.DataFrame:
    """Merge consecutive rows of the same step, which occur where one run ends and the next begins.

    Use the earlier row, because mesh forces are missing during setup. Take columns that it lacks
    from
    the later row. Merge only consecutive rows, because `reset_timestep` may repeat step numbers.
    """
    told_by = series[["step", "simulation"] if "simulation" in series else ["step"]]
    steps = (told_by != told_by.shift()).any(axis="columns").cumsum()
    return series.groupby(steps).first().reset_index(drop=True)


def rows_up_to(series: pd.DataFrame, step: int) -> pd.DataFrame:
    """Return the rows of a series up to the last one before the checkpoint of a step."""
    (reached,) = np.nonzero(series["step"] <= step)
    return series.iloc[: reached.max(initial=-1) + 1]


def _is_own(folder: Path) -> bool:
    return (folder / RECORD).is_file() and bool(read_record(folder).get("own"))


def _read_thermo(folder: Path) -> pd.DataFrame:
    if not (folder / LOG).is_file():
        raise DumpError(f"{folder} holds no {LOG}")
    with warnings.catch_warnings():
        # The run was stopped, so its log may be cut short.
        warnings.simplefilter("ignore", TruncatedFileWarning)
        return read_thermo(folder / LOG)


def _joined_simulations(before: pd.DataFrame, after: pd.DataFrame) -> list[pd.DataFrame]:
    """Join a log and its continuation, whose first simulation is the last one of the log."""
    before = before.assign(simulation=before.get("simulation", 0))
    begun = before["simulation"].iloc[-1]
    return [before, after.assign(simulation=after["simulation"] + begun)]


def _joined_times(before: pd.DataFrame, after: pd.DataFrame) -> list[pd.DataFrame]:
    """Shift the time of a continued log so that it follows the earlier log.

    Drop `time` if either log lacks it. LIGGGHTS restarts its clock at a checkpoint.
    """
    if not ("time" in before and "time" in after):
        return [series.drop(columns="time", errors="ignore") for series in (before, after)]
    begins = before["time"].iloc[-1]
    gap = after["step"].iloc[0] - before["step"].iloc[-1]
    steps = after.groupby("run")["step"].diff()
    if gap > 0 and (steps > 0).any():  # a checkpoint may lie between two lines of the earlier log
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
    """Return the time of every line [s], accumulated over the runs.

    A run may restart its step count and have its own time step.

    Args:
        series: As of `read_thermo`.
        said: Time step of each run [s], for logs without a column of it or of the time.
    """
    times, end = pd.Series(nan, series.index), None
    for number, run in series.groupby("run"):
        time = _time_of_run(run, said[number])
        times[run.index] = time if end is None else time + (end - time.iloc[0])
        end = times[run.index[-1]]
    return times


def _time_of_run(run: pd.DataFrame, said: float) -> pd.Series:
    """Return the time of the lines of a run [s]; NaN if unknown."""
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
    """Return the values that the deck printed as `derived NAME = VALUE`.

    A continued run includes the values of the earlier run.

    Raises:
        EngineError: The folder contains no run.
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
    """Return one of `all_derived`.

    Raises:
        ValueError: The deck did not print it.
    """
    try:
        return all_derived(folder)[name]
    except KeyError:
        raise ValueError(f"{folder}: the log has no line `derived {name} = `") from None


def carry_files(earlier: Path, folder: Path, last: int) -> None:
    """Copy the files to which LIGGGHTS appends: spectra, and complete frames before step `last`."""
    if (earlier / SPECTRA).exists():
        shutil.copy(earlier / SPECTRA, folder)
    if not (earlier / DUMP).exists():
        return
    with open(earlier / DUMP) as dump, open(folder / DUMP, "w") as kept:
        while frame := _next_frame(dump):
            if int(frame[1]) < last:
                kept.writelines(frame)


def _next_frame(dump: TextIO) -> list[str]:
    """Return the lines of the next frame of a dump: nine of head, then atoms; [] if incomplete."""
    head = list(islice(dump, 9))
    if len(head) < 9:
        return []
    frame = head + list(islice(dump, int(head[3])))
    return frame if len(frame) == 9 + int(head[3]) and frame[-1].endswith("\n") else []


def restart_point(folder: Path, record: dict) -> Path:
    """Return the newest complete checkpoint of a run, or the one from which it started.

    Raises:
        EngineError: There is no checkpoint.
    """
    try:
        return newest_checkpoint(folder)
    except EngineError:
        began = Path(record["values"].get("checkpoint", "none"))
        if not (began.is_file() and is_numbered(began)):
            raise
        return began
