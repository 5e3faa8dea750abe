# SPDX-License-Identifier: GPL-2.0-or-later
"""Figure of the grains in two zones of the drum."""

from __future__ import annotations

import pandas as pd
from matplotlib.figure import Figure

from plastigran.plot.style import COLOURS, styled, subplots


def zones_figure(series: pd.DataFrame) -> Figure:
    """Draw the numbers of small and large grains in both zones versus time.

    Args:
        series: Columns time [s], small_1, small_2, large_1 and large_2.
    """
    with styled():
        figure, axes = subplots(1, 2, figsize=(9.2, 3.8))
        for axis, size in zip(axes, ("small", "large"), strict=True):
            for zone, colour in (1, COLOURS[0]), (2, COLOURS[1]):
                count = series[f"{size}_{zone}"]
                axis.plot(series["time"], count, color=colour, label=f"zone {zone}")
            axis.set(xlabel="time (s)", ylabel=f"{size} grains in the zone")
            axis.legend()
    return figure
