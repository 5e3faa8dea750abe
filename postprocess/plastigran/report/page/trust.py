# SPDX-License-Identifier: GPL-2.0-or-later
"""Verification and validation of the laws in a sweep of impacts.

Verification compares impacts in LIGGGHTS with the equations of the law. Validation compares the law
with finite-element computations of spheres. `plastigran validate` computes the errors of the
validation.
"""

from __future__ import annotations

from collections.abc import Mapping

import attrs
import numpy as np
import pandas as pd

from plastigran import laws
from plastigran.calibration.expected_errors import ExpectedError, expected_error
from plastigran.experiments.central import CentralImpact
from plastigran.experiments.central.arrangement import WALLS, on_wall
from plastigran.experiments.central.curves import APART, central_case
from plastigran.materials import RIGID_WALL, Material
from plastigran.plot.chart import Curve, Panel
from plastigran.plot.quantities import PREDICTED, Scale, words
from plastigran.plot.style import title
from plastigran.report.page.charts import Chart

QUANTITIES = ("coefficient_of_restitution", "force_max")
#: Smallest and largest value on the axes of errors [%].
ERROR_AXIS = (1e-4, 160)

Errors = dict[str, tuple[float, float] | None]


@attrs.frozen
class Trust:
    """Known errors of a law in a sweep, as fractions. Unknown errors are None.

    Attributes:
        law: Name of the law.
        verified: Largest relative difference between LIGGGHTS and theory, by quantity.
        validated: Root mean square error and largest error of the law relative to finite elements
            at the speeds of the sweep, by quantity.
        unknown_materials: Materials whose constants are not available. Errors with these materials
            are unknown.
        not_validated: Impacts whose error is unknown, because they are faster than the
            finite-element impacts, hit a metal wall, or use options of the law.
        left_range_at: Lowest impact speed at which the law was used outside its range [m/s]; None
            if the law was never used outside its range.
        law_range: Validity range of the law in words.
    """

    law: str
    verified: dict[str, float | None]
    validated: Errors
    unknown_materials: list[str]
    not_validated: list[str]
    left_range_at: float | None
    law_range: str


def trust(table: pd.DataFrame, materials: Mapping[str, Material]) -> list[Trust]:
    """Return the known errors of each law in the results table of a sweep.

    `materials` are the materials that the sweep recorded, by name.
    """
    if "law" not in table:
        return []
    left_range_at = {}
    if {"in_range", "speed"} <= set(table):
        outside = table[~table["in_range"].astype(bool)]
        left_range_at = outside.groupby("law")["speed"].min().to_dict()
    return [
        Trust(
            str(law),
            {name: _verified(rows, name) for name in QUANTITIES},
            *_validated(rows, materials),
            left_range_at.get(law),
            laws.LAWS[law].range if law in laws.LAWS else "",
        )
        for law, rows in table.groupby("law")
    ]


def _difference(rows: pd.DataFrame, quantity: str) -> pd.Series:
    """Return the absolute relative difference between LIGGGHTS and theory, for each impact."""
    return (rows[quantity] / rows[f"{quantity}{PREDICTED}"] - 1).abs()


def _verified(rows: pd.DataFrame, quantity: str) -> float | None:
    if f"{quantity}{PREDICTED}" not in rows:
        return None
    largest = _difference(rows, quantity).max()
    return None if np.isnan(largest) else float(largest)


def _validated(
    rows: pd.DataFrame, materials: Mapping[str, Material]
) -> tuple[Errors, list[str], list[str]]:
    """Return the errors of a law relative to finite elements, for the impacts of a sweep.

    Args:
        rows: Rows of the results table with this law.
        materials: Materials that the sweep recorded, by name.

    Returns:
        Errors by quantity, names of materials without constants, and impacts whose error is
        unknown. The error of a quantity is the largest of all groups of impacts that cause yield.
    """
    errors, unknown_materials, not_validated = [], [], []
    if {"speed_ratio", "material", "geometry", "radius"} <= set(rows):
        apart = [name for name in APART if name in rows]
        for _, impacts in rows.groupby(apart, dropna=False):
            if not impacts["speed_ratio"].max() >= 1:
                continue
            fastest = impacts.loc[impacts["speed"].idxmax()]
            case = central_case(fastest, materials)
            error = case and _expected_error(case, impacts["speed_ratio"])
            if error is None:
                wall = fastest.get("wall", RIGID_WALL)
                metals = [fastest["material"]] + ([] if wall in WALLS else [wall])
                unknown_materials.append(" or ".join(map(str, metals)))
            elif error.restitution is None:
                not_validated.append(_describe(case))
            else:
                errors.append(error)
    validated: Errors = dict.fromkeys(QUANTITIES)
    if errors and not unknown_materials:
        largest = [
            max(getattr(error, name) for error in errors)
            for name in ("restitution", "restitution_largest", "force", "force_largest")
        ]
        validated = dict(zip(QUANTITIES, (tuple(largest[:2]), tuple(largest[2:])), strict=True))
    return validated, list(dict.fromkeys(unknown_materials)), list(dict.fromkeys(not_validated))


