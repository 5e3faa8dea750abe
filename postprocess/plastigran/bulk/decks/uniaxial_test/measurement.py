# SPDX-License-Identifier: GPL-2.0-or-later
"""Measurements of a uniaxial test: porosity, free height and unconfined strength of the sample."""

from __future__ import annotations

from enum import IntEnum

import attrs
import numpy as np
import pandas as pd

#: Stress / consolidation stress below which the platen has left the sample.
TOUCH = 0.01


class Stage(IntEnum):
    """Stage of a uniaxial test, in order of time.

    The platen consolidates the sample in the mold and moves up. Then the mold opens, and the platen
    compresses the free sample.
    """

    CONSOLIDATION = 0
    UNLOADING = 1
    OPENING = 2
    COMPRESSION = 3


@attrs.frozen
class Strength:
    """Results of a uniaxial test.

    Attributes:
        consolidation: Stress at the end of consolidation [Pa].
        porosity: Porosity at the end of consolidation [-].
        unconfined: Unconfined yield strength, the peak stress of the free sample [Pa]; NaN if the
            sample was not compressed.
        failure_strain: Strain at the peak stress [-].
    """

    consolidation: float
    porosity: float
    unconfined: float
    failure_strain: float

    @property
    def ratio(self) -> float:
        """Unconfined yield strength divided by consolidation stress [-]."""
        return self.unconfined / self.consolidation


def stage_of(step: pd.Series, ends: list[float]) -> pd.Series:
    """Return the `Stage` of each row of the log.

    Args:
        step: Steps of the rows.
        ends: Last step of each stage, except the last stage.
    """
    return pd.Series(np.searchsorted(ends, step), index=step.index)


def platen_height(table: pd.DataFrame, start: float) -> np.ndarray:
    """Return the height of the platen (n,) [m], integrated from its velocity.

    Args:
        table: Columns time [s], velocity of the platen [m/s] and stage.
        start: Height of the platen in the first row [m].
    """
    time, velocity = table["time"].to_numpy(), table["velocity"].to_numpy()
    before = velocity[:-1].copy()
    begins = np.diff(table["stage"]) != 0  # the velocity jumps between stages
    begins[0] = True  # the platen is at rest in the first row
    before[begins] = velocity[1:][begins]
    travel = (before + velocity[1:]) / 2 * np.diff(time)
    return start + np.append(0, np.cumsum(travel))


def platen_work(table: pd.DataFrame) -> pd.Series:
    """Return the work (n,) [J] of the platen between each log line and the previous one.

    Args:
        table: Columns height of the platen [m], and mean upward force on the platen since the
            previous log line [N].
    """
    return -table["force"] * table["height"].diff()


def free_height(table: pd.DataFrame) -> float:
    """Return the height of the unloaded sample [m]; NaN if the platen does not leave the sample.

    Args:
        table: Columns stage, height of the platen [m] and stress [Pa].

    Raises:
        ValueError: The platen did not load the grains.
    """
    consolidation = table["stress"][table["stage"] == Stage.CONSOLIDATION].iloc[-1]
    if not consolidation > 0:
        raise ValueError(
            f"the stress at the end of consolidation is {consolidation:g} Pa, so the platen does "
            "not touch the grains. Raise consolidation"
        )
    unloading = table[table["stage"] == Stage.UNLOADING]
    left = unloading["height"][unloading["stress"] <= TOUCH * consolidation]
    return float(left.iloc[0]) if len(left) else np.nan


def measure_strength(table: pd.DataFrame, strain: float) -> Strength:
    """Measure the strength of a sample.

    Args:
        table: Columns stage, stress [Pa], porosity and strain of the free sample [-].
        strain: Largest strain at which the peak stress may occur [-].
    """
    consolidated = table[table["stage"] == Stage.CONSOLIDATION].iloc[-1]
    tested = table[(table["stage"] == Stage.COMPRESSION) & table["strain"].between(0, strain)]
    peak = np.nan, np.nan
    if len(tested):
        peak = tuple(tested.loc[tested["stress"].idxmax(), ["stress", "strain"]])
    return Strength(consolidated["stress"], consolidated["porosity"], *peak)
