# SPDX-License-Identifier: GPL-2.0-or-later
"""Case silo: grains flow out of a silo with the large orifice."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pandas as pd
from matplotlib.figure import Figure
from scipy.stats import linregress

from plastigran.bulk.outcome import BulkRun
from plastigran.papers.dosta24.beds import run_beds
from plastigran.papers.dosta24.published import silo
from plastigran.plot.style import COLOURS, styled, subplots

#: Mean discharge rate of the eight codes [grains/s].
RATE = 23200.0
#: Grains five hundred times softer than in the benchmark, at a longer time step. By Beverloo's law,
#: the rate does not depend on stiffness. The run ends when the rate is measured.
SOFT = {"youngs_modulus": 2e6, "timestep": 3e-5, "duration": 0.7, "settling": 0.2}
SOFT |= {"rows": 70, "checkpoints": 7}
#: Settings of a quick look.
COARSE = {"grain_count": 1500, "youngs_modulus": 1e6, "timestep": 4e-5, "duration": 0.25}
COARSE |= {"settling": 0.05, "rows": 50, "checkpoints": 2, "volume_fraction": 0.4}


def compute(
    progress: bool,
    coarse: bool,
    folder: Path,
    law: Sequence[str] = ("hertz",),
    beds: int = 1,
    ranks: int = 1,
) -> dict[str, list[BulkRun]]:
    """Run the silo, or continue its runs in `folder`.

    Args:
        progress: Whether to show a progress bar.
        coarse: Whether to run few grains for a short time.
        folder: Folder of the runs.
        law: Labels of `CONTACTS`, or names of laws.
        beds: Number of random fillings.
        ranks: Number of MPI ranks.

    Returns:
        Runs by label.
    """
    settings, path = (COARSE, folder / "silo_coarse") if coarse else (SOFT, folder / "silo")
    return {label: run_beds("silo", settings, label, beds, path, ranks, progress) for label in law}


def rates(data: dict[str, list[BulkRun]]) -> pd.DataFrame:
    """Return the discharge rates in thousand grains per second.

    The rates of other codes from the published filling are measured in the same time as ours.
    """
    rows = []
    for label, runs in data.items():
        times = runs[0].deck.settling, runs[0].series["time"].iloc[-1]
        ours = np.mean([_rate(run.series, *times) for run in runs])
        row = {"law": label, "our runs": ours, "eight codes": RATE / 1e3}
        rows.append(row | {code: _rate(table, *times) for code, table in silo().items()})
    return pd.DataFrame(rows)


def _rate(series: pd.DataFrame, start: float, end: float) -> float:
    """Return the discharge rate between two times in thousand grains per second."""
    part = series[series["time"].between(start, end)]
    return -linregress(part["time"], part["held"]).slope / 1e3


def silo_figure(data: dict[str, list[BulkRun]]) -> Figure:
    """Draw the number of grains in the silo over time among other codes."""
    with styled():
        figure, axes = subplots(figsize=(5.4, 3.8))
        for (code, table), style in zip(silo().items(), ("--", ":"), strict=True):
            axes.plot(table["time"], table["held"] / 1e3, style, color="0.4", label=code)
        for (label, runs), colour in zip(data.items(), COLOURS, strict=False):
            for run in runs:
                name = label if run is runs[0] else None
                axes.plot(run.series["time"], run.series["held"] / 1e3, color=colour, label=name)
        axes.set(xlabel="time (s)", ylabel="thousand grains in the silo")
        axes.legend()
    return figure


TABLES = {"silo_rates": rates}
FIGURES = {"silo": silo_figure}
