# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran lammps`: run an input script in LAMMPS with the contact laws."""

from __future__ import annotations

import argparse
import os
from pathlib import Path

from plastigran.engine.lammps import LOG, lammps_environment, lammps_start
from plastigran.engine.process import EngineError

HELP = "run an input script in LAMMPS with the laws"
EXAMPLE = "plastigran lammps -in inputs/lammps/two_spheres.in -var law thornton"


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument("-in", dest="deck", type=Path, required=True, help="input script")
    command.add_argument(
        "-var",
        dest="variables",
        nargs="+",
        action="append",
        default=[],
        metavar="WORD",
        help="name of an index variable of the script, followed by its values",
    )
    command.add_argument("-log", default=LOG, help=f"log file, default {LOG}; none for no file")
    command.add_argument("--ranks", type=int, default=1, help="number of MPI ranks, default 1")


def run(arguments: argparse.Namespace) -> None:
    """Start LAMMPS, which replaces this process.

    Raises:
        EngineError: The script, LAMMPS or the plugin is missing.
        ValueError: The number of ranks is out of range.
    """
    if not arguments.deck.is_file():
        raise EngineError(f"the input script {arguments.deck} does not exist")
    if arguments.ranks < 1:
        raise ValueError(f"--ranks is {arguments.ranks}; it must be 1 or more")
    words = ["-in", str(arguments.deck), "-log", arguments.log]
    for variable in arguments.variables:
        words += ["-var", *variable]
    line = [*lammps_start(arguments.ranks), *words]
    os.execvpe(line[0], line, lammps_environment())
