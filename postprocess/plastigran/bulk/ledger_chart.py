# SPDX-License-Identifier: GPL-2.0-or-later
"""Chart of the energy balance of a run: stacked energies versus time, and the balance error."""

from __future__ import annotations

import pandas as pd
from matplotlib.figure import Figure

from plastigran.bulk.checks import energy_input, energy_terms
from plastigran.plot.chart import Curve, Panel
from plastigran.plot.quantities import Scale, scale, words
from plastigran.plot.static import draw
from plastigran.plot.style import styled, subplots

#: Energy terms below this fraction of the energy input are not drawn.
SMALL = 2e-3


def ledger_panels(series: pd.DataFrame, total: float, limit: float) -> tuple[Panel, Panel]:
    """Return two panels versus time: stacked energy terms, and balance error.

    Both panels are in per cent of the energy input. The surface energy of contacts with adhesion is
    negative and is drawn below zero.

    Args:
        series: Columns time [s], the terms of the energy balance, and the balance error `drift`
            [J].
        total: Energy input [J], positive.
        limit: Largest allowed balance error as a fraction of the energy input.
    """
    time, terms = scale("time", series["time"]), energy_terms(series)
    areas = [
        Curve(
            x=series["time"].to_numpy(),
            y=(
                series[term].clip(**({"upper": 0} if term == "surfaces" else {"lower": 0})) / total
            ).to_numpy(),
            name=words(term),
            colour=terms.index(term),
            look="area",
        )
        for term in reversed(terms)
        if series[term].abs().max() > SMALL * total
    ]
    drift = Curve(x=series["time"].to_numpy(), y=(series["drift"] / total).to_numpy(), name="error")
    return (
        Panel(x=time, y=Scale("fraction of energy input", "%", 100), curves=areas),
        Panel(x=time, y=Scale("error", "%", 100), curves=[drift], limits=(-limit, limit)),
    )


def energy_text(energy: float) -> str:
    """Return an energy [J] as text with three digits and a unit."""
    size = scale("kinetic_energy", [energy])
    return f"{energy * size.factor:.3g} {size.unit}"


def ledger_figure(series: pd.DataFrame, limit: float) -> Figure:
    """Draw the energy balance; arguments as for `ledger_panels`."""
    total = energy_input(series)
    energies, error = ledger_panels(series, total, limit)
    with styled():
        figure, (above, below) = subplots(
            2, 1, figsize=(6.4, 5.4), sharex=True, height_ratios=(3, 1)
        )
        draw(above, energies)
        above.set_xlabel("")
        handles, labels = above.get_legend_handles_labels()
        above.legend(handles[::-1], labels[::-1], loc="upper left")
        figure.suptitle(f"energy input {energy_text(total)}", fontsize=10)
        draw(below, error)
        below.plot([], [], color="0.4", ls=":", label="limit of the check")
        handles, labels = below.get_legend_handles_labels()
        below.legend(handles[-1:], labels[-1:], loc="upper left", fontsize=8)
    return figure
