# SPDX-License-Identifier: GPL-2.0-or-later
"""`run 0` computes forces and moves nothing, so it does not change the next run."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from deck_text import head, material, run_text

from plastigran.engine.dumps import read_dump
from plastigran.engine.log import read_thermo
from plastigran.engine.process import PROJECT

DECK = (
    head("-0.1 0.1 -0.1 0.1 -0.01 0.1", skin=2e-3)
    + material(7e10, 1e8)
    + """
hard_particles  yes
fix coefficient all property/global rateCoefficient peratomtype {rate_coefficient}
fix reference all property/global referenceRate peratomtype 1.0
fix factors all property/global taylorQuinneyFactor peratomtype 0.9
fix capacity all property/global thermalCapacity peratomtype 900
fix conductivity all property/global thermalConductivity peratomtype 0
create_atoms    1 single 0 0 {height}
create_atoms    1 single 0 0 {other_height}
set group all diameter 0.02 density 2700
pair_style      gran model universal energy_ledger on
pair_coeff      * *
fix floor all wall/gran model universal primitive type 1 zplane 0.0 energy_ledger on
fix temperatures all heat/gran initial_temperature 300
fix warming all heat/dissipation
timestep        1e-7
fix integrate   all nve/sphere
include ${{inputs}}/energy_ledger.in
variable warmed equal f_warming
thermo_style custom step v_kinetic v_elastic v_plastic v_inserted v_drift v_warmed
thermo_modify format float %.15g
thermo 10
dump trajectory all custom 10 trajectory.dump id z vz fz f_Temp
dump_modify trajectory format "%d %.15g %.15g %.15g %.15g"
{first}
{change}
run             200
"""
)
DEEP = {"height": 0.00999, "other_height": 0.02997}  # overlaps of 10 and 20 um, beyond yield
TOUCHING = {"height": 0.01 - 1e-11, "other_height": 0.03 - 3e-11}


def run(folder: Path, first: str, **values: object) -> tuple[np.ndarray, pd.DataFrame]:
    """Return z, vz, fz and temperature of the last run, and its energy terms.

    The first step is left out, because `run 0` has already written it.
    """
    run_text(folder, DECK.format(first=first, **values), inputs=PROJECT / "inputs")
    dump = read_dump(folder / "trajectory.dump").sort_values(["step", "id"])
    table = read_thermo(folder / "log.liggghts")
    entries = table[table["run"] == table["run"].max()].reset_index()
    return dump[["z", "vz", "fz", "Temp"]].to_numpy()[2:], entries


@pytest.mark.parametrize(
    ("change", "values"),
    [
        ("", DEEP),
        ("displace_atoms all move 0 0 1e-5", DEEP),
        ("set group all vz -0.5", TOUCHING | {"rate_coefficient": 0.1}),
    ],
    ids=["nothing", "overlap", "speed"],
)
def test_a_run_of_no_steps_changes_nothing(change, values, tmp_path):
    """With and without `run 0`, the next run has bitwise the same motion, energies and heat.

    Changes by the deck after `run 0` count as inserted energy. The balance error agrees to
    round-off, because sums have another order.
    """
    values = {"rate_coefficient": 0.0, "change": change} | values
    path, entries = run(tmp_path / "plain", "", **values)
    path_after, entries_after = run(tmp_path / "after", "run 0", **values)
    assert np.ptp(path[:, 2]) > 0
    assert (path_after == path).all()
    for entry in ("kinetic", "elastic", "plastic", "warmed"):
        assert (entries_after[entry] == entries[entry]).all()
    scale = entries[["kinetic", "elastic", "plastic"]].iloc[0].sum()
    assert (entries_after["drift"] - entries["drift"]).abs().max() < 1e-12 * scale
    if not change:
        assert entries["warmed"].iloc[-1] > 0 == entries_after["inserted"].abs().max()
