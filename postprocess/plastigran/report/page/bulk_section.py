# SPDX-License-Identifier: GPL-2.0-or-later
"""Section of the page for a finished or unfinished bulk run."""

from __future__ import annotations

from functools import partial
from math import isfinite
from pathlib import Path
from typing import Any

import pandas as pd

from plastigran.bulk.folder import SERIES, read_record
from plastigran.bulk.outcome import BulkRun, open_run
from plastigran.bulk.plan import PLACES
from plastigran.bulk.vtk import time_of
from plastigran.declared import Declaration, declarations
from plastigran.engine.dumps import DumpError
from plastigran.engine.log import (
    LogFollower,
    find_error,
    find_models,
    find_pair_style,
    find_units,
    find_warnings,
    log_path,
    read_runs,
)
from plastigran.engine.process import EngineError
from plastigran.plot.frame_files import SnapshotError
from plastigran.plot.style import title
from plastigran.report.page.bulk_charts import ledger_chart, series_chart
from plastigran.report.page.collect import Results
from plastigran.report.page.movie import Clock, GrainMovie, pack_movie
from plastigran.report.page.pictures import read_pictures
from plastigran.report.page.sections import Section, number, span, version_facts

#: Settings of the deck that the top of the section shows.
_HEAD = ("law", "material", "radius", "timestep")
#: Values that the page takes from the log if the deck is a user's own. In such a deck, a setting
#: with this name may have another meaning.
_FROM_LOG = ("law", "timestep")
#: Unit systems whose time is in seconds.
_SECONDS = ("si", "cgs")


def make(results: Results) -> Section:
    """Return the section of the page for a bulk run."""
    folder = results.folder
    try:
        record = read_record(folder)
    except EngineError as error:
        sentences, verdict = [f"{error}."], "record damaged"
        return Section(results=results, state="unfinished", verdict=verdict, missing=sentences)
    path = log_path(folder)
    log = path.read_text(errors="replace") if path.is_file() else ""
    missing, run = [], None
    try:
        run = open_run(folder)
    except (EngineError, DumpError) as error:
        missing.append(f"The run cannot be read: {error}.")
    if error := find_error(log):
        missing.append(f"The run stopped: {error.strip()}")
    if run is None or not run.finished:
        missing.append(_progress(path, log))
    elif len((folder / SERIES).read_text(errors="replace").splitlines()) < 2:
        missing.append(f"{SERIES} is empty. The page shows data from {path.name} instead.")
    warnings = find_warnings(log)
    state, verdict = _verdict(run, len(warnings))
    timestep = _timestep(record, path)
    charts = [ledger_chart(run.series, run.checks), series_chart(run.series)] if run else []
    movie, damaged_frames = _movie(folder, _clock(timestep, run))
    replaced = ("ledger", "grains") if movie else ("ledger",)
    pictures, damaged_pictures = read_pictures(folder / "figures", replaced)
    settings = record["settings"]
    declared = declarations(type(run.deck)) if run and run.deck else {}
    return Section(
        results=results,
        state=state,
        verdict=verdict,
        missing=missing + damaged_frames + damaged_pictures,
        notes=[f"{note[0].upper()}{note[1:]}" for note in run.notes] if run else [],
        warnings=warnings,
        facts=_facts(record, run, declared, _log_facts(log, timestep)),
        settings=_settings(settings, declared, record["values"]),
        checks=run.checks.to_dict("records") if run else [],
        charts=[chart for chart in charts if chart],
        movie=movie,
        pictures=pictures,
        laws=[settings["law"]] if "law" in settings else [],
    )


def _progress(path: Path, log: str) -> str:
    """Return a sentence that says how far an unfinished run has come."""
    if not log:
        return f"The run has not started: {path.name} is missing or empty."
    at = LogFollower(path).read()
    if not at.last:
        return f"The run has not finished: {path.name} ends before the first time step."
    share = (at.step - at.first) / max(at.last - at.first, 1)
    return (
        f"The run has not finished: {path.name} ends at step {at.step} of {at.last}, {share:.0%} "
        f"of run {at.run} of the deck. Figures and checks are made at the end of a run. Use "
        "plastigran bulk with --restart to continue it from its newest checkpoint."
    )


def _verdict(run: BulkRun | None, warnings: int) -> tuple[str, str]:
    """Return the state of a bulk run, and a few words about its checks and warnings.

    The state is one of the values of `Section.state`.
    """
    warned = f", {warnings} warning{'' if warnings == 1 else 's'}" if warnings else ""
    if run is None or not run.finished:
        return "unfinished", "not finished"
    count = len(run.checks)
    if failed := len(run.analysis.failed):
        return "failed", f"{failed} of {count} checks failed{warned}"
    if count:
        return "passed", f"{count} checks passed{warned}"
    return "done", f"finished{warned}"