def _describe(case: CentralImpact) -> str:
    """Describe the material of an impact in words, with the metal wall and the options if any."""
    wall = f" {on_wall(case.wall_name)}" if case.wall else ""
    return f"{title(case.material.name)}{wall}{f', {case.options}' if case.options else ''}"


def _expected_error(fastest: CentralImpact, ratios: pd.Series) -> ExpectedError:
    """Return the expected error of a law for impact speeds up to the speed of `fastest`.

    The finite elements are spheres on a rigid plane, and the laws have their default options. For
    other options or a metal wall, the error is unknown. `ratios` are impact speeds / yield speed.
    """
    ends = ratios.min(), ratios.max()
    if fastest.options or fastest.wall:
        return ExpectedError.of_another_pair(ends)
    overlap = fastest.predict().overlap_max
    widest = fastest.contact_law().follow(fastest.radius_eff, [overlap])["contact_radius"][0]
    hardening = fastest.material.tangent_modulus > 0
    return expected_error(fastest.law, ends, hardening, widest / fastest.radius_eff)


def verification_chart(table: pd.DataFrame) -> Chart | None:
    """Return the chart of differences between LIGGGHTS and theory; None if no law yields."""
    if "speed_ratio" not in table or table["speed_ratio"].isna().all():
        return None
    yielding = table.dropna(subset=["speed_ratio"]).sort_values("speed_ratio")
    views = {}
    for quantity in QUANTITIES:
        if f"{quantity}{PREDICTED}" in table:
            difference = _difference(yielding, quantity)
            remarks = [
                f"v/v<sub>Y</sub> {ratio:.3g}<br>LIGGGHTS and theory differ by {100 * value:.2g} %"
                for ratio, value in zip(yielding["speed_ratio"], difference, strict=True)
            ]
            shown = difference.clip(lower=ERROR_AXIS[0] / 100)
            errors = yielding.assign(ratio=yielding["speed_ratio"], error=shown, remark=remarks)
            views[words(quantity).capitalize()] = _panels(errors)
    if not views:
        return None
    return Chart(
        name="verification",
        views=views,
        description="difference between impacts in LIGGGHTS and the law's theory, versus speed",
        caption="Verification: difference between LIGGGHTS and the equations of the law. "
        "This difference is the error of the code and of the time step.",
        menu="Quantity",
    )


def validation_chart(table: pd.DataFrame) -> Chart | None:
    """Return the chart of the errors of laws relative to finite elements; None without errors.

    `table` has the columns of `plastigran.calibration.expected_errors.errors_table`.
    """
    remarks = [
        f"v/v<sub>Y</sub> {row.speed_ratio_from:.3g} to {row.speed_ratio_to:.3g}<br>law and finite "
        f"elements differ by {100 * row.rms:.2g} % rms, {100 * row.max:.2g} % at most"
        for row in table.itertuples()
    ]
    middle = np.sqrt(table["speed_ratio_from"] * table["speed_ratio_to"])
    errors = table.assign(ratio=middle, error=table["rms"], remark=remarks).sort_values("ratio")
    views = {}
    for quantity in QUANTITIES:
        of_quantity = errors[errors["quantity"] == quantity]
        for contacts in table["kind"].unique():
            if len(rows := of_quantity[of_quantity["kind"] == contacts]):
                views[f"{words(quantity).capitalize()}, {contacts}"] = _panels(rows)
    if not views:
        return None
    return Chart(
        name="validation",
        views=views,
        description="error of each law compared with finite elements of spheres, versus speed",
        caption="Validation: root mean square difference between the law and finite elements of "
        "spheres of many metals. This error of the law does not depend on the time step.",
        menu="Quantity and metal",
    )


def _panels(errors: pd.DataFrame) -> list[Panel]:
    """Return a panel of a chart: error versus impact speed / yield speed, one curve per law.

    `errors` is a table with the columns law, ratio (impact speed / yield speed), error [%] and
    remark (text under the mouse pointer).
    """
    curves = [
        Curve(
            x=rows["ratio"].to_numpy(),
            y=rows["error"].to_numpy(),
            name=title(str(law)),
            law=str(law),
            look="joined",
            remarks=list(rows["remark"]),
        )
        for law, rows in errors.groupby("law")
    ]
    x = Scale("impact speed / yield speed", "", 1)
    y = Scale("difference", "%", 100)
    return [Panel(x=x, y=y, curves=curves, logarithmic="xy", y_range=ERROR_AXIS)]
