# SPDX-License-Identifier: GPL-2.0-or-later
"""What the centre of mass of a drum's bed says of the bed."""

from __future__ import annotations

from math import pi

import numpy as np
import pandas as pd
from scipy.integrate import cumulative_trapezoid


def add_mechanics(
    series: pd.DataFrame, angular_velocity: float, gravitational_acceleration: float
) -> pd.DataFrame:
    """Revolutions, the bed's angle, and the work its weight asks of the wall.

    Args:
        series: Columns time [s], mass [kg], x, z [m] of its centre, and momentum, the angular one
            about the axis [kg m^2/s].
        angular_velocity: Of the drum [1/s].
        gravitational_acceleration: [m/s^2].

    Returns:
        The series with `revolutions`; `angle`, the lean of the bed [degrees]: that of the line from
        the axis to the centre of mass, which is normal to a segment's chord; and
        `wallwork_predicted` [J]: the wall has the torque of the weight about the axis, and changes
        the bed's angular momentum, and its work is the torque's at the drum's angular velocity.
    """
    torque = gravitational_acceleration * series["mass"] * series["x"]
    impulse = cumulative_trapezoid(torque, series["time"], initial=0)
    momentum = series["momentum"] - series["momentum"].iloc[0]
    return series.assign(
        revolutions=series["time"] / (2 * pi / angular_velocity),
        angle=np.degrees(np.arctan2(series["x"], -series["z"])),
        wallwork_predicted=angular_velocity * (impulse + momentum),
    )
