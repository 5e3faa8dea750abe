# SPDX-License-Identifier: GPL-2.0-or-later
"""Text output for results of impacts: the results table, and laws used outside their range."""

from __future__ import annotations

from collections.abc import Sequence
from math import isnan

import pandas as pd

from plastigran import laws

#: Columns that the printed table shows only if they have several values.
VARIED = ("geometry", "radius", "wall", "options", "surface_energy")
#: Headers of the printed columns: name and unit in two lines.
HEADS = {
    "material": "material",
    "law": "law",
    "wall": "wall",
    "options": "options",
    "geometry": "geometry",
    "radius": "radius\nm",
    "surface_energy": "Gamma\nJ/m2",
    "angle": "angle\ndeg",
    "speed": "speed\nm/s",
    "speed_ratio": "v/v_Y",
    "coefficient_of_restitution": "COR",
    "coefficient_of_restitution_predicted": "COR\ntheory",
    "angular_velocity": "rad/s",
    "angular_velocity_predicted": "rad/s\ntheory",
    "force_max": "peak force\nN",
    "overlap_max": "overlap\nmax, m",
    "overlap_res": "overlap\nresidual, m",
    "contact_time": "contact\ntime, s",
}


def format_table(table: pd.DataFrame, shown: Sequence[str] = ()) -> str:
    """Return a results table as text: names and units in two head lines, five digits.

    Args:
        table: Results table.
        shown: Columns to show; by default, all columns. Missing and empty columns are skipped. If
            `shown` is given, columns of `VARIED` with a single value are skipped, too.
    """
    columns = [name for name in shown or table if name in table and not table[name].isna().all()]
    if shown:
        columns = [name for name in columns if name not in VARIED or table[name].nunique() > 1]
    heads = [(HEADS.get(name, name) + "\n").split("\n")[:2] for name in columns]
    cells = [[_cell(value) for value in line] for line in table[columns].itertuples(index=False)]
    lines = [[head[k] for head in heads] for k in (0, 1)] + cells
    widths = [max(len(line[k]) for line in lines) for k in range(len(columns))]
    text = [
        "  ".join(cell.rjust(width) for cell, width in zip(line, widths, strict=True))
        for line in lines
    ]
    return "\n".join([*text[:2], "-" * len(text[0]), *text[2:]])


def _cell(value: object) -> str:
    if not isinstance(value, float):
        return str(value)
    return "-" if isnan(value) else f"{value:.5g}"


def format_range(table: pd.DataFrame) -> str:
    """Return lines that name each law used outside its range, with the lowest of these speeds."""
    several = "material" in table and table["material"].nunique() > 1
    outside = table.loc[~table["in_range"]]
    lines = []
    for (law, *material), rows in outside.groupby(["law", "material"] if several else ["law"]):
        thrown = f" with {material[0]}" if material else ""
        lines.append(
            f"outside the range of {law} ({laws.LAWS[law].range}){thrown}: "
            f"{rows['speed'].min():g} m/s and faster"
        )
    return "\n".join(lines)
