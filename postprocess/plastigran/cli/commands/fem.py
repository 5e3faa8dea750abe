# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran fem`: one sphere on a rigid plane by finite elements, pressed or thrown."""

from __future__ import annotations

import argparse
import json
import sys
import warnings

from plastigran.cli.arguments import positive
from plastigran.fem.cache import cached
from plastigran.fem.hardening import LinearHardening
from plastigran.fem.hertz import HertzSphere
from plastigran.fem.limits import SmallStrainWarning
from plastigran.fem.material import ElasticPlastic
from plastigran.fem.press import press
from plastigran.fem.throw import throw

HELP = "a sphere on a rigid plane by finite elements, pressed or thrown"


def add_arguments(command: argparse.ArgumentParser) -> None:
    kinds = command.add_subparsers(dest="kind", required=True, metavar="press|throw")
    slow = kinds.add_parser("press", help="press the sphere slowly, and let it go")
    _add_metal(slow)
    slow.add_argument(
        "--force-ratio",
        type=positive,
        nargs="+",
        required=True,
        help="largest forces over the force at yield, increasing; in N for --elastic",
    )
    fast = kinds.add_parser("throw", help="throw the sphere at the plane")
    _add_metal(fast)
    fast.add_argument("--speed", type=positive, required=True, help="m/s")


def _add_metal(command: argparse.ArgumentParser) -> None:
    command.add_argument("--young", type=positive, required=True, help="Young's modulus, Pa")
    command.add_argument("--poisson", type=float, required=True, help="Poisson's ratio")
    command.add_argument("--density", type=positive, default=2700.0, help="kg/m3, default 2700")
    strength = command.add_mutually_exclusive_group(required=True)
    strength.add_argument("--yield", type=positive, dest="yield_stress", help="yield stress, Pa")
    strength.add_argument("--elastic", action="store_true", help="the sphere does not yield")
    command.add_argument(
        "--hardening", type=float, default=0.0, help="plastic modulus d sigma/d eps_p, Pa"
    )
    command.add_argument("--radius", type=positive, default=0.1, help="m, default 0.1")
    command.add_argument("--json", action="store_true", help="all numbers, as JSON")


def run(arguments: argparse.Namespace) -> None:
    hardening = None
    if not arguments.elastic:
        hardening = LinearHardening(arguments.yield_stress, arguments.hardening)
    metal = ElasticPlastic(
        young=arguments.young,
        poisson=arguments.poisson,
        density=arguments.density,
        hardening=hardening,
    )
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always", SmallStrainWarning)
        numbers = {"press": _press, "throw": _throw}[arguments.kind](metal, arguments)
    for warning in said:
        print(f"plastigran: {warning.message}", file=sys.stderr)
    if arguments.json:
        print(json.dumps(numbers))
        return
    for row in numbers.get("unloadings", [numbers]):
        for name, value in row.items():
            if not isinstance(value, dict):
                print(f"{name:28s} {value:.5g}")


def _press(metal: ElasticPlastic, arguments: argparse.Namespace) -> dict:
    unit = 1.0 if arguments.elastic else HertzSphere(metal, arguments.radius).yield_force
    forces = [ratio * unit for ratio in arguments.force_ratio]
    return cached(press, metal, arguments.radius, forces, progress=sys.stderr.isatty()).to_dict()


def _throw(metal: ElasticPlastic, arguments: argparse.Namespace) -> dict:
    sphere = HertzSphere(metal, arguments.radius)
    if arguments.speed <= (0.0 if arguments.elastic else sphere.yield_speed):
        print(
            f"plastigran: {arguments.speed:g} m/s does not reach yield, which begins at "
            f"{sphere.yield_speed:.4g} m/s",
            file=sys.stderr,
        )
    progress = sys.stderr.isatty()
    return cached(throw, metal, arguments.radius, arguments.speed, progress=progress).to_dict()
