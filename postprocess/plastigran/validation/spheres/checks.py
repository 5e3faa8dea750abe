# SPDX-License-Identifier: GPL-2.0-or-later
"""Accuracy of the finite-element table of spheres: finer steps and meshes, and dynamic impacts.

    python -m plastigran.validation.spheres.checks

This command prints the accuracy that docs/universal_derivation.md states. A computation that is not
in the cache takes some minutes.
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
from plastigran.validation.spheres.metals import METALS, RADIUS

REFINED = ("s0.0012-nu0.3-perfect", "s0.0012-nu0.3-H0.02")
FINER: Mapping[str, Mapping[str, float]] = {
    "half the increments' growth": {"growth": 1.02},
    "8 divisions, not 6": {"divisions": 8},
}
#: Metals and speeds v/v_Y of dynamic impacts.
DYNAMIC = (
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


def refined() -> pd.DataFrame:
    """Return how much finer settings change the results of each metal: mean and largest change [%].

    Results are compared at equal forces, from 3 times the yield force.
    """
    rows = []
    for name in REFINED:
        usual = compute(METALS[name])
        beyond = (usual["force_ratio"] > 2.9).to_numpy()
        for description, settings in FINER.items():
            finer = compute(METALS[name], attrs.evolve(SETTINGS, **settings))
            row = {"metal": name, "changed": description}
            for quantity, column in COMPARED.items():
                change = 100 * (finer[column] / usual[column] - 1).to_numpy()[beyond]
                row[f"{quantity}, mean"] = change.mean()
                row[f"{quantity}, largest"] = change[np.abs(change).argmax()]
            rows.append(row)
    return pd.DataFrame(rows)


def dynamic() -> pd.DataFrame:
    """Return the restitution and the largest force / yield force of dynamic impacts.

    The quasi-static values for comparison are interpolated in the finite-element table of spheres.
    """
    rows = []
    for name, speed in DYNAMIC:
        metal, sphere = METALS[name], METALS[name].sphere
        impact = cached(throw, metal.material, RADIUS, float(speed * sphere.yield_speed))
        static = table().query("metal == @name")
        at = np.log(speed), np.log(static["speed_ratio"])
        rows.append(
            {
                "metal": name,
                "speed": speed,
                "restitution, dynamic": impact.coefficient_of_restitution,
                "quasi-static": np.interp(*at, static["coefficient_of_restitution"]),
                "force, dynamic": impact.force_max / sphere.yield_force,
                "force, quasi-static": np.exp(np.interp(*at, np.log(static["force_ratio"]))),
            }
        )
    return pd.DataFrame(rows)


if __name__ == "__main__":
    with pd.option_context("display.width", 200, "display.max_columns", None):
        print(dynamic().round(4).to_string())
        print(refined().round(2).to_string())