def _timestep(record: dict[str, Any], log: Path) -> float | None:
    """Return the time step of a bulk run [s]; None if it is unknown or changes.

    For a user's own deck, the time step is read from the log, because a setting named `timestep`
    may have another meaning there.
    """
    if record.get("own"):
        timesteps = {run.timestep for run in read_runs(log)} if log.is_file() else set()
        return timesteps.pop() if len(timesteps) == 1 and all(map(isfinite, timesteps)) else None
    try:
        return float(record["settings"]["timestep"])
    except (KeyError, ValueError):
        return None


def _movie(folder: Path, clock: Clock) -> tuple[GrainMovie | None, list[str]]:
    try:
        return pack_movie(folder, clock)
    except (SnapshotError, OSError, ValueError, KeyError) as error:
        return None, [f"The frames cannot be shown: {error}."]


def _clock(timestep: float | None, run: BulkRun | None) -> Clock:
    """Return a function that converts a step number to the time in the charts [s].

    The result is None if the time is unknown. A supplied deck has one time step, but the time in
    its charts may start at a later step than 0. A user's own deck may change its time step; the
    time then follows from the time series of the run.
    """
    series = run.series if run else pd.DataFrame()
    timed = len(series) > 0 and {"step", "time"} <= set(series)
    if timed and run.deck is None:
        return partial(time_of, run)
    if timestep is None:
        return None
    start = round(series["step"].iloc[0] - series["time"].iloc[0] / timestep) if timed else 0
    return lambda step: (step - start) * timestep


def _log_facts(log: str, timestep: float | None) -> dict[str, str]:
    """Return contact models, time step and pair style of a user's own deck, from its log."""
    facts = {}
    if models := find_models(log):
        facts["law"] = ", ".join(map(title, models))
    if timestep is not None:
        unit = " s" if find_units(log) in _SECONDS else ""
        facts["timestep"] = number(timestep) + unit
    if style := find_pair_style(log):
        facts["pair style"] = style
    return facts


def _facts(
    record: dict[str, Any],
    run: BulkRun | None,
    declared: dict[str, Declaration],
    log_facts: dict[str, str],
) -> dict[str, str]:
    """Return the facts about a bulk run that its section lists, by name.

    Args:
        record: Content of run.json.
        run: Results of the run; None if they cannot be read.
        declared: Declarations of the deck's settings.
        log_facts: Facts from the log, which are used only for a user's own deck.
    """
    settings, user_deck = record["settings"], record.get("own")
    facts = {"deck": record["deck"]}
    for name in _HEAD:
        if name in settings and not (user_deck and name in _FROM_LOG):
            value = settings[name]
            shown = title(value) if name == "law" else _with_unit(value, declared.get(name))
            facts[name.replace("_", " ")] = shown
    if user_deck:
        facts |= log_facts
    facts["ranks"] = str(record.get("ranks", "unknown"))
    if run is not None and "atoms" in run.series and len(run.series):
        grains = run.series["atoms"]  # the number of grains may change during a run
        first, last, most = grains.iloc[0], grains.iloc[-1], grains.max()
        more = f", at most {number(float(most))}" if most > max(first, last) else ""
        facts["grains"] = span(first, last) + more
    if run is not None:
        facts |= {name: number(value) for name, value in run.results.items()}
    if record.get("restart"):
        facts["continues"] = Path(record["restart"]).name
    return facts | version_facts(record.get("versions", {}))


def _with_unit(value: str, declaration: Declaration | None) -> str:
    if declaration is None or declaration.value_type is not float:
        return value
    try:
        shown = number(float(value))
    except ValueError:
        return value
    return f"{shown} {declaration.unit}" if declaration.unit != "-" else shown


def _settings(
    settings: dict[str, str], declared: dict[str, Declaration], changed: dict[str, str]
) -> list[tuple[str, str, str]]:
    """Return the name, the value with unit and the meaning of each setting of the deck.

    Settings that this run has changed come first.
    """
    names = [name for name in settings if name not in PLACES]
    return [
        (
            name + (" *" if name in changed else ""),
            _with_unit(settings[name], declared.get(name)),
            declared[name].meaning if name in declared else "",
        )
        for name in sorted(names, key=lambda name: name not in changed)
    ]
