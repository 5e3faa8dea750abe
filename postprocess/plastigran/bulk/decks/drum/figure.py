# SPDX-License-Identifier: GPL-2.0-or-later
"""Figure of a rotating drum: the bed, its angle versus time, and the power of the wall."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.figure import Figure
from matplotlib.patches import Circle

from plastigran.bulk.checks import dissipated
from plastigran.plot.grains import draw_grains, mean_power
from plastigran.plot.style import COLOURS, styled, subplot_mosaic

#: Time over which powers are averaged [revolutions]. Avalanches are shorter.
WINDOW = 0.05


def drum_figure(
    series: pd.DataFrame, grains: pd.DataFrame, drum_radius: float, settling: float
) -> Figure:
    """Draw the bed as seen along the axis, the angle of the bed, and the powers versus time.

    The figure shows the power of the wall, of the torque of gravity, and of dissipation in the bed.

    Args:
        series: Columns time [s], revolutions, angle [degrees], and works [J]: wallwork,
            wallwork_predicted, plastic, friction, viscous.
        grains: Columns x, y, z, radius [m], vx, vz [m/s] at one time.
        drum_radius: Radius of the drum [m].
        settling: Time at which the measurement of the angle starts [s].
    """
    steady = series[series["time"] >= settling]
    angle = steady["angle"].mean()
    with styled():
        figure, panels = subplot_mosaic([["bed", "angle"], ["bed", "power"]], figsize=(9.6, 4.2))
        _draw_bed(panels["bed"], grains, drum_radius, angle)
        axes = panels["angle"]
        axes.plot(series["revolutions"], series["angle"], color=COLOURS[0], lw=1)
        ends = steady["revolutions"].iloc[[0, -1]]
        axes.plot(ends, [angle, angle], "--", color="0.2", label=f"mean {angle:.1f}°")
        axes.set(ylim=(0, None), ylabel="angle of the bed (°)")
        axes.legend(loc="lower right")
        axes.tick_params(labelbottom=False)
        _draw_powers(panels["power"], series)
        panels["power"].sharex(axes)
    return figure


def _draw_bed(axes, grains, drum_radius, angle) -> None:
    speed = np.hypot(grains["vx"], grains["vz"])
    discs = draw_grains(axes, grains.assign(speed=speed), "speed")
    axes.add_patch(Circle((0, 0), drum_radius, fill=False, color="0.3", lw=1.5))
    lean = np.radians(angle)
    half_chord = drum_radius * np.array([-1, 1])
    axes.plot(half_chord * np.cos(lean), half_chord * np.sin(lean), "--", color="0.2", lw=1)
    limits = -1.05 * drum_radius, 1.05 * drum_radius
    axes.set(xlim=limits, ylim=limits)
    scale = axes.inset_axes((0.3, 0.82, 0.4, 0.03))  # a position in the empty part of the drum
    axes.figure.colorbar(discs, cax=scale, label="speed (m/s)", orientation="horizontal")


def _draw_powers(axes, series) -> None:
    period = series["time"].iloc[-1] / series["revolutions"].iloc[-1]

    def power(work: pd.Series) -> pd.Series:
        return mean_power(work, series["time"], WINDOW * period) * 1e3

    wall, lever = power(series["wallwork"]), power(series["wallwork_predicted"])
    total, plastic = power(dissipated(series)), power(series["plastic"])
    turns = wall.index / period
    every = max(1, round(WINDOW / 2 / series["revolutions"].iloc[1]))
    points = {"color": COLOURS[0], "mfc": "white", "ms": 4}
    axes.plot(turns, wall, color=COLOURS[0], label="wall")
    axes.plot(turns[::every], lever[::every], "o", label="torque of the weight", **points)
    axes.plot(turns, total, color=COLOURS[1], lw=1, label="dissipated in the bed")
    axes.plot(turns, plastic, color=COLOURS[1], lw=1, ls=":", label="dissipated by yielding")
    # Without energy balance, the work of the wall is unknown. Then matplotlib chooses the limit.
    top = 2.2 * wall.max() or None
    axes.set(ylim=(0, top), ylabel="power (mW)", xlabel="revolutions")
    axes.legend(loc="upper right", ncols=2, fontsize="small")
