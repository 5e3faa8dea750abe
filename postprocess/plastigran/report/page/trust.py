# SPDX-License-Identifier: GPL-2.0-or-later
"""Verification and validation of the laws of a sweep.

Verification compares runs of LIGGGHTS with the theory of the law. Validation compares the law with
finite elements of spheres; its errors are those of `plastigran validate`.
"""

from __future__ import annotations

from collections.abc import Mapping

import attrs
import numpy as np
import pandas as pd
import plotly.graph_objects as go

from plastigran import laws
from plastigran.calibration.expected_errors import ExpectedError, expected_error
from plastigran.experiments.central import CentralImpact
from plastigran.experiments.central.arrangement import WALLS, on_wall
from plastigran.experiments.central.curves import APART, central_case
from plastigran.materials import RIGID_WALL, Material
from plastigran.plot.chart import Curve, Panel
from plastigran.plot.quantities import PREDICTED, Scale, words
from plastigran.plot.style import title
from plastigran.report.page.charts import Chart, chart_name, interactive

QUANTITIES = ("coefficient_of_restitution", "force_max")
#: Ends of the axes of errors [%].
SPAN = (1e-4, 160)
_SPEED = Scale("impact speed / yield speed", "", 1)
_DIFFERENCE = Scale("difference", "%", 100)


@attrs.frozen
class Trust:
    """Known errors of a law in a sweep, as fractions; None where unknown.

    Attributes:
        law: Name of the law.
        verified: Largest difference between runs and theory, by quantity.
        validated: Rms and largest error compared with finite elements at these speeds, by quantity.
        unread: Materials whose constants are not available; they hide the error.
        beyond: Impacts without known error: faster than the finite elements, on a metal wall, or
            with options of the law.
        until: Speed from which the law was beyond its range [m/s].
        range: Range of the law in words.
    """

    law: str
    verified: dict[str, float | None]
    validated: dict[str, tuple[float, float] | None]
    unread: list[str]
    beyond: list[str]
    until: float | None
    range: str


def trust(table: pd.DataFrame, materials: Mapping[str, Material]) -> list[Trust]:
    """Return the known errors of each law of a sweep.

    Args:
        table: Results table of the sweep.
        materials: As for `central_case`.
    """
    if "law" not in table:
        return []
    left = _leaves_range(table)
    return [
        Trust(
            str(law),
            {name: _verified(rows, name) for name in QUANTITIES},
            *_validated(rows, materials),
            left.get(law),
            _law_range(str(law)),
        )
        for law, rows in table.groupby("law")
    ]


def _verified(rows: pd.DataFrame, name: str) -> float | None:
    if f"{name}{PREDICTED}" not in rows:
        return None
    off = (rows[name] / rows[f"{name}{PREDICTED}"] - 1).abs().max()
    return None if np.isnan(off) else float(off)


def _validated(
    rows: pd.DataFrame, materials: Mapping[str, Material]
) -> tuple[dict[str, tuple[float, float] | None], list[str], list[str]]:
    """Return rms and largest error by quantity, unavailable materials, and unknown impacts.

    The error is the largest of the bodies that yield.
    """
    unknown = dict.fromkeys(QUANTITIES)
    if not {"speed_ratio", "material", "geometry", "radius"} <= set(rows):
        return unknown, [], []
    found, unread, beyond = [], [], []
    apart = [name for name in APART if name in rows]
    for values, body in rows.groupby(apart, dropna=False):
        if not body["speed_ratio"].max() >= 1:
            continue
        of = dict(zip(apart, values, strict=True))
        case = central_case(body.loc[body["speed"].idxmax()], materials)
        error = case and _expected(case, body["speed_ratio"])
        if error is None:
            metals = [of["material"], *(w for w in [of.get("wall", RIGID_WALL)] if w not in WALLS)]
            unread.append(" or ".join(map(str, metals)))
        elif error.restitution is None:
            beyond.append(_named(case))
        else:
            found.append(error)
    unread, beyond = list(dict.fromkeys(unread)), list(dict.fromkeys(beyond))
    if unread or not found:
        return unknown, unread, beyond
    errors = {
        "coefficient_of_restitution": [(e.restitution, e.restitution_largest) for e in found],
        "force_max": [(e.force, e.force_largest) for e in found],
    }
    largest = {name: tuple(map(max, zip(*each, strict=True))) for name, each in errors.items()}
    return largest, [], beyond


def _named(case: CentralImpact) -> str:
    """Return the material of an impact, with its wall and options if they are unusual."""
    wall = f" {on_wall(case.wall_name)}" if case.wall else ""
    return f"{title(case.material.name)}{wall}{f', {case.options}' if case.options else ''}"


