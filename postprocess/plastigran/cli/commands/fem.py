# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran fem`: finite elements of a sphere or a cylinder.

`press` compresses a sphere on a plane or a half space; `throw` computes an impact of this sphere.
`vibrate` computes the vibration of an elastic sphere during and after an impact on a plane.
`cylinder` computes the impact of a rigid cylinder on a body.
"""

from __future__ import annotations

import argparse
from itertools import pairwise

import pandas as pd

from plastigran.cli.arguments import add_subcommand, positive, print_json
from plastigran.cli.metal import (
    add_elastic,
    add_metal,
    add_plane,
    add_strain,
    computed,
    metal,
    plane,
    say,
)
from plastigran.fem.cylinder.case import CylinderStrike
from plastigran.fem.cylinder.strike import strike
from plastigran.fem.sphere.press import press
from plastigran.fem.sphere.throw import throw
from plastigran.fem.sphere.vibrate import TRANSITS, vibrate
from plastigran.fem.sphere.vibration import SIGNALS, Vibration
from plastigran.fem.theory.hertz import HertzSphere
from plastigran.physics.impact_modes import impact_modes, nearest_modes

HELP = "compute a sphere on a plane, or a rigid cylinder on a body, by finite elements"
EXAMPLE = """
plastigran fem throw --young 2.1e11 --poisson 0.3 --density 7850 --yield 3e8 --radius 0.01 \\
    --speed 0.1
