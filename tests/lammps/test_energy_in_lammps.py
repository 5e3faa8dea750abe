# SPDX-License-Identifier: GPL-2.0-or-later
"""Energy balance of grains with friction, dashpots and moving walls in LAMMPS."""

from __future__ import annotations

from pathlib import Path

import pandas as pd
import pytest
from lammps_scenes import FRICTION, MATERIAL, RADIUS, body, box, numbered, run, sphere, thermo
from numpy.testing import assert_allclose

from plastigran.engine.lammps import run_lammps
from plastigran.engine.process import EngineError

BED = Path(__file__).parent / "energy.in"
TERMS = "kinetic gravity elastic plastic friction viscous wallwork inserted drift springs".split()
COLUMNS = {f"c_energy[{k}]": name for k, name in enumerate(TERMS, 1)}
ENERGY = "compute energy all plastigran/energy\nthermo_style custom step c_energy[*]\n"
ENERGY += "thermo_modify norm no format float %.15g\n"


def terms(log: str) -> pd.DataFrame:
    return thermo(log).rename(columns=COLUMNS)


def bed(folder: Path, ranks: int = 1, **variables: object) -> pd.DataFrame:
    return terms(run_lammps(BED, variables, folder, ranks))


def check_balance(table: pd.DataFrame) -> float:
    """Check that the sum of the energy terms is constant, and return the energy input [J].

    The tolerance is 1e-3 of the energy input, as in LIGGGHTS.
    """
    energies = table[TERMS[:6]].sum(axis=1)
    total = energies - table["wallwork"] - table["inserted"]
    assert_allclose(total, total[0], atol=1e-3 * energies.max(), rtol=0)
    # `drift` differs only by the round-off of the sums.
    assert_allclose(table["drift"], total - total[0], atol=1e-12 * energies.max(), rtol=0)
    return energies.max()


@pytest.mark.parametrize(("ranks", "newton"), [(1, "on"), (2, "on"), (2, "off")])
def test_the_balance_closes(ranks, newton, tmp_path):
    table = bed(tmp_path, ranks, newton=newton)
    total = check_balance(table)
    last = table.iloc[-1]
    assert (last[["plastic", "friction", "viscous", "wallwork"]] > 0.05 * total).all()


@pytest.mark.parametrize("ranks", [1, 2])
def test_the_balance_continues_after_a_restart(ranks, tmp_path):
    """The terms differ from those of a run without restart by less than 1e-6 of the kinetic energy.
    They are not identical: in the setup of a run, LAMMPS computes the dashpots with the velocities
    at the end of the step. The tolerance was set after the first comparison, which gave 1e-8.
    """
    unbroken = bed(tmp_path, plate="no").set_index("Step")
    continued = bed(tmp_path, ranks, plate="no", **{"from": 1800}).set_index("Step")
    assert unbroken.loc[1800, "friction"] > 1e-2 * unbroken.loc[0, "kinetic"]
    for step in (1800, 2000):
        scale = 1e-6 * unbroken.loc[step, "kinetic"]
        assert_allclose(continued.loc[step, TERMS], unbroken.loc[step, TERMS], atol=scale, rtol=0)
    check_balance(pd.concat([unbroken.loc[:1600], continued]).reset_index())


def test_changes_by_the_deck_are_inserted_energy(tmp_path):
    """Changed speeds, a deleted grain and a removed wall in contact count as inserted energy."""
    spheres = [sphere(0.999 * RADIUS, 0, 0, 0, 0), sphere(5 * RADIUS, 0, 0, 0.1, 0)]
    log = run(
        tmp_path,
        f"""{box(8 * RADIUS)}{numbered(spheres)}
        pair_style granular/plastigran
        pair_coeff * * hertz {body()} {FRICTION}
        fix wall all wall/gran/plastigran granular hertz rigid {FRICTION} xplane 0 NULL
        {ENERGY}
        fix motion all nve/noforce
        timestep 1e-6
        run 1
        velocity all set 0 0.2 0 sum yes units box
        run 1
        unfix wall
        run 1
        group second id 2
        delete_atoms group second compress no
        run 1
        """,
    )
    table = terms(log)
    mass = 4 / 3 * 3.141592653589793 * RADIUS**3 * MATERIAL.density
    stored = table["elastic"][0]
    assert stored > 0
    gains = [0, 0, 2 * 0.5 * mass * 0.2**2, -stored, -0.5 * mass * (0.1**2 + 0.2**2)]
    after = table["inserted"].iloc[[0, 1, 2, 4, 6]].diff().fillna(0)
    assert_allclose(after, gains, atol=1e-9 * stored, rtol=1e-9)


