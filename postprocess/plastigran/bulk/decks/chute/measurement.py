# SPDX-License-Identifier: GPL-2.0-or-later
"""What weight does in a chute flow, from the motion of the flow's centre of mass."""

from __future__ import annotations

from math import cos, sin

import pandas as pd
from scipy.integrate import cumulative_trapezoid


def add_mechanics(
    series: pd.DataFrame, angle: float, gravitational_acceleration: float
) -> pd.DataFrame:
    """Potential energy and the power of the weight.

    Args:
        series: Columns time [s], mass [kg], z [m] and speed [m/s] of its centre.
        angle: Of the chute [rad].
        gravitational_acceleration: [m/s^2].

    Returns:
        The series with `gravity_predicted` [J], the change of the flow's potential energy, and
        `weight_power` [W], m g v sin(angle).
    """
    weight = gravitational_acceleration * series["mass"]
    along = cumulative_trapezoid(series["speed"], series["time"], initial=0)
    up = series["z"] - series["z"].iloc[0]
    return series.assign(
        gravity_predicted=weight * (cos(angle) * up - sin(angle) * along),
        weight_power=weight * sin(angle) * series["speed"],
    )
