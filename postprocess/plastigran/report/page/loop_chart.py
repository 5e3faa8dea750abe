# SPDX-License-Identifier: GPL-2.0-or-later
"""Chart of central impacts: loops of force over overlap."""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np
import pandas as pd
import plotly.graph_objects as go

from plastigran.engine.dumps import DumpError, TruncatedFileWarning, read_dump
from plastigran.experiments.central import GEOMETRIES
from plastigran.experiments.central.arrangement import run_label
from plastigran.experiments.collision import CollisionError, force_overlap_loop
from plastigran.plot.style import title
from plastigran.report.page.charts import Chart, chart_name, figure, line, of_law
from plastigran.report.page.names import scale
from plastigran.report.page.sweep_charts import APART, said_of

#: Share by which radii and speeds are told apart; trajectories have 17 digits.
DIGITS = 1e-9
#: What the name of a run's folder tells.
LABELLED = ("geometry", "material", "law", "wall", "options")
#: Points a loop is drawn with at most.
LOOP_POINTS = 80


def loops_chart(name: str, folder: Path, table: pd.DataFrame) -> tuple[Chart | None, list[str]]:
    """Force over overlap of central impacts, a loop each, one speed at a time; None where the
    trajectories are not there. And a sentence where some cannot be read."""
    loops: dict[tuple, list] = {}
    damaged: list[Exception] = []
    if not {"geometry", "law", "speed", "material", "radius"} <= set(table):
        return None, []
    apart = [name for name in APART if name in table and table[name].nunique() > 1]
    for run in sorted(folder.glob("runs/*/trajectory.dump")):
        try:
            found = _loop(run, table)
        except (CollisionError, DumpError, TruncatedFileWarning) as error:
            damaged.append(error)
            continue
        if found:
            row, loop = found
            key = row["speed"], *(row[name] for name in apart)
            loops.setdefault(key, []).append((row, loop))
    missing = [f"Loops of {len(damaged)} impacts cannot be read: {damaged[0]}."] if damaged else []
    if not loops:
        return None, missing
    views = {
        ", ".join(filter(None, map(said_of, ("speed", *apart), key))): _loops(loops[key])
        for key in sorted(loops)
    }
    names = list(views)
    chart = Chart(
        chart_name(name, "loops"),
        views,
        "normal force over overlap during an impact, a loop for each law",
        "Loading goes up the left side, the rebound comes down the right one: the area between is "
        "what the impact took. Where a loop ends on the axis is the dent that stays.",
        "Impact" if len(views) > 1 else "",
        names[len(names) // 2],
        height=440,
    )
    return chart, missing


def _loop(trajectory: Path, table: pd.DataFrame) -> tuple[pd.Series, pd.DataFrame] | None:
    """The loop in a run's folder, and the row of the table that is its; None where it has none.

    Raises:
        CollisionError, DumpError, TruncatedFileWarning: The trajectory is damaged.
    """
    label = trajectory.parent.name.partition("_")[2]
    told = table[[name for name in LABELLED if name in table]].astype(str)
    rows = table[[run_label(**row) == label for row in told.to_dict("records")]]
    with warnings.catch_warnings():
        warnings.simplefilter("error", TruncatedFileWarning)
        motion = read_dump(trajectory)
    loop = force_overlap_loop(motion)
    speed = loop["speed"].iloc[0] / rows["geometry"].map(GEOMETRIES).astype(float)
    same = np.isclose(rows["speed"], speed, rtol=DIGITS, atol=0)
    same &= np.isclose(rows["radius"], motion["radius"].iloc[0], rtol=DIGITS, atol=0)
    if not same.any():
        return None
    touching = loop[loop["overlap"] >= 0]
    every = max(1, -(-len(touching) // LOOP_POINTS))
    return rows[same].iloc[0], touching.iloc[::every]


def _loops(loops: list[tuple[pd.Series, pd.DataFrame]]) -> go.Figure:
    every = pd.concat([loop for _, loop in loops])
    x, y = scale("overlap_max", every["overlap"]), scale("force_max", every["force"])
    made = figure(f"overlap ({x.unit})", f"normal force ({y.unit})")
    for row, loop in sorted(loops, key=lambda each: each[0]["law"]):
        name = title(row["law"])
        made.add_trace(
            line(
                (loop["overlap"] * x.factor).astype("float32"),
                (loop["force"] * y.factor).astype("float32"),
                name,
                of_law(row["law"]),
                f"<b>{name}</b><br>overlap %{{x:.4g}} {x.unit}<br>force %{{y:.4g}} {y.unit}"
                "<extra></extra>",
            )
        )
    return made
