# SPDX-License-Identifier: GPL-2.0-or-later
"""Accuracy of the table of spheres: finer steps and meshes, and dynamic impacts.

    python -m plastigran.validation.spheres.checks

prints the numbers of docs/laws/universal.md. What is not in the cache takes some minutes each.
"""

from __future__ import annotations

from collections.abc import Mapping

import attrs
import numpy as np
import pandas as pd

from plastigran.fem.cache import cached
from plastigran.fem.sphere.throw import throw
from plastigran.validation.spheres import table
from plastigran.validation.spheres.compute import SETTINGS, compute
from plastigran.validation.spheres.metals import METALS, RADIUS, SphereMetal

REFINED = ("s0.0012-nu0.3-perfect", "s0.0012-nu0.3-H0.02")
FINER: Mapping[str, Mapping[str, float]] = {
    "half the increments' growth": {"growth": 1.02},
    "8 divisions, not 6": {"divisions": 8},
}
#: Metals and speeds v/v_Y.
THROWN = (
    ("s0.0012-nu0.3-perfect", 10.0),
    ("s0.0012-nu0.3-perfect", 100.0),
    ("s0.0012-nu0.3-H0.02", 50.0),
    ("s0.005-nu0.3-perfect", 10.0),
)
COMPARED = {
    "overlap": "overlap_ratio",
    "residual overlap": "overlap_res_ratio",
    "contact radius": "contact_radius_ratio",
    "restitution": "coefficient_of_restitution",
}


def named(name: str) -> SphereMetal:
    """Return the metal with that name."""
    return next(metal for metal in METALS if metal.name == name)


def refined() -> pd.DataFrame:
    """Return the change with finer settings [%]: mean and largest over the rows of a metal.

    Rows begin at 3 P_Y and are compared at the same force.
    """
    found = []
    for name in REFINED:
        usual = compute(named(name))
        beyond = (usual["force_ratio"] > 2.9).to_numpy()
        for what, finer in FINER.items():
            other = compute(named(name), attrs.evolve(SETTINGS, **finer))
            row = {"metal": name, "changed": what}
            for said, column in COMPARED.items():
                change = 100 * (other[column] / usual[column] - 1).to_numpy()[beyond]
                row[f"{said}, mean"] = change.mean()
                row[f"{said}, largest"] = change[np.abs(change).argmax()]
            found.append(row)
    return pd.DataFrame(found)


def thrown() -> pd.DataFrame:
    """Return restitution and largest force (in yield units) of dynamic impacts.

    Values of quasi-static compression are interpolated between the rows of the table.
    """
    found, rows = [], table()
    for name, speed in THROWN:
        metal = named(name)
        sphere = metal.sphere
        impact = cached(throw, metal.material, RADIUS, float(speed * sphere.yield_speed))
        pressed = rows[rows["metal"] == name]
        at = np.log(speed), np.log(pressed["speed_ratio"])
        found.append(
            {
                "metal": name,
                "speed": speed,
                "restitution, thrown": impact.coefficient_of_restitution,
                "pressed": np.interp(*at, pressed["coefficient_of_restitution"]),
                "force, thrown": impact.force_max / sphere.yield_force,
                "force, pressed": np.exp(np.interp(*at, np.log(pressed["force_ratio"]))),
            }
        )
    return pd.DataFrame(found)


if __name__ == "__main__":
    with pd.option_context("display.width", 200, "display.max_columns", None):
        print(thrown().round(4).to_string())
        print(refined().round(2).to_string())
