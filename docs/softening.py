#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Print the results of two bulk decks with a stiff material and with the softened material.

    .venv/bin/python docs/softening.py [--decks drum hopper] [--factors 1 0.01 0.001 0.0001]
                                       [--seeds 1 2 3] [--output FOLDER]

The defaults take about 25 minutes of one core, most of it in the stiff runs. The script reads
finished runs from the output folder instead of repeating them.
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from itertools import product
from pathlib import Path

import attrs
import pandas as pd
from scipy.stats import linregress

from plastigran.bulk import BulkRun, run_bulk
from plastigran.bulk import open as open_run
from plastigran.calibration.softening import TIME_POWER, soften
from plastigran.materials import Material, read_material, write_material

LAW = "thornton"
#: Factor that turns the stiff material into the granules of the decks.
SOFTEST = 1e-4
#: Small decks with 600 and 110 grains, and the time steps [s] of the softest material.
HOPPER = {"orifice": 8, "layers": 3, "timestep": 1.0e-5, "duration": 0.6, "rows": 150}
HOPPER |= {"filling": 0.1, "checkpoints": 1}
DRUM = {"drum_radius": 0.05, "length": 0.03, "froude": 0.2, "duration": 0.9, "settling": 0.3}
DRUM |= {"timestep": 1.5e-5, "checkpoints": 2}
DECKS = {"drum": DRUM, "hopper": HOPPER}
SHARES = ("plastic", "friction", "viscous")


def stiff_material() -> Material:
    """Return granules 10 000 times as stiff as in the decks, with the same restitution."""
    granules = read_material("soft_granules")
    return attrs.evolve(
        granules,
        name="stiff_granules",
        youngs_modulus=granules.youngs_modulus / SOFTEST,
        yield_strength=granules.yield_strength / SOFTEST**0.8,
    )


def measure(run: BulkRun) -> dict[str, float]:
    """Return the quantities of a run that the script compares.

    These are the discharge rate of the hopper [grains/s] or the power of the drum's wall [W], and
    the shares of the dissipation.
    """
    series, deck = run.series, run.deck
    if run.name == "hopper":
        out = series["counted"] / series["atoms"].iloc[0]
        steady, quantity = series[out.between(0.1, 0.5)], "counted"
    else:
        steady, quantity = series[series["time"] >= deck.settled], "wallwork"
    lost = steady[list(SHARES)].iloc[-1] - steady[list(SHARES)].iloc[0]
    rate = linregress(steady["time"], steady[quantity]).slope
    return {"rate or power": rate, **(lost / lost.sum())}


def compared(
    folder: Path, decks: list[str], factors: list[float], seeds: list[int]
) -> pd.DataFrame:
    """Return mean and standard deviation over seeds of the measured values, by deck and factor."""
    rows = []
    for deck, factor, seed in product(decks, factors, seeds):
        run = _run(folder / f"{deck}_{factor:g}_{seed}", deck, DECKS[deck], factor, seed)
        rows.append({"deck": deck, "factor": factor, **measure(run)})
    grouped = pd.DataFrame(rows).groupby(["deck", "factor"], sort=False)
    return grouped.agg(["mean", "std"])


def _run(
    folder: Path, deck: str, settings: Mapping[str, object], factor: float, seed: int
) -> BulkRun:
    if (folder / "run" / "checks.csv").exists():
        return open_run(folder / "run")
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "material.in"
    write_material(soften(stiff_material(), factor), file, f"Softened by {factor:g}.", force=True)
    timestep = settings["timestep"] * (factor / SOFTEST) ** TIME_POWER
    values = {**settings, "timestep": timestep, "law": LAW, "seed": seed}
    values |= {"materials": folder.resolve(), "material": file.stem}
    return run_bulk(deck, values, folder / "run", force=True, show=False)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--decks", nargs="+", choices=DECKS, default=list(DECKS))
    parser.add_argument("--factors", type=float, nargs="+", default=[1, 0.01, 0.001, 0.0001])
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3])
    parser.add_argument("--output", type=Path, default=Path("results/softening"))
    arguments = parser.parse_args()
    table = compared(arguments.output, arguments.decks, arguments.factors, arguments.seeds)
    print(table.to_string(float_format="{:.4g}".format))


if __name__ == "__main__":
    main()
