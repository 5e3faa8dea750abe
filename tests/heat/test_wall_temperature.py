# SPDX-License-Identifier: GPL-2.0-or-later
"""A wall with a temperature heats grains in contact with it, and no others."""

from __future__ import annotations

import numpy as np
import pytest

from plastigran.engine.dumps import read_dump
from plastigran.engine.process import run_deck

DECK = """
units           si
atom_style      granular
atom_modify     map array
boundary        f f f
newton          off
communicate     single vel yes
region box block -0.1 0.1 -0.1 0.1 -0.1 0.1 units box
create_box 1 box
neighbor        0.002 bin
fix youngsModulus all property/global youngsModulus peratomtype 7e9
fix poissonsRatio all property/global poissonsRatio peratomtype 0.3
fix yieldStrength all property/global yieldStrength peratomtype 1e7
fix conductivity all property/global thermalConductivity peratomtype 100
fix capacity all property/global thermalCapacity peratomtype 400
create_atoms 1 single -0.05 0 0.00999 units box
create_atoms 1 single 0.05 0 0.01005 units box
set group all diameter 0.02 density 2700
pair_style gran model thornton tangential off
pair_coeff * *
fix floor all wall/gran model thornton tangential off primitive type 1 zplane 0.0 temperature 400
fix temperature all heat/gran initial_temperature 300
timestep 1e-6
dump trajectory all custom 1 trajectory.dump id z f_heatFlux
dump_modify trajectory sort id
run 1
"""


def test_only_grains_in_contact_with_a_wall_are_heated(tmp_path):
    """A grain that touches the wall is heated; a grain that is within 0.01 radii of it is not."""
    (tmp_path / "deck.in").write_text(DECK)
    run_deck(tmp_path / "deck.in", {}, tmp_path)
    table = read_dump(tmp_path / "trajectory.dump")
    last = table[table["step"] == table["step"].max()].sort_values("id")
    touching, apart = last.iloc[:, -1].to_numpy()
    assert np.isfinite(touching) and touching > 0
    assert apart == pytest.approx(0, abs=1e-12 * touching)
