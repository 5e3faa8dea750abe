# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran vtk`: frames of a bulk run for ParaView and OVITO."""

from __future__ import annotations

import argparse
from pathlib import Path

HELP = "write frames of a bulk run for ParaView and OVITO, with the plastic work of each contact"
EXAMPLE = """
plastigran bulk hopper -v frames=20 contact_history=1 --output results/frames
plastigran vtk results/frames
"""


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "folder",
        type=Path,
        help="folder of a bulk run that wrote frames, for example with `-v frames=10`",
    )
    command.add_argument("--output", type=Path, help="folder of the files, default FOLDER/vtk")


def run(arguments: argparse.Namespace) -> None:
    # Import here, because matplotlib is slow to load.
    from plastigran.bulk.outcome import open_run
    from plastigran.bulk.vtk import write_vtk

    written = write_vtk(open_run(arguments.folder), arguments.output or arguments.folder / "vtk")
    print("written: " + "  ".join(map(str, written)))
