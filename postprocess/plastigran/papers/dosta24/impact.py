# SPDX-License-Identifier: GPL-2.0-or-later
"""Case impact of the benchmark of Dosta et al. 2024: a steel ball hits a bed of grains."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from plastigran.bulk.outcome import BulkRun
from plastigran.papers.dosta24.beds import CONTACTS, energy_table, run_beds
from plastigran.papers.dosta24.published import eight_codes, reruns
from plastigran.plot.style import COLOURS, styled, subplots

#: Times at which the benchmark compares the displacement of the ball [s].
TIMES = (0.03, 0.05, 0.1)
#: Number of grains in the bed that all eight codes of the benchmark have computed.
EIGHT_CODES_BED = 25000
#: Numbers of grains in the beds whose initial grain positions the benchmark has published.
PUBLISHED_BEDS = (25000, 50000, 100000)
#: Number of random beds, by number of grains and label of `CONTACTS`.
BEDS = {25000: {"hertz": 5, "thornton": 1}, 50000: {"hertz": 1}, 100000: {"hertz": 2}}
#: Settings of all runs. The time step is twice as long as in the paper. In the bed of the eight
#: codes, the ball rebounds and flies freely before the end of the run, so its later motion follows
#: from gravity.
FULL = {"timestep": 1e-6, "duration": 0.05, "rows": 100}
#: Inner sides of the box [m] and initial volume fraction, chosen for the ten beds of the eight
#: codes. The defaults of the deck are chosen for the published beds, which are looser.
EIGHT_CODES_SETTINGS = {"length": 0.098, "width": 0.058, "volume_fraction": 0.585}
#: Number of grains and settings of a short run with a small bed (coarse).
COARSE_GRAINS = 800
COARSE = {"length": 0.02, "width": 0.015, "ball_radius": 0.003, "ball_height": 0.03}
COARSE |= {"volume_fraction": 0.5}
COARSE |= {"timestep": 2e-6, "duration": 0.01, "rows": 50, "checkpoints": 2}


#: Runs with several random beds, by number of grains and label of `CONTACTS`.
Runs = dict[tuple[int, str], list[BulkRun]]


def compute(
    progress: bool,
    coarse: bool,
    folder: Path,
    grains: int | None = None,
    law: Sequence[str] | None = None,
    beds: int | None = None,
    ranks: int = 1,
    host: str | None = None,
) -> Runs:
    """Run the impact of the ball on random beds, or continue the runs in `folder`.

    Args:
        progress: Whether to show a progress bar.
        coarse: Whether to run one small bed for a short time.
        folder: Folder of the runs.
        grains: Number of grains; by default the numbers in `BEDS`.
        law: Labels of `CONTACTS`, or names of laws; by default the labels in `BEDS`.
        beds: Number of beds; by default the numbers in `BEDS`.
        ranks: Number of MPI ranks.
        host: "lammps", or None for LIGGGHTS.
    """
    runs = {}
    for count in [COARSE_GRAINS] if coarse else [grains] if grains else BEDS:
        for label in law or BEDS.get(count, CONTACTS):
            number = 1 if coarse else beds or BEDS.get(count, {}).get(label, 1)
            settings = {"grain_count": count} | (COARSE if coarse else FULL)
            if count == EIGHT_CODES_BED:
                settings |= EIGHT_CODES_SETTINGS
            path = folder / f"impact_{count}"
            if host:
                settings["host"] = host
                path = path.with_name(f"{path.name}_{host}")
            runs[count, label] = run_beds(
                "ball_impact", settings, label, number, path, ranks, progress
            )
    return runs


def displacement_at(time: float, run: BulkRun) -> float:
    """Return the displacement of the ball [m].

    For a time after the end of the run, the displacement is computed from free flight under
    gravity. This requires that the ball flies freely at the end and still moves upward at `time`.
    Otherwise, the displacement is NaN.

    Args:
        time: Time [s].
        run: Run of the deck.
    """
    series, deck = run.series, run.deck
    before, last = series.iloc[-2], series.iloc[-1]
    later = time - last["time"]
    if later <= 1e-12:
        return float(np.interp(time, series["time"], series["displacement"]))
    gravity = deck.gravitational_acceleration
    falling = gravity * (last["time"] - before["time"])
    flies = np.isclose(before["velocity"] - last["velocity"], falling, rtol=1e-3)
    if not flies or last["velocity"] <= gravity * later:
        return np.nan
    return last["displacement"] + last["velocity"] * later - gravity * later**2 / 2


def impact(data: Runs) -> pd.DataFrame:
    """Return the displacement of the ball at `TIMES`, and its largest depth [mm].

    The column of a law is the mean over our random beds; its "deviation" is the standard deviation
    of this mean. "codes, lowest" and "codes, highest" are the extremes of the mean values of the
    eight codes. The last columns are runs of other codes that start from the published grain
    positions.
    """
    rows = []
    for count in dict.fromkeys(count for count, _ in data):
        for time in (*TIMES, None):
            quantity = f"displacement at {1e3 * time:g} ms" if time else "largest depth"
            row = {"grains": count, "quantity": quantity}
            for (number, label), runs in data.items():
                if number == count:
                    ours = np.array([_measured(run, time) for run in runs])
                    row[label] = 1e3 * ours.mean()
                    if len(ours) > 1:
                        deviation = ours.std(ddof=1) / np.sqrt(len(ours))
                        row[f"{label}, deviation"] = 1e3 * deviation
            if count == EIGHT_CODES_BED:
                means = [_published(code, time) for code in eight_codes().values()]
                row |= {"codes, lowest": 1e3 * min(means), "codes, highest": 1e3 * max(means)}
            if count in PUBLISHED_BEDS:
                for name, run in reruns(count).items():
                    row[f"{name}, published bed"] = 1e3 * _published(run, time)
            rows.append(row)
    return pd.DataFrame(rows)


def _measured(run: BulkRun, time: float | None) -> float:
    """Return the displacement at `time`, or the largest depth as a displacement [m]."""
    return displacement_at(time, run) if time else float(run.series["displacement"].min())


def _published(table: pd.DataFrame, time: float | None) -> float:
    """Return the result of `_measured` for a published trajectory: columns time, displacement."""
    if time is None:
        return float(table["displacement"].min())
    return float(np.interp(time, table["time"], table["displacement"]))


def energies(data: Runs) -> pd.DataFrame:
    """Return the energy of ball and bed at the end of the runs [J], and its terms in per cent."""
    return energy_table(
        ({"grains": count, "law": label}, runs) for (count, label), runs in data.items()
    )


def impact_figure(data: Runs) -> Figure:
    """Draw the displacement of the ball versus time, compared with the eight codes."""
    counts, labels = (list(dict.fromkeys(names)) for names in zip(*data, strict=True))
    with styled():
        figure, axes = subplots(1, len(counts), figsize=(4.6 * len(counts), 3.8), squeeze=False)
        for axis, count in zip(axes[0], counts, strict=True):
            _draw_published(axis, count)
            for (number, label), runs in data.items():
                if number != count:
                    continue
                colour = COLOURS[labels.index(label)]
                for run in runs:
                    name = label if run is runs[0] else None
                    series = run.series
                    displacement = 1e3 * series["displacement"]
                    axis.plot(1e3 * series["time"], displacement, color=colour, lw=1, label=name)
            axis.set(title=f"{count} grains", xlabel="time (ms)")
            axis.set_ylabel("displacement of the ball (mm)")
            axis.legend(loc="best")
    return figure


def _draw_published(axis: Axes, count: int) -> None:
    """Draw the range of the eight codes, and runs of other codes with the published bed."""
    if count == EIGHT_CODES_BED:
        codes = eight_codes().values()
        time = next(iter(codes))["time"]
        lowest = np.min([code["displacement"] - code["sd"] for code in codes], axis=0)
        highest = np.max([code["displacement"] + code["sd"] for code in codes], axis=0)
        label = "mean ± standard deviation of eight codes"
        axis.fill_between(1e3 * time, 1e3 * lowest, 1e3 * highest, color="0.85", label=label)
    if count in PUBLISHED_BEDS:
        for (name, run), style in zip(reruns(count).items(), ("--", ":"), strict=True):
            label = f"{name}, published bed"
            axis.plot(1e3 * run["time"], 1e3 * run["displacement"], style, color="0.4", label=label)


TABLES = {"impact": impact, "impact_energies": energies}
FIGURES = {"impact": impact_figure}
