# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran reproduce`: tables and figures of a paper, compared with results of this package."""

from __future__ import annotations

import argparse

from plastigran.cli.reports import add_evidence_arguments, run_evidence
from plastigran.papers import find_paper, paper_names

HELP = "reproduce tables and figures of a paper by finite elements, laws and LIGGGHTS"
EXAMPLE = "plastigran reproduce zv02 --coarse"


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "paper", choices=paper_names(), help="name of the paper; each has a page in docs/papers"
    )
    add_evidence_arguments(command, "results/PAPER", "docs/papers")


def run(arguments: argparse.Namespace) -> None:
    paper = find_paper(arguments.paper)
    run_evidence(paper, f"{paper.citation}: {paper.title}", arguments)
