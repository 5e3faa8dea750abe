# SPDX-License-Identifier: GPL-2.0-or-later
"""Figure of a chute flow: grains, velocity profile, power of the weight, and dissipated power."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from plastigran.bulk.checks import dissipated
from plastigran.physics.bagnold import Profile
from plastigran.plot.grains import draw_grains, mean_power
from plastigran.plot.style import COLOURS, styled, subplots

#: Time over which powers are averaged [s].
WINDOW = 0.12


def chute_figure(
    series: pd.DataFrame, grains: pd.DataFrame, profile: Profile, settling: float
) -> Figure:
    """Draw the grains of the last frame, the mean speed versus height, and the powers versus time.

    Args:
        series: Columns time [s], weight_power [W], plastic, friction and viscous [J].
        grains: Grains of several frames, with the columns step, x, y, z, radius [m], vx, vy, vz
            [m/s].
        profile: Mean velocity profile of these frames.
        settling: Time at which the measurement of profile and powers starts [s].
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
    base = (grains[["vx", "vy", "vz"]] == 0).all(axis="columns")
    draw_grains(axes, grains[base])
    discs = draw_grains(axes, grains[~base], "vx")
    x, z, radius = grains["x"], grains["z"], grains["radius"]
    axes.set_xlim(x.min() - 0.005, x.max() + 0.005)
    axes.set_ylim((z - radius).min(), (z + radius).max())
    figure.colorbar(discs, ax=axes, label="speed (m/s)", shrink=0.8)


def _draw_profile(axes, profile) -> None:
    table, style = profile.table, {"color": COLOURS[0]}
    axes.plot(table["speed"], table["height"] * 1e3, "o", mfc="white", ms=5, **style)
    height = np.linspace(0, profile.depth, 100)
    speed = profile.slip + profile.rate * (profile.depth**1.5 - (profile.depth - height) ** 1.5)
    axes.plot(speed, height * 1e3, lw=1.3, label="Bagnold", **style)
    axes.set(xlim=(0, None), xlabel="mean speed (m/s)", ylabel="height above the base (mm)")
    axes.legend(loc="upper left")


def _draw_powers(axes, series, settling) -> None:
    time, weight = series["time"], series["weight_power"]
    total = mean_power(dissipated(series), time, WINDOW)
    plastic = mean_power(series["plastic"], time, WINDOW)
    axes.plot(time, weight, color=COLOURS[0], label="weight")
    axes.plot(total.index, total, color=COLOURS[1], lw=1, label="dissipated in the flow")
    axes.plot(plastic.index, plastic, ":", color=COLOURS[1], lw=1, label="dissipated by yielding")
    axes.axvline(settling, color="0.4", ls=":")
    axes.set(ylim=(0, 1.2 * weight.max()), ylabel="power (W)", xlabel="time (s)")
    axes.legend(loc="center right")
