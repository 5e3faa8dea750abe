# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran chung-ooi`: benchmark impacts."""

from __future__ import annotations

import argparse

from plastigran.cli.arguments import add_jobs, add_output, fresh_folder, positive_integer
from plastigran.experiments.central import laws_for, sweep

HELP = "the eight benchmark impacts of Chung & Ooi (2011), against theory"


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--benchmark", nargs="+", type=int, choices=range(1, 9), default=list(range(1, 9))
    )
    command.add_argument(
        "--law",
        default="vu_quoc_zhang",
        choices=laws_for("sphere"),
        metavar="LAW",
        help="any law for spheres, unyielding, default vu_quoc_zhang; hertz is the engine's own",
    )
    command.add_argument(
        "--steps", type=positive_integer, default=1000, help="time steps a contact, default 1000"
    )
    add_jobs(command)
    add_output(command, "results/chung_ooi")


def run(arguments: argparse.Namespace) -> None:
    """The benchmark impacts of Chung & Ooi: a table and a figure each, and how far off theory."""
    from plastigran.experiments import (
        chung_ooi,  # matplotlib is slow to load
        chung_ooi_figures,  # matplotlib is slow to load
    )
    from plastigran.plot import style  # matplotlib is slow to load

    folder = fresh_folder(arguments.output, arguments.force)
    cases = [
        case
        for case in chung_ooi.cases(arguments.law, arguments.steps)
        if case.benchmark in arguments.benchmark
    ]
    table, outcomes = sweep(cases, folder, arguments.jobs)
    for number, part in table.groupby("benchmark"):
        name = folder / f"benchmark_{number}"
        part.dropna(axis="columns", how="all").to_csv(name.with_suffix(".csv"), index=False)
        style.save(chung_ooi_figures.figure(number, outcomes), name)
    agreement = chung_ooi.agreement(table)
    agreement.to_csv(folder / "agreement.csv")
    print("Largest deviations from theory:\n")
    print(agreement.to_string(float_format="{:.1e}".format, na_rep=""))
    print(f"\nwritten: {folder}: impacts.csv, agreement.csv, benchmark_*.csv, .png, .svg")
