# SPDX-License-Identifier: GPL-2.0-or-later
"""Measure the impact of a rod from the trajectory that the deck `rod.in` writes."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd

from plastigran.engine.dumps import read_dump
from plastigran.experiments.collision import CollisionError, measure_loop
from plastigran.physics.rod import RodOutcome

#: IDs of the three spheres that form the rod in the deck.
TIP, CENTRE, FAR_END = 1, 2, 3


def measure_rod(
    trajectory: str | Path | pd.DataFrame, gravitational_acceleration: float
) -> RodOutcome:
    """Measure a rod's impact from the trajectory that `rod.in` writes.

    Args:
        trajectory: Path of the dump, or its table from `read_dump`.
        gravitational_acceleration: Gravitational acceleration in the deck [m/s^2]. The forces in
            the dump include the weight of each sphere, which this function subtracts.

    Raises:
        CollisionError: The table does not contain three spheres, or the tip never touches or does
            not separate.
    """
    if not isinstance(trajectory, pd.DataFrame):
        trajectory = read_dump(trajectory)
    parts = {number: part.reset_index(drop=True) for number, part in trajectory.groupby("id")}
    if set(parts) != {TIP, CENTRE, FAR_END}:
        raise CollisionError(
            f"the trajectory has {len(parts)} spheres; the rod in rod.in consists of three"
        )
    tip, centre = parts[TIP], parts[CENTRE]
    force = tip["fy"] + tip["mass"] * gravitational_acceleration
    loop = pd.DataFrame(
        {
            "time": tip["time"],
            "overlap": tip["radius"] - tip["y"],
            # Set the force to zero if it is only round-off from the subtraction of the weight.
            "force": force.where(force > 1e-9 * force.max(), 0),
            "speed": -tip["vy"],
        }
    )
    collision = measure_loop(loop)
    loaded = np.flatnonzero(loop["force"])
    before = loop.iloc[loaded[0] - 1]
    touch = before["time"] - before["overlap"] / before["speed"]
    history = pd.DataFrame(
        {
            "time": loop["time"] - touch,
            "overlap": loop["overlap"],
            "force": loop["force"],
            "friction_force": tip["fx"],
            "displacement_x": centre["x"] - centre["x"][loaded[0] - 1],
            "displacement_y": centre["y"] - centre["y"][loaded[0] - 1],
            "velocity_x": centre["vx"],
            "velocity_y": centre["vy"],
            "angular_velocity": centre["omegaz"],
            "slip_velocity": tip["vx"] + tip["omegaz"] * tip["radius"],
        }
    ).iloc[loaded[0] - 1 : loaded[-1] + 2]
    return RodOutcome(
        coefficient_of_restitution=collision.coefficient_of_restitution,
        angular_velocity=history["angular_velocity"].iloc[-1],
        force_max=collision.force_max,
        overlap_max=collision.overlap_max,
        overlap_res=collision.overlap_res,
        loading_time=collision.loading_time,
        contact_time=collision.contact_time,
        history=history,
    )
