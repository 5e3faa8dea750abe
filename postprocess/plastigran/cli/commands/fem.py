# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran fem`: one sphere on a rigid plane by finite elements, pressed or thrown, or a rigid
cylinder that strikes a body."""

from __future__ import annotations

import argparse
import json
import sys

from plastigran.cli.arguments import positive
from plastigran.cli.cylinder import add_cylinder, cylinder
from plastigran.cli.metal import add_metal, add_strain, computed, metal
from plastigran.fem.hertz import HertzSphere
from plastigran.fem.press import press
from plastigran.fem.throw import throw

HELP = "a sphere on a rigid plane, or a rigid cylinder on a body, by finite elements"


def add_arguments(command: argparse.ArgumentParser) -> None:
    kinds = command.add_subparsers(dest="kind", required=True, metavar="press|throw|cylinder")
    slow = kinds.add_parser("press", help="press the sphere slowly, and let it go")
    add_metal(slow)
    slow.add_argument(
        "--force-ratio",
        type=positive,
        nargs="+",
        required=True,
        help="largest forces over the force at yield, increasing",
    )
    fast = kinds.add_parser("throw", help="throw the sphere at the plane")
    add_metal(fast, elastic=True)
    fast.add_argument("--speed", type=positive, required=True, help="m/s")
    for command in (slow, fast):
        add_strain(command)
    add_cylinder(kinds.add_parser("cylinder", help="let a rigid cylinder strike a body"))


def run(arguments: argparse.Namespace) -> None:
    if arguments.kind == "cylinder":
        numbers = cylinder(arguments)
    else:
        sphere = HertzSphere(metal(arguments), arguments.radius)
        numbers = {"press": _press, "throw": _throw}[arguments.kind](sphere, arguments)
    if arguments.json:
        print(json.dumps(numbers))
        return
    for row in numbers.get("unloadings", [numbers]):
        for name, value in row.items():
            if isinstance(value, float):
                print(f"{name:28s} {value:.5g}")


def _press(sphere: HertzSphere, arguments: argparse.Namespace) -> dict:
    forces = [ratio * sphere.yield_force for ratio in arguments.force_ratio]
    if arguments.force_ratio[-1] <= 1:
        _say(f"{forces[-1]:.4g} N does not reach yield, which begins at {sphere.yield_force:.4g} N")
    found = computed(press, sphere.material, sphere.radius, forces, strain=arguments.strain)
    return found.to_dict()


def _throw(sphere: HertzSphere, arguments: argparse.Namespace) -> dict:
    if sphere.material.hardening and arguments.speed <= sphere.yield_speed:
        _say(
            f"{arguments.speed:g} m/s does not reach yield, which begins at "
            f"{sphere.yield_speed:.4g} m/s"
        )
    case = (sphere.material, sphere.radius, arguments.speed)
    return computed(throw, *case, strain=arguments.strain).to_dict()


def _say(line: str) -> None:
    print(f"plastigran: {line}", file=sys.stderr)
