# SPDX-License-Identifier: GPL-2.0-or-later
"""What figures of flowing grains share: the grains themselves, and powers from works."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection


def draw_grains(axes: Axes, grains: pd.DataFrame, colours: str | None = None) -> EllipseCollection:
    """Grains to scale as seen along y, the near ones over the far ones.

    Args:
        axes: Gets equal scales and no frame.
        grains: Columns x, y, z, radius [m], and that of the colours.
        colours: Column whose values they show; grey without one.

    Returns:
        The discs, for a colour bar.
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
    """Mean power over a window that moves along [W].

    Args:
        work: So far [J], (n,).
        time: Evenly spaced [s], (n,).
        window: To average over, in whole rows, a quarter of them at most [s].

    Returns:
        One row a window, (m,), m < n, indexed by the time of its middle [s].
    """
    rows = max(1, min(round(window / (time.iloc[1] - time.iloc[0])), len(time) // 4))
    work, time = work.to_numpy(), time.to_numpy()
    power = (work[rows:] - work[:-rows]) / (time[rows:] - time[:-rows])
    return pd.Series(power, index=(time[rows:] + time[:-rows]) / 2)
