# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran demo`: run example simulations and write a report."""

from __future__ import annotations

import argparse
from pathlib import Path

from plastigran.cli.arguments import add_jobs
from plastigran.cli.commands.bulk import report
from plastigran.cli.experiments import show_study
from plastigran.engine.process import EngineError
from plastigran.engine.versions import versions
from plastigran.experiments.central import GEOMETRIES, PAPER_SPEEDS, CentralImpact
from plastigran.experiments.runs import sweep
from plastigran.materials import read_material
from plastigran.usable_laws import laws_for

HELP = "run examples: collisions, a cooling gas and a hopper, with figures and a report"
EXAMPLE = "plastigran demo --output results/demo"

#: Settings of the hopper run. Its soft grains overlap by up to a quarter of the effective radius
#: when they land. Of the accurate laws, only `jackson_green` is valid for such overlaps. The impact
#: speeds reach 27 yield speeds; the error of the restitution is then 4 % (docs/validation.md).
HOPPER = {"law": "jackson_green", "layers": "10", "frames": "20"}
#: Settings of the cooling gas in LAMMPS: a tenth of the duration of the run in LIGGGHTS.
TENTH = {"side": "8", "duration": "40", "rows": "40", "checkpoints": "4"}


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--output",
        type=Path,
        default=Path("results/demo"),
        help="folder of results, default results/demo; earlier results there are overwritten",
    )
    add_jobs(command)


def run(arguments: argparse.Namespace) -> None:
    """Run collisions, a cooling gas and a hopper of yielding grains, and write an HTML report."""
    # Import here, because matplotlib and plotly are slow to load.
    from plastigran.bulk.run import run_bulk
    from plastigran.plot.frame_files import find_frames
    from plastigran.plot.snapshot import draw
    from plastigran.report.page import write_report

    folder = arguments.output
    jobs, names = arguments.jobs, laws_for("sphere", [read_material("aluminium_zv02")])
    speeds = folder / "speeds"
    show_study(CentralImpact.study(speeds, jobs, force=True, law=names, speed=PAPER_SPEEDS), speeds)
    print("For comparison, the table includes impacts outside the validity range of a law.")
    print("\nRestitution at 0.1 m/s: sphere on a mesh, sphere on a primitive wall, two spheres")
    impacts = CentralImpact.plan(
        geometry=GEOMETRIES, law=names, speed=0.1, material="aluminium_zv02", radius=0.1
    )
    table = sweep(impacts, folder / "geometries", jobs, progress=False, force=True).table
    pivot = table.pivot(index="law", columns="geometry", values="coefficient_of_restitution")
    print(pivot.rename_axis(index=None, columns=None).to_string(float_format="{:.6f}".format))
    with_lammps = has_lammps()
    if with_lammps:
        collide_in_lammps(folder / "lammps")
    print("\nA freely cooling gas of 512 grains, on two ranks:")
    gas = folder / "cooling_gas"
    report(run_bulk("cooling_gas", {"side": "8", "frames": "16"}, gas, ranks=2, force=True))
    if with_lammps:
        print("\nThe first tenth of the run of the gas in LAMMPS:")
        lammps = folder / "cooling_gas_in_lammps"
        report(run_bulk("cooling_gas", TENTH, lammps, ranks=2, force=True, host="lammps"))
    print("\nHalf of 2080 yielding grains flow out of a hopper, on two ranks:")
    hopper = folder / "hopper"
    report(run_bulk("hopper", HOPPER, hopper, ranks=2, force=True))
    picture = hopper / "figures" / "grains.png"
    frames = find_frames(hopper)
    draw(frames[len(frames) // 2], picture, view="front")
    figures = [
        speeds / "restitution.png",
        gas / "figures" / "cooling_gas.png",
        hopper / "figures" / "hopper.png",
        hopper / "figures" / "ledger.png",
        picture,
    ]
    page = write_report([folder], folder / "report.html", "The demo")
    print(f"\nAll results on one page, to open in a browser:\n  {page}")
    print("\nFigures:\n" + "\n".join(f"  {figure}" for figure in figures))


def has_lammps() -> bool:
    """Return whether LAMMPS can run; otherwise print the reason."""
    try:
        versions("lammps")
    except EngineError as error:
        print(f"\nThe demo continues without LAMMPS: {error}")
        return False
    return True


def collide_in_lammps(folder: Path) -> None:
    """Run an impact of two spheres in LAMMPS, and print the restitution."""
    pair = CentralImpact("universal", 0.1, "aluminium_zv02", 0.1, "two_spheres", host="lammps")
    restitution = pair.run(folder).coefficient_of_restitution
    print(f"\nRestitution of the same two spheres in LAMMPS, law universal: {restitution:.6f}")
