# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran cylinder`: the cylinder study."""

from __future__ import annotations

import argparse

from plastigran.cli.arguments import add_output, fresh_folder, positive_integer

HELP = "the cylinder study: maps and comparison"


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--points",
        type=positive_integer,
        default=30,
        help="radii and speeds of a map, default 30",
    )
    add_output(command, "results/cylinder")


def run(arguments: argparse.Namespace) -> None:
    """The cylinder study: maps, and the finite elements' impact."""
    from plastigran.experiments import (
        cylinder,  # matplotlib is slow to load
        cylinder_figures,  # matplotlib is slow to load
    )
    from plastigran.plot import style  # matplotlib is slow to load

    folder = fresh_folder(arguments.output, arguments.force, "comparison.csv")
    maps, table = cylinder.run(folder, arguments.points)
    print("Cylinder of 10 um, 0.1 mm long, at 1 m/s: laws, engine and finite elements")
    print(table.T.to_string(float_format="{:.4g}".format, na_rep=""))
    written = [folder / "maps.csv", folder / "comparison.csv"]
    for ratio, part in maps.groupby("length_ratio"):
        written += style.save(cylinder_figures.maps_figure(part), folder / f"maps_{ratio:g}")
    written += style.save(cylinder_figures.comparison_figure(), folder / "comparison")
    print("\nwritten: " + "  ".join(str(path) for path in written))
