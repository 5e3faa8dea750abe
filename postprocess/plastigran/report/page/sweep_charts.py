# SPDX-License-Identifier: GPL-2.0-or-later
"""Charts of a sweep: what was measured with theory's lines, and loops of force over overlap."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
import plotly.graph_objects as go

from plastigran import laws
from plastigran.experiments.central import GEOMETRIES, CentralImpact
from plastigran.experiments.collision import CollisionError, force_overlap_loop
from plastigran.engine.dumps import DumpError, read_dump
from plastigran.materials import read_material
from plastigran.plot.style import title
from plastigran.report.page.charts import Chart, chart_name, figure, line, of_law, points
from plastigran.report.page.names import scale, words

#: Speeds of a line of theory.
FINE = 60
#: Points a loop is drawn with at most.
LOOP_POINTS = 80
_PREDICTED = "_predicted"


def measured_chart(name: str, table: pd.DataFrame) -> Chart | None:
    """Every quantity that theory has too, over speed or angle: points measured in the engine,
    lines of theory. None of a table without such a quantity."""
    abscissa = _abscissa(table)
    quantities = [
        column
        for column in table
        if f"{column}{_PREDICTED}" in table and table[column].notna().any()
    ]
    if not quantities or abscissa is None:
        return None
    groups = _groups(table, abscissa)
    theory = {key: _theory(rows, abscissa) for key, rows in groups.items()}
    views = {
        words(quantity).capitalize(): _measured(groups, theory, quantity, abscissa)
        for quantity in quantities
    }
    return Chart(
        chart_name(name, "measured"),
        views,
        f"{', '.join(map(words, quantities))} over {words(abscissa)}, a curve for each law",
        "Points are what LIGGGHTS did with a law, lines what the law says without it. Where points "
        "lie on their line, the run is verified; whether the law is right is another question, "
        "below.",
        "Quantity" if len(views) > 1 else "",
        height=440,
    )


def _abscissa(table: pd.DataFrame) -> str | None:
    """The case's number that varies most; where none does, the word."""
    numbers = [name for name in ("speed", "angle", "incident_angle", "radius") if name in table]
    words = [name for name in ("geometry", "material") if name in table]
    varied = [name for name in numbers + words if table[name].nunique() > 1]
    most = max(
        (name for name in varied if name in numbers), key=lambda n: table[n].nunique(), default=None
    )
    return most or next(iter(varied), numbers[0] if numbers else None)


def _groups(table: pd.DataFrame, abscissa: str) -> dict[tuple[str, str], pd.DataFrame]:
    """Rows of a curve, by law and by what else sets the curve apart."""
    apart = [
        name
        for name in ("material", "geometry", "radius", "angle", "coefficient_of_friction")
        if name in table and name != abscissa and table[name].nunique() > 1
    ]
    law = table["law"] if "law" in table else pd.Series("", table.index)
    found = {}
    for key, rows in table.groupby([law, *(table[name] for name in apart)], sort=True):
        others = ", ".join(_said(name, value) for name, value in zip(apart, key[1:], strict=True))
        found[str(key[0]), others] = rows.sort_values(abscissa)
    return found


def _said(name: str, value: object) -> str:
    if isinstance(value, str):
        return title(value) if name == "material" else value.replace("_", " ")
    found = scale(name, [value])
    return f"{found.title} {value * found.factor:g} {found.unit}".strip()


def _measured(groups: dict, theory: dict, quantity: str, abscissa: str) -> go.Figure:
    every = pd.concat(groups.values())
    y = scale(quantity, every[quantity])
    numbers = every[abscissa].dtype.kind in "if"
    x = scale(abscissa, every[abscissa] if numbers else [])
    made = figure(x.axis, y.axis)
    if numbers and every[abscissa].min() > 0 and np.ptp(np.log(every[abscissa])) > 3:
        made.update_xaxes(type="log")
        if y.unit and (every[quantity] > 0).all():
            made.update_yaxes(type="log")
    if quantity == "coefficient_of_restitution":
        made.update_yaxes(range=[0, 1.05])
    dashes = dict(zip(dict.fromkeys(key[1] for key in groups), ("solid", "dash", "dot") * 9))
    for (law, others), rows in groups.items():
        name = ", ".join(filter(None, (title(law), others)))
        at = f"{x.title} %{{x:.4g}} {x.unit}" if numbers else "%{x}"
        said = f"<b>{name}</b><br>{at}<br>{y.title} %{{y:.5g}} {y.unit}"
        fine = theory[law, others]
        column = f"{quantity}{_PREDICTED}"
        made.add_trace(
            line(
                _along(fine[abscissa], x.factor),
                fine[column if column in fine else quantity] * y.factor,
                name,
                of_law(law),
                said + "<extra>theory</extra>",
                line={"dash": dashes[others]},
            )
        )
        made.add_trace(
            points(
                _along(rows[abscissa], x.factor),
                rows[quantity] * y.factor,
                name,
                of_law(law),
                said + "<extra>LIGGGHTS</extra>",
            )
        )
    return made


