# SPDX-License-Identifier: GPL-2.0-or-later
"""Chart of a sweep: what was measured, with theory's lines."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import cycle

import numpy as np
import pandas as pd
import plotly.graph_objects as go

from plastigran import laws
from plastigran.experiments.central import GEOMETRIES, CentralImpact
from plastigran.experiments.central.arrangement import WALLS, on_wall
from plastigran.materials import NO_WALL, RIGID_WALL, USUAL, Material
from plastigran.plot.style import title
from plastigran.report.page.charts import Chart, chart_name, decades, figure, line, of_law, points
from plastigran.report.page.names import PREDICTED, scale, words

#: Speeds of a line of theory, and how far it goes to both sides of a single one.
FINE = 60
BESIDE = 1.3
#: Of lines of theory, as plotly and as a sentence has them.
KINDS = {
    "solid": "solid",
    "dash": "dashed",
    "dot": "dotted",
    "dashdot": "dash-dotted",
    "longdash": "long-dashed",
    "longdashdot": "long-dash-dotted",
}
#: What sets curves of a law apart.
APART = (
    "material",
    "wall",
    "options",
    "geometry",
    "radius",
    "angle",
    "coefficient_of_friction",
)
#: Of theory where there is no line.
DASH = {"symbol": "line-ew", "size": 22}


def measured_chart(
    name: str, table: pd.DataFrame, materials: Mapping[str, Material]
) -> Chart | None:
    """Every quantity that theory has too, over speed or angle: points measured in the engine,
    lines of theory. None of a table without such curves.

    Args:
        name: Of the section.
        table: Of the impacts.
        materials: As for `central_case`.
    """
    abscissa = _abscissa(table)
    quantities = [
        column
        for column in table
        if f"{column}{PREDICTED}" in table and table[column].notna().any()
    ]
    if not quantities or abscissa is None:
        return None
    groups = _groups(table, abscissa)
    if any(rows[abscissa].duplicated().any() for rows in groups.values()):
        return None  # something else varies: no curve
    theory = {key: _theory(rows, abscissa, materials) for key, rows in groups.items()}
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
        f"below.{_dashes_said(groups)}",
        "Quantity" if len(views) > 1 else "",
        height=440,
    )


def _abscissa(table: pd.DataFrame) -> str | None:
    """The case's number that varies most; where none does, the word."""
    numbers = [name for name in ("speed", "angle", "incident_angle", "radius") if name in table]
    words = [name for name in ("geometry", "material", "wall", "options") if name in table]
    varied = [name for name in numbers + words if table[name].nunique() > 1]
    most = max(
        (name for name in varied if name in numbers), key=lambda n: table[n].nunique(), default=None
    )
    return most or next(iter(varied), numbers[0] if numbers else None)


def _groups(table: pd.DataFrame, abscissa: str) -> dict[tuple[str, str], pd.DataFrame]:
    """Rows of a curve, by law and by what else sets the curve apart."""
    if abscissa == "geometry" and "wall" in table:  # which says where there is none
        table = table.assign(wall=table["wall"].replace(NO_WALL, RIGID_WALL))
    apart = [
        name for name in APART if name in table and name != abscissa and table[name].nunique() > 1
    ]
    law = table["law"] if "law" in table else pd.Series("", table.index)
    found = {}
    for key, rows in table.groupby([law, *(table[name] for name in apart)], dropna=False):
        said = (said_of(name, value) for name, value in zip(apart, key[1:], strict=True))
        others = ", ".join(filter(None, said))
        found[str(key[0]), others] = rows.sort_values(abscissa)
    return found


def _dashes(groups: dict) -> dict[str, str]:
    """The kind of line of what sets curves of a law apart."""
    apart = dict.fromkeys(others for _, others in groups)
    return dict(zip(apart, cycle(KINDS), strict=False))


def _dashes_said(groups: dict) -> str:
    """A sentence on the kinds of lines, where there are several."""
    found = [f"{KINDS[dash]} {others}" for others, dash in _dashes(groups).items()]
    return f" Lines: {'; '.join(found)}." if len(found) > 1 else ""


