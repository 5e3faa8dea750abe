# SPDX-License-Identifier: GPL-2.0-or-later
"""LAMMPS scripts in which spheres collide with each other, with a plane and with a region."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
from contact_constants import VALUES, required

from plastigran.engine.dumps import read_dump
from plastigran.engine.lammps import run_lammps
from plastigran.materials import Material, read_material

MATERIAL = read_material("aluminium_zv02")
RADIUS = 5e-3
FRICTION = "tangential mindlin_rescale NULL 1.0 0.5"
#: Constants in addition to the required ones. By default, `walton_braun` unloads as stiffly as it
#: loads, so its collisions would be elastic.
ALSO = {"walton_braun": {"unloading_stiffness": 4e6}}


def constants(law: str) -> dict[str, float]:
    """Return the constants that a law needs besides those of `body`.

    The name of a law may include its adhesion, such as `thornton adhesion jkr`.
    """
    if law.endswith("adhesion jkr"):
        return {"surface_energy": VALUES["surface_energy"]}
    return required(law) | ALSO.get(law, {})


def words(values: dict[str, object]) -> str:
    return " ".join(f"{name} {value}" for name, value in values.items())


def body(material: Material = MATERIAL) -> str:
    """Return the words of a body for a `pair_coeff` or wall line."""
    values = material.variables()
    first = (values.pop("youngs_modulus"), values.pop("poissons_ratio"))
    values = {name: values[name] for name in ("yield_strength", "yield_pressure_factor")}
    return f"{first[0]} {first[1]} {words(values)}"


def run(folder: Path, script: str, ranks: int = 1, **variables: object) -> str:
    """Run an input script, and return the log."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "in.lammps").write_text(script)
    return run_lammps(folder / "in.lammps", variables, folder, ranks)


def thermo(log: str) -> pd.DataFrame:
    """Return the thermodynamic output of all runs, one row per output."""
    rows, columns = [], None
    for line in log.splitlines():
        cells = line.split()
        if cells[:1] == ["Step"]:
            columns = cells
        elif columns and len(cells) == len(columns) and cells[0].isdigit():
            rows.append([float(cell) for cell in cells])
        elif line.startswith("Loop time"):
            columns = columns if rows else None
    names = next(line.split() for line in log.splitlines() if line.split()[:1] == ["Step"])
    return pd.DataFrame(rows, columns=names)


def box(half: float, types: int = 1) -> str:
    """Return the lines that create an empty box with sides of 2 `half` [m]."""
    return f"""
        units si
        atom_style sphere
        atom_modify map array
        boundary f f f
        comm_modify vel yes
        region box block -{half} {half} -{half} {half} -{half} {half}
        create_box {types} box
        neighbor {0.05 * RADIUS} bin
        """


def sphere(x: float, y: float, z: float, vx: float, vy: float = 0) -> str:
    """Return the lines of a sphere; `@` stands for its atom ID."""
    return (
        f"create_atoms 1 single {x:.17g} {y:.17g} {z:.17g}\n"
        f"set atom @ diameter {2 * RADIUS:.17g} density {MATERIAL.density:.17g}\n"
        f"set atom @ vx {vx:.17g} vy {vy:.17g}\n"
    )


def numbered(spheres: list[str]) -> str:
    return "".join(lines.replace("@", str(k + 1)) for k, lines in enumerate(spheres))


def rebounds(
    folder: Path,
    line: str,
    wall: str,
    speeds: list[float],
    step: float,
    steps: int,
    gap: float = 1e-9,
    sideways: float = 0,
    density: float = MATERIAL.density,
    friction: str = FRICTION,
) -> dict[str, pd.DataFrame]:
    """Collide pairs of spheres, and spheres with a plane and with a region.

    Args:
        folder: Folder of the run.
        line: Words of `pair_coeff` after the atom types: law and body of the spheres.
        wall: Words of the walls: law and body.
        speeds: Speeds (N,) of each sphere [m/s].
        step, steps: Time step [s] and number of time steps.
        gap: Distance of each sphere from contact at the start [m].
        sideways: Tangential velocity of each sphere, divided by its speed.
        density: Density of the spheres [kg/m^3].
        friction: Words of LAMMPS' tangential model.

    Returns:
        For `pair`, `plane` and `region`, a table of the final velocities vx, vy [m/s] and spins
        [rad/s] of the N spheres at positive x.
    """
    spheres, apart, geometries = [], 4 * RADIUS, ("plane", "region", "pair")
    for row in range(3):
        for k, speed in enumerate(speeds):
            place = (RADIUS + gap, apart * k, apart * row)
            spheres.append(sphere(*place, -speed, sideways * speed))
    for k, speed in enumerate(speeds):
        spheres.append(sphere(-RADIUS - gap, apart * k, 2 * apart, speed, -sideways * speed))
    count = len(speeds)
    run(
        folder,
        box(half=apart * (count + 3))
        + numbered(spheres)
        + f"""
        set group all density {density}
        pair_style granular/plastigran
        pair_coeff * * {line} {friction}
        group planes id 1:{count}
        group regions id {count + 1}:{2 * count}
        region wall plane 0 0 0 1 0 0
        fix plane planes wall/gran/plastigran granular {wall} {friction} xplane 0 NULL
        fix region regions wall/gran/region/plastigran granular {wall} {friction} region wall
        fix motion all nve/sphere
        timestep {step:.17g}
        run {steps}
        write_dump all custom end.dump id vx vy omegaz modify sort id format float %.17g
        """,
    )
    end = read_dump(folder / "end.dump").sort_values("id")
    parts = np.split(end[["vx", "vy", "omegaz"]].to_numpy(), 4)
    tables = [pd.DataFrame(part, columns=["vx", "vy", "spin"]) for part in parts[:3]]
    return dict(zip(geometries, tables, strict=True))
