# SPDX-License-Identifier: GPL-2.0-or-later
"""Series of a bulk run: the table of its log lines from step 0.

The series of a continued run begins with the log lines of the earlier runs.
"""

from __future__ import annotations

import warnings
from math import nan
from pathlib import Path

import numpy as np
import pandas as pd

from plastigran.bulk.folder import BEFORE, RECORD, read_record
from plastigran.engine.dumps import DumpError, TruncatedFileWarning
from plastigran.engine.log import LoggedRun, log_path, read_runs, thermo_table


def read_series(folder: str | Path) -> pd.DataFrame:
    """Read the log of a run from step 0. A continued run includes the log lines of earlier runs.

    Returns:
        One row per log line: `step`, `time` [s] from step 0, then the deck's columns in SI units.
        For a user's deck, the column `run` numbers the `run` commands. The time of a user's deck
        continues over all `run` commands. The column `time` is missing if neither the log nor
        `timestep` commands determine it. If the deck has `clear` commands, the column `simulation`
        numbers the simulations between these commands.

    Raises:
        DumpError: The log is missing or has no rows.
    """
    folder = Path(folder)
    own = (folder / RECORD).is_file() and bool(read_record(folder).get("own"))
    parts = _read_earlier_rows(folder)
    try:
        series = _read_own_log(folder) if own else _read_supplied_log(folder)
        parts.append(series.rename(columns=lambda name: name.removeprefix("v_")))
    except DumpError:
        if not parts:  # neither this run nor an earlier run has written a line
            raise
    parts = [part for part in parts if len(part)] or parts[-1:]
    if own and len(parts) == 2:
        parts = _continue_time(*_continue_simulations(*parts))
    series = _merge_equal_steps(pd.concat(parts, ignore_index=True))
    if "simulation" in series and not series["simulation"].any():
        series = series.drop(columns="simulation")
    return series


def rows_up_to(series: pd.DataFrame, step: int) -> pd.DataFrame:
    """Return the rows of a series up to the last row whose step is at most the given step."""
    (reached,) = np.nonzero(series["step"] <= step)
    return series.iloc[: reached.max(initial=-1) + 1]


def _read_earlier_rows(folder: Path) -> list[pd.DataFrame]:
    if not (folder / BEFORE).exists():
        return []
    try:
        return [pd.read_csv(folder / BEFORE).astype({"step": int})]
    except (KeyError, ValueError) as error:
        raise DumpError(
            f"{folder / BEFORE} is damaged: {error}. Restore the file or repeat the run"
        ) from None


def _read_log(folder: Path) -> tuple[list[LoggedRun], pd.DataFrame]:
    """Return the `run` commands of the log, and the table of the log lines that they wrote.

    The last line of the log may be incomplete, if the run was stopped.
    """
    log = log_path(folder)
    if not log.is_file():
        raise DumpError(f"{folder} contains no {log.name}. Check the path, or repeat the run")
    runs = read_runs(log)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", TruncatedFileWarning)
        table = thermo_table(log, runs)
    return runs, table


def _read_supplied_log(folder: Path) -> pd.DataFrame:
    """Return the log lines of the last `run` command of a deck of inputs/bulk, with time [s]."""
    _, table = _read_log(folder)
    series = table[table["run"] == table["run"].max()].drop(columns="run").reset_index(drop=True)
    series.insert(1, "time", series["step"] * series.pop("timestep"))
    return series


def _read_own_log(folder: Path) -> pd.DataFrame:
    """Return the log lines of all `run` commands of a user's deck, with the time [s] if known."""
    runs, series = _read_log(folder)
    series["simulation"] = [runs[number].simulation for number in series["run"]]
    time, end = pd.Series(nan, series.index), None
    for number, rows in series.groupby("run"):
        time[rows.index] = _time_of_run(rows, runs[number].timestep)
        if end is not None:  # end is None for the first `run` command of the log
            time[rows.index] += end - time[rows.index[0]]
        end = time[rows.index[-1]]
    if time.notna().all():
        series["time"] = time
    else:
        series = series.drop(columns="time", errors="ignore")
    return series


def _time_of_run(rows: pd.DataFrame, timestep: float) -> pd.Series:
    """Return the time of the log lines of one `run` command [s]; NaN if unknown.

    Args:
        rows: Log lines of the command. A column `time` or `timestep` takes precedence over the
            argument `timestep`.
        timestep: Time step from the command `timestep` [s], or NaN.
    """
    if "time" in rows and rows["time"].notna().all():
        return rows["time"]
    if "timestep" in rows and rows["timestep"].notna().all():
        timestep = rows["timestep"].iloc[0] if rows["timestep"].nunique() == 1 else nan
    first = rows["step"].iloc[0]
    steps = rows["step"] - first
    # The time since the first step is 0 at the first step, even if the time step is NaN.
    return (first * timestep if first else 0.0) + (steps * timestep).where(steps > 0, 0.0)


def _continue_simulations(before: pd.DataFrame, after: pd.DataFrame) -> list[pd.DataFrame]:
    """Renumber the column `simulation` of a continued log, so that it continues the earlier one."""
    before = before.assign(simulation=before.get("simulation", 0))
    last = before["simulation"].iloc[-1]
    return [before, after.assign(simulation=after["simulation"] + last)]


def _continue_time(before: pd.DataFrame, after: pd.DataFrame) -> list[pd.DataFrame]:
    """Shift the time of a continued log so that it follows the earlier log.

    LIGGGHTS restarts its time when it reads a checkpoint. If either log lacks `time`, the column is
    removed from both tables.
    """
    if not ("time" in before and "time" in after):
        return [series.drop(columns="time", errors="ignore") for series in (before, after)]
    start = before["time"].iloc[-1]
    gap = after["step"].iloc[0] - before["step"].iloc[-1]
    steps = after.groupby("run")["step"].diff()
    # Add the time between the last line of the earlier log and the checkpoint.
    if gap > 0 and (steps > 0).any():
        line = (steps > 0).idxmax()
        start += gap * (after["time"].diff() / steps)[line]
    return [before, after.assign(time=after["time"] + (start - after["time"].iloc[0]))]


def _merge_equal_steps(series: pd.DataFrame) -> pd.DataFrame:
    """Merge consecutive rows of the same step, which occur where one run ends and the next begins.

    The earlier row is kept, because LIGGGHTS writes the later row during setup, without mesh
    forces. The later row supplies columns that the earlier row lacks. Only consecutive rows are
    merged, because `reset_timestep` may repeat steps.
    """
    keys = series[["step", "simulation"] if "simulation" in series else ["step"]]
    groups = (keys != keys.shift()).any(axis="columns").cumsum()
    return series.groupby(groups).first().reset_index(drop=True)
