# SPDX-License-Identifier: GPL-2.0-or-later
"""Case drum: grains of two sizes mix in a rotating drum."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from plastigran.bulk.outcome import BulkRun
from plastigran.calibration.softening import POWERS
from plastigran.papers.dosta24.beds import energy_table, run_beds, softened_grains
from plastigran.papers.dosta24.published import drum
from plastigran.plot.style import COLOURS, styled, subplots

#: Softening factor of both sizes of grains.
SOFTENING = 1 / 500
GRAINS = softened_grains(SOFTENING) | {
    "large_youngs_modulus": 5e8 * SOFTENING,
    "large_yield_strength": 3.21e6 * SOFTENING ** POWERS["yield_strength"],
}
#: Settings of all runs. The time step is 25 times as long as in the benchmark.
SOFT = GRAINS | {"timestep": 2e-5, "duration": 5.0, "rows": 250, "checkpoints": 25}
#: A small drum for a short time. Its results are not comparable with the benchmark.
COARSE = GRAINS | {"timestep": 2e-5, "duration": 0.2, "rows": 20, "checkpoints": 2}
COARSE |= {"drum_radius": 0.03, "length": 0.014, "grain_count": 250, "large_count": 60}
COARSE |= {"volume_fraction": 0.25}
#: Times of the table of grain numbers [s].
TIMES = (0.2, 0.4, 0.6, 1, 2, 3, 4)
#: Columns of grain numbers, with a description of the counted grains. Zone 1: x > 0, z > 0; zone 2:
#: x < 0, z < 0.
COUNTS = {
    "small_1": "small grains in zone 1",
    "small_2": "small grains in zone 2",
    "large_1": "large grains in zone 1",
    "large_2": "large grains in zone 2",
}


def compute(
    progress: bool,
    coarse: bool,
    folder: Path,
    law: Sequence[str] = ("hertz", "thornton"),
    beds: int = 1,
    ranks: int = 1,
) -> dict[str, list[BulkRun]]:
    """Run the drum with each law, or continue its runs in `folder`.

    Args:
        progress: Whether to show a progress bar.
        coarse: Whether to run a small drum for a short time.
        folder: Folder of the runs.
        law: Labels of `CONTACTS`, or names of laws.
        beds: Number of random beds.
        ranks: Number of MPI ranks.

    Returns:
        Runs of several random beds, by label of `CONTACTS`.
    """
    settings, path = (COARSE, folder / "drum_coarse") if coarse else (SOFT, folder / "drum")
    return {
        label: run_beds("mixing_drum", settings, label, beds, path, ranks, progress)
        for label in law
    }


def zones(data: dict[str, list[BulkRun]]) -> pd.DataFrame:
    """Return the numbers of grains in both zones over time, compared with other codes.

    The last row of each quantity is the root mean square difference from the mean of LIGGGHTS and
    MUSEN, over all times at which both are published.
    """
    series = {label: _mean([run.series for run in runs]) for label, runs in data.items()}
    end = min(table["time"].iloc[-1] for table in series.values())
    published = drum()
    common = _common_times(published, end)
    rows = []
    for column, name in COUNTS.items():
        for time in (time for time in TIMES if time <= common[-1]):
            row = {"number of": name, "time (s)": f"{time:g}"}
            for label, table in (series | published).items():
                row[label] = round(float(_at(table, column, time)))
            rows.append(row)
        reference = np.mean([_at(table, column, common) for table in published.values()], axis=0)
        row = {"number of": name, "time (s)": "rms difference"}
        for label, table in (series | published).items():
            difference = _at(table, column, common) - reference
            row[label] = round(float(np.sqrt(np.mean(difference**2))))
        rows.append(row)
    return pd.DataFrame(rows)


def _mean(tables: list[pd.DataFrame]) -> pd.DataFrame:
    """Return the mean of the series of several beds with equal times."""
    return sum(table[["time", *COUNTS]] for table in tables) / len(tables)


def _common_times(published: dict[str, pd.DataFrame], end: float) -> np.ndarray:
    """Return the times up to `end` at which all published series have a value [s]."""
    first = max(table["time"].iloc[0] for table in published.values())
    table = next(iter(published.values()))
    return table.loc[table["time"].between(first, end), "time"].to_numpy()


def _at(table: pd.DataFrame, column: str, time: float | np.ndarray) -> np.ndarray:
    """Return a grain number at `time`, interpolated linearly."""
    return np.interp(time, table["time"], table[column])


def energies(data: dict[str, list[BulkRun]]) -> pd.DataFrame:
    """Return the energy terms at the end of the runs that have an energy balance."""
    return energy_table(({"law": label}, runs) for label, runs in data.items())


def zones_figure(data: dict[str, list[BulkRun]]) -> Figure:
    """Draw the numbers of small and large grains in both zones versus time, with other codes."""
    with styled():
        figure, axes = subplots(2, 2, figsize=(9.2, 6.4), sharex=True)
        for axis, (column, quantity) in zip(axes.flat, COUNTS.items(), strict=True):
            for (label, runs), colour in zip(data.items(), COLOURS, strict=False):
                for run in runs:
                    name = label if run is runs[0] else None
                    axis.plot(run.series["time"], run.series[column], color=colour, label=name)
            for (code, table), style in zip(drum().items(), ("--", ":"), strict=True):
                axis.plot(table["time"], table[column], style, color="0.4", label=code)
            axis.set(ylabel=quantity)
        for axis in axes[1]:
            axis.set(xlabel="time (s)")
        axes[0, 1].legend()
    return figure


TABLES = {"drum_zones": zones, "drum_energies": energies}
FIGURES = {"drum": zones_figure}
