# SPDX-License-Identifier: GPL-2.0-or-later
"""Charts of a bulk run: where its energy is and went, and what else its log holds."""

from __future__ import annotations

import pandas as pd
from plotly.subplots import make_subplots

from plastigran.bulk.checks import LEDGER, TAKEN, energy_input, last_simulation
from plastigran.report.page.charts import INK, Chart, chart_name, figure, line
from plastigran.report.page.names import PREDICTED, scale, words

#: Rows of a log that a chart shows at most.
ROWS = 400
#: Shares of the energy below which an entry of the ledger is not drawn.
SMALL = 2e-3


def ledger_chart(name: str, series: pd.DataFrame) -> Chart | None:
    """Energies stacked over time, the ledger's drift below; None of a log without a ledger."""
    series = last_simulation(series)
    if not {*TAKEN, "drift", "time"} <= set(series) or not (came_in := energy_input(series)) > 0:
        return None
    series = thinned(series)
    made = make_subplots(
        2, 1, shared_xaxes=True, row_heights=[0.76, 0.24], vertical_spacing=0.07
    ).update_layout(template="none", hovermode="x unified")
    time = scale("time", series["time"])
    for k, entry in enumerate(TAKEN):
        if series[entry].abs().max() <= SMALL * came_in:
            continue
        made.add_trace(
            line(
                series["time"] * time.factor,
                100 * series[entry].clip(lower=0) / came_in,
                words(entry),
                {"colour": k},
                "%{y:.1f} %",
                stackgroup="energy",
                line={"width": 0.5},
            ),
            row=1,
            col=1,
        )
    made.add_trace(
        line(
            series["time"] * time.factor,
            100 * series["drift"] / came_in,
            "drift",
            {"colour": INK},
            "%{y:.3g} %",
            showlegend=False,
        ),
        row=2,
        col=1,
    )
    for bound in (-LEDGER, LEDGER):
        made.add_hline(100 * bound, row=2, col=1, line={"dash": "dot", "width": 1, "color": "gray"})
    made.update_yaxes(title="share of energy (%)", rangemode="tozero", row=1, col=1)
    made.update_yaxes(title="drift (%)", row=2, col=1)
    made.update_xaxes(title=time.axis, row=2, col=1)
    came = scale("kinetic_energy", [came_in])
    return Chart(
        chart_name(name, "ledger"),
        {"": made},
        "shares of the energy that came in, stacked over time, and the drift of their sum",
        f"Of the {came_in * came.factor:.3g} {came.unit} that came in, all told: what moves, what "
        "contacts store, and what yielding, friction and viscosity took. Below, what the sum is "
        f"off by; dotted, the limit of {100 * LEDGER:g} %.",
        height=460,
    )


def series_chart(name: str, series: pd.DataFrame) -> Chart | None:
    """Each column of the log over time, with theory where there is one."""
    if "time" not in series or len(series) < 2:
        return None
    series = thinned(series)
    time = scale("time", series["time"])
    views = {}
    for column in series:
        values = pd.to_numeric(series[column], errors="coerce")
        if column in ("step", "time", "run", "simulation") or column.endswith(PREDICTED):
            continue
        if values.isna().all() or values.nunique() < 2:
            continue
        y = scale(column, values)
        made = figure(time.axis, y.axis, hovermode="x unified")
        said = f"%{{y:.5g}} {y.unit}".strip()
        at = series["time"] * time.factor
        made.add_trace(line(at, values * y.factor, "LIGGGHTS", {"colour": 0}, said))
        if (predicted := f"{column}{PREDICTED}") in series:
            expected = series[predicted] * y.factor
            made.add_trace(
                line(at, expected, "theory", {"colour": INK}, said, line={"dash": "dash"})
            )
        title = y.title.capitalize()  # of a user's columns, two may be read alike
        views[f"{title} ({column})" if title in views else title] = made
    if not views:
        return None
    return Chart(
        chart_name(name, "series"),
        views,
        "one column of the run's log over time",
        "What the deck wrote to its log; dashed where theory has it too.",
        "Column of the log",
        height=360,
    )


def thinned(series: pd.DataFrame) -> pd.DataFrame:
    """At most `ROWS` rows, evenly, the last among them."""
    every = max(1, -(-len(series) // ROWS))
    return series.iloc[(len(series) - 1) % every :: every]
