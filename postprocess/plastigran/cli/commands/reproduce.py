# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran reproduce`: tables and figures of a paper, compared with results of this package."""

from __future__ import annotations

import argparse
from pathlib import Path

from plastigran.cli.arguments import positive_integer
from plastigran.cli.reports import add_evidence_arguments, run_evidence
from plastigran.engine.versions import HOSTS
from plastigran.papers import find_paper, paper_names

HELP = "reproduce tables and figures of a paper by finite elements, laws, LIGGGHTS and LAMMPS"
EXAMPLE = "plastigran reproduce zv02 --coarse"


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "paper",
        choices=paper_names(),
        help="name of the paper; each paper has a page in docs/papers",
    )
    add_evidence_arguments(command, "results/PAPER", "docs/papers")
    bulk = command.add_argument_group(
        "bulk benchmarks",
        "Only for dosta24. If the command was interrupted, repeat it to continue its simulations. "
        "Finished simulations are not repeated, even with --force.",
    )
    bulk.add_argument(
        "--case", choices=("impact", "silo", "drum"), help="deck of the benchmark, default all"
    )
    bulk.add_argument(
        "--host",
        choices=list(HOSTS),
        help="program that runs the decks, default liggghts; lammps needs --case impact",
    )
    bulk.add_argument(
        "--grains", type=positive_integer, help="number of grains, only with --case impact"
    )
    bulk.add_argument(
        "--law",
        nargs="+",
        metavar="LAW",
        help="contact laws, default hertz with the restitution of the benchmark, and thornton",
    )
    bulk.add_argument(
        "--beds", type=positive_integer, help="number of beds with different random positions"
    )
    bulk.add_argument("--ranks", type=positive_integer, help="number of MPI ranks, default 1")


def run(arguments: argparse.Namespace) -> None:
    names = ("case", "host", "grains", "law", "beds", "ranks")
    options = {name: value for name in names if (value := getattr(arguments, name)) is not None}
    if (fewer := options.keys() - {"ranks"}) and arguments.docs:
        raise ValueError(f"--docs needs complete results. Remove --{min(fewer)}")
    if (given := options.keys() & {"grains", "beds"}) and arguments.coarse:
        raise ValueError(
            f"--{min(given)} has no effect with --coarse, which always runs one small bed. Remove "
            f"--{min(given)}"
        )
    folder = arguments.output or Path("results") / arguments.paper
    paper = find_paper(arguments.paper, folder, **options)
    run_evidence(paper, f"{paper.citation}: {paper.title}", arguments)
