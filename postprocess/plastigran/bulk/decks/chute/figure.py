# SPDX-License-Identifier: GPL-2.0-or-later
"""Figure of a chute flow: grains, profile, and power of weight and dissipation."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from plastigran.bulk.checks import dissipated
from plastigran.physics.bagnold import Profile
from plastigran.plot.grains import draw_grains, mean_power
from plastigran.plot.style import COLOURS, styled, subplots

#: Averaging time of powers [s].
WINDOW = 0.12


def chute_figure(
    series: pd.DataFrame, grains: pd.DataFrame, profile: Profile, settling: float
) -> Figure:
    """Draw the last grains colored by speed, mean speed over height, and powers over time.

    Args:
        series: Columns time [s], weight_power [W], plastic, friction and viscous [J].
        grains: Frames: columns step, x, y, z, radius [m], vx, vy, vz [m/s].
        profile: Profile of the frames.
        settling: Time before profile and powers are measured [s].
    """
    with styled():
        figure, (bed, speeds, powers) = subplots(
            1, 3, figsize=(10.5, 3.8), width_ratios=(0.6, 0.9, 1.2)
        )
        _draw_grains(figure, bed, grains[grains["step"] == grains["step"].max()])
        _draw_profile(speeds, profile)
        _draw_powers(powers, series, settling)
    return figure


def _draw_grains(figure, axes, grains) -> None:
    held = (grains[["vx", "vy", "vz"]] == 0).all(axis="columns")
    draw_grains(axes, grains[held])
    discs = draw_grains(axes, grains[~held], "vx")
    axes.set_xlim(grains["x"].min() - 0.005, grains["x"].max() + 0.005)
    axes.set_ylim((grains["z"] - grains["radius"]).min(), (grains["z"] + grains["radius"]).max())
    figure.colorbar(discs, ax=axes, label="speed (m/s)", shrink=0.8)


def _draw_profile(axes, profile) -> None:
    table = profile.table
    axes.plot(table["speed"], table["height"] * 1e3, "o", color=COLOURS[0], mfc="white", ms=5)
    height = np.linspace(0, profile.depth, 100)
    lack = profile.depth**1.5 - (profile.depth - height) ** 1.5
    axes.plot(
        profile.slip + profile.rate * lack, height * 1e3, color=COLOURS[0], lw=1.3, label="Bagnold"
    )
    axes.set_xlim(0, None)
    axes.set_xlabel("mean speed (m/s)")
    axes.set_ylabel("height above the base (mm)")
    axes.legend(loc="upper left")


def _draw_powers(axes, series, settling) -> None:
    taken = mean_power(dissipated(series), series["time"], WINDOW)
    yielding = mean_power(series["plastic"], series["time"], WINDOW)
    axes.plot(series["time"], series["weight_power"], color=COLOURS[0], label="weight")
    axes.plot(taken.index, taken, color=COLOURS[1], lw=1, label="dissipated in the flow")
    axes.plot(yielding.index, yielding, ":", color=COLOURS[1], lw=1, label="by yielding")
    axes.axvline(settling, color="0.4", ls=":")
    axes.set_ylim(0, 1.2 * series["weight_power"].max())
    axes.set_ylabel("power (W)")
    axes.set_xlabel("time (s)")
    axes.legend(loc="center right")