def _along(values: pd.Series, factor: float) -> pd.Series:
    """Numbers in an axis' unit, or words as they are read."""
    return values * factor if values.dtype.kind in "if" else values.str.replace("_", " ")


def _theory(rows: pd.DataFrame, abscissa: str) -> pd.DataFrame:
    """Theory at many speeds, or where it cannot be had again, what the table has of it."""
    first = rows.iloc[0]
    if abscissa != "speed" or len(rows) < 2 or first.get("geometry") not in GEOMETRIES:
        return rows
    try:
        case = CentralImpact(
            law=first["law"],
            speed=rows["speed"].max(),
            material=read_material(first["material"]),
            radius=first["radius"],
            geometry=first["geometry"],
        )
        law = case.contact_law()
    except ValueError:  # a material of the user's own, say
        return rows
    speeds = np.unique(
        np.r_[rows["speed"], np.geomspace(rows["speed"].min(), rows["speed"].max(), FINE)]
    )
    found = law.central_impact(case.radius_eff, case.mass_eff, speeds * case.bodies)
    names = ("coefficient_of_restitution", "force_max", "overlap_max", "overlap_res")
    fine = {f"{name}{_PREDICTED}": getattr(found, name) for name in names}
    # The same law with another material of that name would be another theory.
    again = np.interp(rows["speed"], speeds, fine[f"force_max{_PREDICTED}"])
    if not np.allclose(again, rows[f"force_max{_PREDICTED}"], rtol=1e-6):
        return rows
    return pd.DataFrame({"speed": speeds, **fine})


def loops_chart(name: str, folder: Path, table: pd.DataFrame) -> Chart | None:
    """Force over overlap of central impacts, a loop each, one speed at a time; None where the
    trajectories are not there."""
    loops: dict[float, list] = {}
    if not {"geometry", "law", "speed", "material"} <= set(table):
        return None
    for run in sorted(folder.glob("runs/*/trajectory.dump")):
        if found := _loop(run, table):
            row, loop = found
            loops.setdefault(row["speed"], []).append((row, loop))
    if not loops:
        return None
    views = {f"{speed:.3g} m/s": _loops(loops[speed]) for speed in sorted(loops)}
    names = list(views)
    return Chart(
        chart_name(name, "loops"),
        views,
        "normal force over overlap during an impact, a loop for each law",
        "Loading goes up the left side, the rebound comes down the right one: the area between is "
        "what the impact took. Where a loop ends on the axis is the dent that stays.",
        "Impact speed" if len(views) > 1 else "",
        names[len(names) // 2],
        height=440,
    )


def _loop(trajectory: Path, table: pd.DataFrame) -> tuple[pd.Series, pd.DataFrame] | None:
    """The loop in a run's folder, and the row of the table that is its; None where it has none."""
    label = trajectory.parent.name
    rows = table[
        [label.endswith(f"{r.geometry}_{r.material}_{r.law}") for r in table.itertuples()]
    ]
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
    varied = len({(r["geometry"], r["material"], r["radius"]) for r, _ in loops}) > 1
    for row, loop in sorted(loops, key=lambda each: each[0]["law"]):
        name = title(row["law"])
        if varied:
            name += f", {title(row['material'])}, {row['geometry'].replace('_', ' ')}"
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


def leaves_range(table: pd.DataFrame) -> dict[str, float]:
    """The speed from which on each law was used beyond its range [m/s], of those that were."""
    if not {"in_range", "law", "speed"} <= set(table):
        return {}
    outside = table[~table["in_range"].astype(bool)]
    return outside.groupby("law")["speed"].min().to_dict()


def law_range(law: str) -> str:
    """What a law is good for, in its own words."""
    return laws.LAWS[law].range if law in laws.LAWS else ""
