# SPDX-License-Identifier: GPL-2.0-or-later
"""Section of the page for the tables and figures of other commands, such as `validate`."""

from __future__ import annotations

from pathlib import Path

import pandas as pd

from plastigran.calibration.expected_errors import errors_table
from plastigran.declared import declarations
from plastigran.materials import Material, read_material
from plastigran.plot.quantities import words
from plastigran.report.page.collect import Results
from plastigran.report.page.pictures import read_pictures
from plastigran.report.page.sections import Section, Table, cells, number
from plastigran.report.page.trust import validation_chart

#: Largest number of rows of a table on a page.
MOST_ROWS = 500
#: Name of the table of errors that `plastigran validate` writes.
ERRORS = "errors"


def make(results: Results) -> Section:
    """Return the section of the page for a folder of tables, figures and material files."""
    folder, missing, tables, laws, chart = results.folder, [], [], [], None
    for file in sorted(folder.glob("*.in")):
        try:
            tables.append(_material_table(file))
        except (ValueError, OSError) as error:
            missing.append(f"{file.name} is not a material file: {error}.")
    for file in sorted(folder.glob("*.csv")):
        try:
            table = pd.read_csv(file, comment="#")
        except (OSError, ValueError) as error:
            missing.append(f"{file.name} cannot be read: {error}.")
            continue
        if file.stem == ERRORS and set(errors_table()) <= set(table):
            laws = sorted(table["law"].unique())
            chart = validation_chart(table)
        if len(table) > MOST_ROWS:
            missing.append(
                f"{file.name} has {len(table)} rows, too many for this page. See {folder}."
            )
        else:
            tables.append(cells(table, file.stem.replace("_", " ").capitalize()))
    pictures, damaged = read_pictures(folder)
    count = len(tables) + len(pictures)
    return Section(
        results=results,
        state="unfinished" if missing else "done",
        verdict=f"{count} tables and figures" if count != 1 else "1 table or figure",
        missing=missing + damaged,
        charts=[chart] if chart else [],
        pictures=pictures,
        tables=tables,
        laws=laws,
    )


def _material_table(file: Path) -> Table:
    """Return a table of the constants of a material file, with the remark of the file as title."""
    material = read_material(file)
    units = {name: declaration.unit for name, declaration in declarations(Material).items()}
    rows = [
        [words(name), number(value), units[name].replace("-", "")]
        for name, value in material.variables().items()
    ]
    remark = file.read_text(errors="replace").partition("\n")[0].removeprefix("#").strip()
    title = f"Material {material.name}: {remark}" if remark else f"Material {material.name}"
    return Table(title=title, head=["constant", "value", "unit"], rows=rows, open=True)
