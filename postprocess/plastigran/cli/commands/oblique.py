# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran oblique`: oblique impacts of a sphere, computed from the laws without LIGGGHTS."""

from __future__ import annotations

import argparse
import warnings
from pathlib import Path

import numpy as np
import pandas as pd

from plastigran import laws
from plastigran.cli.arguments import (
    add_json,
    add_material,
    positive,
    positive_integer,
    print_json,
)
from plastigran.cli.commands.calibrate import FIGURES
from plastigran.contact import Contact
from plastigran.materials import RIGID, read_material
from plastigran.physics.oblique_contact import normalized_angle

HELP = "compute oblique impacts of a sphere on a plane by a normal and a tangential law"
EXAMPLE = """
plastigran oblique --law hertz --material steel --radius 0.0025 --speed 1 --friction 0.1
"""


COLUMNS = """
columns of the table:
  angle                   angle of the velocity from the normal before the impact
  normalized_angle        tan(angle) 4 G*/(mu E*), where mu is the coefficient of friction;
                          G* and E* are the effective shear modulus and Young's modulus
  normal_restitution      normal speed after the impact / normal speed before the impact
  tangential_restitution  tangential speed of the center after the impact /
                          tangential speed of the center before the impact
  spin                    spin of the sphere after the impact; it does not spin before
  rebound_angle           angle of the velocity from the normal after the impact
  friction_work           energy dissipated by friction
"""


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.epilog = f"{COLUMNS.strip()}\n\n{command.epilog}"
    spheres = [name for name, law in laws.LAWS.items() if law.shape == "sphere"]
    command.add_argument(
        "--law", choices=spheres, default="hertz", help="normal law, default hertz"
    )
    command.add_argument(
        "--tangential",
        nargs="+",
        choices=list(laws.TANGENTIAL_LAWS),
        default=list(laws.TANGENTIAL_LAWS),
        help="tangential laws, default all",
    )
    add_material(command, "steel")
    command.add_argument("--wall", help="material of the plane, default a rigid plane")
    command.add_argument("--radius", type=positive, required=True, help="radius of the sphere, m")
    command.add_argument(
        "--speed",
        type=positive,
        required=True,
        help="speed of the sphere before the impact, m/s, the same at all angles; its part along "
        "the normal is SPEED cos(angle)",
    )
    command.add_argument("--friction", type=positive, required=True, help="coefficient of friction")
    command.add_argument(
        "--rings",
        type=positive_integer,
        default=4,
        help="number of concentric rings into which the law partial_slip divides the contact area, "
        "2 to 8, default 4",
    )
    command.add_argument(
        "--angles",
        nargs=2,
        type=positive,
        default=(1, 60),
        metavar=("LOW", "HIGH"),
        help="lowest and highest angle from the normal, degrees, default 1 60",
    )
    command.add_argument(
        "--points", type=positive_integer, default=20, help="number of angles, default 20"
    )
    command.add_argument(
        "--figure",
        type=Path,
        metavar="FILE.png",
        help="file for a figure of the outcomes versus the angle",
    )
    add_json(command)


def run(arguments: argparse.Namespace) -> None:
    if arguments.figure is not None and arguments.figure.suffix not in FIGURES:
        raise ValueError(f"--figure is {arguments.figure}; it must end in {' or '.join(FIGURES)}")
    material = read_material(arguments.material)
    wall = RIGID if arguments.wall is None else read_material(arguments.wall)
    angles = np.linspace(*arguments.angles, arguments.points)
    tables = []
    for name in arguments.tangential:
        contact = Contact(
            arguments.law,
            material,
            wall,
            radius=arguments.radius,
            friction=arguments.friction,
            tangential=name,
            rings=arguments.rings,
        )
        outcome = contact.oblique_impact(arguments.speed, angles)
        tables.append(
            pd.DataFrame(
                {
                    "tangential": name,
                    "angle": angles,
                    "normalized_angle": normalized_angle(
                        contact.pair, arguments.friction, np.radians(angles)
                    ),
                    "normal_restitution": outcome.normal_restitution,
                    "tangential_restitution": outcome.tangential_restitution,
                    "spin": outcome.spin,
                    "rebound_angle": outcome.rebound_angle,
                    "friction_work": outcome.friction_work,
                }
            )
        )
    if material.surface_energy:
        warnings.warn(
            f"surface_energy of material {material.name} is {material.surface_energy:.6g} J/m2, "
            "but has no effect: oblique impacts are computed without adhesion",
            stacklevel=2,
        )
    table = pd.concat(tables, ignore_index=True)
    if arguments.figure is not None:
        _draw(table, arguments.figure)
    if arguments.json:
        print_json(table.to_dict("records"))
    else:
        units = {"angle": "°", "spin": "rad/s", "rebound_angle": "°", "friction_work": "J"}
        table = table.rename(columns={name: f"{name}, {unit}" for name, unit in units.items()})
        print(table.to_string(index=False, float_format="{:.4g}".format))
        if arguments.figure is not None:
            print(f"\nwritten: {arguments.figure}")


def _draw(table: pd.DataFrame, path: Path) -> None:
    from plastigran.plot.oblique import oblique_figure  # import here, because matplotlib is slow
    from plastigran.plot.style import save

    save(oblique_figure(table), path, (path.suffix,))
