# SPDX-License-Identifier: GPL-2.0-or-later
"""Speed over height in a chute flow, and Bagnold's profile fitted to it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pandas as pd
from scipy.stats import linregress

#: Shares of the depth between which the profile is held against Bagnold's: layers at the base slip,
#: and at the surface grains hop.
FITTED = (0.15, 0.95)


@dataclass(frozen=True)
class Profile:
    """Speed over height, and Bagnold's profile v = slip + rate (h^(3/2) - (h - z)^(3/2)) in it.

    Attributes:
        table: Columns height [m] above the base, speed [m/s], speed_predicted [m/s] and count, one
            row a bin.
        depth: h [m], twice the height of the centre of mass.
        slip: Speed at the base [m/s].
        rate: [m^(-1/2)/s].
        residual: Root mean square of speed - speed_predicted over the fitted bins, over the speed
            at the surface [-].
    """

    table: pd.DataFrame
    depth: float
    slip: float
    rate: float
    residual: float

    @property
    def surface_speed(self) -> float:
        """Of the fitted profile [m/s]."""
        return self.slip + self.rate * self.depth**1.5


def fit_profile(grains: pd.DataFrame, diameter: float) -> Profile:
    """Mean speed in bins half a grain thick, and Bagnold's profile fitted to it.

    Args:
        grains: Frames of glued and flowing grains: columns id, z, radius [m], vx, vy, vz [m/s].
        diameter: Of a grain in the mean [m].
    """
    held = (grains[["vx", "vy", "vz"]] == 0).all(axis="columns")
    base = grains[held]
    upper = base["z"] > base["z"].median()  # of its two layers
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
    line = linregress(shape[fitted], table["speed"][fitted])
    table["speed_predicted"] = line.intercept + line.slope * shape
    left = (table["speed"] - table["speed_predicted"])[fitted]
    surface = line.intercept + line.slope * depth**1.5
    residual = float((left**2).mean() ** 0.5 / abs(surface))
    return Profile(table.reset_index(drop=True), depth, line.intercept, line.slope, residual)
