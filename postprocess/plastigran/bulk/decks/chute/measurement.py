# SPDX-License-Identifier: GPL-2.0-or-later
"""Work and power of the weight in a chute flow, from the motion of its center of mass."""

from __future__ import annotations

from math import cos, sin

import pandas as pd
from scipy.integrate import cumulative_trapezoid


def add_mechanics(
    series: pd.DataFrame, angle: float, gravitational_acceleration: float
) -> pd.DataFrame:
    """Add potential energy and power of the weight.

    Args:
        series: Columns time [s], mass [kg], z [m] and speed [m/s] of the center of mass.
        angle: Angle of the chute [rad].
        gravitational_acceleration: Gravitational acceleration [m/s^2].

    Returns:
        The series with `gravity_predicted` [J], the change of potential energy, and `weight_power`
        [W], m g v sin(angle).
    """
    weight = gravitational_acceleration * series["mass"]
    along = cumulative_trapezoid(series["speed"], series["time"], initial=0)
    up = series["z"] - series["z"].iloc[0]
    return series.assign(
        gravity_predicted=weight * (cos(angle) * up - sin(angle) * along),
        weight_power=weight * sin(angle) * series["speed"],
    )
