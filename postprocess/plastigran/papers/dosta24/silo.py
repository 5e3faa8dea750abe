# SPDX-License-Identifier: GPL-2.0-or-later
"""Case silo of the benchmark of Dosta et al. 2024: discharge through a large or a small orifice."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from plastigran.bulk.outcome import BulkRun
from plastigran.papers.dosta24.beds import energy_table, run_beds, softened_grains
from plastigran.papers.dosta24.published import silo
from plastigran.plot.style import COLOURS, styled, subplots

#: Mean discharge rates of the eight codes by orifice, in thousand grains per second. The rates are
#: means over the time until the silo is empty, or over 5 s.
RATES = {"large": 23.2, "small": 7.7}
#: Settings of all runs: grains with 1/100 of the Young's modulus, and a time step nine times as
#: long as in the benchmark. Grains with 1/500 of the modulus would discharge 5 % faster. The run
#: ends when the rate is measured.
SOFT = softened_grains(0.01) | {"timestep": 1.35e-5, "duration": 0.25, "settling": 0.1}
SOFT |= {"rows": 25, "checkpoints": 5}
#: Settings of a run that lasts until the silo is empty, by orifice and label of `CONTACTS`.
LONG = {("large", "hertz"): {"duration": 4.4, "rows": 220, "checkpoints": 22}}
#: A silo counts as empty if at most this fraction of the grains is still in it.
EMPTY = 1e-3
#: Contact laws of the runs by orifice, as labels of `CONTACTS`.
LAWS = {"large": ("hertz", "thornton"), "small": ("hertz",)}
#: Line styles of other codes in the figure.
STYLES = {"LIGGGHTS": "--", "MUSEN": ":"}
#: Settings of a short run with few grains (coarse).
COARSE = softened_grains(0.002) | {"timestep": 4e-5, "duration": 0.08, "settling": 0.03}
COARSE |= {"rows": 40, "checkpoints": 2, "grain_count": 2000, "volume_fraction": 0.5}

#: Runs with several random fillings, by orifice and label of `CONTACTS`.
Runs = dict[tuple[str, str], list[BulkRun]]


def compute(
    progress: bool,
    coarse: bool,
    folder: Path,
    law: Sequence[str] | None = None,
    beds: int = 1,
    ranks: int = 1,
) -> Runs:
    """Run the silo with both orifices, or continue its runs in `folder`.

    Args:
        progress: Whether to show a progress bar.
        coarse: Whether to run few grains for a short time.
        folder: Folder of the runs.
        law: Labels of `CONTACTS`, or names of laws; by default the labels in `LAWS`.
        beds: Number of random fillings.
        ranks: Number of MPI ranks.
    """
    runs = {}
    for orifice, labels in LAWS.items():
        path = folder / f"silo_{orifice}"
        for label in law or labels:
            settings = {"orifice": orifice}
            settings |= COARSE if coarse else SOFT | LONG.get((orifice, label), {})
            runs[orifice, label] = run_beds("silo", settings, label, beds, path, ranks, progress)
    return runs


def rates(data: Runs) -> pd.DataFrame:
    """Return the discharge rates of our runs and of other codes, in thousand grains per second.

    Each orifice has two rows: the mean rate over the whole discharge (`whole_rate`), and the mean
    rate from the setting `settling` until the end of our shortest run.
    """
    rows = []
    for orifice in dict.fromkeys(orifice for orifice, _ in data):
        series = {
            label: [run.series for run in runs]
            for (other, label), runs in data.items()
            if other == orifice
        }
        start = data[orifice, next(iter(series))][0].deck.settling
        end = min(one["time"].iloc[-1] for several in series.values() for one in several)
        published = {f"{code}, published filling": [s] for code, s in silo(orifice).items()}
        empty = {
            label: several for label, several in series.items() if all(map(_is_empty, several))
        }
        rows.append(
            {"orifice": orifice, "from (s)": 0, "to": "empty or end", "eight codes": RATES[orifice]}
            | {name: np.mean([*map(whole_rate, s)]) for name, s in (empty | published).items()}
        )
        rows.append(
            {"orifice": orifice, "from (s)": start, "to": f"{end:.2f} s"}
            | {
                name: np.mean([_rate(one, start, end) for one in several])
                for name, several in (series | published).items()
            }
        )
    first = ["orifice", "from (s)", "to", *dict.fromkeys(label for _, label in data), "eight codes"]
    table = pd.DataFrame(rows)
    return table.reindex(columns=[*first, *(name for name in table if name not in first)])


def _is_empty(series: pd.DataFrame) -> bool:
    """Return whether the silo is empty at the end of a run."""
    return series["held"].iloc[-1] <= EMPTY * series["held"].iloc[0]


def whole_rate(series: pd.DataFrame) -> float:
    """Return the mean discharge rate until the silo is empty, or until the end of the run.

    The unit is thousand grains per second.
    """
    remaining = series["held"] > EMPTY * series["held"].iloc[0]
    last = min(remaining.sum(), len(series) - 1)
    return _rate(series, 0, series["time"].iloc[last])


def _rate(series: pd.DataFrame, start: float, end: float) -> float:
    """Return the discharge rate between two times in thousand grains per second."""
    first, last = np.interp((start, end), series["time"], series["held"])
    return (first - last) / (end - start) / 1e3


def energies(data: Runs) -> pd.DataFrame:
    """Return the energy terms at the end of each run that has an energy balance."""
    return energy_table(
        ({"orifice": orifice, "law": label}, runs) for (orifice, label), runs in data.items()
    )


def silo_figure(data: Runs) -> Figure:
    """Draw the numbers of grains in the silo versus time, compared with other codes."""
    with styled():
        figure, axes = subplots(1, 2, figsize=(9.2, 3.8))
        end = max(run.series["time"].iloc[-1] for runs in data.values() for run in runs)
        for axis, orifice in zip(axes, RATES, strict=True):
            for code, series in silo(orifice).items():
                times = np.append(series["time"][series["time"] < end], end)
                held = np.interp(times, series["time"], series["held"]) / 1e3
                axis.plot(times, held, STYLES[code], color="0.4", label=code)
            labels = [label for other, label in data if other == orifice]
            for label, colour in zip(labels, COLOURS, strict=False):
                for run in data[orifice, label]:
                    name = label if run is data[orifice, label][0] else None
                    axis.plot(
                        run.series["time"], run.series["held"] / 1e3, color=colour, label=name
                    )
            axis.set(xlabel="time (s)", ylabel="number of grains in the silo (thousands)")
            axis.set_title(f"{orifice} orifice")
            axis.legend()
    return figure


TABLES = {"silo_rates": rates, "silo_energies": energies}
FIGURES = {"silo": silo_figure}
