# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran timestep`: how long a step may be."""

from __future__ import annotations

import argparse

from plastigran import materials
from plastigran.cli.arguments import law_names, positive
from plastigran.experiments.central import GEOMETRIES, CentralImpact

HELP = "recommended time step of an impact"


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--law",
        nargs="+",
        default=["all"],
        metavar="LAW",
        help="laws, or all (default) that the material has the constants for",
    )
    command.add_argument("--radius", type=positive, default=0.1, help="m, default 0.1")
    command.add_argument("--geometry", choices=list(GEOMETRIES), default="sphere_wall")
    command.add_argument("--speed", type=positive, required=True, help="impact speed, m/s")
    command.add_argument("--material", default="aluminium_zv02")


def run(arguments: argparse.Namespace) -> None:
    material = materials.read_material(arguments.material)
    for name in law_names(arguments.law, [arguments.material]):
        case = CentralImpact(name, arguments.speed, material, arguments.radius, arguments.geometry)
        print(f"{name:20s} {case.timestep:.4g} s")
