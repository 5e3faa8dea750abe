# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran modes`: free vibrations of an elastic sphere."""

from __future__ import annotations

import argparse

from plastigran import materials
from plastigran.cli.arguments import add_json, add_material, positive, positive_integer, print_json
from plastigran.declared import RADIUS, read_number
from plastigran.physics.modes import sphere_modes

HELP = "compute free vibrations of an elastic sphere"
EXAMPLE = "plastigran modes --material ice --radius 0.01"


def add_arguments(command: argparse.ArgumentParser) -> None:
    add_material(command)
    command.add_argument("--radius", type=positive, required=True, help="radius of the sphere, m")
    command.add_argument(
        "--degree",
        type=positive_integer,
        default=4,
        help="highest angular degree of the modes, default 4",
    )
    command.add_argument(
        "--overtones",
        type=positive_integer,
        default=3,
        help="number of modes of each kind (radial, spheroidal, toroidal) and degree, default 3",
    )
    add_json(command)


def run(arguments: argparse.Namespace) -> None:
    material = materials.read_material(arguments.material)
    table = sphere_modes(
        material.youngs_modulus,
        material.poissons_ratio,
        material.density,
        read_number("radius", arguments.radius, RADIUS),
        range(arguments.degree + 1),
        arguments.overtones,
    )
    if arguments.json:
        print_json(table.to_dict("records"))
        return
    table = table.rename(columns={"frequency": "frequency, Hz"})
    print(table.to_string(index=False, float_format="{:.6g}".format))
