# SPDX-License-Identifier: GPL-2.0-or-later
"""The oblique rod of Ghaednia, Cermik & Marghitu (2015): equations of motion for all laws."""

from __future__ import annotations

from collections.abc import Iterable
from statistics import fmean

import pandas as pd

from plastigran import laws
from plastigran.experiments.rod import RodImpact
from plastigran.experiments.rod.paper import (
    PAPER_RESTITUTION,
    PAPER_SPEEDS,
    MeasuredRun,
    paper_rods,
)
from plastigran.validation.laws_on_spheres import yielding_laws
from plastigran.validation.tables import nearest_first

MEASURED = MeasuredRun()
#: Tangential models of the table `tangential_models`.
TANGENTIAL_MODELS = ("no_history", "history", *laws.TANGENTIAL_LAWS)


def impacts(names: Iterable[str] | None = None, tangential: str = "no_history") -> pd.DataFrame:
    """Return the restitution at the tip of the rod that each law predicts.

    Args:
        names: Names of laws; None for all elasto-plastic laws.
        tangential: Tangential model. By default, friction has no spring, as in the paper.

    Returns:
        Table with the columns law, angle [degrees], speed [m/s], restitution, angular_velocity
        [rad/s], and measured: the restitution of the experiments, about the same at all speeds.
    """
    rows = []
    for name in yielding_laws() if names is None else names:
        for rod in paper_rods():
            for speed in PAPER_SPEEDS:
                outcome = RodImpact(name, speed, rod, tangential).predict()
                rows.append(
                    {
                        "law": name,
                        "angle": rod.angle,
                        "speed": speed,
                        "restitution": outcome.coefficient_of_restitution,
                        "angular_velocity": outcome.angular_velocity,
                        "measured": PAPER_RESTITUTION[rod.angle],
                    }
                )
    return pd.DataFrame(rows)


def summary(impacts: pd.DataFrame) -> pd.DataFrame:
    """Return the errors of each law for the oblique rod [%].

    The four errors are: restitution at each of the two angles, and restitution and angular velocity
    of the one impact whose velocities the paper prints. The law with the smallest sum of absolute
    errors comes first.

    Args:
        impacts: Table of `impacts`.
    """
    rod = next(rod for rod in paper_rods() if rod.angle == MEASURED.angle)
    rebound = MEASURED.coefficient_of_restitution(rod)
    speed = -MEASURED.velocity_before
    rows = []
    for law, part in impacts.groupby("law"):
        row: dict[str, object] = {"law": law}
        error = 100 * (part["restitution"] / part["measured"] - 1)
        for angle in sorted(PAPER_RESTITUTION, reverse=True):
            row[f"restitution at {angle:g}° (%)"] = fmean(error[part["angle"] == angle])
        run = part[(part["angle"] == MEASURED.angle) & (part["speed"] == speed)].iloc[0]
        row["velocities printed in the paper, restitution (%)"] = 100 * (
            run["restitution"] / rebound - 1
        )
        spin = run["angular_velocity"] / MEASURED.angular_velocity
        row["velocities printed in the paper, angular velocity (%)"] = 100 * (spin - 1)
        rows.append(row)
    return nearest_first(rows)


def tangential_models(law: str = "universal") -> pd.DataFrame:
    """Return the errors of one law with each of `TANGENTIAL_MODELS`, as in `summary`."""
    rows = [
        summary(impacts([law], model)).assign(law=model).rename(columns={"law": "tangential model"})
        for model in TANGENTIAL_MODELS
    ]
    return pd.concat(rows, ignore_index=True)
