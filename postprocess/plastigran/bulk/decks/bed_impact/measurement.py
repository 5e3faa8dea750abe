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
        One row per grain: `id`, `z` [m], `vz` [m/s], `touching` (number of contacts), `z_before`
            and `vz_before` (before the impact), and `plastic_work` since then [J].

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

    The lowest shot starts a radius above the surface. Above the surface, a shot flies freely, so
    v^2 + 2 g z is constant during the flight.

    Args:
        shot: Rows of `read_grains_dump`, of the shots only.
        radius: Radius of a shot [m].
        gravitational_acceleration: Downward acceleration g [m/s^2].

    Returns:
        One row per shot: `impact_speed` and `rebound_speed` [m/s], 0 for a shot that is not above
        the surface; `plastic_work` since the start [J].
    """
    surface = shot["z_before"].min() - radius  # height of the center of a shot in contact
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
    """Return the plastic work since the impact in layers one diameter thick, by current depth.

    Args:
        grains: Rows of `read_grains_dump`, of bed and shots.
        surface: Height of the top of the bed before the impact [m].
        diameter: Grain diameter [m].

    Returns:
        One row per layer: `depth` of its middle below the surface [m], `plastic_work` [J].
    """
    layer = np.floor((surface - grains["z"]) / diameter).clip(lower=0)
    work = grains["plastic_work"].groupby(layer).sum()
    return pd.DataFrame({"depth": (work.index + 0.5) * diameter, "plastic_work": work.to_numpy()})
