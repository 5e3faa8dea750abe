# SPDX-License-Identifier: GPL-2.0-or-later
"""Figure of collision spectra: number of impacts versus speed, energy and force."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from plastigran.plot.style import COLOURS, styled, subplots


def spectra_figure(spectra: Mapping[str, Mapping[str, pd.DataFrame]]) -> Figure:
    """Draw the number of impacts per class, with a panel per quantity and a curve per partner.

    The classes are intervals of the quantity. Classes that are not positive are omitted, because
    the axes are logarithmic. Classes below the round-off of the largest value are omitted, because
    they contain impacts without energy loss.

    Args:
        spectra: Tables by axis title, and then by partner (particles or a wall). Each table is
            sorted and has the columns lower and upper, the edges of the class, and count.
    """
    with styled():
        figure, panels = subplots(1, len(spectra), figsize=(10.5, 3.4), sharey=True)
        for axes, (title, partners) in zip(panels, spectra.items(), strict=True):
            largest = np.nanmax([0.0, *(classes["upper"].max() for classes in partners.values())])
            least = np.finfo(float).eps * largest
            for k, (partner, classes) in enumerate(partners.items()):
                _draw(axes, classes[classes["lower"] > least], partner, COLOURS[k % len(COLOURS)])
            axes.set_xscale("log")
            axes.set_yscale("log")
            axes.set_xlabel(title)
        panels[0].set_ylabel("impacts per class")
        panels[0].legend(loc="upper left", fontsize="small")
    return figure


def _draw(axes: Axes, classes: pd.DataFrame, label: str, colour: str) -> None:
    """Draw a horizontal step for each class, and a gap where the table lacks a class."""
    edges, counts = [], []
    for lower, upper, count in zip(*(classes[n] for n in ("lower", "upper", "count")), strict=True):
        if not edges:
            edges.append(lower)
        elif not np.isclose(lower, edges[-1], rtol=1e-6, atol=0):
            edges.append(lower)
            counts.append(np.nan)
        edges.append(upper)
        counts.append(count)
    if counts:
        axes.stairs(counts, edges, baseline=None, color=colour, lw=1.5, zorder=2)
    axes.plot([], [], color=colour, label=label)
