# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran fem`: finite elements of a sphere or a cylinder.

A sphere on a plane or a half space is compressed, hits it, or hits it and vibrates. A rigid
cylinder
hits a body.
"""

from __future__ import annotations

import argparse
from itertools import pairwise

import pandas as pd

from plastigran.cli.arguments import Subparsers, positive, print_json
from plastigran.cli.cylinder import add_cylinder, cylinder
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

#: Units of printed numbers; for ratios, the reference.
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
    "kinetic_restitution": "by kinetic energy, with half the vibration",
    "nodal_restitution": "by the mean velocity of corner nodes, with the vibration",
    "vibration_energy": "fraction of the impact energy",
    "contact_time": "s",
    "coefficient_of_restitution": "by momentum, of the center of mass",
}

#: Units of table columns.
COLUMNS = {"frequency": "Hz", "found": "Hz", "energy": "J"}


def add_arguments(command: argparse.ArgumentParser) -> None:
    """Add a command for each kind of computation."""
    kinds = Subparsers(
        command.add_subparsers(dest="kind", required=True, metavar="press|throw|vibrate|cylinder")
    )
    steel = "--young 2.1e11 --poisson 0.3 --density 7850"
    slow = kinds.add(
        "press",
        "quasi-static compression and unloading of the sphere",
        f"plastigran fem press {steel} --yield 3e8 --radius 0.01 --force-ratio 10 40",
    )
    add_metal(slow, elastic=True)
    slow.add_argument(
        "--force-ratio",
        type=positive,
        nargs="+",
        required=True,
        help="largest forces as multiples of the yield force, increasing",
    )
    fast = kinds.add(
        "throw",
        "impact of the sphere on the plane",
        f"plastigran fem throw {steel} --yield 3e8 --radius 0.01 --speed 0.1",
    )
    add_metal(fast, elastic=True)
    fast.add_argument("--speed", type=positive, required=True, help="impact speed, m/s")
    for command in (slow, fast):
        add_plane(command)
        add_strain(command)
    add_cylinder(
        kinds.add(
            "cylinder",
            "impact of a rigid cylinder on a body",
            f"plastigran fem cylinder {steel} --yield 3e8 --radius 1e-5 --length 1e-4 \\\n"
            "    --mass 1.6e-6 --speed 0.5",
        )
    )
    ringing = kinds.add(
        "vibrate",
        "impact of an elastic sphere, with its vibration",
        f"plastigran fem vibrate {steel} --radius 0.01 --speed 0.5",
    )
    add_elastic(ringing)
    ringing.add_argument("--speed", type=positive, required=True, help="impact speed, m/s")
    ringing.add_argument(
        "--transits",
        type=positive,
        default=TRANSITS,
        help="duration of the flight divided by the time in which a compression wave crosses "
        f"the sphere, default {TRANSITS:g}",
    )


def run(arguments: argparse.Namespace) -> None:
    """Compute, and print the numbers with their units, or all of them as JSON.

    Raises:
        ValueError: An argument is out of range, or the first increment does not converge.
    """
    if arguments.kind == "cylinder":
        numbers = cylinder(arguments)
    else:
        sphere = HertzSphere(metal(arguments), arguments.radius, plane(arguments))
        kinds = {"press": _press, "throw": _throw, "vibrate": _vibrate}
        numbers = kinds[arguments.kind](sphere, arguments)
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


def _press(sphere: HertzSphere, arguments: argparse.Namespace) -> dict:
    if sphere.yielding is None:
        raise ValueError("neither body yields, but --force-ratio is a multiple of the yield force")
    ratios = arguments.force_ratio
    for before, ratio in pairwise(ratios):
        if ratio <= before:
            raise ValueError(f"force-ratio {ratio:g} follows {before:g}; they must increase")
    forces = [ratio * sphere.yield_force for ratio in ratios]
    if ratios[-1] <= 1:
        say(f"{forces[-1]:.4g} N is below the yield force, {sphere.yield_force:.4g} N")
    case = (sphere.material, sphere.radius, forces)
    numbers = computed(press, *case, strain=arguments.strain, plane=sphere.plane).to_dict()
    for row in numbers["unloadings"]:
        row["force_ratio"] = row["force"] / sphere.yield_force
    return numbers


def _throw(sphere: HertzSphere, arguments: argparse.Namespace) -> dict:
    if sphere.yielding and arguments.speed <= sphere.yield_speed:
        say(f"{arguments.speed:g} m/s is below the yield speed, {sphere.yield_speed:.4g} m/s")
    case = (sphere.material, sphere.radius, arguments.speed)
    return computed(throw, *case, strain=arguments.strain, plane=sphere.plane).to_dict()


def _vibrate(sphere: HertzSphere, arguments: argparse.Namespace) -> dict:
    found: Vibration = computed(
        vibrate, sphere.material, sphere.radius, arguments.speed, arguments.transits
    )
    numbers = found.to_dict()
    material = found.material
    exact = impact_modes(
        material.youngs_modulus,
        material.poissons_ratio,
        material.density,
        found.radius,
        1.1 * found.modes["frequency"].max(),
    )
    for name, table in numbers.items():
        if name == "modes" or name.endswith("_peaks"):
            rest = {column: table[column] for column in ("energy", "amplitude") if column in table}
            nearest = nearest_modes(table["frequency"], exact).drop(columns=["ka", "ha"])
            numbers[name] = nearest.to_dict("list") | rest
    return numbers
