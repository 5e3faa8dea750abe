# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran impact`: collisions in the engine."""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
import pandas as pd

from plastigran import materials
from plastigran.cli.arguments import (
    add_jobs,
    add_law_and_sphere,
    add_output,
    fresh_folder,
    law_names,
    positive,
    positive_integer,
)
from plastigran.cli.tables import format_table, print_range
from plastigran.experiments.central import Impact, plan, sweep

HELP = "run collisions in the engine, table and figures"


def add_arguments(command: argparse.ArgumentParser) -> None:
    add_law_and_sphere(command)
    command.add_argument("--speed", nargs="+", type=positive, help="impact speeds, m/s")
    command.add_argument(
        "--speeds",
        nargs=2,
        type=positive,
        default=(0.001, 0.2),
        metavar=("LOW", "HIGH"),
        help="range of speeds when --speed is not given, m/s, default 0.001 0.2",
    )
    command.add_argument(
        "--points", type=positive_integer, default=9, help="speeds in it, default 9"
    )
    command.add_argument(
        "--material", nargs="+", default=["aluminium_zv02"], help=f"{', '.join(materials.names())}"
    )
    add_jobs(command)
    add_output(command, "results/impact")


def run_impacts(impacts: list[Impact], folder: Path, jobs: int | None) -> pd.DataFrame:
    """Sweep, table, figures."""
    # matplotlib is slow to load
    from plastigran.experiments.central_figures import loops_figure, restitution_figure
    from plastigran.plot import style

    table, collisions = sweep(impacts, folder, jobs)
    print(format_table(table))
    print_range(table)
    written = [folder / "impacts.csv"]
    written += style.save(restitution_figure(table, impacts), folder / "restitution")
    written += style.save(loops_figure(collisions), folder / "loops")
    print("\nwritten: " + "  ".join(str(path) for path in written))
    return table


def run(arguments: argparse.Namespace) -> None:
    speeds = arguments.speed or np.geomspace(*arguments.speeds, arguments.points)
    impacts = plan(
        law_names(arguments.law, arguments.material),
        speeds,
        arguments.material,
        arguments.radius,
        arguments.geometry,
    )
    run_impacts(impacts, fresh_folder(arguments.output, arguments.force), arguments.jobs)
