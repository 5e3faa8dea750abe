# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran validate`: every law compared with finite elements, papers and experiments."""

from __future__ import annotations

import argparse

from plastigran.cli.reports import add_evidence_arguments, run_evidence

HELP = "compare every law with finite elements, papers and experiments"
EXAMPLE = "plastigran validate --coarse"


def add_arguments(command: argparse.ArgumentParser) -> None:
    add_evidence_arguments(command, "results/validation", "docs")


def run(arguments: argparse.Namespace) -> None:
    # Import here, because matplotlib is slow to load.
    from plastigran.validation.report import ERRORS, EVIDENCE
    from plastigran.validation.summary import write_summaries

    made = run_evidence(EVIDENCE, EVIDENCE.title, arguments)
    if arguments.docs:  # also update the table of errors in the package
        made.tables["errors"].to_csv(ERRORS, index=False)
        pages = write_summaries(arguments.docs / "laws", made.tables["errors"])
        if not arguments.json:
            print(f"written: {'  '.join(map(str, [ERRORS, *pages]))}")
