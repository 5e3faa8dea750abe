# SPDX-License-Identifier: GPL-2.0-or-later
"""Section of tables and figures of other commands: validation, papers, a calibrated metal."""

from __future__ import annotations

from pathlib import Path

import pandas as pd

from plastigran.calibration.expected_errors import errors_table
from plastigran.declared import declarations
from plastigran.materials import Material, read_material
from plastigran.report.page.collect import Results
from plastigran.report.page.names import number
from plastigran.report.page.pictures import read_pictures
from plastigran.report.page.sections import Section, Table, cells
from plastigran.report.page.trust import validation_chart

#: Largest number of rows of a table on a page.
LONGEST = 500
#: Table of errors of `plastigran validate`.
ERRORS = "errors"


def make(results: Results, name: str) -> Section:
    """Return the section of a folder of tables, figures and materials.

    Args:
        results: Folder of the results.
        name: ID of the element of the page.
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
            missing.append(
                f"{file.name} has {len(table)} rows, too many for this page. See {folder}."
            )
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
    """Return tables of the constants of calibrated materials, with their source."""
    found, damaged = [], []
    for file in sorted(folder.glob("*.in")):
        try:
            material = read_material(file)
        except (ValueError, OSError) as error:
            damaged.append(f"{file.name} is not a material file: {error}.")
            continue
        said = declarations(Material)
        rows = [
            [name.replace("_", " "), number(value), said[name].unit.replace("-", "")]
            for name, value in material.variables().items()
        ]
        remark = file.read_text(errors="replace").partition("\n")[0].removeprefix("#").strip()
        title = f"Material {material.name}: {remark}" if remark else f"Material {material.name}"
        found.append(Table(title=title, head=["constant", "value", "unit"], rows=rows, open=True))
    return found, damaged
