# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran cite`: BibTeX of the software and of the sources of its laws."""

from __future__ import annotations

import argparse

from plastigran.citation import cite, subjects

HELP = "print BibTeX of the software and of the sources of laws"
EXAMPLE = "plastigran cite kogut_etsion thornton >laws.bib"


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "law",
        nargs="*",
        metavar="LAW",
        help="names of laws, `rate_factor` for the strain-rate dependence, or `all`; default: only "
        "the software",
    )


def run(arguments: argparse.Namespace) -> None:
    names = list(subjects()) if "all" in arguments.law else arguments.law
    print(cite(names), end="")
