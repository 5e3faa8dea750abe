# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures of uniaxial tests: stress in the mold and on the free sample, and flow functions."""

from __future__ import annotations

import pandas as pd
from matplotlib.figure import Figure

from plastigran.bulk.decks.uniaxial_test.measurement import Stage, Strength
from plastigran.plot.style import COLOURS, styled, subplots


def uniaxial_figure(runs: dict[str, tuple[pd.DataFrame, Strength]]) -> Figure:
    """Draw the stress of the platen in the mold and on the free sample.

    Args:
        runs: For each label, a table with the columns stage, strain [-], stress [Pa] and porosity
            [-], and the strength of the sample.
    """
    with styled():
        figure, (mold, free) = subplots(1, 2, figsize=(9.2, 3.8))
        for colour, (label, (table, strength)) in zip(COLOURS, runs.items(), strict=False):
            line = {"color": colour, "lw": 1.4}
            confined = table[(table["stage"] <= Stage.UNLOADING) & (table["stress"] > 0)]
            mold.plot(confined["porosity"], confined["stress"] / 1e3, **line, label=label)
            tested = table[(table["stage"] == Stage.COMPRESSION) & (table["strain"] >= 0)]
            free.plot(tested["strain"], tested["stress"] / 1e3, **line)
            peak = strength.failure_strain, strength.unconfined / 1e3
            label = f"{strength.ratio:.2f} times the consolidation stress"
            free.plot(*peak, "o", color=colour, mfc="white", label=label)
        mold.invert_xaxis()
        mold.set(xlabel="porosity in the mold", ylabel="stress of the platen (kPa)")
        mold.set_ylim(bottom=0)
        mold.legend(loc="upper left")
        free.set(xlabel="strain of the free sample", ylabel="stress of the platen (kPa)")
        free.set_ylim(bottom=0)
        free.legend(title="unconfined yield strength")
    return figure


def flow_function_figure(table: pd.DataFrame) -> Figure:
    """Draw flow functions, and the trend of the strength with surface energy.

    Args:
        table: One row per test: surface_energy [J/m^2], consolidation and unconfined [Pa].
    """
    with styled():
        figure, (flow, trend) = subplots(1, 2, figsize=(9.2, 3.8))
        for colour, (energy, tests) in zip(COLOURS, table.groupby("surface_energy"), strict=False):
            stress = tests.sort_values("consolidation") / 1e3
            label = f"{energy:g} J/m²"
            flow.plot(
                stress["consolidation"], stress["unconfined"], "o-", color=colour, label=label
            )
        largest = table["consolidation"].max() / 1e3
        flow.set(xlabel="consolidation stress (kPa)", ylabel="unconfined yield strength (kPa)")
        flow.set(xlim=(0, 1.05 * largest), ylim=(0, None))
        top = flow.get_ylim()[1]
        for ratio in (1, 2, 4, 10):  # limits between Jenike's classes of flowability
            end = min(largest, ratio * top)
            flow.plot([0, end], [0, end / ratio], ":", color="0.6", lw=1)
            flow.annotate(f"1/{ratio}" if ratio > 1 else "1", (end, end / ratio), color="0.4")
        flow.legend(title="surface energy")
        for colour, (nominal, tests) in zip(
            COLOURS, table.groupby("consolidation_stress"), strict=False
        ):
            tests = tests.sort_values("surface_energy")
            ratio = tests["unconfined"] / tests["consolidation"]
            trend.plot(
                tests["surface_energy"], ratio, "o-", color=colour, label=f"{nominal / 1e3:g} kPa"
            )
        trend.set(xlabel="surface energy (J/m²)", ylabel="strength / consolidation stress")
        trend.set(xlim=(0, None), ylim=(0, None))
        trend.legend(title="consolidation stress")
    return figure
