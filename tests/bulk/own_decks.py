# SPDX-License-Identifier: GPL-2.0-or-later
"""Decks, and folders of finished runs, that the tests of users' decks share."""

from __future__ import annotations

import json
from pathlib import Path

#: A sphere falls on a plane mesh. The deck has no settings. Its log has two columns with long
#: names, and no column of the time or the time step.
PLAIN = """
# Stoß einer Kugel
units si
atom_style granular
boundary f f f
newton off
communicate single vel yes
region box block -0.05 0.05 -0.05 0.05 -0.01 0.05 units box
create_box 1 box
neighbor 0.002 bin
include properties.in
pair_style gran model thornton tangential history
pair_coeff * *
fix plate all mesh/surface file meshes/plate.stl type 1 scale 0.008 rotate axis 0 1 0 angle 90
fix floor all wall/gran model thornton tangential history mesh n_meshes 1 meshes plate
create_atoms 1 single 0 0 0.00501
set group all diameter 0.01 density 7850
velocity all set 0 0 -0.1
fix integrate all nve/sphere
variable kinetic_of_all equal ke
variable kinetic_of_all_twice equal 2*ke
timestep 1.0e-7
thermo_style custom step atoms ke v_kinetic_of_all v_kinetic_of_all_twice
thermo 100
run 1000
run 500
"""
PROPERTIES = """
fix m1 all property/global youngsModulus peratomtype 2.1e11
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global yieldStrength peratomtype 3.0e8
fix m4 all property/global coefficientFriction peratomtypepair 1 0.3
"""
#: The two settings that a deck needs to continue from a checkpoint.
START = "variable start index fresh\nvariable checkpoint index none\n"


def finished_run(folder: Path, log: str, before: str = "", **record: object) -> Path:
    """Write the folder of a finished run of a user's deck `mine`, and return the folder.

    Args:
        folder: Folder to create.
        log: Text of the log of LIGGGHTS.
        before: Series of the run that this run continues, as CSV text; empty for a new run.
        record: Values of run.json that replace the defaults.
    """
    folder.mkdir()
    record = {"deck": "mine", "own": True, "values": {}, "settings": {}} | record
    (folder / "run.json").write_text(json.dumps(record))
    (folder / "log.liggghts").write_text(log)
    (folder / "series.csv").write_text("step\n")
    if before:
        (folder / "before.csv").write_text(before)
    return folder


def table(columns: str, *rows: str) -> str:
    """Return the log of one run with the given columns and rows."""
    return "\n".join((f"Step {columns}", *rows, "Loop time of 1\n"))
