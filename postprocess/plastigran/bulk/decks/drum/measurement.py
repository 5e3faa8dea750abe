# SPDX-License-Identifier: GPL-2.0-or-later
"""Measurements of a drum's bed from its center of mass."""

from __future__ import annotations

from math import pi

import numpy as np
import pandas as pd
from scipy.integrate import cumulative_trapezoid


def add_mechanics(
    series: pd.DataFrame, angular_velocity: float, gravitational_acceleration: float
) -> pd.DataFrame:
    """Add revolutions, the angle of the bed, and the expected work of the wall.

    Args:
        series: Columns time [s], mass [kg], x, z [m] of the center of mass, and momentum, the
            angular momentum about the axis [kg m^2/s].
        angular_velocity: Angular velocity of the drum [1/s].
        gravitational_acceleration: Gravitational acceleration [m/s^2].

    Returns:
        The series with `revolutions`; `angle`, the inclination of the bed [degrees], which is that
        of the line from the axis to the center of mass; and `wallwork_predicted` [J], the work of
        the torque that balances the weight and changes the angular momentum of the bed.
    """
    torque = gravitational_acceleration * series["mass"] * series["x"]
    impulse = cumulative_trapezoid(torque, series["time"], initial=0)
    momentum = series["momentum"] - series["momentum"].iloc[0]
    return series.assign(
        revolutions=series["time"] / (2 * pi / angular_velocity),
        angle=np.degrees(np.arctan2(series["x"], -series["z"])),
        wallwork_predicted=angular_velocity * (impulse + momentum),
    )
