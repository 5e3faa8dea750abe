# SPDX-License-Identifier: GPL-2.0-or-later
"""Section of the page for a complete or incomplete sweep of impacts."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pandas as pd

from plastigran.calibration.expected_errors import errors_table
from plastigran.declared import declarations
from plastigran.engine.log import find_error, log_path
from plastigran.experiments.central.arrangement import WALLS
from plastigran.experiments.central.curves import central_case
from plastigran.experiments.central.remarks import dented
from plastigran.experiments.record import STUDY, TABLE, read_study, read_table
from plastigran.experiments.tables import HEADS
from plastigran.materials import NO_WALL, USUAL, Material
from plastigran.plot.quantities import PREDICTED, QUANTITIES, words
from plastigran.plot.style import title
from plastigran.report.page.charts import Chart
from plastigran.report.page.collect import Results
from plastigran.report.page.pictures import read_pictures
from plastigran.report.page.sections import Section, Table, cells, span, version_facts
from plastigran.report.page.sweep_charts import loops_chart, measured_chart
from plastigran.report.page.trust import Trust, trust, validation_chart, verification_chart

#: Largest number of laws named at the top of the section.
MOST_NAMED = 3
#: Required columns of a table of impacts.
_REQUIRED = ("law", "material", "radius", "speed")
#: Names of figures of central impacts, each with the name of the chart that replaces the figure.
_REPLACED = {"restitution": "measured", "loops": "loops"}


def make(results: Results) -> Section:
    """Return the section of the page for a sweep."""
    folder = results.folder
    study, missing = read_study(folder)
    table, damaged = _read_table(folder / TABLE)
    missing += damaged
    runs = sorted(path for path in folder.glob("runs/*") if path.is_dir())
    if len(table) < len(runs) and (len(table) or not missing):
        missing.append(
            f"{TABLE} has {len(table)} of {len(runs)} impacts. The others failed, were stopped, "
            "are still running, or have a damaged row."
        )
    missing += _errors(runs)
    materials, damaged = _materials(study)
    missing += damaged
    by_law = trust(table, materials)
    charts, damaged = _charts(folder, table, materials, by_law)
    missing += damaged
    drawn = {chart.name for chart in charts} if "geometry" in table else set()
    pictures, damaged = read_pictures(
        folder, {figure for figure, chart in _REPLACED.items() if chart in drawn}
    )
    missing += [
        f"The constants of {name} are not available. The error of the laws compared with finite "
        "elements depends on hardening, so it is unknown for this material."
        for name in sorted({name for entry in by_law for name in entry.unknown_materials})
    ]
    missing += damaged
    impacts = _impacts(len(table))
    verdict = impacts + (" by theory" if study.get("by_theory") else "")
    tables = _constants(materials)
    if len(table):
        heads = {name: _head(name) for name in table}
        tables.append(cells(table, f"The {impacts} in numbers", heads))
    return Section(
        results=results,
        state="unfinished" if missing else "done",
        verdict=f"{len(table)} of {_impacts(len(runs))}" if missing else verdict,
        missing=missing,
        warnings=_dented(table, materials),
        facts=_facts(study, table, runs),
        charts=charts,
        pictures=pictures,
        tables=tables,
        trust=by_law,
        laws=sorted(table["law"].unique()) if "law" in table else [],
    )


def _read_table(path: Path) -> tuple[pd.DataFrame, list[str]]:
    """Return the results table of a sweep, and sentences if the table is missing or incomplete."""
    if not path.is_file() or not path.stat().st_size:
        return pd.DataFrame(), [f"{TABLE} is missing or empty: no impact has finished."]
    try:
        table, left_out = read_table(path)
        if lost := [name for name in _REQUIRED if "geometry" in table and name not in table]:
            raise ValueError(f"column {lost[0]} is missing")
        return table, left_out
    except (OSError, ValueError) as error:
        return pd.DataFrame(), [f"{TABLE} is damaged and not shown: {error}."]


def _materials(study: dict) -> tuple[dict[str, Material], list[str]]:
    """Return the materials that the sweep recorded, and a sentence for each unreadable material."""
    materials, damaged = {}, []
    recorded = study.get("materials")
    for name, values in recorded.items() if isinstance(recorded, dict) else ():
        try:
            materials[name] = Material(name, **values)
        except (TypeError, ValueError) as error:
            damaged.append(f"{STUDY} has incomplete data for material {name}: {error}.")
    return materials, damaged


def _head(column: str) -> str:
    """Return the title of a column of the results table: name and unit of the quantity."""
    measured = column.removesuffix(PREDICTED)
    name, unit = QUANTITIES.get(measured, (words(measured), ""))
    head = HEADS.get(column, HEADS.get(measured, f"{name}\n{unit}"))
    name, _, unit = head.partition("\n")
    parts = f"{name} {unit}" if ", " in unit else ", ".join(filter(None, (name, unit)))
    return f"{parts}, theory" if column != measured and column not in HEADS else parts


def _constants(materials: Mapping[str, Material]) -> list[Table]:
    """Return a table of the constants of the materials."""
    if not materials:
        return []
    table = pd.DataFrame([{"material": n} | m.variables() for n, m in materials.items()])
    units = {name: declaration.unit for name, declaration in declarations(Material).items()}
    heads = {
        name: words(name) if units.get(name, "-") in ("", "-") else f"{words(name)}, {units[name]}"
        for name in table
    }
    return [cells(table, "Constants of the materials", heads)]


def _impacts(count: int) -> str:
    """Return a number of impacts as text, such as "1 impact"."""
    return f"{count} impact{'' if count == 1 else 's'}"


def _charts(
    folder: Path, table: pd.DataFrame, materials: Mapping[str, Material], by_law: list[Trust]
) -> tuple[list[Chart], list[str]]:
    """Return the charts of a sweep, and a list with a sentence if trajectories cannot be read."""
    if not len(table):
        return [], []
    loops, damaged = loops_chart(folder, table)
    charts = [measured_chart(table, materials), loops]
    if "speed_ratio" in table and table["speed_ratio"].nunique() > 1:
        charts.append(verification_chart(table))
        if _has_usual(table) or any(any(entry.validated.values()) for entry in by_law):
            errors = errors_table()
            charts.append(validation_chart(errors[errors["law"].isin(table["law"])]))
    return [chart for chart in charts if chart], damaged


def _has_usual(table: pd.DataFrame) -> bool:
    """Return whether any impact has no metal wall and uses the default options of the law."""
    usual = pd.Series(True, table.index)
    if "wall" in table:
        usual &= table["wall"].isin(WALLS)
    if "options" in table:
        usual &= table["options"] == USUAL
    return usual.any()


def _errors(runs: list[Path]) -> list[str]:
    """Return sentences with the error messages of LIGGGHTS in the runs, each message once."""
    errors: dict[str, str] = {}
    for run in runs:
        log = log_path(run)
        if log.is_file() and (error := find_error(log.read_text(errors="replace"))):
            errors.setdefault(error.strip(), run.name)
    return [f"LIGGGHTS stopped in runs/{run}: {error}" for error, run in errors.items()]


def _dented(table: pd.DataFrame, materials: Mapping[str, Material]) -> list[str]:
    """Return a sentence if a wall yields although the law assumes that the sphere yields."""
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
            # Omit `NO_WALL`, which stands for an impact between two spheres.
            values = [wall for wall in values if wall != NO_WALL]
        unit = {"radius": " m", "speed": " m/s", "angle": "°"}.get(name, "")
        if table[name].dtype.kind in "if":
            facts[words(name)] = span(values.min(), values.max()) + unit
        else:
            shown = map(title, values) if name in ("material", "wall") else values
            facts[words(name)] = ", ".join(str(value).replace("_", " ") for value in shown)
    versions = dict(study.get("versions", {}))
    if log := next((log for log in map(log_path, runs) if log.is_file()), None):
        with open(log, errors="replace") as file:
            versions["engine"] = file.readline().strip()
    return facts | version_facts(versions)
