# SPDX-License-Identifier: GPL-2.0-or-later
"""Results of impacts as text."""

from __future__ import annotations

import pandas as pd

from plastigran import laws

TABLE = [
    "material",
    "law",
    "angle",
    "speed",
    "speed_ratio",
    "coefficient_of_restitution",
    "coefficient_of_restitution_predicted",
    "angular_velocity",
    "angular_velocity_predicted",
    "force_max",
    "overlap_max",
    "overlap_res",
    "contact_time",
]
SHORT = {
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


def format_table(table: pd.DataFrame) -> str:
    """A results table as text: names and units in two head lines, five digits."""
    columns = [c for c in TABLE if c in table and not table[c].isna().all()]
    heads = [(SHORT.get(c, c) + "\n").split("\n")[:2] for c in columns]
    cells = [
        [f"{value:.5g}" if isinstance(value, float) else str(value) for value in line]
        for line in table[columns].itertuples(index=False)
    ]
    head_lines = [[head[k] for head in heads] for k in (0, 1)]
    widths = [max(len(line[k]) for line in [*head_lines, *cells]) for k in range(len(columns))]
    lines = [
        "  ".join(cell.rjust(width) for cell, width in zip(line, widths, strict=True))
        for line in [*head_lines, *cells]
    ]
    lines.insert(2, "-" * len(lines[0]))
    return "\n".join(lines)


def print_range(table: pd.DataFrame) -> None:
    """Say from which speed on a law was used beyond its range."""
    outside = table.loc[~table["in_range"], ["law", "speed"]]
    for law, speeds in outside.groupby("law")["speed"]:
        print(
            f"outside the range of {law} ({laws.LAWS[law].range}): {speeds.min():g} m/s and faster"
        )
