# SPDX-License-Identifier: GPL-2.0-or-later
"""Shot on a plate or a bed: speeds before and after, shot by shot, and plastic work by depth."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd

from plastigran.engine.dumps import read_dump

_NAMES = {"before[1]": "vz_before", "before[2]": "z_before"}


def read_grains_dump(path: str | Path) -> pd.DataFrame:
    """The last frame of the deck's `grains.dump`.

    Returns:
        One row a grain: `id`, `z` [m], `vz` [m/s], `touching`, how many others, `z_before` and
        `vz_before`, before the shot, and `plastic_work` since then [J].

    Raises:
        DumpError: The file is not a dump.
    """
    frames = read_dump(path)
    last = frames[frames["step"] == frames["step"].max()]
    return last.drop(columns="step").rename(columns=_NAMES).reset_index(drop=True)


def measure_shots(
    shot: pd.DataFrame, radius: float, gravitational_acceleration: float
) -> pd.DataFrame:
    """Speeds at which each shot meets and leaves the target's surface.

    The lowest shot starts a radius above it. Between the surface and where a shot is, it flies
    freely: v^2 + 2 g z stays.

    Args:
        shot: Rows of `read_grains_dump`, of the shot alone.
        radius: Of the shot [m].
        gravitational_acceleration: g, downwards [m/s^2].

    Returns:
        One row a shot: `impact_speed` and `rebound_speed` [m/s], 0 for one that does not fly above
        the surface; `plastic_work` since the start [J].
    """
    surface = shot["z_before"].min() - radius  # where a touching shot's centre is
    fall = 2 * gravitational_acceleration * (shot["z_before"] - surface)
    rise = 2 * gravitational_acceleration * (shot["z"] - surface)
    speed = np.sqrt(shot["vz"] ** 2 + rise.clip(lower=0))
    come_back = (shot["z"] > surface) & (shot["touching"] == 0)
    come_back &= (shot["vz"] > 0) | (gravitational_acceleration > 0)
    return pd.DataFrame(
        {
            "impact_speed": np.sqrt(shot["vz_before"] ** 2 + fall),
            "rebound_speed": speed.where(come_back, 0.0),
            "plastic_work": shot["plastic_work"],
        }
    )


def plastic_work_by_depth(grains: pd.DataFrame, surface: float, diameter: float) -> pd.DataFrame:
    """Plastic work since the shot, in layers a diameter thick, at which depth it now lies.

    Args:
        grains: Rows of `read_grains_dump`, of bed and shot.
        surface: Height of the bed's highest point before the shot [m].
        diameter: Of the grains [m].

    Returns:
        One row a layer: `depth` of its middle below the surface [m], `plastic_work` [J].
    """
    layer = np.floor((surface - grains["z"]) / diameter).clip(lower=0)
    work = grains["plastic_work"].groupby(layer).sum()
    return pd.DataFrame({"depth": (work.index + 0.5) * diameter, "plastic_work": work.to_numpy()})


def predicted_rebound(law, radius: float, mass: float, speeds: pd.Series) -> np.ndarray:
    """V e(v) of central impacts on a plate of the same material [m/s], one a speed.

    Args:
        law: Of `plastigran.laws`, between the two bodies.
        radius: Of the shot [m].
        mass: Of the shot [kg].
        speeds: Of impact [m/s], (n,).
    """
    speeds = np.asarray(speeds)
    return speeds * law.central_impact(radius, mass, speeds).coefficient_of_restitution
