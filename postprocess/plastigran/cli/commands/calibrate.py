# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran calibrate`: constants of a law from finite elements."""

from __future__ import annotations

import argparse

from plastigran.cli.arguments import positive
from plastigran.cli.metal import add_metal, add_strain, computed, metal, print_json
from plastigran.engine.deck import property_name
from plastigran.fem.sphere.calibration import calibrate, check_range
from plastigran.fem.sphere.press import press
from plastigran.fem.theory.hertz import HertzSphere

HELP = "constants of vu_quoc_zhang from finite elements"


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--fem", action="store_true", default=True, help="by finite elements, the only way so far"
    )
    add_metal(command)
    add_strain(command)
    command.add_argument(
        "--range",
        type=positive,
        default=41.0,
        dest="force_ratio",
        metavar="PMAX/PY",
        help="largest force of the fit over the force at yield, default 41",
    )


def run(arguments: argparse.Namespace) -> None:
    sphere = HertzSphere(metal(arguments), arguments.radius)
    force = arguments.force_ratio * sphere.yield_force
    check_range(sphere, force)
    pressing = computed(press, sphere.material, sphere.radius, [force], strain=arguments.strain)
    numbers = calibrate(pressing).to_dict()
    if arguments.json:
        print_json(numbers)
        return
    for name, value in numbers.items():
        print(f"{name:28s} {value:.5g}")
    for name in ("contact_radius_coefficient", "curvature_coefficient"):
        keyword, value = property_name(name), f"{numbers[name]:.6g}"
        print(f"variable {name} index {value}  # a line of a material file")
        print(f"fix {name} all property/global {keyword} peratomtypepair 1 {value}  # of a deck")
