# SPDX-License-Identifier: GPL-2.0-or-later
"""Figure of a cooling gas: granular temperature versus time, compared with mean-field theory."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from plastigran.physics.kinetic_theory import haff
from plastigran.plot.style import COLOURS, MARKERS, styled, subplots


def cooling_figure(
    runs: dict[str, pd.DataFrame], stall: float | None, cooling_rate: float | None = None
) -> Figure:
    """Draw temperatures of simulations (points) and mean-field theory (lines), and their ratio.

    Args:
        runs: Tables by label: columns time [s], temperature, temperature_predicted [m^2/s^2] and
            temperature_error [-].
        stall: Square of the yield speed v_Y of two grains [m^2/s^2]; None for a law without yield.
        cooling_rate: Cooling rate -d ln T/dt at the start [1/s], for the curve of a gas with
            constant restitution. None omits this curve.
    """
    with styled():
        figure, (axes, below) = subplots(
            2, 1, figsize=(6.4, 5.8), sharex=True, height_ratios=(3, 1)
        )
        for colour, marker, (label, series) in zip(COLOURS, MARKERS, runs.items(), strict=False):
            shown = series[series["time"] > 0]
            time, error = shown["time"] * 1e3, 2 * shown["temperature_error"]
            points = shown.iloc[np.unique(np.geomspace(1, len(shown), 28).astype(int)) - 1]
            axes.plot(time, shown["temperature_predicted"], color=colour, lw=1.3)
            markers = {"ls": "", "marker": marker, "color": colour, "mfc": "white"}
            axes.plot(points["time"] * 1e3, points["temperature"], label=label, **markers)
            below.fill_between(time, 1 - error, 1 + error, color=colour, alpha=0.15, lw=0)
            ratio = shown["temperature"] / shown["temperature_predicted"]
            below.plot(time, ratio, color=colour, lw=1)
        if cooling_rate:
            first = next(iter(runs.values()))
            time, start = first["time"], first["temperature_predicted"].iloc[0]
            line = {"color": "0.6", "lw": 1, "label": "constant restitution"}
            axes.plot(time * 1e3, haff(start, cooling_rate, time), "--", **line)
        if stall is not None:
            axes.axhline(stall, color="0.4", ls=":")
            place = {"xycoords": ("axes fraction", "data"), "va": "bottom", "ha": "right"}
            axes.annotate("$v_Y^2$, yield speed squared", (0.99, stall), **place)
        axes.plot([], [], color="0.4", lw=1.3, label="mean field")
        axes.set(xscale="log", yscale="log", ylabel="granular temperature (m²/s²)")
        axes.legend(title="points: simulation", loc="lower left")
        below.axhline(1, color="0.4", lw=0.8)
        band = {"color": "0.5", "alpha": 0.3, "lw": 0, "label": "two standard deviations"}
        below.fill_between([], [], [], **band)
        below.legend(loc="lower left", fontsize=8)
        below.set(ylabel="simulation /\nmean field", xlabel="time (ms)")
    return figure
