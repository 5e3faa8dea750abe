# SPDX-License-Identifier: GPL-2.0-or-later
"""Data of the charts of central impacts: points with lines of theory, and force-overlap loops."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from importlib.resources import files
from math import isnan, nan

import numpy as np
import pandas as pd

from plastigran.experiments.central import GEOMETRIES, CentralImpact
from plastigran.experiments.central.arrangement import WALLS, on_wall
from plastigran.materials import NO_WALL, RIGID_WALL, USUAL, Material
from plastigran.plot.chart import DASHES, Curve, Panel
from plastigran.plot.quantities import PREDICTED, Scale, scale
from plastigran.plot.style import title

#: Number of points of a theoretical line, and factor by which its range of speeds exceeds the range
#: of the simulated speeds at both ends.
THEORY_POINTS = 120
THEORY_MARGIN = 1.3
#: Columns of the results table that may distinguish curves of one law.
APART = (
    "material",
    "wall",
    "options",
    "geometry",
    "radius",
    "surface_energy",
    "angle",
    "coefficient_of_friction",
)
#: An axis is logarithmic if the natural logarithms of its values span more than this number.
LOGARITHMIC = 3.0

Groups = dict[tuple[str, str], pd.DataFrame]


def finite_elements() -> pd.DataFrame:
    """Read peak force and restitution from the finite elements of Zhang and Vu-Quoc (2002).

    Returns:
        Columns speed [m/s], force_max [N] and coefficient_of_restitution.
    """
    source = files("plastigran") / "data" / "finite_elements_zv02.csv"
    with source.open() as file:
        return pd.read_csv(file, comment="#")


def measured_panels(
    table: pd.DataFrame,
    materials: Mapping[str, Material],
    quantities: Sequence[str],
    abscissa: str,
) -> dict[str, Panel]:
    """Return a chart panel for each quantity: simulated points and a line of theory for each law.

    Args:
        table: Results table of several impacts.
        materials: As for `central_case`.
        quantities: Columns on the y axes.
        abscissa: Column on the x axes.

    Returns:
        Panels by quantity; empty if two rows of a curve have the same abscissa.
    """
    groups = curve_groups(table, abscissa)
    if any(rows[abscissa].duplicated().any() for rows in groups.values()):
        return {}
    theory = {key: _theory(rows, abscissa, materials) for key, rows in groups.items()}
    return {name: _measured(groups, theory, name, abscissa) for name in quantities}


def curve_groups(table: pd.DataFrame, abscissa: str) -> Groups:
    """Return the rows of each curve, by law and by a phrase that distinguishes curves of one law.

    The phrase lists the values of those columns in `APART` that differ between the curves, such as
    "radius 2 mm".
    """
    if abscissa == "geometry" and "wall" in table:  # the geometry implies the wall
        table = table.assign(wall=table["wall"].replace(NO_WALL, RIGID_WALL))
    table = _without_lone_defaults(table)
    apart = [name for name in varied(table) if name != abscissa]
    law = table["law"] if "law" in table else pd.Series("", table.index)
    keys = [law, *(table[name] for name in apart)]
    return {
        (str(name), in_words(apart, values)): rows.sort_values(abscissa)
        for (name, *values), rows in table.groupby(keys, dropna=False)
    }


def line_styles(groups: Groups) -> dict[str, int]:
    """Return the line style, as an index into `DASHES`, for each phrase from `curve_groups`."""
    words = dict.fromkeys(others for _, others in groups)
    return {others: k % len(DASHES) for k, others in enumerate(words)}


def varied(table: pd.DataFrame) -> list[str]:
    """Return those columns in `APART` that have several values in a results table."""
    return [name for name in APART if name in table and table[name].nunique() > 1]


def in_words(names: Sequence[str], values: Sequence[object]) -> str:
    """Return values of table columns as text with names and units, joined by commas."""
    return ", ".join(filter(None, map(_in_words, names, values)))


def _in_words(name: str, value: object) -> str:
    if name == "wall":
        return on_wall(str(value))
    if isinstance(value, str):
        return title(value) if name in ("law", "material") else value.replace("_", " ")
    if isnan(value):  # the quantity does not apply to the law
        return ""
    axis = scale(name, [value])
    space = "" if axis.unit == "°" else " "
    shown = f"{value * axis.factor:.3g}{space}{axis.unit}".strip()
    return shown if name == "speed" else f"{axis.title} {shown}"


def _without_lone_defaults(table: pd.DataFrame) -> pd.DataFrame:
    """Replace the word `default` in the column `options` by "" if a law has no other options."""
    if not {"law", "options"} <= set(table):
        return table
    lone = table.groupby("law")["options"].transform("nunique") == 1
    return table.assign(options=table["options"].mask(lone & (table["options"] == USUAL), ""))


def _measured(groups: Groups, theory: Groups, quantity: str, abscissa: str) -> Panel:
    table = pd.concat(groups.values())
    values = table[abscissa]
    numeric = values.dtype.kind in "if"
    y = scale(quantity, table[quantity])
    logarithmic = ""
    if numeric and values.min() > 0 and np.ptp(np.log(values)) > LOGARITHMIC:
        logarithmic = "xy" if y.unit and (table[quantity] > 0).all() else "x"
    dashes, curves = line_styles(groups), []
    for (law, others), rows in groups.items():
        line = theory[law, others]
        predicted = f"{quantity}{PREDICTED}"
        named = {
            "name": ", ".join(filter(None, (title(law), others))),
            "law": law,
            "dash": dashes[others],
        }
        # Draw a line only through two or more points with numeric abscissae; otherwise draw a dash
        # at each point.
        look = "line" if numeric and len(line) > 1 else "dashes"
        y_line = line[predicted if predicted in line else quantity]
        x_line, x = _abscissae(line[abscissa]), _abscissae(rows[abscissa])
        curves += [
            Curve(x=x_line, y=y_line, look=look, source="theory", **named),
            Curve(x=x, y=rows[quantity], look="points", source="LIGGGHTS", **named),
        ]
    if abscissa == "speed" and _is_of_paper(table):
        curves += _paper(quantity)
    return Panel(
        x=scale(abscissa, values if numeric else []),
        y=y,
        curves=curves,
        logarithmic=logarithmic,
        y_range=(0, 1.05) if quantity == "coefficient_of_restitution" else None,
    )


def _abscissae(values: pd.Series) -> np.ndarray:
    if values.dtype.kind in "if":
        return values.to_numpy()
    return values.str.replace("_", " ").to_numpy()


def _is_of_paper(table: pd.DataFrame) -> bool:
    """Return whether all spheres are the sphere of Zhang and Vu-Quoc (2002), without options."""
    if not {"geometry", "material", "radius", "wall", "options"} <= set(table):
        return False
    sphere = (table["material"] == "aluminium_zv02") & (table["radius"] == 0.1)
    return bool((sphere & table["wall"].isin(WALLS) & table["options"].isin(("", USUAL))).all())


def _paper(quantity: str) -> list[Curve]:
    paper = finite_elements()
    if quantity not in paper:
        return []
    paper = paper[["speed", quantity]].dropna()
    name = "finite elements (Zhang & Vu-Quoc 2002)"
    x, y = paper["speed"].to_numpy(), paper[quantity].to_numpy()
    return [Curve(x=x, y=y, name=name, look="cross", source="finite elements")]


def _theory(rows: pd.DataFrame, abscissa: str, materials: Mapping[str, Material]) -> pd.DataFrame:
    """Return predictions of the law at many speeds; return `rows` if it cannot be evaluated."""
    if abscissa != "speed":
        return rows
    case = central_case(rows.iloc[-1], materials)
    if case is None:
        return rows
    ends = rows["speed"].min() / THEORY_MARGIN, rows["speed"].max() * THEORY_MARGIN
    speeds = np.unique(np.r_[rows["speed"], np.geomspace(*ends, THEORY_POINTS)])
    closing_speeds = speeds * case.bodies
    impacts = case.contact_law().central_impact(case.radius_eff, case.mass_eff, closing_speeds)
    names = ("coefficient_of_restitution", "force_max", "overlap_max", "overlap_res")
    theory = {f"{name}{PREDICTED}": getattr(impacts, name) for name in names}
    return pd.DataFrame({"speed": speeds, **theory})


def central_case(row: pd.Series, materials: Mapping[str, Material]) -> CentralImpact | None:
    """Return the impact that a row of a results table describes.

    Args:
        row: Row of the table.
        materials: Materials in the record of the simulations, by name. Other materials are read
            from their files.

    Returns:
        The impact. None for a row of another experiment, and for a material that is not available
        or has other constants now than in the simulations.
    """
    if row.get("geometry") not in GEOMETRIES:
        return None
    wall, options = row.get("wall"), row.get("options")
    surface_energy = row.get("surface_energy", nan)
    try:
        case = CentralImpact(
            law=row["law"],
            speed=row["speed"],
            material=materials.get(row["material"], row["material"]),
            radius=row["radius"],
            geometry=row["geometry"],
            wall=None if wall in (*WALLS, None) else materials.get(wall, wall),
            options=None if options in (USUAL, "") else options,
            surface_energy=None if pd.isna(surface_energy) else surface_energy,
        )
    except ValueError:
        return None
    force = row["force_max" + PREDICTED if "force_max" + PREDICTED in row else "force_max"]
    return case if np.isclose(case.predict().force_max, force, rtol=1e-6) else None


def loop_panels(
    loops: Sequence[tuple[Mapping[str, object], pd.DataFrame]],
    panel_by: str,
    curve_by: str,
    apart: Sequence[str],
    common_axes: bool,
) -> dict[str, Panel]:
    """Return panels of force versus overlap.

    Args:
        loops: For each impact, its row of the results table, and a table with the columns overlap
            [m] and force [N].
        panel_by: Column "law" or "speed"; each of its values gets its own panel.
        curve_by: Column whose values name the curves in a panel, "speed" or "law".
        apart: Further columns whose values get separate panels; see `varied`.
        common_axes: Whether the axes of all panels have the same units.

    Returns:
        Panels by their title.
    """
    table = _without_lone_defaults(pd.DataFrame([dict(case) for case, _ in loops]))
    names = [panel_by, *apart]
    axes = _loop_axes([loop for _, loop in loops]) if common_axes else None
    panels = {}
    for key, rows in table.sort_values(curve_by).groupby(names, dropna=False):
        chosen = [loops[k] for k in rows.index]
        x, y = axes or _loop_axes([loop for _, loop in chosen])
        curves = [
            Curve(
                x=loop["overlap"].to_numpy("float32"),
                y=loop["force"].to_numpy("float32"),
                name=_in_words(curve_by, case[curve_by]),
                law=str(case["law"]),
            )
            for case, loop in chosen
        ]
        panels[in_words(names, key)] = Panel(x=x, y=y, curves=curves)
    return panels


def _loop_axes(loops: Sequence[pd.DataFrame]) -> tuple[Scale, Scale]:
    together = pd.concat(loops)
    x, y = scale("overlap_max", together["overlap"]), scale("force_max", together["force"])
    return Scale("overlap", x.unit, x.factor), Scale("normal force", y.unit, y.factor)
