# SPDX-License-Identifier: GPL-2.0-or-later
"""Figure of the discharge of a silo."""

from __future__ import annotations

import pandas as pd
from matplotlib.figure import Figure

from plastigran.plot.style import COLOURS, styled, subplots


def silo_figure(series: pd.DataFrame, rate: float | None, settling: float) -> Figure:
    """Draw the number of grains in the silo versus time, with the discharge rate as a line.

    Args:
        series: Columns time [s] and held, the number of grains in the silo.
        rate: Discharge rate [grains/s], or None if the rate was not measured.
        settling: Time at which the measurement of the rate starts [s].
    """
    with styled():
        figure, axes = subplots(figsize=(5.4, 3.8))
        axes.plot(series["time"], series["held"], color=COLOURS[0])
        if rate is not None:
            first = series[series["time"] >= settling].iloc[0]
            line = first["held"] - rate * (series["time"] - first["time"])
            shown = (series["time"] >= settling) & (line >= 0)
            label = f"{rate:.3g} grains/s"
            axes.plot(series["time"][shown], line[shown], "--", color=COLOURS[1], label=label)
            axes.legend()
        axes.set(xlabel="time (s)", ylabel="grains above the orifice")
    return figure
