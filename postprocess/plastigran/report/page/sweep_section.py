# SPDX-License-Identifier: GPL-2.0-or-later
"""Section of a sweep of impacts, complete or not."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pandas as pd

from plastigran.calibration.expected_errors import errors_table
from plastigran.engine.log import LOG, find_error
from plastigran.experiments.central.arrangement import WALLS
from plastigran.experiments.central.curves import central_case
from plastigran.experiments.central.remarks import dented
from plastigran.experiments.record import TABLE, read_study, read_table
from plastigran.experiments.tables import HEADS
from plastigran.materials import NO_WALL, USUAL, Material
from plastigran.plot.quantities import words
from plastigran.plot.style import title
from plastigran.report.page.charts import chart_name
from plastigran.report.page.collect import Results
from plastigran.report.page.materials import constants, recorded
from plastigran.report.page.names import number
from plastigran.report.page.pictures import read_pictures
from plastigran.report.page.sections import Section, Table, cells, version_facts
from plastigran.report.page.sweep_charts import loops_chart, measured_chart
from plastigran.report.page.trust import Trust, trust, validation_chart, verification_chart

#: Largest number of laws that the head names.
MOST_NAMED = 3
#: Required columns of a table of impacts.
_OF_AN_IMPACT = ("law", "material", "radius", "speed")
#: Figures of central impacts, each with the chart that replaces it.
_CHARTED = {"restitution": "measured", "loops": "loops"}


def make(results: Results, name: str) -> Section:
    """Return the section of a sweep.

    Args:
        results: Folder of the sweep.
        name: ID of the element of the page.
    """
    folder = results.folder
    study, missing = read_study(folder)
    table, left = _read_table(folder / TABLE)
    missing += left
    runs = sorted(path for path in folder.glob("runs/*") if path.is_dir())
    if len(table) < len(runs) and (len(table) or not missing):
        fate = "are still running, or are left out" if missing else "or are still running"
        missing.append(
            f"{TABLE} has {len(table)} of {len(runs)} impacts. The others failed, were "
            f"stopped, {fate}."
        )
    missing += _errors(runs)
    laws = sorted(table["law"].unique()) if "law" in table else []
    materials, odd = recorded(study)
    missing += odd
    trusted = trust(table, materials)
    charts = []
    if len(table):
        loops, damaged = loops_chart(name, folder, table)
        missing += damaged
        charts = [measured_chart(name, table, materials), loops]
        if "speed_ratio" in table and table["speed_ratio"].nunique() > 1:
            errors = errors_table()
            errors = errors[errors["law"].isin(laws)]
            charts.append(verification_chart(name, table))
            if not _is_unusual(table) or any(any(t.validated.values()) for t in trusted):
                charts.append(validation_chart(name, errors))
    drawn = {chart.name for chart in charts if chart}
    replaced = {figure for figure, kind in _CHARTED.items() if chart_name(name, kind) in drawn}
    pictures, left = read_pictures(folder, replaced if "geometry" in table else ())
    by = " by theory" if study.get("by_theory") else ""
    return Section(
        kind="sweep",
        name=name,
        title=results.name,
        folder=folder,
        state="unfinished" if missing else "done",
        verdict=f"{len(table)} of {_impacts(len(runs))}" if missing else _impacts(len(table)) + by,
        missing=missing + _unread(trusted) + left,
        warnings=_dented(table, materials),
        facts=_facts(study, table, runs),
        charts=[chart for chart in charts if chart],
        pictures=pictures,
        tables=[*constants(materials), *_rows(table)],
        trust=trusted,
        laws=laws,
    )


def _read_table(path: Path) -> tuple[pd.DataFrame, list[str]]:
    """Return the results table, and sentences if it is missing or incomplete."""
    if not path.is_file() or not path.stat().st_size:
        return pd.DataFrame(), [f"{TABLE} is missing or empty: no impact has finished."]
    try:
        table, left = read_table(path)
        if lost := [name for name in _OF_AN_IMPACT if "geometry" in table and name not in table]:
            raise ValueError(f"column {lost[0]} is missing")
        return table, left
    except (OSError, ValueError) as error:
        return pd.DataFrame(), [f"{TABLE} is damaged and left out: {error}."]


def _impacts(count: int) -> str:
    """Return a number of impacts in words."""
    return f"{count} impact{'' if count == 1 else 's'}"


def _rows(table: pd.DataFrame) -> list[Table]:
    """Return the table of all impacts."""
    title = f"The {_impacts(len(table))} in numbers"
    return [cells(table, title, _heads(table))] if len(table) else []


def _is_unusual(table: pd.DataFrame) -> bool:
    """Return whether all impacts are on metal walls or use options of their law."""
    usual = pd.Series(True, table.index)
    if "wall" in table:
        usual &= table["wall"].isin(WALLS)
    if "options" in table:
        usual &= table["options"] == USUAL
    return not usual.any()


def _errors(runs: list[Path]) -> list[str]:
    """Return the error messages of LIGGGHTS, each once."""
    said: dict[str, str] = {}
    for run in runs:
        log = run / LOG
        if log.is_file() and (error := find_error(log.read_text(errors="replace"))):
            said.setdefault(error.strip(), run.name)
    return [f"LIGGGHTS stopped in runs/{run}: {error}" for error, run in said.items()]


def _unread(trusted: list[Trust]) -> list[str]:
    names = sorted({name for each in trusted for name in each.unread})
    return [
        f"The constants of {name} are not available. They decide on hardening, so the error "
        "compared with finite elements is unknown."
        for name in names
    ]


def _dented(table: pd.DataFrame, materials: Mapping[str, Material]) -> list[str]:
    """Return a sentence if the wall yields, but the law is for a sphere that yields."""
    rows = table[~table["wall"].isin(WALLS)] if "wall" in table else table.iloc[:0]
    cases = (central_case(row, materials) for _, row in rows.iterrows())
    return [sentence] if (sentence := dented(case for case in cases if case)) else []


def _facts(study: dict, table: pd.DataFrame, runs: list[Path]) -> dict[str, str]:
    facts = {"command": f"plastigran {study['command']}"} if study.get("command") else {}
    if study.get("by_theory"):
        facts["made by"] = "theory alone, without LIGGGHTS"
    if "law" in table:
        names = [title(str(law)) for law in sorted(table["law"].unique())]
        facts["law"] = ", ".join(names) if len(names) <= MOST_NAMED else f"{len(names)} laws"
    for name in ("geometry", "material", "wall", "options", "radius", "angle", "speed"):
        if name not in table or table[name].isna().all() or set(table[name]) <= {NO_WALL, USUAL}:
            continue
        values = table[name].unique()
        if name == "wall" and len(values) > 1:
            values = [wall for wall in values if wall != NO_WALL]  # two spheres have no wall
        unit = {"radius": " m", "speed": " m/s", "angle": "°"}.get(name, "")
        if table[name].dtype.kind in "if":
            ends = [number(float(value)) for value in (values.min(), values.max())]
            facts[words(name)] = " to ".join(dict.fromkeys(ends)) + unit
        else:
            shown = map(title, values) if name in ("material", "wall") else values
            facts[words(name)] = ", ".join(str(value).replace("_", " ") for value in shown)
    versions = dict(study.get("versions", {}))
    logs = [run / LOG for run in runs if (run / LOG).is_file()]
    if logs:
        with open(logs[0], errors="replace") as log:
            versions["engine"] = log.readline().strip()
    return facts | version_facts(versions)


def _heads(table: pd.DataFrame) -> dict[str, str]:
    return {name: HEADS.get(name, words(name)).replace("\n", ", ") for name in table}
