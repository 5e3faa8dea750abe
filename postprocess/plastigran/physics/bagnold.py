# SPDX-License-Identifier: GPL-2.0-or-later
"""Velocity profile of a granular flow down a chute, and a fit of Bagnold's profile."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pandas as pd

#: Fractions of the flow depth between which Bagnold's profile is fitted. The fit omits the base,
#: where layers slip, and the surface, where grains bounce.
FITTED = (0.15, 0.95)


@dataclass(frozen=True)
class Profile:
    """Velocity profile, and the fit of Bagnold's profile v = slip + rate (h^1.5 - (h - z)^1.5).

    v is the speed at the height z above the base, and h the depth of the flow.

    Attributes:
        table: One row per bin of height. The columns are height [m] above the base, speed [m/s],
            speed_predicted [m/s] and count, the number of grain velocities in the bin.
        depth: Depth h of the flow [m], twice the height of the center of mass.
        slip: Speed at the base [m/s].
        rate: Factor `rate` of the profile [m^(-1/2)/s].
        residual: Root mean square of speed - speed_predicted in the fitted bins, divided by the
            speed at the surface [-].
    """

    table: pd.DataFrame
    depth: float
    slip: float
    rate: float
    residual: float

    @property
    def surface_speed(self) -> float:
        """Speed of the fitted profile at the surface [m/s]."""
        return self.slip + self.rate * self.depth**1.5


def fit_profile(grains: pd.DataFrame, diameter: float) -> Profile:
    """Fit Bagnold's profile to the mean speed in bins of height, each half a grain diameter thick.

    Args:
        grains: Frames of all grains, the fixed grains of the base included. The columns are id, z,
            radius [m], vx, vy, vz [m/s].
        diameter: Mean diameter of the grains [m].
    """
    held = (grains[["vx", "vy", "vz"]] == 0).all(axis="columns")
    base = grains[held]
    upper = base["z"] > base["z"].median()  # select the upper of the two layers of the base
    flow = grains[~held].assign(
        height=lambda row: row["z"] - base.loc[upper, "z"].mean(),
        volume=lambda row: row["radius"] ** 3,
    )
    depth = 2 * np.average(flow["height"], weights=flow["volume"])
    bins = (flow["height"] / (diameter / 2)).round().astype(int)
    table = flow.groupby(bins).agg(speed=("vx", "mean"), count=("vx", "size"))
    table = table[table["count"] > 0.1 * table["count"].median()]
    table.insert(0, "height", table.index * diameter / 2)
    shape = depth**1.5 - (depth - table["height"]).clip(lower=0) ** 1.5
    fitted = table["height"].between(*(share * depth for share in FITTED))
    from scipy.stats import linregress  # imported here: scipy.stats is slow

    line = linregress(shape[fitted], table["speed"][fitted])
    table["speed_predicted"] = line.intercept + line.slope * shape
    left = (table["speed"] - table["speed_predicted"])[fitted]
    surface = line.intercept + line.slope * depth**1.5
    residual = float((left**2).mean() ** 0.5 / abs(surface))
    return Profile(table.reset_index(drop=True), depth, line.intercept, line.slope, residual)
