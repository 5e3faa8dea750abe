# SPDX-License-Identifier: GPL-2.0-or-later
"""Grains and a wall that attract each other, for tests of adhesive laws with adhesion.in."""

from __future__ import annotations

from math import pi
from pathlib import Path

import numpy as np
import pandas as pd
import stl

from plastigran import laws
from plastigran.engine.dumps import read_dump
from plastigran.engine.process import run_deck

DECK = Path(__file__).parent / "decks" / "adhesion.in"
RADIUS, DENSITY = 2.45e-6, 1350.0
MASS = 4 / 3 * pi * RADIUS**3 * DENSITY
GRAIN, PLANE = laws.Body(1.2e9, 0.3, 35.3e6, 1), laws.Body(182e9, 0.3)
WALL, GRAINS = laws.combine(GRAIN, PLANE), laws.combine(GRAIN, GRAIN)
CONSTANTS = {
    "jkr": {"surface_energy": 0.2},
    "thornton_ning_1998": {"surface_energy": 0.05},
    "walton_braun": {"loading_stiffness": 1e3, "unloading_stiffness": 4e3},
    "luding_2008": {
        "loading_stiffness": 1e3,
        "unloading_stiffness": 5e3,
        "adhesive_stiffness": 500,
        "plasticity_depth": 0.02,
    },
    "edinburgh_2014": {"stiffness_ratio": 5, "adhesion_ratio": 0.1},
    "thornton adhesion jkr": {"surface_energy": 0.1},
    "universal adhesion jkr": {"surface_energy": 0.1},
    "kogut_etsion adhesion jkr": {"surface_energy": 0.05},
}
SIDE = 1.16e-4  # side of the mesh of the wall [m]; LIGGGHTS refuses meshes below 1e-4
CORNERS = SIDE / 2 * np.array([[0, -1, -1], [0, 1, -1], [0, 1, 1], [0, -1, 1]])
PLATE = CORNERS[[[0, 1, 2], [0, 2, 3]]]  # two triangles that meet along y = z
BOX = "region box block -6e-5 6e-5 -6e-5 6e-5 -6e-5 6e-5 units box\ncreate_box 2 box\n"
# Some laws whose contacts persist without overlap.
STRETCHED = ("jkr", "thornton_ning_1998", "universal adhesion jkr")


def property_lines(constants: dict[str, float]) -> str:
    lines = []
    for name, value in constants.items():
        first, *rest = name.split("_")
        keyword = first + "".join(word.capitalize() for word in rest)
        lines.append(
            f"fix {name} all property/global {keyword} peratomtypepair 2 {4 * f'{value} '}"
        )
    return "\n".join(lines) + "\n"


def sphere(
    x: float, y: float, vx: float, radius: float = RADIUS, density: float = DENSITY, z: float = 0
) -> str:
    """Return a line that creates a sphere, and two lines that set it; `@` is its atom ID."""
    return (
        f"create_atoms 1 single {x:.17g} {y:.17g} {z:.17g} units box\n"
        f"set atom @ diameter {2 * radius:.17g} density {density:.17g}\n"
        f"set atom @ vx {vx:.17g}\n"
    )


def run(law: str, folder: Path, bodies: list[str], commands: str, ranks: int = 1, **variables):
    """Run the deck adhesion.in and return its log.

    Args:
        law: Law of pairs and wall, optionally followed by `adhesion jkr`.
        folder: Folder for the files of the deck and its output.
        bodies: Lines of the spheres, with `@` for the atom ID.
        commands: Lines that run the simulation.
        ranks: Number of MPI ranks.
        variables: Variables of the deck. Further names are `values`, constants that replace
            constants of the law; `restart`, a file to read; `mesh`, triangles of the wall, shape
            (n, 3, 3); and `motion`, lines that move the mesh.
    """
    folder.mkdir(exist_ok=True)
    text = "".join(body.replace("@", str(k)) for k, body in enumerate(bodies, 1))
    constants = variables.pop("values", CONSTANTS.get(law, {}))
    restart = variables.pop("restart", None)
    law, _, option = law.partition(" ")
    variables["options"] = f"{option} {variables.pop('options', '')}"
    mesh, surface = variables.pop("mesh", None), variables.pop("motion", "") + "\n"
    if mesh is not None:
        stl.write(folder / "plate.stl", mesh, digits=12)
        surface = f"fix plate all mesh/surface file {folder}/plate.stl type 2\n" + surface
        variables.setdefault("wall", "mesh n_meshes 1 meshes plate")
    for name, content in (
        ("begin", f"read_restart {restart}\n" if restart else BOX),
        ("bodies", "" if restart else text),
        ("constants", property_lines(constants)),
        ("surface", surface),
        ("commands", commands + "\n"),
    ):
        (folder / f"{name}.in").write_text(content)
        variables[name] = (folder / f"{name}.in").resolve()
    return run_deck(DECK, {"law": law, **variables}, folder, ranks=ranks)


def table(folder: Path) -> pd.DataFrame:
    return read_dump(folder / "trajectory.dump").drop_duplicates(["step", "id"])


def law_of(name: str, pair: laws.MaterialPair = WALL) -> laws.Law:
    law, _, option = name.partition(" ")
    return (laws.ADHESIVE_LAWS if option else laws.LAWS)[law](pair, **CONSTANTS[name])


TERMS = ["kinetic", "gravity", "elastic", "plastic", "friction", "viscous", "wallwork"]
TERMS += ["inserted", "drift", "springs", "surface", "adhesion"]


def energy_terms(
    law: str, folder: Path, bodies: list[str], steps: int, **variables
) -> pd.DataFrame:
    """Run with the energy balance; return about 100 rows of its terms [J]."""
    columns = " ".join(f"f_energy_ledger[{k}]" for k in range(1, 13))
    commands = (
        f"thermo_style custom step {columns}\nthermo_modify norm no lost error format float %.12g\n"
        f"thermo {max(1, steps // 100)}\nrun {steps}"
    )
    log = run(law, folder, bodies, commands, every=steps, **variables)
    rows = [line.split() for line in log.splitlines()]
    numbers = [row for row in rows if len(row) == 13 and row[0].isdigit()]
    table = pd.DataFrame(np.array(numbers, float)[:, 1:], columns=TERMS)
    assert len(table) > 90
    return table