@pytest.mark.parametrize("steps", [0, 3])
def test_changes_after_a_restart_are_inserted_energy(steps, tmp_path):
    """The restart file is written before or after the first run. Then the deck changes the speed of
    a sphere. Before the first run, the balance has not begun, so the change does not count. The
    tolerance is round-off.
    """
    motion = f"{ENERGY}\nfix motion all nve/noforce\ntimestep 1e-6"
    log = run(
        tmp_path,
        f"""{box(8 * RADIUS)}{numbered([sphere(5 * RADIUS, 0, 0, 0.1, 0)])}
        pair_style granular/plastigran
        pair_coeff * * hertz {body()} {FRICTION}
        {motion}
        {f"run {steps}" if steps else ""}
        write_restart moving.restart
        clear
        read_restart moving.restart
        {motion}
        velocity all set 0.3 0 0 units box
        run 1
        """,
    )
    last = terms(log).iloc[-1]
    gain = 0.5 * 4 / 3 * 3.141592653589793 * RADIUS**3 * MATERIAL.density * (0.3**2 - 0.1**2)
    assert last["inserted"] == pytest.approx(gain if steps else 0, rel=1e-9, abs=1e-15)
    assert abs(last["drift"]) < 1e-12 * last["kinetic"]


def test_poured_grains_are_inserted_energy(tmp_path):
    """The balance error is below 1e-5 of the largest kinetic energy. It arises because gravity
    accelerates an inserted grain for only half of its first step."""
    log = run(
        tmp_path,
        f"""{box(8 * RADIUS)}
        pair_style granular/plastigran
        pair_coeff * * hertz {body()} {FRICTION}
        {ENERGY}
        fix gravity all gravity 9.81 vector 0 0 -1
        fix motion all nve/sphere
        region top block -0.03 0.03 -0.03 0.03 0.02 0.035
        fix pour all pour 20 1 4767 region top diam one 0.002 vol 0.1 200 dens 2500 2500 &
            vel 0 0 0 0 -2
        timestep 1e-6
        thermo 1000
        run 3000
        """,
    )
    table = terms(log)
    assert table["inserted"].iloc[-1] > 0
    assert_allclose(table["drift"], 0, atol=1e-5 * table["kinetic"].max())


def test_a_wall_has_the_force_of_its_contacts(tmp_path):
    spheres = [sphere(0.999 * RADIUS, 0, 0, 0), sphere(0.998 * RADIUS, 3 * RADIUS, 0, 0)]
    log = run(
        tmp_path,
        f"""processors 1 * 1
        {box(8 * RADIUS)}{numbered(spheres)}
        pair_style granular/plastigran
        pair_coeff * * hertz {body()} {FRICTION}
        fix wall all wall/gran/plastigran granular hertz rigid {FRICTION} xplane 0 NULL
        variable load equal fx[1]+fx[2]
        thermo_style custom step f_wall[*] v_load
        thermo_modify norm no format float %.15g
        run 0
        """,
        ranks=2,
    )
    (row,) = thermo(log).itertuples(index=False)
    assert row[4] > 0
    assert_allclose(row[1:4], (-row[4], 0, 0), rtol=1e-12)


def test_heat_conduction_has_no_balance(tmp_path):
    with pytest.raises(EngineError, match="does not support LAMMPS' model `heat`"):
        run(
            tmp_path,
            f"""{box(8 * RADIUS)}
            fix temperature all property/atom temperature heatflow ghost yes
            {numbered([sphere(0, 0, 0, 0)])}
            pair_style granular/plastigran
            pair_coeff * * hertz {body()} {FRICTION} heat area 0.1
            {ENERGY}
            run 0""",
        )
