# SPDX-License-Identifier: GPL-2.0-or-later
"""A contact keeps its history while atoms are sorted, others are inserted or deleted, and the
border between ranks moves across the contact."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from plastigran import laws
from plastigran.engine.dumps import read_dump
from plastigran.engine.log import read_thermo
from plastigran.engine.process import run_deck

#: Deck in which two spheres are compressed, partly unloaded and kept in place. Others move around
#: them.
DECK = """
variable law index thornton
variable grid index "1 1 1"
variable output index .
variable inputs index inputs
units           si
atom_style      granular
atom_modify     map array {sort}
boundary        m m m
newton          off
communicate     single vel yes
processors      {grid}
region          box block -0.06 0.06 -0.02 0.02 -0.02 0.02 units box
create_box      1 box
neighbor        0.001 bin
neigh_modify    delay 0 every 20 check no
fix youngs   all property/global youngsModulus peratomtype 5e7
fix poisson  all property/global poissonsRatio peratomtype 0.3
fix strength all property/global yieldStrength peratomtype 1e6
pair_style      gran model ${{law}} tangential off
pair_coeff      * *
create_atoms 1 single 0.02 -0.0049 0
create_atoms 1 single 0.02 0.0051 0
create_atoms 1 single -0.055 0 0
create_atoms 1 single 0.05 0 0
set group all diameter 0.01 density 1500
group           one id 1
group           two id 2
group           held id 1 2
fix             press two move linear 0 -0.1 0 units box
timestep        1.0e-5
run             400
unfix           press
fix             release two move linear 0 0.1 0 units box
run             50
unfix           release
velocity        held set 0 0 0

group           traffic subtract all held
velocity        traffic set 0 0 0
group           runner id 4
velocity        runner set 10 0 0
fix integrate   traffic nve/sphere
variable        border equal (xhi+xlo)/2
thermo_style    custom step atoms v_border
thermo          500
dump            forces held custom 10 ${{output}}/forces.dump id x y z fx fy fz
dump_modify     forces sort id format "%d %.17g %.17g %.17g %.17g %.17g %.17g"
{comes}
run             500
group           gone id 3
delete_atoms    group gone compress {compress}
run             500
"""
COMES = """
fix template all particletemplate/sphere 11939 atom_type 1 density constant 1500 &
  radius constant 0.002
fix mixture all particledistribution/discrete 12203 1 template 1.0
region          source block -0.05 -0.03 -0.01 0.01 -0.01 0.01 units box
fix source traffic insert/pack seed 12373 distributiontemplate mixture insert_every 100 &
  overlapcheck yes vel constant 1 0 0 particles_in_region 20 region source
"""


def forces(law: str, folder: Path, grid: str, sort: str, comes: str, compress: str) -> np.ndarray:
    """Return the force between the two spheres that are kept in place [N], by frame."""
    text = DECK.format(grid=grid, sort=sort, comes=comes, compress=compress)
    (folder / "deck.in").write_text(text)
    ranks = int(np.prod([int(n) for n in grid.split()]))
    run_deck(folder / "deck.in", {"law": law}, folder, ranks=ranks)
    table = read_dump(folder / "forces.dump").sort_values(["step", "id"])
    first, second = (table.loc[table["id"] == k, "fy"].to_numpy() for k in (1, 2))
    assert first == pytest.approx(-second, rel=1e-12)
    assert len(second) == 101
    return second


@pytest.mark.parametrize("law", ["thornton", "vu_quoc_zhang"])
@pytest.mark.parametrize(
    ("grid", "sort", "comes", "compress"),
    [
        ("1 1 1", "sort 10 0.01", "", "no"),
        ("1 1 1", "sort 0 0", COMES, "yes"),
        ("2 1 1", "sort 10 0.01", COMES, "no"),
    ],
    ids=["sorted", "others come and go", "the border moves"],
)
def test_a_held_contact_keeps_its_force(law, grid, sort, comes, compress, tmp_path):
    """A contact that is kept in place keeps its history and force, whatever other particles do.

    The force stays on the unloading curve; without history, it would be 1.5 times as large. The
    border of two ranks starts left of the pair, at the middle of the box, and follows a moving
    particle past the pair. The force is constant to a relative 1e-9, because the overlap is a
    difference of constant positions, fifty times larger. It agrees with the law to 1e-6.
    """
    force = forces(law, tmp_path, grid, sort, comes, compress)
    assert force == pytest.approx(np.full(101, force[0]), rel=1e-9)
    body = laws.Body(youngs_modulus=5e7, poissons_ratio=0.3, yield_strength=1e6)
    model = laws.LAWS[law](laws.combine(body, body))
    state = model.State()
    deepest, held = 0.0004, 0.00035
    for overlap in (deepest, held):
        expected = model.respond(0.0025, overlap, state).force
    assert force[0] == pytest.approx(expected, rel=1e-6)
    assert model.respond(0.0025, held, model.State()).force > 1.2 * expected
    # Only the last two runs have the column `border`.
    log = read_thermo(tmp_path / "log.liggghts").dropna(subset="border")
    assert log["border"].iloc[0] < 0.02 < log["border"].iloc[-1]
    if comes:
        # Grains were inserted, and one was deleted.
        assert log["atoms"].max() > 20 and log["atoms"].diff().min() < 0
