# SPDX-License-Identifier: GPL-2.0-or-later
"""Figure of the ball that hits a bed of grains: displacement and velocity versus time."""

from __future__ import annotations

import pandas as pd
from matplotlib.figure import Figure

from plastigran.plot.style import COLOURS, styled, subplots


def impact_figure(series: pd.DataFrame, surface: float) -> Figure:
    """Draw displacement and velocity of the ball versus time.

    Args:
        series: Columns time [s], displacement [m] and velocity [m/s].
        surface: Displacement at which the ball touches the initial surface of the bed [m].
    """
    with styled():
        figure, (left, right) = subplots(1, 2, figsize=(9.2, 3.8))
        time = 1e3 * series["time"]
        left.plot(time, 1e3 * series["displacement"], color=COLOURS[0])
        left.axhline(1e3 * surface, color="0.5", lw=1, label="surface of the bed")
        left.legend()
        left.set(xlabel="time (ms)", ylabel="displacement of the ball (mm)")
        right.plot(time, series["velocity"], color=COLOURS[0])
        right.set(xlabel="time (ms)", ylabel="velocity of the ball (m/s)")
    return figure
