# SPDX-License-Identifier: GPL-2.0-or-later
"""Figure of a rotating drum: the bed, its angle over time, and where the wall's power goes."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.collections import EllipseCollection
from matplotlib.figure import Figure

from plastigran.figures import COLOURS, STYLE, plt

#: Revolutions over which powers are averaged: avalanches come and go within less.
WINDOW = 0.05


def drum_figure(
    series: pd.DataFrame, grains: pd.DataFrame, drum_radius: float, settling: float
) -> Figure:
    """The bed along its axis, coloured by speed; its angle; powers of wall, weight and bed.

    Args:
        series: Columns time [s], revolutions, angle [degrees], and works [J]: wallwork,
            wallwork_predicted, plastic, friction, viscous.
        grains: Columns x, z, radius [m], vx, vz [m/s] of one moment.
        drum_radius: [m].
        settling: Time before angle and power are taken [s].
    """
    steady = series[series["time"] >= settling]
    angle = steady["angle"].mean()
    with plt.rc_context(STYLE):
        figure, panels = plt.subplot_mosaic(
            [["bed", "angle"], ["bed", "power"]], figsize=(9.6, 4.2), layout="constrained"
        )
        _draw_bed(panels["bed"], grains, drum_radius, angle)
        axes = panels["angle"]
        axes.plot(series["revolutions"], series["angle"], color=COLOURS[0], lw=1)
        axes.plot(
            steady["revolutions"].iloc[[0, -1]],
            [angle, angle],
            "--",
            color="0.2",
            label=f"mean {angle:.1f}°",
        )
        axes.set_ylim(0, None)
        axes.set_ylabel("angle of the bed (°)")
        axes.legend(loc="lower right")
        axes.tick_params(labelbottom=False)
        _draw_powers(panels["power"], series)
        panels["power"].sharex(axes)
    return figure


def _draw_bed(axes, grains, drum_radius, angle) -> None:
    speed = np.hypot(grains["vx"], grains["vz"])
    order = np.argsort(grains["y"].to_numpy())[::-1]  # seen along +y, the near ones last
    shown = grains.iloc[order]
    discs = EllipseCollection(
        2 * shown["radius"],
        2 * shown["radius"],
        np.zeros(len(shown)),
        units="xy",
        offsets=shown[["x", "z"]],
        transOffset=axes.transData,
        array=speed.iloc[order],
        cmap="viridis",
        edgecolor="white",
        lw=0.3,
    )
    axes.add_collection(discs)
    axes.add_patch(plt.Circle((0, 0), drum_radius, fill=False, color="0.3", lw=1.5))
    lean = np.radians(angle)
    half_chord = drum_radius * np.array([-1, 1])
    axes.plot(half_chord * np.cos(lean), half_chord * np.sin(lean), "--", color="0.2", lw=1)
    axes.set_xlim(-1.05 * drum_radius, 1.05 * drum_radius)
    axes.set_ylim(-1.05 * drum_radius, 1.05 * drum_radius)
    axes.set_aspect("equal")
    axes.set_axis_off()
    scale = axes.inset_axes((0.3, 0.82, 0.4, 0.03))  # where the drum is empty
    axes.figure.colorbar(discs, cax=scale, label="speed (m/s)", orientation="horizontal")


def _draw_powers(axes, series) -> None:
    spacing = series["revolutions"].iloc[1] - series["revolutions"].iloc[0]
    lines = max(1, min(round(WINDOW / spacing), len(series) // 4))

    def power(work: pd.Series) -> pd.Series:
        return (work - work.shift(lines)) / (series["time"] - series["time"].shift(lines)) * 1e3

    dissipated = series["plastic"] + series["friction"] + series["viscous"]
    middle = series["revolutions"] - lines * spacing / 2
    axes.plot(middle, power(series["wallwork"]), color=COLOURS[0], label="wall")
    axes.plot(
        middle[:: lines // 2 or 1],
        power(series["wallwork_predicted"])[:: lines // 2 or 1],
        "o",
        color=COLOURS[0],
        mfc="white",
        ms=4,
        label="weight's lever arm",
    )
    axes.plot(middle, power(dissipated), color=COLOURS[1], lw=1, label="taken by the bed")
    axes.plot(middle, power(series["plastic"]), color=COLOURS[1], lw=1, ls=":", label="by yielding")
    axes.set_ylim(0, 2.2 * power(series["wallwork"]).max())
    axes.set_ylabel("power (mW)")
    axes.set_xlabel("revolutions")
    axes.legend(loc="upper right", ncols=2, fontsize="small")
