#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Measure flow functions of the uniaxial test, or compare two grain sizes.

    .venv/bin/python docs/flow_function.py                  # three stresses, three surface energies
    .venv/bin/python docs/flow_function.py --scaling        # two grain sizes, three seeds

Each command takes about five minutes on one core. The script reads finished runs from the
output folder instead of repeating them.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import pandas as pd

from plastigran.bulk import BulkRun, run_bulk
from plastigran.bulk import open as open_run

STRESSES = (2.5e3, 5e3, 1e4)  # Pa
ENERGIES = (0.0, 2.0, 4.0)  # J/m^2
#: A sample of 500 grains.
SAMPLE = {"side": 5, "layers": 10}
#: Numbers of cells along the side of the mold. With six cells, the grains have 2/3 of the radius.
SIDES = (4, 6)
SEEDS = (1, 2, 3)
#: Radius [m], time step [s] and surface energy [J/m^2] of the larger grains.
RADIUS, TIMESTEP, ENERGY = 1.25e-3, 3.75e-6, 2.5


def run(folder: Path, **settings: object) -> BulkRun:
    """Return a run of the deck with some settings, from its folder if it is finished."""
    words = "_".join(f"{name}_{value:g}" for name, value in settings.items())
    if (folder / words / "checks.csv").exists():
        return open_run(folder / words)
    return run_bulk("uniaxial_test", settings, folder / words, force=True, show=False)


def row(test: BulkRun) -> dict[str, float]:
    """Return settings and results of a test, as `flow_function_figure` needs them."""
    strength = test.deck.strength(test.series)
    return {
        "consolidation_stress": test.deck.consolidation_stress,
        "surface_energy": test.deck.surface_energy,
        "radius": test.deck.radius,
        "consolidation": strength.consolidation,
        "porosity": strength.porosity,
        "unconfined": strength.unconfined,
        "ratio": strength.ratio,
    }


def flow_functions(folder: Path) -> pd.DataFrame:
    """Return one row per consolidation stress and surface energy; `adhesion_ratio` is 0."""
    return pd.DataFrame(
        row(
            run(
                folder,
                consolidation_stress=stress,
                surface_energy=energy,
                adhesion_ratio=0,
                **SAMPLE,
            )
        )
        for energy in ENERGIES
        for stress in STRESSES
    )


def scaling(folder: Path) -> pd.DataFrame:
    """Return one row per grain size and seed, for samples of one width and one height.

    Stiffness is proportional to the grain size d, because Young's modulus is the same. The surface
    energy is proportional to d, so that the pull-off force is proportional to d^2.
    """
    rows = []
    for side in SIDES:
        scale = SIDES[0] / side
        settings = {"radius": RADIUS * scale, "timestep": TIMESTEP * scale}
        settings |= {"surface_energy": ENERGY * scale, "side": side, "layers": 2 * side}
        rows += [row(run(folder, **settings, seed=seed)) for seed in SEEDS]
    return pd.DataFrame(rows)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scaling", action="store_true", help="compare two grain sizes")
    parser.add_argument("--output", type=Path, default=Path("results/flow_function"))
    arguments = parser.parse_args()
    table = (scaling if arguments.scaling else flow_functions)(arguments.output)
    print(table.to_string(index=False, float_format="{:.4g}".format))
    if arguments.scaling:
        print(table.groupby("radius")["ratio"].agg(["mean", "std"]))


if __name__ == "__main__":
    main()
