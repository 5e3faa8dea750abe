# SPDX-License-Identifier: GPL-2.0-or-later
"""A cooling gas of elasto-plastic grains has the same energy in LIGGGHTS and in LAMMPS."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from lammps_scenes import MATERIAL, RADIUS, body, run, thermo
from numpy.testing import assert_allclose

from plastigran.engine.process import run_deck

SIDE, SPACING, STEP, STEPS = 8, 2.4 * RADIUS, 2e-7, 60_000
OUTPUT = f"""
fix motion all nve/sphere
timestep {STEP}
thermo 10000
thermo_style custom step ke
thermo_modify norm no format float %.15g
run {STEPS}
"""


def write_gas(file: Path) -> None:
    """Write grains on a lattice with random velocities, as a data file for both hosts."""
    random = np.random.default_rng(1)
    lattice = SPACING * (np.stack(np.mgrid[:SIDE, :SIDE, :SIDE], -1).reshape(-1, 3) + 0.5)
    velocities = random.normal(0, 0.3, lattice.shape)
    numbers = range(1, len(lattice) + 1)
    lines = ["gas\n", f"{len(lattice)} atoms", "1 atom types"]
    lines += [f"0 {SIDE * SPACING} {axis}lo {axis}hi" for axis in "xyz"]
    grain = f"1 {2 * RADIUS} {MATERIAL.density}"
    lines += ["\nAtoms\n"]
    lines += [f"{k} {grain} {x} {y} {z}" for k, (x, y, z) in zip(numbers, lattice, strict=True)]
    lines += ["\nVelocities\n"]
    lines += [f"{k} {x} {y} {z} 0 0 0" for k, (x, y, z) in zip(numbers, velocities, strict=True)]
    file.write_text("\n".join([*lines, ""]))


@pytest.mark.parametrize("law", ["thornton", "universal"])
def test_a_cooling_gas_has_the_same_energy(law, tmp_path):
    """The relative differences of the energies are below 1e-8.

    The hosts add forces in different orders, and collisions amplify this round-off.
    """
    write_gas(tmp_path / "gas.data")
    (tmp_path / "gas.in").write_text(
        f"""
units si
hard_particles yes
atom_style granular
atom_modify map array
boundary p p p
newton off
communicate single vel yes
read_data gas.data
neighbor {0.1 * RADIUS} bin
neigh_modify delay 0
fix youngs_modulus all property/global youngsModulus peratomtype {MATERIAL.youngs_modulus}
fix poissons_ratio all property/global poissonsRatio peratomtype {MATERIAL.poissons_ratio}
fix strength all property/global yieldStrength peratomtype {MATERIAL.yield_strength}
fix factor all property/global yieldPressureFactor peratomtype {MATERIAL.yield_pressure_factor}
pair_style gran model {law} tangential off
pair_coeff * *
{OUTPUT}"""
    )
    liggghts = thermo(run_deck(tmp_path / "gas.in", {}, tmp_path))
    lammps = thermo(
        run(
            tmp_path,
            f"""
            units si
            atom_style sphere
            boundary p p p
            newton off
            comm_modify vel yes
            read_data gas.data
            neighbor {0.1 * RADIUS} bin
            neigh_modify delay 0
            pair_style granular/plastigran
            pair_coeff * * {law} {body()} tangential linear_nohistory 0 0
            {OUTPUT}""",
        )
    )
    energy = liggghts["KinEng"].to_numpy()
    assert energy[-1] < 0.6 * energy[0]  # impacts far beyond yield
    assert_allclose(lammps["KinEng"], energy, rtol=1e-8)
