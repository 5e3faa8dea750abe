# SPDX-License-Identifier: GPL-2.0-or-later
"""Parts of figures of flowing grains: picture of the grains, and mean power in a moving window."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection


def draw_grains(axes: Axes, grains: pd.DataFrame, colours: str | None = None) -> EllipseCollection:
    """Draw grains to scale as discs, seen along y. Near grains cover far grains.

    Args:
        axes: Axes to draw in. The function sets equal scales and removes the frame.
        grains: Columns x, y, z, radius [m], and the column `colours`.
        colours: Column whose values color the grains; None for gray grains.

    Returns:
        The discs, from which a color bar can be made.
    """
    shown = grains.sort_values("y", ascending=False)
    size = 2 * shown["radius"]
    colouring = {"array": shown[colours], "cmap": "viridis"} if colours else {"facecolor": "0.6"}
    discs = EllipseCollection(
        size,
        size,
        np.zeros(len(shown)),
        units="xy",
        offsets=shown[["x", "z"]],
        transOffset=axes.transData,
        edgecolor="white",
        lw=0.3,
        **colouring,
    )
    axes.add_collection(discs)
    axes.set_aspect("equal")
    axes.set_axis_off()
    return discs


def mean_power(work: pd.Series, time: pd.Series, window: float) -> pd.Series:
    """Return the mean power in a moving window [W].

    Args:
        work: Accumulated work (n,), J.
        time: Evenly spaced times (n,), s.
        window: Length of the window [s]. The function rounds it to a whole number of time
            intervals, and limits it to a quarter of the series.

    Returns:
        The power of each window (m,), where m < n. The index is the time at the middle of the
        window [s].
    """
    rows = max(1, min(round(window / (time.iloc[1] - time.iloc[0])), len(time) // 4))
    work, time = work.to_numpy(), time.to_numpy()
    power = (work[rows:] - work[:-rows]) / (time[rows:] - time[:-rows])
    return pd.Series(power, index=(time[rows:] + time[:-rows]) / 2)
