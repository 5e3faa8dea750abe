# SPDX-License-Identifier: GPL-2.0-or-later
"""Figure of oblique impacts versus the normalized impact angle of Maw, Barber & Fawcett (1976)."""

from __future__ import annotations

import pandas as pd
from matplotlib.figure import Figure

from plastigran.plot.style import COLOURS, styled, subplots

PANELS = {
    "tangential_restitution": "tangential restitution",
    "spin": "spin (rad/s)",
    "rebound_angle": "rebound angle (°)",
}


@styled()
def oblique_figure(table: pd.DataFrame) -> Figure:
    """Draw tangential restitution, spin and rebound angle, with a curve for each tangential law.

    Args:
        table: Columns tangential (name of the law), normalized_angle, and the keys of `PANELS`.
    """
    figure, row = subplots(1, 3, figsize=(10.4, 3.4))
    for axes, (quantity, label) in zip(row, PANELS.items(), strict=True):
        for colour, (name, part) in zip(COLOURS, table.groupby("tangential"), strict=False):
            axes.plot(part["normalized_angle"], part[quantity], color=colour, label=name)
        axes.set(xlabel=r"normalized angle $\psi$", ylabel=label)
    row[0].legend()
    return figure
