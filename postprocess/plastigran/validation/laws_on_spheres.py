# SPDX-License-Identifier: GPL-2.0-or-later
"""Errors of every law compared with finite elements of spheres, by kind and speed."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
import pandas as pd

from plastigran import laws
from plastigran.calibration.expected_errors import KINDS
from plastigran.materials import RIGID
from plastigran.physics.central import yield_speed
from plastigran.usable_laws import laws_for
from plastigran.validation.spheres import table
from plastigran.validation.spheres.metals import PLANE_MODULUS, RADIUS, SphereMetal
from plastigran.validation.spheres.regimes import SPEED_RATIOS, kind
from plastigran.validation.tables import root_mean_square

#: Bounds of the speed regimes, v/v_Y.
REGIMES = (*SPEED_RATIOS, 1000)
#: Law that was fitted to some of the metals, and the name of its rows for those.
FITTED_LAW, ON_FITTED_METALS = "universal", "universal, metals of its fit"
MASS = 1.0  # mass of a sphere [kg]; ratios do not depend on it
#: Compared quantities, by column of the table of errors.
QUANTITIES = ("coefficient_of_restitution", "force_max")


def yielding_laws() -> list[str]:
    """Return the names of the laws for spheres that yield."""
    return [name for name in laws_for("sphere") if laws.LAWS[name].yields]


def compare(names: Iterable[str] | None = None, rows: pd.DataFrame | None = None) -> pd.DataFrame:
    """Compare laws with each row of the table of spheres.

    Args:
        names: Names of laws; None for all that yield.
        rows: Rows of the table of spheres, or None for all.

    Returns:
        A row for each law and row of the table: law, metal, set, kind, speed_ratio and
            `QUANTITIES`, each as law / finite elements - 1 [-]. The rows of `FITTED_LAW` for metals
            of its fit have the law `ON_FITTED_METALS`.
    """
    rows = table() if rows is None else rows
    rows = rows[rows["speed_ratio"] > 1].assign(kind=kind)
    found = []
    for _, metal in rows.groupby("metal", sort=False):
        properties = metal.iloc[0]
        sphere = _metal(properties).sphere
        force = sphere.yield_force
        pair = laws.combine(_body(properties), RIGID)
        speed = yield_speed(pair, RADIUS, MASS) * metal["speed_ratio"].to_numpy()
        for name in yielding_laws() if names is None else names:
            impact = laws.LAWS[name](pair).central_impact(RADIUS, MASS, speed)
            line = metal[["metal", "set", "kind", "speed_ratio"]].assign(law=name)
            reference = metal["coefficient_of_restitution"].to_numpy()
            line["coefficient_of_restitution"] = impact.coefficient_of_restitution / reference - 1
            reference = metal["force_ratio"].to_numpy() * force
            line["force_max"] = impact.force_max / reference - 1
            if name == FITTED_LAW:
                line["law"] = line["law"].mask(line["set"] == "fit", ON_FITTED_METALS)
            found.append(line)
    return pd.concat(found, ignore_index=True)


def without_fitted_metals(compared: pd.DataFrame) -> pd.DataFrame:
    """Return the rows of a comparison that no law was fitted to."""
    return compared[compared["law"] != ON_FITTED_METALS]


def errors(compared: pd.DataFrame) -> pd.DataFrame:
    """Return the errors by law, kind of contact and speed regime.

    Args:
        compared: As of `compare`.

    Returns:
        Columns law, kind, speed_ratio_from and speed_ratio_to (the regime), quantity (one of
        `QUANTITIES`), rms and max (relative errors [-]), and cases (their number). A regime without
        cases has no row.
    """
    regime = pd.cut(compared["speed_ratio"], REGIMES, labels=False)
    kinds = pd.Categorical(compared["kind"], KINDS, ordered=True)
    compared = compared.assign(regime=regime, kind=kinds).dropna(subset="regime")
    found = []
    for (law, sort, step), part in compared.groupby(["law", "kind", "regime"], observed=True):
        for quantity in QUANTITIES:
            error = part[quantity].to_numpy()
            found.append(
                {
                    "law": law,
                    "kind": sort,
                    "speed_ratio_from": REGIMES[int(step)],
                    "speed_ratio_to": REGIMES[int(step) + 1],
                    "quantity": quantity,
                    "rms": root_mean_square(error),
                    "max": float(np.abs(error).max()),
                    "cases": len(error),
                }
            )
    return pd.DataFrame(found)


def _metal(row: pd.Series) -> SphereMetal:
    return SphereMetal(row["yield_strength_ratio"], row["poissons_ratio"], row["hardening_ratio"])


def _body(row: pd.Series) -> laws.Body:
    nu, hardening = row["poissons_ratio"], row["hardening_ratio"]
    youngs_modulus = PLANE_MODULUS * (1 - nu**2)
    return laws.Body(
        youngs_modulus,
        nu,
        row["yield_strength_ratio"] * PLANE_MODULUS,
        tangent_modulus=youngs_modulus * hardening / (1 + hardening),
    )