def said_of(name: str, value: object) -> str:
    """A value of a case in words, with its unit."""
    if name == "wall":
        return on_wall(str(value))
    if isinstance(value, str):
        return title(value) if name == "material" else value.replace("_", " ")
    found = scale(name, [value])
    space = "" if found.unit == "°" else " "
    shown = f"{value * found.factor:.3g}{space}{found.unit}".strip()
    return shown if name == "speed" else f"{found.title} {shown}"


def _measured(groups: dict, theory: dict, quantity: str, abscissa: str) -> go.Figure:
    every = pd.concat(groups.values())
    y = scale(quantity, every[quantity])
    numbers = every[abscissa].dtype.kind in "if"
    x = scale(abscissa, every[abscissa] if numbers else [])
    made = figure(x.axis, y.axis)
    if numbers and every[abscissa].min() > 0 and np.ptp(np.log(every[abscissa])) > 3:
        decades(made.update_xaxes)
        if y.unit and (every[quantity] > 0).all():
            decades(made.update_yaxes)
    if quantity == "coefficient_of_restitution":
        made.update_yaxes(range=[0, 1.05])
    dashes = _dashes(groups)
    for (law, others), rows in groups.items():
        name = ", ".join(filter(None, (title(law), others)))
        at = f"{x.title} %{{x:.4g}} {x.unit}" if numbers else "%{x}"
        said = f"<b>{name}</b><br>{at}<br>{y.title} %{{y:.5g}} {y.unit}"
        fine = theory[law, others]
        column = f"{quantity}{PREDICTED}"
        dashed = {"line": {"dash": dashes[others]}}
        # Between words, and beside a lone point, there is nothing: a dash at each.
        curve = numbers and len(fine) > 1
        draw, look = (line, dashed) if curve else (points, {"marker": DASH})
        made.add_trace(
            draw(
                _along(fine[abscissa], x.factor),
                fine[column if column in fine else quantity] * y.factor,
                name,
                of_law(law),
                said + "<extra>theory</extra>",
                **look,
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


def _theory(rows: pd.DataFrame, abscissa: str, materials: Mapping[str, Material]) -> pd.DataFrame:
    """Theory at many speeds, a little beside that of a single impact; where it cannot be had again,
    what the table has of it."""
    if abscissa != "speed":
        return rows
    case = central_case(rows.iloc[-1], materials)
    if case is None:
        return rows
    ends = rows["speed"].min(), rows["speed"].max()
    if ends[0] == ends[1]:
        ends = ends[0] / BESIDE, ends[1] * BESIDE
    speeds = np.unique(np.r_[rows["speed"], np.geomspace(*ends, FINE)])
    found = case.contact_law().central_impact(case.radius_eff, case.mass_eff, speeds * case.bodies)
    names = ("coefficient_of_restitution", "force_max", "overlap_max", "overlap_res")
    fine = {f"{name}{PREDICTED}": getattr(found, name) for name in names}
    return pd.DataFrame({"speed": speeds, **fine})


def central_case(row: pd.Series, materials: Mapping[str, Material]) -> CentralImpact | None:
    """The impact of a row of a table; None where it is another experiment's, or its material is not
    at hand: it is a user's own, say, or another one of that name.

    Args:
        row: Of the table.
        materials: That the sweep has recorded, by name; others are those at hand.
    """
    if row.get("geometry") not in GEOMETRIES:
        return None
    wall, options = row.get("wall"), row.get("options")
    try:
        case = CentralImpact(
            law=row["law"],
            speed=row["speed"],
            material=materials.get(row["material"], row["material"]),
            radius=row["radius"],
            geometry=row["geometry"],
            wall=None if wall in (*WALLS, None) else materials.get(wall, wall),
            options=None if options == USUAL else options,
        )
    except ValueError:
        return None
    force = row["force_max" + PREDICTED if "force_max" + PREDICTED in row else "force_max"]
    return case if np.isclose(case.predict().force_max, force, rtol=1e-6) else None


def leaves_range(table: pd.DataFrame) -> dict[str, float]:
    """The speed from which on each law was used beyond its range [m/s], of those that were."""
    if not {"in_range", "law", "speed"} <= set(table):
        return {}
    outside = table[~table["in_range"].astype(bool)]
    return outside.groupby("law")["speed"].min().to_dict()


def law_range(law: str) -> str:
    """What a law is good for, in its own words."""
    return laws.LAWS[law].range if law in laws.LAWS else ""
