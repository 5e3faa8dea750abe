# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran timestep`: recommended time step."""

from __future__ import annotations

import argparse
import sys

from plastigran import materials
from plastigran.cli.arguments import add_json, add_laws, add_material, positive, print_json
from plastigran.experiments.collide import IMPACTS
from plastigran.usable_laws import choose_laws

HELP = "print the recommended time step of an impact"
EXAMPLE = (
    "plastigran timestep --law universal --material steel --radius 0.005 --speed 0.5\n"
    "plastigran timestep --law universal --surface-energy 0.5 --material steel --radius 1e-5 "
    "--speed 0.5"
)

EXPERIMENTS = {
    geometry: experiment for experiment in IMPACTS.values() for geometry in experiment.geometries
}


def add_arguments(command: argparse.ArgumentParser) -> None:
    add_laws(command, "the bodies of --geometry")
    command.add_argument(
        "--radius", type=positive, default=0.1, help="radius of the body, m, default 0.1"
    )
    command.add_argument(
        "--geometry",
        choices=list(EXPERIMENTS),
        default="sphere_wall",
        help="geometry of the contact, default sphere_wall",
    )
    command.add_argument(
        "--speed",
        type=positive,
        required=True,
        help="speed of each body, m/s; two spheres close at twice this speed",
    )
    add_material(command, "aluminium_zv02")
    command.add_argument("--wall", help="material of the wall, default a rigid wall")
    command.add_argument(
        "--surface-energy",
        type=float,
        help="work of adhesion of the two bodies, J/m^2; switches on 'adhesion jkr' in laws with "
        "Hertz' elastic contact. Default for laws that require it: the value of the material",
    )
    add_json(command)


def run(arguments: argparse.Namespace) -> None:
    material = materials.read_material(arguments.material)
    experiment = EXPERIMENTS[arguments.geometry]
    impacts = experiment.plan(
        law=choose_laws(arguments.law, experiment.shape, [material]),
        speed=arguments.speed,
        material=material,
        radius=arguments.radius,
        geometry=arguments.geometry,
        wall=arguments.wall,
        surface_energy=arguments.surface_energy,
    )
    steps = {impact.law: impact.timestep for impact in impacts}
    if arguments.json:
        print_json([{"law": name, "timestep": step} for name, step in steps.items()])
    else:
        for name, step in steps.items():
            print(f"{name:20s} {step:.4g} s")
    for shape, other in IMPACTS.items():
        if "all" in arguments.law and shape != experiment.shape:
            geometries = ", ".join(other.geometries)
            print(f"omitted: laws for {shape}s. Use --geometry {geometries}", file=sys.stderr)
