# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran rod`: the oblique rod."""

from __future__ import annotations

import argparse

from plastigran.cli.arguments import (
    UsageError,
    add_jobs,
    add_output,
    fresh_folder,
    law_names,
    positive,
)
from plastigran.cli.tables import format_table, print_range
from plastigran.experiments.central import sweep
from plastigran.experiments.rod import PAPER_FRICTION, Rod
from plastigran.experiments.rod import runs as rod_runs

HELP = "drop the paper's oblique rod, table and figures"


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument("--law", nargs="+", default=["all"], metavar="LAW", help="default all")
    command.add_argument(
        "--speed", nargs="+", type=positive, default=rod_runs.PAPER_SPEEDS, help="m/s"
    )
    command.add_argument(
        "--angle",
        nargs="+",
        type=positive,
        default=list(PAPER_FRICTION),
        help="between rod and flat, degrees, default the paper's",
    )
    command.add_argument("--friction", type=positive, help="default the paper's at each angle")
    command.add_argument(
        "--tangential", choices=rod_runs.TANGENTIAL, default="history", help="default history"
    )
    add_jobs(command)
    add_output(command, "results/rod")


def paper_rod(angle: float, friction: float | None) -> Rod:
    """The paper's rod at an angle [degrees], with the friction the paper gives for it or another.

    Raises:
        UsageError: The paper gives none.
    """
    if friction is not None:
        return Rod(angle=angle, friction=friction)
    if angle in PAPER_FRICTION:
        return Rod(angle=angle, friction=PAPER_FRICTION[angle])
    known = " and ".join(f"{paper:g}" for paper in PAPER_FRICTION)
    raise UsageError(f"the paper gives friction at {known} degrees only; add --friction")


def run(arguments: argparse.Namespace) -> None:
    from plastigran.experiments.rod import figures as rod_figures  # matplotlib is slow to load
    from plastigran.plot import style

    rods = [paper_rod(angle, arguments.friction) for angle in arguments.angle]
    names = law_names(arguments.law, [rods[0].material.name])
    runs = rod_runs.plan(names, arguments.speed, rods, arguments.tangential)
    folder = fresh_folder(arguments.output, arguments.force)
    table, impacts = sweep(runs, folder, arguments.jobs)
    print(format_table(table))
    print_range(table)
    closest = rod_figures.closest_to_measured(impacts)
    written = [folder / "impacts.csv"]
    for name, figure in (
        ("outcome", rod_figures.outcome_figure(table)),
        ("deformation", rod_figures.deformation_figure(table)),
        ("motion", rod_figures.motion_figure(closest, impacts[closest])),
    ):
        written += style.save(figure, folder / name)
    print("\nwritten: " + "  ".join(str(path) for path in written))
