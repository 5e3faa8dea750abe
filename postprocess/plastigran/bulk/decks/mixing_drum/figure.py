# SPDX-License-Identifier: GPL-2.0-or-later
"""Figure of the numbers of grains in two zones of the mixing drum.

The zones are opposite quadrants of the cross section, seen along the axis of the drum. Zone 1 is
the quadrant x > 0, z > 0; zone 2 is the quadrant x < 0, z < 0. z points upward from the axis.
"""

from __future__ import annotations

import pandas as pd
from matplotlib.figure import Figure

from plastigran.plot.style import COLOURS, styled, subplots


def zones_figure(series: pd.DataFrame) -> Figure:
    """Draw the numbers of small and of large grains in zones 1 and 2 versus time.

    Args:
        series: Columns time [s], and the numbers of grains small_1, small_2, large_1 and large_2,
            where 1 and 2 are the zones.
    """
    with styled():
        figure, axes = subplots(1, 2, figsize=(9.2, 3.8))
        for axis, size in zip(axes, ("small", "large"), strict=True):
            for zone, colour in (1, COLOURS[0]), (2, COLOURS[1]):
                count = series[f"{size}_{zone}"]
                axis.plot(series["time"], count, color=colour, label=f"zone {zone}")
            axis.set(xlabel="time (s)", ylabel=f"number of {size} grains in each zone")
            axis.legend()
    return figure
