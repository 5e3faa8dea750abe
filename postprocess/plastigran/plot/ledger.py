# SPDX-License-Identifier: GPL-2.0-or-later
"""Figure of the energy ledger: where the energy of a run is and went, and what is missing."""

from __future__ import annotations

from collections.abc import Sequence

import pandas as pd
from matplotlib.figure import Figure

from plastigran.plot.style import COLOURS, styled, subplots


def ledger_figure(
    series: pd.DataFrame, entries: Sequence[str], came_in: float, limit: float
) -> Figure:
    """Energies stacked over time; below, the drift over the energy that came in.

    Args:
        series: Columns time [s], the entries and drift [J].
        entries: Names of the columns to stack, from below.
        came_in: Energy that came in, which the others are shares of [J].
        limit: What the drift may be at most, as such a share.
    """
    with styled():
        figure, (axes, below) = subplots(
            2, 1, figsize=(6.4, 5.4), sharex=True, height_ratios=(3, 1)
        )
        shown = [entry for entry in reversed(entries) if series[entry].abs().max() > 2e-3 * came_in]
        axes.stackplot(
            series["time"],
            [series[entry].clip(lower=0) / came_in for entry in shown],
            labels=shown,
            colors=[COLOURS[entries.index(entry)] for entry in shown],
            alpha=0.75,
            lw=0,
        )
        axes.set_axisbelow(True)
        axes.set_ylabel(f"energy, of the {came_in:.3g} J that came in, all told")
        handles, labels = axes.get_legend_handles_labels()
        axes.legend(handles[::-1], labels[::-1], loc="upper left")
        below.plot(series["time"], series["drift"] / came_in, color="0.2", lw=1)
        for bound, said in ((-limit, None), (limit, "limit of the check")):
            below.axhline(bound, color="0.4", ls=":", label=said)
        below.legend(loc="upper left", fontsize=8)
        below.ticklabel_format(axis="y", style="sci", scilimits=(0, 0))
        below.set_ylabel("drift")
        below.set_xlabel("time (s)")
    return figure
