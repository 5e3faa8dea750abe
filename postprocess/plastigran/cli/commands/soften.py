# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran soften`: a softer material with the same restitution."""

from __future__ import annotations

import argparse
from pathlib import Path

from plastigran import materials
from plastigran.calibration.softening import (
    SOUND_OVERLAP,
    TIME_POWER,
    comparison,
    lowest_factor,
    resting_overlap,
    soften,
)
from plastigran.cli.arguments import (
    add_json,
    add_laws,
    add_material,
    positive,
    print_json,
    refuse_idle,
)
from plastigran.usable_laws import choose_laws

HELP = "compute a softer material with the same restitution, which allows longer time steps"
EXAMPLE = "plastigran soften --material steel --speedup 10 --radius 0.005 --speed 1"


def add_arguments(command: argparse.ArgumentParser) -> None:
    add_material(command)
    softness = command.add_mutually_exclusive_group(required=True)
    softness.add_argument(
        "--factor",
        type=positive,
        help="ratio of the softened to the original Young's modulus, at most 1",
    )
    softness.add_argument(
        "--speedup",
        type=positive,
        help="ratio of the softened to the original time step, instead of --factor",
    )
    command.add_argument("--radius", type=positive, required=True, help="radius of the grains, m")
    command.add_argument(
        "--speed",
        type=positive,
        required=True,
        help="closing speed of the fastest impacts of the run, m/s",
    )
    command.add_argument(
        "--depth",
        type=positive,
        help="depth of a bed at rest, m; the command then also checks the overlap under its weight",
    )
    add_laws(command, "spheres")
    command.add_argument("--output", type=Path, help="material file to write, NAME.in")
    command.add_argument("--force", action="store_true", help="overwrite the material file")
    add_json(command)


def run(arguments: argparse.Namespace) -> None:
    if arguments.output is None:
        refuse_idle(arguments, "--output", force=False)
    if arguments.speedup is not None and arguments.speedup < 1:
        raise ValueError(f"--speedup is {arguments.speedup:g}; it must be at least 1")
    material = materials.read_material(arguments.material)
    factor = arguments.factor or arguments.speedup ** (1 / TIME_POWER)
    softened = soften(material, factor)
    names = choose_laws(arguments.law, "sphere", [material])
    table = comparison(material, factor, arguments.radius, arguments.speed, names)
    overlaps = {"impact": [float(table[name].max()) for name in ("overlap", "overlap_softened")]}

    def overlap_at_rest(factor: float) -> float:
        bed = soften(material, factor), arguments.radius, arguments.depth
        return max(resting_overlap(*bed, law=name) for name in names)

    if arguments.depth:
        overlaps["rest"] = [overlap_at_rest(1), overlap_at_rest(factor)]
    at_rest = overlap_at_rest if arguments.depth else None
    lowest = lowest_factor(overlaps["impact"][0], at_rest)
    speedup = factor**TIME_POWER
    numbers = {
        "factor": factor,
        "speedup": speedup,
        "material": softened.variables(),
        "overlap_softened": {name: after for name, (_, after) in overlaps.items()},
        "sound_to_factor": lowest,
        "laws": table.to_dict("records"),
    }
    if arguments.output:
        remark = (
            f"{material.name} with {factor:g} times its Young's modulus and the same restitution."
        )
        materials.write_material(softened, arguments.output, remark, force=arguments.force)
    if arguments.json:
        print_json(numbers)
        return
    print(materials.material_lines(softened))
    if arguments.output:
        print(f"\nwritten: {arguments.output}")
    print(
        f"\nTime steps are {speedup:.4g} times as long. Overlaps divided by the radius:\n"
        + "\n".join(
            f"  {name:8s} {before:.2g} -> {after:.2g}" for name, (before, after) in overlaps.items()
        )
    )
    verdict = (
        "acceptable" if factor >= lowest else "TOO SOFT: the grains do not behave like hard grains"
    )
    print(
        # With the factor 1.0005, rounding to four digits never gives a factor that is too low.
        f"  {verdict}. The lowest acceptable factor is {1.0005 * lowest:.4g}, at which the largest "
        f"overlap of a law is {SOUND_OVERLAP:g} of the radius"
    )
    print(
        "\nlaw                    restitution      softened  largest change  step, s  softened, s"
    )
    for row in numbers["laws"]:
        change = f"{row['restitution_change']:.3f}" if row["restitution_change"] else "exact"
        remark = "" if row["in_range_softened"] else "  outside the law's range"
        if remark and not row["in_range"]:
            remark += ", also before softening"
        print(
            f"{row['law']:20s} {row['coefficient_of_restitution']:13.4f} "
            f"{row['coefficient_of_restitution_softened']:13.4f} {change:>15s} "
            f"{row['timestep']:8.2g} {row['timestep_softened']:12.2g}{remark}"
        )
