# SPDX-License-Identifier: GPL-2.0-or-later
"""The command `plastigran`: thin faces over functions a notebook can call."""

from __future__ import annotations

import argparse
import sys
from math import inf
from pathlib import Path

import numpy as np
import pandas as pd

from plastigran import laws, materials, rod_runs
from plastigran.collision import CollisionError
from plastigran.dumps import DumpError
from plastigran.engine import PROJECT, EngineError
from plastigran.impact import GEOMETRIES, PAPER_SPEEDS, Impact, laws_for, plan, sweep
from plastigran.modes import sphere_modes
from plastigran.rod import PAPER_RODS, Rod

TABLE = [
    "material",
    "law",
    "angle",
    "speed",
    "speed_ratio",
    "coefficient_of_restitution",
    "coefficient_of_restitution_predicted",
    "angular_velocity",
    "angular_velocity_predicted",
    "force_max",
    "overlap_max",
    "overlap_res",
    "contact_time",
]
SHORT = {
    "angle": "angle\ndeg",
    "speed": "speed\nm/s",
    "speed_ratio": "v/v_Y",
    "coefficient_of_restitution": "COR",
    "coefficient_of_restitution_predicted": "COR\ntheory",
    "angular_velocity": "rad/s",
    "angular_velocity_predicted": "rad/s\ntheory",
    "force_max": "peak force\nN",
    "overlap_max": "overlap\nmax, m",
    "overlap_res": "overlap\nresidual, m",
    "contact_time": "contact\ntime, s",
}


class UsageError(ValueError):
    """A command line that cannot be carried out."""


