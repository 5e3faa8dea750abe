# SPDX-License-Identifier: GPL-2.0-or-later
"""Arguments of `plastigran fem cylinder`, and its impact."""

from __future__ import annotations

import argparse

from plastigran.cli.arguments import positive
from plastigran.cli.metal import add_metal, add_strain, computed, metal, say
from plastigran.fem.cylinder.case import CylinderStrike
from plastigran.fem.cylinder.strike import strike


def add_cylinder(command: argparse.ArgumentParser) -> None:
    """Add the material of the body, the cylinder and its motion."""
    add_metal(command, elastic=True, radius=None)
    command.add_argument("--length", type=positive, required=True, help="length of the cylinder, m")
    command.add_argument(
        "--mass", type=positive, required=True, help="mass that moves with the cylinder, kg"
    )
    command.add_argument("--speed", type=positive, required=True, help="speed toward the body, m/s")
    command.add_argument(
        "--sliding-speed", type=float, default=0.0, help="speed along the surface, m/s"
    )
    command.add_argument("--coefficient-of-friction", type=float, default=0.0, help="default 0")
    add_strain(command)
    command.add_argument(
        "--thickness",
        type=positive,
        help="thickness of the body, m; by default no wave returns from its far side",
    )


def cylinder(arguments: argparse.Namespace) -> dict:
    """Return the results of the impact that the arguments describe."""
    names = (
        "radius",
        "length",
        "mass",
        "speed",
        "sliding_speed",
        "coefficient_of_friction",
        "thickness",
    )
    given = {name: getattr(arguments, name) for name in names}
    case = CylinderStrike(material=metal(arguments), **given)
    force = case.line.impact_force(case.mass, case.speed)
    if case.material.hardening is not None and force <= case.line.yield_force:
        say(
            f"speed {case.speed:g} m/s is too low for yield: the contact force is "
            f"{case.line.yield_force:.4g} N at yield, but reaches only {force:.4g} N"
        )
    return computed(strike, case, strain=arguments.strain).to_dict()
