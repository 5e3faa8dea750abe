# SPDX-License-Identifier: GPL-2.0-or-later
"""Charts of a bulk run: its energy balance, and the columns of its log."""

from __future__ import annotations

import pandas as pd

from plastigran.bulk.checks import (
    ADHESION,
    ENERGIES,
    LEDGER,
    LEDGER_CHECKS,
    energy_input,
    energy_terms,
    last_simulation,
)
from plastigran.bulk.ledger_chart import energy_text, ledger_panels
from plastigran.plot.chart import Curve, Panel
from plastigran.plot.quantities import PREDICTED, scale
from plastigran.report.page.charts import Chart

#: Largest number of rows of a log that a chart shows.
ROWS = 400


def ledger_chart(series: pd.DataFrame, checks: pd.DataFrame) -> Chart | None:
    """Return the chart of the energy balance, or None if the log has no energy terms."""
    series = last_simulation(series)
    terms = energy_terms(series)
    if not {*ENERGIES, "drift", "time"} <= set(series) or not energy_input(series) > 0:
        return None
    total = energy_input(series)
    limits = checks.loc[checks["name"] == LEDGER_CHECKS[0], "limit"]
    limit = float(limits.iloc[0]) if len(limits) else LEDGER
    adhesion = (
        " With adhesion, the surface energy of contacts is negative, and contacts that form or "
        "break lose energy."
        if terms != ENERGIES and series[ADHESION].any(axis=None)
        else ""
    )
    return Chart(
        name="ledger",
        views={"": ledger_panels(_thin(series), total, limit)},
        description="shares of the energy input versus time, stacked, and the balance error",
        caption=f"Shares of the energy input, {energy_text(total)}: kinetic energy, energy stored "
        "in contacts, and energy dissipated by yielding, friction and viscosity. The lower panel "
        f"shows the balance error. Dotted lines are its limit, {100 * limit:.2g} %.{adhesion}",
        height=460,
        by_time=True,
    )


def series_chart(series: pd.DataFrame) -> Chart | None:
    """Return a chart of the columns of the log versus time, with theory where it is available."""
    if "time" not in series or len(series) < 2:
        return None
    series = _thin(series)
    views = {}
    for column in series:
        values = pd.to_numeric(series[column], errors="coerce")
        if column in ("step", "time", "run", "simulation") or column.endswith(PREDICTED):
            continue
        if values.nunique() < 2:
            continue
        panel = _series_panel(series.assign(**{column: values}), column)
        # Make titles unique, because two columns of a user's log may have the same title.
        title = panel.y.title.capitalize()
        views[f"{title} ({column})" if title in views else title] = [panel]
    if not views:
        return None
    return Chart(
        name="series",
        views=views,
        description="one column of the log versus time",
        caption="A column of the log that the deck wrote. Dashed lines are theory.",
        menu="Column of the log",
        height=360,
        by_time=True,
    )


def _series_panel(series: pd.DataFrame, column: str) -> Panel:
    time = series["time"].to_numpy()
    curves = [Curve(x=time, y=series[column].to_numpy(), name="LIGGGHTS", colour=0)]
    if (predicted := f"{column}{PREDICTED}") in series:
        curves.append(Curve(x=time, y=series[predicted].to_numpy(), name="theory", dash=1))
    return Panel(x=scale("time", time), y=scale(column, series[column]), curves=curves)


def _thin(series: pd.DataFrame) -> pd.DataFrame:
    """Return at most `ROWS` evenly spaced rows of a time series, including its last row."""
    stride = max(1, -(-len(series) // ROWS))
    return series.iloc[(len(series) - 1) % stride :: stride]