def positive(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number") from None
    if not 0 < value < inf:
        raise argparse.ArgumentTypeError(f"{text} is not positive and finite")
    return value


def positive_integer(text: str) -> int:
    try:
        value = int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number") from None
    if value < 1:
        raise argparse.ArgumentTypeError(f"{text} is not 1 or more")
    return value


def format_table(table: pd.DataFrame) -> str:
    """A results table as text: names and units in two head lines, five digits."""
    columns = [c for c in TABLE if c in table and not table[c].isna().all()]
    heads = [(SHORT.get(c, c) + "\n").split("\n")[:2] for c in columns]
    cells = [
        [f"{value:.5g}" if isinstance(value, float) else str(value) for value in line]
        for line in table[columns].itertuples(index=False)
    ]
    head_lines = [[head[k] for head in heads] for k in (0, 1)]
    widths = [max(len(line[k]) for line in [*head_lines, *cells]) for k in range(len(columns))]
    lines = [
        "  ".join(cell.rjust(width) for cell, width in zip(line, widths, strict=True))
        for line in [*head_lines, *cells]
    ]
    lines.insert(2, "-" * len(lines[0]))
    return "\n".join(lines)


def law_names(given: list[str], material_names: list[str]) -> list[str]:
    """Names from the command line; "all" stands for every law for spheres the materials have
    constants for."""
    bodies = [materials.read_material(material) for material in material_names]
    names = list(dict.fromkeys(given))
    if "all" in given:
        spheres = laws_for("sphere")
        names = [n for n in spheres if all(not body.missing(n) for body in bodies)]
        if left := sorted(set(spheres) - set(names)):
            print(
                f"left out, for the material lacks their constants: {', '.join(left)}",
                file=sys.stderr,
            )
    for name in names:
        if name not in laws.LAWS:
            raise UsageError(f"no law {name!r}; there are {', '.join(sorted(laws.LAWS))}")
    return names


def fresh_folder(folder: Path, force: bool, table: str = "impacts.csv") -> Path:
    """A folder for results: never one that holds some, unless forced."""
    if (folder / table).exists() and not force:
        raise UsageError(f"{folder} holds results; choose another --output, or add --force")
    return folder


def print_range(table: pd.DataFrame) -> None:
    """Say from which speed on a law was used beyond its range."""
    outside = table.loc[~table["in_range"], ["law", "speed"]]
    for law, speeds in outside.groupby("law")["speed"]:
        print(
            f"outside the range of {law} ({laws.LAWS[law].range}): {speeds.min():g} m/s and faster"
        )


def run_impacts(impacts: list[Impact], folder: Path, jobs: int | None) -> pd.DataFrame:
    """Sweep, table, figures."""
    from plastigran import figures  # matplotlib is slow to load

    table, collisions = sweep(impacts, folder, jobs)
    print(format_table(table))
    print_range(table)
    written = [folder / "impacts.csv"]
    written += figures.save(figures.restitution_figure(table, impacts), folder / "restitution")
    written += figures.save(figures.loops_figure(collisions), folder / "loops")
    print("\nwritten: " + "  ".join(str(path) for path in written))
    return table


def impact_command(arguments: argparse.Namespace) -> None:
    speeds = arguments.speed or np.geomspace(*arguments.speeds, arguments.points)
    impacts = plan(
        law_names(arguments.law, arguments.material),
        speeds,
        arguments.material,
        arguments.radius,
        arguments.geometry,
    )
    run_impacts(impacts, fresh_folder(arguments.output, arguments.force), arguments.jobs)


def paper_rod(angle: float, friction: float | None) -> Rod:
    """The paper's rod at an angle [degrees], with the friction the paper gives for it or another.

    Raises:
        UsageError: The paper gives none.
    """
    if friction is not None:
        return Rod(angle=angle, friction=friction)
    for rod in PAPER_RODS:
        if rod.angle == angle:
            return rod
    known = " and ".join(f"{rod.angle:g}" for rod in PAPER_RODS)
    raise UsageError(f"the paper gives friction at {known} degrees only; add --friction")


def rod_command(arguments: argparse.Namespace) -> None:
    from plastigran import figures, rod_figures  # matplotlib is slow to load

    rods = [paper_rod(angle, arguments.friction) for angle in arguments.angle]
    names = law_names(arguments.law, [rods[0].material.name])
    runs = rod_runs.plan(names, arguments.speed, rods, arguments.tangential)
    folder = fresh_folder(arguments.output, arguments.force)
    table, impacts = sweep(runs, folder, arguments.jobs)
    print(format_table(table))
    print_range(table)
    run = rod_figures.closest_to_measured(impacts)
    written = [folder / "impacts.csv"]
    for name, figure in (
        ("outcome", rod_figures.outcome_figure(table)),
        ("deformation", rod_figures.deformation_figure(table)),
        ("motion", rod_figures.motion_figure(run, impacts[run])),
    ):
        written += figures.save(figure, folder / name)
    print("\nwritten: " + "  ".join(str(path) for path in written))


def laws_command(_: argparse.Namespace) -> None:
    for name, law in sorted(laws.LAWS.items()):
        engine_own = " (the engine's own model)" if name == "hertz" else ""
        print(f"{name}{engine_own}, for {law.geometry}s")
        print(f"  source  {law.source}\n  range   {law.range}")
        for p in law.parameters():
            default = "required" if p["default"] is None else f"default {p['default']:g}"
            print(
                f"  {p['property']} [{p['unit']}], {default}, "
                f"{p['lower']:g} to {p['upper']:g}: {p['meaning']}"
            )
        for o in law.options():
            choices = "|".join(o["choices"])
            print(f"  {o['name']} {choices}, default {o['default']}: {o['meaning']}")
        print()


def timestep_command(arguments: argparse.Namespace) -> None:
    material = materials.read_material(arguments.material)
    for name in law_names(arguments.law, [arguments.material]):
        impact = Impact(name, arguments.speed, material, arguments.radius, arguments.geometry)
        print(f"{name:20s} {impact.time_step():.4g} s")


def modes_command(arguments: argparse.Namespace) -> None:
    material = materials.read_material(arguments.material)
    table = sphere_modes(
        material.youngs_modulus,
        material.poissons_ratio,
        material.density,
        arguments.radius,
        range(arguments.degree + 1),
        arguments.overtones,
    )
    table = table.rename(columns={"frequency": "frequency, Hz"})
    print(table.to_string(index=False, float_format="{:.6g}".format))


def cylinder_command(arguments: argparse.Namespace) -> None:
    """The cylinder study: maps, and the finite elements' impact."""
    from plastigran import cylinder  # matplotlib is slow to load

    folder = fresh_folder(arguments.output, arguments.force, "comparison.csv")
    table, written = cylinder.run(folder, arguments.points)
    print("Cylinder of 10 um, 0.1 mm long, at 1 m/s: laws, engine and finite elements")
    print(table.T.to_string(float_format="{:.4g}".format, na_rep=""))
    print("\nwritten: " + "  ".join(str(path) for path in written))


def demo_command(arguments: argparse.Namespace) -> None:
    """The paper's sphere over four decades of speed; then one impact through every geometry."""
    folder = arguments.output
    names = law_names(["all"], ["aluminium_zv02"])
    run_impacts(
        plan(names, PAPER_SPEEDS, ["aluminium_zv02"], 0.1),
        folder / "speeds",
        arguments.jobs,
    )
    print("\nThe same impact, 0.1 m/s, as a pair, on a primitive wall and on a mesh:")
    through = [
        impact
        for geometry in GEOMETRIES
        for impact in plan(names, [0.1], ["aluminium_zv02"], 0.1, geometry)
    ]
    table, _ = sweep(through, folder / "geometries", arguments.jobs, progress=False)
    pivot = table.pivot(index="law", columns="geometry", values="coefficient_of_restitution")
    print(pivot.rename_axis(index=None, columns=None).to_string(float_format="{:.6f}".format))
    print(f"\nLook at {folder / 'speeds' / 'restitution.png'}")


def chung_ooi_command(arguments: argparse.Namespace) -> None:
    """The benchmark impacts of Chung & Ooi: a table and a figure each, and how far off theory."""
    from plastigran import chung_ooi, chung_ooi_figures, figures  # matplotlib is slow to load

    folder = arguments.output
    if (folder / "agreement.csv").exists() and not arguments.force:
        raise UsageError(f"{folder} holds results; choose another --output, or add --force")
    chosen = [case for case in chung_ooi.cases() if case.benchmark in arguments.benchmark]
    table, collisions = chung_ooi.run_cases(
        chosen, folder / "runs", arguments.law, arguments.steps, arguments.jobs
    )
    for number, part in table.groupby("benchmark"):
        name = folder / f"benchmark_{number}"
        part.dropna(axis="columns", how="all").to_csv(name.with_suffix(".csv"), index=False)
        figures.save(chung_ooi_figures.figure(number, table, collisions), name)
    agreement = chung_ooi.agreement(table)
    agreement.to_csv(folder / "agreement.csv")
    print("Largest deviations from theory:\n")
    print(agreement.to_string(float_format="{:.1e}".format, na_rep=""))
    print(f"\nwritten: {folder}: agreement.csv, benchmark_*.csv, .png, .svg")


def parser() -> argparse.ArgumentParser:
    top = argparse.ArgumentParser(
        prog="plastigran", description="Elasto-plastic contact laws for LIGGGHTS: runs and checks."
    )
    commands = top.add_subparsers(dest="command", required=True)

    def common(command: argparse.ArgumentParser) -> None:
        command.add_argument(
            "--law",
            nargs="+",
            default=["all"],
            metavar="LAW",
            help="laws, or all (default) that the material has the constants for",
        )
        command.add_argument("--radius", type=positive, default=0.1, help="m, default 0.1")
        command.add_argument(
            "--geometry",
            choices=list(GEOMETRIES),
            default="sphere_wall",
            help="default sphere_wall",
        )

    impact = commands.add_parser("impact", help="run collisions in the engine, table and figures")
    common(impact)
    impact.add_argument("--speed", nargs="+", type=positive, help="impact speeds, m/s")
    impact.add_argument(
        "--speeds",
        nargs=2,
        type=positive,
        default=(0.001, 0.2),
        metavar=("LOW", "HIGH"),
        help="range of speeds when --speed is not given, m/s, default 0.001 0.2",
    )
    impact.add_argument(
        "--points", type=positive_integer, default=9, help="speeds in it, default 9"
    )
    impact.add_argument(
        "--material", nargs="+", default=["aluminium_zv02"], help=f"{', '.join(materials.names())}"
    )
    impact.add_argument("--jobs", type=positive_integer, help="engines at a time, default: cores")
    impact.add_argument("--output", type=Path, default=Path("results/impact"))
    impact.add_argument("--force", action="store_true", help="overwrite results")
    impact.set_defaults(run=impact_command)

    rod = commands.add_parser("rod", help="drop the paper's oblique rod, table and figures")
    rod.add_argument("--law", nargs="+", default=["all"], metavar="LAW", help="default all")
    rod.add_argument("--speed", nargs="+", type=positive, default=rod_runs.PAPER_SPEEDS, help="m/s")
    rod.add_argument(
        "--angle",
        nargs="+",
        type=positive,
        default=[paper.angle for paper in PAPER_RODS],
        help="between rod and flat, degrees, default the paper's",
    )
    rod.add_argument("--friction", type=positive, help="default the paper's at each angle")
    rod.add_argument(
        "--tangential", choices=rod_runs.TANGENTIAL, default="history", help="default history"
    )
    rod.add_argument("--jobs", type=positive_integer, help="engines at a time, default: cores")
    rod.add_argument("--output", type=Path, default=Path("results/rod"))
    rod.add_argument("--force", action="store_true", help="overwrite results")
    rod.set_defaults(run=rod_command)

    listing = commands.add_parser("laws", help="list the laws, their constants and ranges")
    listing.set_defaults(run=laws_command)

    timestep = commands.add_parser("timestep", help="recommended time step of an impact")
    common(timestep)
    timestep.add_argument("--speed", type=positive, required=True, help="impact speed, m/s")
    timestep.add_argument("--material", default="aluminium_zv02")
    timestep.set_defaults(run=timestep_command)

    modes = commands.add_parser("modes", help="free vibrations of an elastic sphere")
    modes.add_argument("--material", required=True, help=f"{', '.join(materials.names())}")
    modes.add_argument("--radius", type=positive, required=True, help="m")
    modes.add_argument(
        "--degree", type=positive_integer, default=4, help="highest degree, default 4"
    )
    modes.add_argument(
        "--overtones",
        type=positive_integer,
        default=3,
        help="modes of each kind and degree, default 3",
    )
    modes.set_defaults(run=modes_command)

    benchmarks = commands.add_parser(
        "chung-ooi", help="the eight benchmark impacts of Chung & Ooi (2011), against theory"
    )
    benchmarks.add_argument(
        "--benchmark", nargs="+", type=int, choices=range(1, 9), default=list(range(1, 9))
    )
    benchmarks.add_argument(
        "--law",
        default="vu_quoc_zhang",
        choices=laws_for("sphere"),
        metavar="LAW",
        help="any law for spheres, unyielding, default vu_quoc_zhang; hertz is the engine's own",
    )
    benchmarks.add_argument(
        "--steps", type=positive_integer, default=1000, help="time steps a contact, default 1000"
    )
    benchmarks.add_argument("--jobs", type=positive_integer)
    benchmarks.add_argument("--output", type=Path, default=Path("results/chung_ooi"))
    benchmarks.add_argument("--force", action="store_true", help="overwrite results")
    benchmarks.set_defaults(run=chung_ooi_command)
    cylinder = commands.add_parser("cylinder", help="the cylinder study: maps and comparison")
    cylinder.add_argument(
        "--points",
        type=positive_integer,
        default=30,
        help="radii and speeds of a map, default 30",
    )
    cylinder.add_argument("--output", type=Path, default=Path("results/cylinder"))
    cylinder.add_argument("--force", action="store_true", help="overwrite results")
    cylinder.set_defaults(run=cylinder_command)

    demo = commands.add_parser("demo", help="the tour: collisions and their figures")
    demo.add_argument("--output", type=Path, default=PROJECT / "results" / "demo")
    demo.add_argument("--jobs", type=positive_integer)
    demo.set_defaults(run=demo_command)
    return top


def main(argv: list[str] | None = None) -> int:
    """Entry point; 0 when all went well, 1 after an error, whose one line goes to stderr."""
    try:
        arguments = parser().parse_args(argv)
    except EngineError as error:  # the materials it lists are not where they should be
        print(f"plastigran: {error}", file=sys.stderr)
        return 1
    try:
        arguments.run(arguments)
    except BrokenPipeError:  # the reader of our output has had enough
        sys.stderr.close()
    except (EngineError, CollisionError, DumpError, ValueError, OSError) as error:
        print(f"plastigran: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        output = getattr(arguments, "output", None)
        kept = f"; what is finished is in {output}" if output else ""
        print(f"plastigran: stopped{kept}", file=sys.stderr)
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
