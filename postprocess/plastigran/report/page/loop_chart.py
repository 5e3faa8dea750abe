# SPDX-License-Identifier: GPL-2.0-or-later
"""Chart of central impacts: loops of force over overlap."""

from __future__ import annotations

from pathlib import Path

import pandas as pd
import plotly.graph_objects as go

from plastigran.engine.dumps import DumpError, read_dump
from plastigran.experiments.central import GEOMETRIES
from plastigran.experiments.collision import CollisionError, force_overlap_loop
from plastigran.plot.style import title
from plastigran.report.page.charts import Chart, chart_name, figure, line, of_law
from plastigran.report.page.names import scale
from plastigran.report.page.sweep_charts import said_of

#: Points a loop is drawn with at most.
LOOP_POINTS = 80


def loops_chart(name: str, folder: Path, table: pd.DataFrame) -> Chart | None:
    """Force over overlap of central impacts, a loop each, one speed at a time; None where the
    trajectories are not there."""
    loops: dict[tuple, list] = {}
    if not {"geometry", "law", "speed", "material", "radius"} <= set(table):
        return None
    apart = [name for name in ("geometry", "material", "radius") if table[name].nunique() > 1]
    for run in sorted(folder.glob("runs/*/trajectory.dump")):
        if found := _loop(run, table):
            row, loop = found
            key = row["speed"], *(row[name] for name in apart)
            loops.setdefault(key, []).append((row, loop))
    if not loops:
        return None
    views = {
        ", ".join(
            said_of(name, value) for name, value in zip(("speed", *apart), key, strict=True)
        ): _loops(loops[key])
        for key in sorted(loops)
    }
    names = list(views)
    return Chart(
        chart_name(name, "loops"),
        views,
        "normal force over overlap during an impact, a loop for each law",
        "Loading goes up the left side, the rebound comes down the right one: the area between is "
        "what the impact took. Where a loop ends on the axis is the dent that stays.",
        "Impact" if len(views) > 1 else "",
        names[len(names) // 2],
        height=440,
    )


def _loop(trajectory: Path, table: pd.DataFrame) -> tuple[pd.Series, pd.DataFrame] | None:
    """The loop in a run's folder, and the row of the table that is its; None where it has none."""
    label = trajectory.parent.name
    rows = table[[label.endswith(f"{r.geometry}_{r.material}_{r.law}") for r in table.itertuples()]]
    try:
        loop = force_overlap_loop(read_dump(trajectory))
    except (CollisionError, DumpError):
        return None
    if rows.empty:
        return None
    closing = loop["speed"].iloc[0] / rows["geometry"].map(GEOMETRIES).iloc[0]
    row = rows.loc[(rows["speed"] / closing - 1).abs().idxmin()]
    touching = loop[loop["overlap"] >= 0]
    every = max(1, -(-len(touching) // LOOP_POINTS))
    return row, touching.iloc[::every]


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
