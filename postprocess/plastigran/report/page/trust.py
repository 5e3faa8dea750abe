# SPDX-License-Identifier: GPL-2.0-or-later
"""Verification and validation side by side: how far runs are off the law, and the law off nature.

Verification holds a run of the engine against the law's own theory. Validation holds the law
against finite elements of spheres, by what `plastigran validate` found.
"""

from __future__ import annotations

from collections.abc import Mapping

import attrs
import numpy as np
import pandas as pd

from plastigran.calibration.expected_errors import ExpectedError, expected_error
from plastigran.experiments.central import CentralImpact
from plastigran.experiments.central.arrangement import WALLS, on_wall
from plastigran.materials import RIGID_WALL, Material
from plastigran.plot.style import title
from plastigran.report.page.charts import Chart, chart_name, decades, figure, of_law, points
from plastigran.report.page.names import PREDICTED, words
from plastigran.report.page.sweep_charts import APART, central_case, law_range, leaves_range

QUANTITIES = ("coefficient_of_restitution", "force_max")
#: Limits of the charts' axes of errors, powers of ten of a per cent.
SPAN = (-4, 2.2)
_SCALE = "difference (%)"
_SPEED = "impact speed / yield speed"


@attrs.frozen
class Trust:
    """What is known of a law in a sweep; numbers are shares, None where nothing is known.

    Attributes:
        law: Its name.
        verified: By quantity, the largest difference of the runs from the law's theory.
        validated: By quantity, rms and largest error against finite elements at like speeds.
        unread: Materials in the way of that: their constants are not at hand.
        beyond: Impacts of which nothing is known: at speeds that the finite elements do not reach,
            on walls of a metal, by options of the law.
        until: Speed from which on the law was beyond its range [m/s].
        range: Its range in words.
    """

    law: str
    verified: dict[str, float | None]
    validated: dict[str, tuple[float, float] | None]
    unread: list[str]
    beyond: list[str]
    until: float | None
    range: str


def trust(table: pd.DataFrame, materials: Mapping[str, Material]) -> list[Trust]:
    """What is known of each law of a table of impacts, a sweep's.

    Args:
        table: Of the impacts.
        materials: As for `central_case`.
    """
    if "law" not in table:
        return []
    left = leaves_range(table)
    return [
        Trust(
            str(law),
            {name: _verified(rows, name) for name in QUANTITIES},
            *_validated(rows, materials),
            left.get(law),
            law_range(str(law)),
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
    """Rms and largest error of a law by quantity, the largest of the bodies that yield; materials
    that are not at hand, and impacts that nothing is known of."""
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
    """An impact's material, and the wall and options that are not the usual ones."""
    wall = f" {on_wall(case.wall_name)}" if case.wall else ""
    return f"{title(case.material.name)}{wall}{f', {case.options}' if case.options else ''}"


def _expected(fastest: CentralImpact, ratios: pd.Series) -> ExpectedError:
    """Nothing is known of laws with options, nor of walls of another metal: the finite elements are
    of spheres on a rigid plane, and of the laws as they are by default."""
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


def verification_chart(name: str, table: pd.DataFrame) -> Chart | None:
    """Difference of every impact from theory over speed; None where no law has a yield speed."""
    if "speed_ratio" not in table or table["speed_ratio"].isna().all():
        return None
    views = {}
    for quantity in QUANTITIES:
        if f"{quantity}{PREDICTED}" not in table:
            continue
        made = _empty()
        for law, rows in table.dropna(subset=["speed_ratio"]).groupby("law"):
            rows = rows.sort_values("speed_ratio")
            off = 100 * (rows[quantity] / rows[f"{quantity}{PREDICTED}"] - 1).abs()
            made.add_trace(
                points(
                    rows["speed_ratio"],
                    off.clip(lower=10 ** SPAN[0]),
                    title(str(law)),
                    of_law(str(law)),
                    f"<b>{title(str(law))}</b><br>v/v<sub>Y</sub> %{{x:.3g}}"
                    f"<br>run off theory by %{{customdata:.2g}} %<extra></extra>",
                    mode="lines+markers",
                    line={"width": 1},
                    customdata=off,
                    marker={"size": 6},
                )
            )
        views[words(quantity).capitalize()] = made
    if not views:
        return None
    return Chart(
        chart_name(name, "verification"),
        views,
        "difference between runs of the engine and the law's own theory, over speed",
        "Verification: runs of LIGGGHTS against the equations of their law, in per cent. This is "
        "the code's and the time step's error.",
        "Quantity",
    )


def validation_chart(name: str, table: pd.DataFrame) -> Chart | None:
    """Errors of laws against finite elements over speed; None where none is known.

    Args:
        name: Of the section.
        table: Of the laws, with the columns of `plastigran.calibration.expected_errors`.
    """
    views = {}
    for quantity in QUANTITIES:
        for kind, rows in table[table["quantity"] == quantity].groupby("kind", sort=False):
            made = _empty()
            for law, errors in rows.groupby("law"):
                errors = errors.sort_values("speed_ratio_from")
                middle = np.sqrt(errors["speed_ratio_from"] * errors["speed_ratio_to"])
                made.add_trace(
                    points(
                        middle,
                        100 * errors["rms"],
                        title(str(law)),
                        of_law(str(law)),
                        f"<b>{title(str(law))}</b><br>v/v<sub>Y</sub> %{{customdata[0]:.3g}} to "
                        "%{customdata[1]:.3g}<br>law off finite elements by %{y:.2g} % rms, "
                        "%{customdata[2]:.2g} % at most<extra></extra>",
                        mode="lines+markers",
                        line={"width": 1},
                        marker={"size": 6},
                        customdata=np.stack(
                            [
                                errors["speed_ratio_from"],
                                errors["speed_ratio_to"],
                                100 * errors["max"],
                            ],
                            axis=1,
                        ),
                    )
                )
            views[f"{words(quantity).capitalize()}, {kind}"] = made
    if not views:
        return None
    return Chart(
        chart_name(name, "validation"),
        views,
        "error of each law against finite elements of spheres, over speed",
        "Validation: the law itself against finite elements of spheres of many metals, in per cent "
        "(root mean square). This is what a law is off, however well it runs.",
        "Quantity and metal",
    )


def _empty():
    made = figure(_SPEED, _SCALE)
    decades(made.update_xaxes)
    decades(made.update_yaxes)
    made.update_yaxes(range=SPAN)
    return made