plastigran fem press --help
"""

#: Text after each printed number: its unit, or an explanation of a ratio.
UNITS = {
    "force": "N",
    "force_max": "N",
    "force_ratio": "times the yield force",
    "yield_force": "N",
    "radius": "m",
    "approach": "m",
    "contact_radius": "m",
    "residual_approach": "m",
    "overlap_max": "m",
    "overlap_res": "m",
    "residual_depth": "m",
    "thickness": "m",
    "work_loading": "J",
    "work_unloading": "J",
    "speed": "m/s",
    "timestep": "s",
    "kinetic_restitution": (
        "restitution from the kinetic energy, which includes half of the vibration energy"
    ),
    "nodal_restitution": (
        "restitution from the mean velocity of the corner nodes, which includes the vibration"
    ),
    "vibration_energy": "fraction of the impact energy",
    "contact_time": "s",
    "coefficient_of_restitution": "restitution from the momentum of the center of mass",
}

#: Units of columns in printed tables.
COLUMNS = {"frequency": "Hz", "measured": "Hz", "energy": "J"}


def add_arguments(command: argparse.ArgumentParser) -> None:
    """Add a subcommand for each finite-element computation."""
    computations = command.add_subparsers(
        dest="kind", required=True, metavar="press|throw|vibrate|cylinder"
    )
    steel = "--young 2.1e11 --poisson 0.3 --density 7850"
    press_command = add_subcommand(
        computations,
        "press",
        "quasi-static compression and unloading of a sphere on a plane",
        f"plastigran fem press {steel} --yield 3e8 --radius 0.01 --force-ratio 10 40",
    )
    add_metal(press_command)
    press_command.add_argument(
        "--force-ratio",
        type=positive,
        nargs="+",
        required=True,
        help="largest force before each unloading, as a multiple of the yield force; give the "
        "values in increasing order",
    )
    throw_command = add_subcommand(
        computations,
        "throw",
        "impact of a sphere on a plane",
        f"plastigran fem throw {steel} --yield 3e8 --radius 0.01 --speed 0.1",
    )
    add_metal(throw_command)
    _add_speed(throw_command, "impact speed, m/s")
    for sphere_command in (press_command, throw_command):
        add_plane(sphere_command)
        add_strain(sphere_command)
    cylinder_command = add_subcommand(
        computations,
        "cylinder",
        "impact of a rigid cylinder on a body",
        f"plastigran fem cylinder {steel} --yield 3e8 --radius 1e-5 --length 1e-4 \\\n"
        "    --mass 1.6e-6 --speed 0.5",
    )
    _add_cylinder(cylinder_command)
    vibrate_command = add_subcommand(
        computations,
        "vibrate",
        "impact of an elastic sphere on a plane, with its vibration",
        f"plastigran fem vibrate {steel} --radius 0.01 --speed 0.5",
    )
    add_elastic(vibrate_command)
    _add_speed(vibrate_command, "impact speed, m/s")
    vibrate_command.add_argument(
        "--transits",
        type=positive,
        default=TRANSITS,
        help="duration of the computation after the rebound, as a multiple of the time in which a "
        f"compression wave crosses the sphere, default {TRANSITS:g}",
    )
    press_command.set_defaults(compute=_press)
    throw_command.set_defaults(compute=_throw)
    cylinder_command.set_defaults(compute=_cylinder)
    vibrate_command.set_defaults(compute=_vibrate)


def _add_speed(command: argparse.ArgumentParser, meaning: str) -> None:
    command.add_argument("--speed", type=positive, required=True, help=meaning)


def _add_cylinder(command: argparse.ArgumentParser) -> None:
    add_metal(command, radius=None)
    command.add_argument("--length", type=positive, required=True, help="length of the cylinder, m")
    command.add_argument(
        "--mass", type=positive, required=True, help="mass that moves with the cylinder, kg"
    )
    _add_speed(command, "speed toward the body, m/s")
    command.add_argument(
        "--sliding-speed", type=float, default=0.0, help="speed along the surface, m/s, default 0"
    )
    command.add_argument(
        "--coefficient-of-friction",
        type=float,
        default=0.0,
        help="coefficient of friction, default 0",
    )
    add_strain(command)
    command.add_argument(
        "--thickness",
        type=positive,
        help="thickness of the body, m; default: so thick that no wave returns from its far side",
    )


def run(arguments: argparse.Namespace) -> None:
    """Run the computation and print its results, as numbers with units or as JSON.

    Raises:
        ValueError: An argument is out of range, or the first increment does not converge.
    """
    numbers = arguments.compute(arguments)
    if arguments.json:
        print_json(numbers)
        return
    for row in numbers.get("unloadings", [numbers]):
        for name, value in row.items():
            if isinstance(value, float):
                print(f"{name:28s} {value:<12.5g} {UNITS[name]}".rstrip())
    for name in ("modes", *(f"{signal}_peaks" for signal in SIGNALS)):
        if name in numbers:
            table = pd.DataFrame(numbers[name]).rename(
                columns=lambda column: (
                    f"{column}, {COLUMNS[column]}" if column in COLUMNS else column
                )
            )
            shown = table.to_string(index=False, float_format="{:.6g}".format)
            print(f"\n{name.replace('_', ' ')}\n{shown}")


def _sphere(arguments: argparse.Namespace) -> HertzSphere:
    return HertzSphere(metal(arguments), arguments.radius, plane(arguments))


def _press(arguments: argparse.Namespace) -> dict:
    sphere, ratios = _sphere(arguments), arguments.force_ratio
    if sphere.yielding is None:
        raise ValueError("neither body yields, but --force-ratio needs a yield force. Add --yield")
    for before, ratio in pairwise(ratios):
        if ratio <= before:
            raise ValueError(
                f"--force-ratio: {ratio:g} follows {before:g}, but ratios must increase"
            )
    forces = [ratio * sphere.yield_force for ratio in ratios]
    if ratios[-1] <= 1:
        say(
            f"the largest force, {forces[-1]:.4g} N, is below the yield force, "
            f"{sphere.yield_force:.4g} N, so that no body yields"
        )
    case = (sphere.material, sphere.radius, forces)
    numbers = computed(press, *case, strain=arguments.strain, plane=sphere.plane).to_dict()
    for row in numbers["unloadings"]:
        row["force_ratio"] = row["force"] / sphere.yield_force
    return numbers


def _throw(arguments: argparse.Namespace) -> dict:
    sphere = _sphere(arguments)
    if sphere.yielding and arguments.speed <= sphere.yield_speed:
        say(f"speed {arguments.speed:g} m/s is below the yield speed, {sphere.yield_speed:.4g} m/s")
    case = (sphere.material, sphere.radius, arguments.speed)
    return computed(throw, *case, strain=arguments.strain, plane=sphere.plane).to_dict()


def _cylinder(arguments: argparse.Namespace) -> dict:
    case = CylinderStrike(
        material=metal(arguments),
        radius=arguments.radius,
        length=arguments.length,
        mass=arguments.mass,
        speed=arguments.speed,
        sliding_speed=arguments.sliding_speed,
        coefficient_of_friction=arguments.coefficient_of_friction,
        thickness=arguments.thickness,
    )
    force = case.line.impact_force(case.mass, case.speed)
    if case.material.hardening is not None and force <= case.line.yield_force:
        say(
            f"speed {case.speed:g} m/s is too low for yield: the contact force is "
            f"{case.line.yield_force:.4g} N at yield, but reaches only {force:.4g} N"
        )
    return computed(strike, case, strain=arguments.strain).to_dict()


def _vibrate(arguments: argparse.Namespace) -> dict:
    sphere = _sphere(arguments)
    result: Vibration = computed(
        vibrate, sphere.material, sphere.radius, arguments.speed, arguments.transits
    )
    numbers, material = result.to_dict(), result.material
    exact = impact_modes(
        material.youngs_modulus,
        material.poissons_ratio,
        material.density,
        result.radius,
        1.1 * result.modes["frequency"].max(),
    )
    for name, table in numbers.items():
        if name == "modes" or name.endswith("_peaks"):
            rest = {column: table[column] for column in ("energy", "amplitude") if column in table}
            nearest = nearest_modes(table["frequency"], exact).drop(columns=["ka", "ha"])
            numbers[name] = nearest.to_dict("list") | rest
    return numbers
