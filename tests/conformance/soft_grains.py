# SPDX-License-Identifier: GPL-2.0-or-later
"""Decks of a few soft grains of about 10 mm, as text."""

from __future__ import annotations

from pathlib import Path

import pandas as pd

from plastigran.engine.dumps import read_dump
from plastigran.engine.process import run_deck

SETTINGS = """
variable inputs index inputs
variable output index .
"""
#: Commands that create the simulation box; two ranks divide it along x.
BOX = """
processors      {grid} 1
units           si
atom_style      granular
atom_modify     map array
boundary        f f f
newton          off
communicate     single vel yes
region          box block -0.08 0.08 -0.04 0.04 -0.02 0.08 units box
create_box      2 box
"""
PROPERTIES = """
neighbor        0.001 bin
neigh_modify    delay 0
fix youngs   all property/global youngsModulus peratomtype 1e7 2e7
fix poisson  all property/global poissonsRatio peratomtype 0.3 0.25
fix strength all property/global yieldStrength peratomtype {strength} {strength}
fix bounce   all property/global coefficientRestitution peratomtypepair 2 1 1 1 1
fix friction all property/global coefficientFriction peratomtypepair 2 0.3 0.4 0.4 0.5
"""
#: Properties of LIGGGHTS' rolling friction and cohesion models.
COMPANIONS = """
fix rolling  all property/global coefficientRollingFriction peratomtypepair 2 0.1 0.2 0.2 0.1
fix cohesion all property/global cohesionEnergyDensity peratomtypepair 2 2e4 4e4 4e4 2e4
fix content  all property/global surfaceLiquidContentInitial scalar 0.01
fix tension  all property/global surfaceTension scalar 0.5
fix fluid    all property/global fluidViscosity scalar 0.01
fix wetting  all property/global contactAngle peratomtype 30 40
fix nearest  all property/global minSeparationDistanceRatio scalar 0.01
fix farthest all property/global maxSeparationDistanceRatio scalar 1.1
"""
#: Gravity, time step and dump. An impact lasts about 300 steps.
MOTION = """
fix gravity all gravity 9.81 vector 0 0 -1
timestep        1e-5
thermo          20
dump grains all custom 20 grains.dump id x y z vx vy vz omegax omegay omegaz fx fy fz {more}
dump_modify grains sort id format "%d{formats}"
"""
#: Yield strengths [Pa]. Without yield, the laws agree with LIGGGHTS' hertz.
STRENGTH, NO_YIELD = "1e5", "1e30"


def motion(more: str = "") -> str:
    """Return the lines for gravity, time step and dump; `more` names further columns of the
    dump.
    """
    return MOTION.format(more=more, formats=" %.17g" * (12 + len(more.split())))


def execute(text: str, folder: Path, ranks: int = 1) -> pd.DataFrame:
    """Run a deck; return the motion of its grains by step and atom ID."""
    folder.mkdir(exist_ok=True)
    (folder / "deck.in").write_text(SETTINGS + text)
    run_deck(folder / "deck.in", {}, folder, ranks=ranks)
    table = read_dump(folder / "grains.dump").drop_duplicates(["step", "id"], keep="last")
    return table.set_index(["step", "id"])


def fresh(text: str, folder: Path, ranks: int = 1) -> pd.DataFrame:
    """Run commands in the box `BOX`; return the motion as `execute` does."""
    return execute(BOX.format(grid="2 1" if ranks == 2 else "1 1") + text, folder, ranks)


def assert_alike(one: pd.DataFrame, other: pd.DataFrame, rel: float) -> None:
    """Check that each column differs by at most `rel` times its largest magnitude."""
    assert (one.index == other.index).all()
    assert one.notna().all(axis=None) and other.notna().all(axis=None)
    scale = one.abs().max()
    assert (scale[["fx", "fz"]] > 0).all(), "nothing touches"
    assert ((one - other).abs().max() <= rel * scale).all(), (one - other).abs().max() / scale
