# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran timestep`: how long a step may be."""

from __future__ import annotations

import argparse

from plastigran import materials
from plastigran.cli.arguments import add_law_and_sphere, law_names, positive
from plastigran.experiments.central import Impact

HELP = "recommended time step of an impact"


def add_arguments(command: argparse.ArgumentParser) -> None:
    add_law_and_sphere(command)
    command.add_argument("--speed", type=positive, required=True, help="impact speed, m/s")
    command.add_argument("--material", default="aluminium_zv02")


def run(arguments: argparse.Namespace) -> None:
    material = materials.read_material(arguments.material)
    for name in law_names(arguments.law, [arguments.material]):
        impact = Impact(name, arguments.speed, material, arguments.radius, arguments.geometry)
        print(f"{name:20s} {impact.time_step():.4g} s")