def _expected(fastest: CentralImpact, ratios: pd.Series) -> ExpectedError:
    """Return the expected error of a law for the speeds up to `fastest`.

    There is none for options of a law and for metal walls: the finite elements are of spheres on
    a rigid plane, for the default laws.
    """
    if fastest.options or fastest.wall:
        return ExpectedError.of_another_pair((ratios.min(), ratios.max()))
    overlap = fastest.predict().overlap_max
    widest = fastest.contact_law().follow(fastest.radius_eff, [overlap])["contact_radius"][0]
    return expected_error(
        fastest.law,
        (ratios.min(), ratios.max()),
        fastest.material.tangent_modulus > 0,
        widest / fastest.radius_eff,
    )


def _leaves_range(table: pd.DataFrame) -> dict[str, float]:
    """Return the lowest speed [m/s] at which each law was used beyond its range, if it was."""
    if not {"in_range", "law", "speed"} <= set(table):
        return {}
    outside = table[~table["in_range"].astype(bool)]
    return outside.groupby("law")["speed"].min().to_dict()


def _law_range(law: str) -> str:
    return laws.LAWS[law].range if law in laws.LAWS else ""


def verification_chart(name: str, table: pd.DataFrame) -> Chart | None:
    """Return the chart of differences from theory over speed; None if no law has a yield speed."""
    if "speed_ratio" not in table or table["speed_ratio"].isna().all():
        return None
    yielding = table.dropna(subset=["speed_ratio"]).sort_values("speed_ratio")
    views = {}
    for quantity in QUANTITIES:
        if f"{quantity}{PREDICTED}" not in table:
            continue
        curves = []
        for law, rows in yielding.groupby("law"):
            off = (rows[quantity] / rows[f"{quantity}{PREDICTED}"] - 1).abs()
            remarks = [
                f"v/v<sub>Y</sub> {ratio:.3g}<br>run and theory differ by {100 * each:.2g} %"
                for ratio, each in zip(rows["speed_ratio"], off, strict=True)
            ]
            off = off.clip(lower=SPAN[0] / 100)
            curves.append(_law_curve(str(law), rows["speed_ratio"], off, remarks))
        views[words(quantity).capitalize()] = _errors(curves)
    if not views:
        return None
    return Chart(
        chart_name(name, "verification"),
        views,
        "difference between runs of LIGGGHTS and the law's own theory, over speed",
        "Verification: difference between runs of LIGGGHTS and the equations of their law. It is "
        "the error of the code and of the time step.",
        "Quantity",
    )


def validation_chart(name: str, table: pd.DataFrame) -> Chart | None:
    """Return the chart of errors of laws against finite elements over speed; None without errors.

    Args:
        name: ID of the section.
        table: Errors of the laws, columns as of `plastigran.calibration.expected_errors`.
    """
    views = {}
    for quantity in QUANTITIES:
        for kind, rows in table[table["quantity"] == quantity].groupby("kind", sort=False):
            curves = []
            for law, errors in rows.sort_values("speed_ratio_from").groupby("law"):
                middle = np.sqrt(errors["speed_ratio_from"] * errors["speed_ratio_to"])
                remarks = [
                    f"v/v<sub>Y</sub> {row.speed_ratio_from:.3g} to "
                    f"{row.speed_ratio_to:.3g}<br>law and finite elements differ by "
                    f"{100 * row.rms:.2g} % rms, {100 * row.max:.2g} % at most"
                    for row in errors.itertuples()
                ]
                curves.append(_law_curve(str(law), middle, errors["rms"], remarks))
            views[f"{words(quantity).capitalize()}, {kind}"] = _errors(curves)
    if not views:
        return None
    return Chart(
        chart_name(name, "validation"),
        views,
        "error of each law against finite elements of spheres, over speed",
        "Validation: difference between the law and finite elements of spheres of many metals, "
        "root mean square. It is the error of the law, however accurate the run.",
        "Quantity and metal",
    )


def _law_curve(law: str, ratio: pd.Series, error: pd.Series, remarks: list[str]) -> Curve:
    x, y = ratio.to_numpy(), error.to_numpy()
    return Curve(x=x, y=y, name=title(law), law=law, look="joined", remarks=remarks)


def _errors(curves: list[Curve]) -> go.Figure:
    panel = Panel(x=_SPEED, y=_DIFFERENCE, curves=curves, logarithmic="xy", y_range=SPAN)
    return interactive(panel)
