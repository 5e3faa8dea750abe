# SPDX-License-Identifier: GPL-2.0-or-later
"""Figure of collision spectra: how many impacts there are, by speed, energy and force."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from plastigran.plot.style import COLOURS, styled, subplots

LABELS = {
    "normal_speed": "normal speed of approach (m/s)",
    "dissipated_energy": "energy dissipated (J)",
    "largest_force": "largest force (N)",
}


def spectra_figure(table: pd.DataFrame) -> Figure:
    """Impacts by class, a curve for particles and for each wall, a panel for each quantity.

    Impacts whose value is not positive have no place on the logarithmic axes.

    Args:
        table: Columns quantity, with, lower, upper and count, several rows of a class together;
            in SI units.
    """
    positive = table[table["lower"] > 0]
    partners = sorted(table["with"].unique(), key=lambda name: (name != "particle", name))
    with styled():
        figure, panels = subplots(1, len(LABELS), figsize=(10.5, 3.4), sharey=True)
        for axes, (quantity, label) in zip(panels, LABELS.items(), strict=True):
            chosen = positive[positive["quantity"] == quantity]
            for k, partner in enumerate(partners):
                _draw(axes, chosen[chosen["with"] == partner], partner, COLOURS[k % len(COLOURS)])
            axes.set_xscale("log")
            axes.set_yscale("log")
            axes.set_xlabel(label)
        panels[0].set_ylabel("impacts in a class")
        panels[0].legend(loc="upper left", fontsize="small")
    return figure


def _draw(axes: Axes, rows: pd.DataFrame, label: str, colour: str) -> None:
    """A step for each class; classes without impacts are a gap."""
    classes = rows.groupby(["lower", "upper"], as_index=False)["count"].sum()
    if classes.empty:
        axes.plot([], [], color=colour, label=label)
        return
    lower, upper, count = (classes[name].to_numpy() for name in ("lower", "upper", "count"))
    gap = np.full(len(count), np.nan)
    x = np.stack([lower, upper, upper], axis=1).ravel()
    y = np.stack([count, count, gap], axis=1).ravel()
    # No gap between classes that touch.
    keep = np.ones(len(x), dtype=bool)
    keep[2::3][:-1] = ~np.isclose(upper[:-1], lower[1:], rtol=1e-6)
    axes.plot(x[keep], y[keep], color=colour, label=label)
