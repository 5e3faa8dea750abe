# SPDX-License-Identifier: GPL-2.0-or-later
"""The section of a sweep of impacts, whole or not."""

from __future__ import annotations

import json
from pathlib import Path

import pandas as pd

from plastigran.engine.log import LOG, find_error
from plastigran.experiments.runs import STUDY, TABLE
from plastigran.experiments.tables import HEADS
from plastigran.materials import read_material
from plastigran.plot.style import title
from plastigran.report.page.bulk_section import version_facts
from plastigran.report.page.collect import Results
from plastigran.report.page.loop_chart import loops_chart
from plastigran.report.page.names import number, words
from plastigran.report.page.pictures import read_pictures
from plastigran.report.page.sections import Section, cells
from plastigran.report.page.sweep_charts import measured_chart
from plastigran.report.page.trust import trust, validation_chart, verification_chart

#: Laws of a sweep that its head names, at most.
MOST_NAMED = 3
#: Figures of central impacts, which charts replace.
_CHARTED = {"restitution", "loops"}


def make(results: Results, name: str) -> Section:
    """What is to be shown of a sweep.

    Args:
        results: Its folder.
        name: Of the element of the page.
    """
    folder = results.folder
    runs = sorted(path for path in folder.glob("runs/*") if path.is_dir())
    study, missing = _read_study(folder)
    try:
        table = pd.read_csv(folder / TABLE)
    except (OSError, ValueError):
        table = pd.DataFrame()
        missing.append(f"{TABLE} is missing or empty: no impact has finished.")
    if len(table) < len(runs):
        missing.append(
            f"{len(table)} of {len(runs)} impacts have a line in {TABLE}; the others failed, were "
            "stopped, or run still."
        )
    missing += _errors(runs)
    laws = sorted(table["law"].unique()) if "law" in table else []
    charts = []
    if len(table):
        hardening = _hardens(table)
        charts = [measured_chart(name, table), loops_chart(name, folder, table)]
        if "speed_ratio" in table and table["speed_ratio"].nunique() > 1:
            charts += [verification_chart(name, table), validation_chart(name, laws)]
    pictures, left = read_pictures(folder, _CHARTED if "geometry" in table else ())
    return Section(
        kind="sweep",
        name=name,
        title=results.name,
        folder=folder,
        state="unfinished" if missing else "done",
        verdict=f"{len(table)} of {len(runs)} impacts" if missing else f"{len(table)} impacts",
        missing=missing + left,
        facts=_facts(study, table, runs),
        charts=[chart for chart in charts if chart],
        pictures=pictures,
        tables=[cells(table, f"All {len(table)} impacts", _heads(table))] if len(table) else [],
        trust=trust(table, hardening) if len(table) else [],
        laws=laws,
    )


def _read_study(folder: Path) -> tuple[dict, list[str]]:
    """What the sweep has recorded of itself, and a sentence where that cannot be read."""
    if not (folder / STUDY).is_file():
        return {}, []
    try:
        study = json.loads((folder / STUDY).read_text())
        return (study, []) if isinstance(study, dict) else ({}, [f"{STUDY} is no record."])
    except ValueError as error:
        return {}, [f"{STUDY} is damaged: {error}."]


def _errors(runs: list[Path]) -> list[str]:
    """What the engine said where it stopped, each once."""
    said: dict[str, str] = {}
    for run in runs:
        log = run / LOG
        if log.is_file() and (error := find_error(log.read_text(errors="replace"))):
            said.setdefault(error.strip(), run.name)
    return [f"The engine stopped in runs/{run}: {error}" for error, run in said.items()]


def _hardens(table: pd.DataFrame) -> bool:
    try:
        materials = [read_material(name) for name in table.get("material", pd.Series()).unique()]
    except ValueError:
        return False
    return any(material.tangent_modulus > 0 for material in materials)


def _facts(study: dict, table: pd.DataFrame, runs: list[Path]) -> dict[str, str]:
    facts = {"command": f"plastigran {study['command']}"} if study.get("command") else {}
    if "law" in table:
        names = [title(str(law)) for law in sorted(table["law"].unique())]
        facts["law"] = ", ".join(names) if len(names) <= MOST_NAMED else f"{len(names)} laws"
    for name in ("geometry", "material", "radius", "angle", "speed"):
        if name not in table or table[name].isna().all():
            continue
        values = table[name].unique()
        unit = {"radius": " m", "speed": " m/s", "angle": "°"}.get(name, "")
        if table[name].dtype.kind in "if":
            ends = [number(float(value)) for value in (values.min(), values.max())]
            facts[words(name)] = " to ".join(dict.fromkeys(ends)) + unit
        else:
            shown = map(title, values) if name == "material" else values
            facts[words(name)] = ", ".join(str(value).replace("_", " ") for value in shown)
    versions = dict(study.get("versions", {}))
    logs = [run / LOG for run in runs if (run / LOG).is_file()]
    if logs:
        with open(logs[0], errors="replace") as log:
            versions["engine"] = log.readline().strip()
    return facts | version_facts(versions)


def _heads(table: pd.DataFrame) -> dict[str, str]:
    return {name: HEADS.get(name, words(name)).replace("\n", ", ") for name in table}
