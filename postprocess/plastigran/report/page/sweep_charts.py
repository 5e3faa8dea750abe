# SPDX-License-Identifier: GPL-2.0-or-later
"""Charts of a sweep of impacts: measured quantities, lines of theory, and force-overlap loops."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pandas as pd

from plastigran.engine.dumps import DumpError, TruncatedFileWarning, read_dump
from plastigran.experiments.central import GEOMETRIES
from plastigran.experiments.central.arrangement import run_label
from plastigran.experiments.central.curves import (
    curve_groups,
    line_styles,
    loop_panels,
    measured_panels,
    varied,
)
from plastigran.experiments.collision import CollisionError, force_overlap_loop
from plastigran.materials import Material
from plastigran.plot.chart import DASHES
from plastigran.plot.quantities import PREDICTED, words
from plastigran.report.page.charts import Chart

#: Relative difference below which two radii or two speeds count as equal. It is far above the
#: round-off of trajectory files, which have 17 digits.
TOLERANCE = 1e-9
#: Columns of the results table whose values form the folder name of a LIGGGHTS run.
LABELLED = ("geometry", "material", "law", "wall", "options")
#: Largest number of points in the curve of a force-overlap loop.
LOOP_POINTS = 80


def measured_chart(table: pd.DataFrame, materials: Mapping[str, Material]) -> Chart | None:
    """Return the chart of measured quantities and their theoretical values; None without theory.

    `materials` are the materials that the sweep recorded, by name.
    """
    abscissa = _abscissa(table)
    quantities = [
        column
        for column in table
        if f"{column}{PREDICTED}" in table and table[column].notna().any()
    ]
    if not quantities or abscissa is None:
        return None
    panels = measured_panels(table, materials, quantities, abscissa)
    if not panels:
        return None
    return Chart(
        name="measured",
        views={words(name).capitalize(): [panel] for name, panel in panels.items()},
        description=f"{', '.join(map(words, quantities))} versus {words(abscissa)}, one curve per "
        "law",
        caption="Points are impacts in LIGGGHTS; lines are the theory of the law. If points lie "
        "on their line, LIGGGHTS solves the law correctly. The accuracy of the law itself is shown "
        "below."
        f"{_dash_legend(table, abscissa)}",
        menu="Quantity",
        height=440,
    )


def _abscissa(table: pd.DataFrame) -> str | None:
    """Return the column of the x axis.

    The x axis is the numeric column with the most different values. If no number varies, it is a
    column of texts that varies, such as the material.
    """
    numbers = [name for name in ("speed", "angle", "incident_angle", "radius") if name in table]
    others = [name for name in ("geometry", "material", "wall", "options") if name in table]
    counts = {name: table[name].nunique() for name in numbers + others}
    most = max(numbers, key=counts.get, default=None)
    if most is not None and counts[most] > 1:
        return most
    return next((name for name in others if counts[name] > 1), most)


def _dash_legend(table: pd.DataFrame, abscissa: str) -> str:
    """Return a sentence that explains the line styles, or "" if there is only one style."""
    styles = line_styles(curve_groups(table, abscissa))
    legend = [f"{DASHES[dash][2]} {others}" for others, dash in styles.items()]
    return f" Lines: {'; '.join(legend)}." if len(legend) > 1 else ""


def loops_chart(folder: Path, table: pd.DataFrame) -> tuple[Chart | None, list[str]]:
    """Return the chart of force versus overlap, with a view for each speed and a loop for each law.

    The chart is None if the sweep has no trajectories. The second result is a list with a sentence
    for the page if trajectories cannot be read; otherwise it is empty.
    """
    loops, damaged = [], []
    if not {"geometry", "law", "speed", "material", "radius"} <= set(table):
        return None, []
    for trajectory in sorted(folder.glob("runs/*/trajectory.dump")):
        try:
            loops += _loop(trajectory, table)
        except (CollisionError, DumpError, TruncatedFileWarning) as error:
            damaged.append(error)
    missing = [f"Loops of {len(damaged)} impacts cannot be read: {damaged[0]}."] if damaged else []
    if not loops:
        return None, missing
    panels = loop_panels(loops, "speed", "law", varied(table), common_axes=False)
    chart = Chart(
        name="loops",
        views={name: [panel] for name, panel in panels.items()},
        description="normal force versus overlap during an impact, one loop per law",
        caption="The left branch of a loop is loading, the right branch unloading. The area "
        "between them is the dissipated energy. The loop ends on the axis at the residual overlap.",
        menu="Impact",
        start=list(panels)[len(panels) // 2],
        height=440,
    )
    return chart, missing


def _loop(trajectory: Path, table: pd.DataFrame) -> list[tuple[pd.Series, pd.DataFrame]]:
    """Return the table row and the force-overlap loop of the impact of a trajectory.

    The result is empty if the table does not contain the impact.

    Raises:
        CollisionError, DumpError, TruncatedFileWarning: The trajectory is damaged.
    """
    label = trajectory.parent.name.partition("_")[2]
    cases = table[[name for name in LABELLED if name in table]].astype(str)
    rows = table[[run_label(**case) == label for case in cases.to_dict("records")]]
    with warnings.catch_warnings():
        warnings.simplefilter("error", TruncatedFileWarning)
        motion = read_dump(trajectory)
    loop = force_overlap_loop(motion)
    speed = loop["speed"].iloc[0] / rows["geometry"].map(GEOMETRIES).astype(float)
    same = np.isclose(rows["speed"], speed, rtol=TOLERANCE, atol=0)
    same &= np.isclose(rows["radius"], motion["radius"].iloc[0], rtol=TOLERANCE, atol=0)
    touching = loop[loop["overlap"] >= 0]
    stride = max(1, -(-len(touching) // LOOP_POINTS))
    return [(row, touching.iloc[::stride]) for _, row in rows[same].head(1).iterrows()]
