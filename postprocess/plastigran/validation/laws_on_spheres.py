# SPDX-License-Identifier: GPL-2.0-or-later
"""Errors of every law relative to finite elements of spheres, by kind of contact and speed."""

from __future__ import annotations

import numpy as np
import pandas as pd

from plastigran import laws
from plastigran.calibration.expected_errors import KINDS
from plastigran.physics.central import yield_speed
from plastigran.usable_laws import laws_for
from plastigran.validation.spheres import SPEED_RATIOS, contact_kinds, table
from plastigran.validation.spheres.metals import RADIUS, SphereMetal
from plastigran.validation.tables import root_mean_square

#: Bounds of the speed regimes, impact speed / yield speed.
REGIMES = (*SPEED_RATIOS, 1000)
#: Law that was fitted to some of the metals, and the name of its table rows for these metals.
FITTED_LAW, ON_FITTED_METALS = "universal", "universal, metals of its fit"
MASS = 1.0  # mass of a sphere [kg]; ratios do not depend on it
#: Compared quantities, by column of the table of errors.
QUANTITIES = ("coefficient_of_restitution", "force_max")


def yielding_laws() -> list[str]:
    """Return the names of the elasto-plastic laws for spheres."""
    return [name for name in laws_for("sphere") if laws.LAWS[name].yields]


def compare() -> pd.DataFrame:
    """Compare the elasto-plastic laws with finite elements of spheres, for impacts beyond yield.

    Returns:
        Table with a row for each law and each impact of `validation.spheres.table`: law, metal,
        set, kind, speed_ratio and `QUANTITIES`. Each quantity is the relative error of the law,
        law / finite elements - 1. The rows of the law `universal` for metals of its fit have the
        law name `ON_FITTED_METALS`.
    """
    rows = table()
    rows = rows[rows["speed_ratio"] > 1].assign(kind=contact_kinds)
    parts = []
    for _, impacts in rows.groupby("metal", sort=False):
        metal = SphereMetal.of(impacts.iloc[0])
        speed = yield_speed(metal.pair, RADIUS, MASS) * impacts["speed_ratio"].to_numpy()
        force = impacts["force_ratio"] * metal.sphere.yield_force
        restitution = impacts["coefficient_of_restitution"]
        for name in yielding_laws():
            impact = laws.LAWS[name](metal.pair).central_impact(RADIUS, MASS, speed)
            part = impacts[["metal", "set", "kind", "speed_ratio"]].assign(
                law=name,
                coefficient_of_restitution=impact.coefficient_of_restitution / restitution - 1,
                force_max=impact.force_max / force - 1,
            )
            if name == FITTED_LAW:
                part["law"] = part["law"].mask(part["set"] == "fit", ON_FITTED_METALS)
            parts.append(part)
    return pd.concat(parts, ignore_index=True)


def without_fitted_metals(compared: pd.DataFrame) -> pd.DataFrame:
    """Return a table of `compare` without the rows of `universal` for the metals of its fit."""
    return compared[compared["law"] != ON_FITTED_METALS]


def errors(compared: pd.DataFrame) -> pd.DataFrame:
    """Return the errors by law, kind of contact and speed regime.

    Args:
        compared: Table of `compare`.

    Returns:
        Table with the columns law, kind, speed_ratio_from and speed_ratio_to (the speed regime),
        quantity (one of `QUANTITIES`), rms and max (relative errors), and cases (number of
        impacts). A regime without impacts has no row.
    """
    compared = compared.assign(
        regime=pd.cut(compared["speed_ratio"], REGIMES, labels=False),
        kind=pd.Categorical(compared["kind"], KINDS, ordered=True),
    ).dropna(subset="regime")
    rows = []
    for (law, contact, number), part in compared.groupby(["law", "kind", "regime"], observed=True):
        for quantity in QUANTITIES:
            error = part[quantity].to_numpy()
            rows.append(
                {
                    "law": law,
                    "kind": contact,
                    "speed_ratio_from": REGIMES[int(number)],
                    "speed_ratio_to": REGIMES[int(number) + 1],
                    "quantity": quantity,
                    "rms": root_mean_square(error),
                    "max": float(np.abs(error).max()),
                    "cases": len(error),
                }
            )
    return pd.DataFrame(rows)
