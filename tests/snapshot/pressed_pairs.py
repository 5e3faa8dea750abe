# SPDX-License-Identifier: GPL-2.0-or-later
"""A run of two pairs of grains with frames, brief enough for every test to have its own."""

from __future__ import annotations

from pathlib import Path

from plastigran.engine.process import run_deck

#: Two pairs of grains side by side, radii 2 and 1 mm, pressed together by a tenth of a millimetre.
DECK = """
variable inputs index inputs
variable output index .
variable frames index 2
variable frame_every index 50
variable side index f
variable top index 0.02
units           si
atom_style      granular
atom_modify     map array
boundary        f f ${side}
newton          off
communicate     single vel yes
region          box block -0.02 0.02 -0.02 0.02 -0.002 ${top} units box
create_box      1 box
neighbor        0.001 bin
neigh_modify    delay 0
variable law index thornton
variable options index ""
include         ${inputs}/materials/soft_granules.in
include         ${inputs}/bulk/parts/friction.in
include         ${inputs}/bulk/parts/contact.in
create_atoms 1 single -0.008 0 0.0039
create_atoms 1 single -0.008 0 0
create_atoms 1 single 0.008 0 0
create_atoms 1 single 0.008 0 0.0019
set group all diameter 0.002 density 1500
group large id 1 2
set group large diameter 0.004 density 1500
fix integrate all nve/sphere
fix plate all mesh/surface file ${inputs}/meshes/plate.stl type 1 scale 0.001 move -0.012 0 0
fix wall all wall/gran model ${law} tangential ${tangential} rolling_friction ${rolling_friction} &
  mesh n_meshes 1 meshes plate ${options} ${accounting}
timestep 1.0e-7
include ${inputs}/bulk/parts/frames.in
include ${inputs}/bulk/parts/mesh_frames.in
run 100
"""


def press_pairs(folder: Path, **settings: object) -> Path:
    """Run the deck with some of its settings; returns the folder."""
    (folder / "deck.in").write_text(DECK)
    run_deck(folder / "deck.in", settings, folder)
    return folder
