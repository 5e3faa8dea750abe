# SPDX-License-Identifier: GPL-2.0-or-later
"""The section of tables and figures that a command has written: validation, papers, a metal."""

from __future__ import annotations

from pathlib import Path

import pandas as pd

from plastigran.calibration.expected_errors import errors_table
from plastigran.declared import declaration
from plastigran.materials import Material, read_material
from plastigran.report.page.collect import Results
from plastigran.report.page.names import number
from plastigran.report.page.pictures import read_pictures
from plastigran.report.page.sections import Section, Table, cells
from plastigran.report.page.trust import validation_chart

#: Rows of a table beyond which it is left in its file.
LONGEST = 500
#: The table of errors that `plastigran validate` writes.
ERRORS = "errors"


def make(results: Results, name: str) -> Section:
    """What is to be shown of a folder of tables, figures and materials.

    Args:
        results: The folder.
        name: Of the element of the page.
    """
    folder, missing, tables, laws = results.folder, [], [], []
    charts = []
    for file in sorted(folder.glob("*.csv")):
        try:
            table = pd.read_csv(file, comment="#")
        except (OSError, ValueError) as error:
            missing.append(f"{file.name} cannot be read: {error}.")
            continue
        if file.stem == ERRORS and set(errors_table()) <= set(table):
            laws = sorted(table["law"].unique())
            charts = [validation_chart(name, table)]
        if len(table) > LONGEST:
            missing.append(f"{file.name} has {len(table)} rows; it is in {folder}.")
            continue
        tables.append(cells(table, file.stem.replace("_", " ").capitalize()))
    materials, damaged = _materials(folder)
    pictures, left = read_pictures(folder)
    missing += damaged
    count = len(tables) + len(materials) + len(pictures)
    return Section(
        kind="tables",
        name=name,
        title=results.name,
        folder=folder,
        state="unfinished" if missing else "done",
        verdict=f"{count} tables and figures" if count != 1 else "1 table or figure",
        missing=missing + left,
        charts=[chart for chart in charts if chart],
        pictures=pictures,
        tables=materials + tables,
        laws=laws,
    )


def _materials(folder: Path) -> tuple[list[Table], list[str]]:
    """Materials that a calibration has written: the constants, and where they are from."""
    found, damaged = [], []
    for file in sorted(folder.glob("*.in")):
        try:
            material = read_material(file)
        except (ValueError, OSError) as error:
            damaged.append(f"{file.name} is no material: {error}.")
            continue
        said = declaration(Material)
        rows = [
            [name.replace("_", " "), number(value), said[name].unit.replace("-", "")]
            for name, value in material.variables().items()
        ]
        remark = file.read_text(errors="replace").partition("\n")[0].removeprefix("#").strip()
        title = f"Material {material.name}: {remark}" if remark else f"Material {material.name}"
        found.append(Table(title=title, head=["constant", "value", "unit"], rows=rows, open=True))
    return found, damaged
