# SPDX-License-Identifier: GPL-2.0-or-later
"""Measurements of shots on a plate or a bed: speeds of each shot, and plastic work by depth."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd

from plastigran.engine.dumps import read_dump

_NAMES = {"before[1]": "vz_before", "before[2]": "z_before"}


def read_grains_dump(path: str | Path) -> pd.DataFrame:
    """Read the last frame of the deck's `grains.dump`.

    Returns:
        One row per grain: `id`, height `z` [m], vertical velocity `vz` [m/s], number of contacts
            `touching`, `z_before` and `vz_before` at the start of the shots, and `plastic_work`
            since the start of the shots [J].

    Raises:
        DumpError: The file is not a dump.
    """
    frames = read_dump(path)
    last = frames[frames["step"] == frames["step"].max()]
    return last.drop(columns="step").rename(columns=_NAMES).reset_index(drop=True)


def measure_shots(
    shot: pd.DataFrame, radius: float, gravitational_acceleration: float
) -> pd.DataFrame:
    """Measure the speeds at which each shot reaches and leaves the surface of the target.

    The gap between the lowest shot and the surface is initially one radius. Above the surface, a
    shot flies freely, so v^2 + 2 g z is constant during the flight.

    Args:
        shot: Rows of `read_grains_dump` that are shots.
        radius: Radius of a shot [m].
        gravitational_acceleration: Downward acceleration g [m/s^2].

    Returns:
        One row per shot: `impact_speed` [m/s], `rebound_speed` [m/s] (0 for a shot that has not
        rebounded), and `plastic_work` since the start of the shots [J].
    """
    surface = shot["z_before"].min() - radius  # height of a shot's center when it touches
    fall = 2 * gravitational_acceleration * (shot["z_before"] - surface)
    rise = 2 * gravitational_acceleration * (shot["z"] - surface)
    speed = np.sqrt(shot["vz"] ** 2 + rise.clip(lower=0))
    rebounded = (shot["z"] > surface) & (shot["touching"] == 0)
    rebounded &= (shot["vz"] > 0) | (gravitational_acceleration > 0)
    return pd.DataFrame(
        {
            "impact_speed": np.sqrt(shot["vz_before"] ** 2 + fall),
            "rebound_speed": speed.where(rebounded, 0.0),
            "plastic_work": shot["plastic_work"],
        }
    )


def plastic_work_by_depth(grains: pd.DataFrame, surface: float, diameter: float) -> pd.DataFrame:
    """Return the plastic work since the start of the shots, in layers one grain diameter thick.

    The final height of a grain determines its layer.

    Args:
        grains: Table of `read_grains_dump`, with the grains of the bed and the shots.
        surface: Height of the top of the bed before the impact [m].
        diameter: Grain diameter [m].

    Returns:
        One row per layer: `depth` of the middle of the layer below the surface [m], and
        `plastic_work` [J].
    """
    layer = np.floor((surface - grains["z"]) / diameter).clip(lower=0)
    work = grains["plastic_work"].groupby(layer).sum()
    return pd.DataFrame({"depth": (work.index + 0.5) * diameter, "plastic_work": work.to_numpy()})
