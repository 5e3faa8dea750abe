# SPDX-License-Identifier: GPL-2.0-or-later
"""The energy balance over several runs, restarts, and inserted and deleted grains."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from ledger_runs import ENTRIES, ledger, plastic_work

from plastigran.engine.process import EngineError


def log(folder: Path) -> str:
    return (folder / "log.liggghts").read_text()


@pytest.mark.parametrize("pre", ["yes", "no"])
@pytest.mark.parametrize("steps", [0, 200])
def test_changes_of_the_deck_between_runs_are_counted(pre, steps, tmp_path):
    """Energy that the deck adds between two runs counts as inserted, with and without `pre no`.

    Terms that are printed between runs have their values at the end of the earlier run. The initial
    energy contains the energy of wall contacts.

    The balance error is below 1e-3 of the added energy; the time step causes a tenth of this limit.
    """
    table = ledger("changed", tmp_path, pre=pre, steps=steps)
    end, second = (table[table["run"] == run].iloc[-1] for run in (0, 2))
    assert table["elastic"].iloc[0] > 0.9 * end["kinetic"] > 0
    given = second["inserted"]
    assert given > 5 * end["kinetic"]
    assert table["drift"].abs().max() < 1e-3 * given
    log = (tmp_path / "log.liggghts").read_text()
    said = [re.findall(rf"^{word} (.+)$", log, re.MULTILINE) for word in ("ended", "changed")]
    assert said[0][-1] == said[1][-1]
    kinetic, inserted, _ = map(float, said[0][-1].split())
    assert inserted == 0 and kinetic == pytest.approx(end["kinetic"], rel=1e-6)


def test_another_integrator_is_refused(tmp_path):
    """The energy balance refuses integrators other than velocity Verlet, such as respa."""
    with pytest.raises(EngineError, match="run_style respa is not supported"):
        ledger("set_types", tmp_path, change="run_style respa 2 2 pair 1")


def test_deleted_particles_need_a_setup(tmp_path):
    with pytest.raises(
        EngineError, match="particles were added or deleted since the last run, but"
    ):
        ledger("changed", tmp_path, pre="no", remove=1)


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_restart_keeps_the_terms(bed, ranks, tmp_path):
    """A run from a restart file has the energy terms of the second part of the whole run.

    They agree to 1e-9 of the initial energy, because the log has a limited number of digits and two
    ranks sum in another order.
    """
    folder, whole = bed
    restart = folder / "middle.restart"
    table = ledger("bed_restart", tmp_path, ranks, restart=restart, after=2000)
    second = whole[whole["run"] == 1].iloc[: len(table)]
    assert len(table) == 5 and table["plastic"].iloc[0] > 0
    scale = whole[["kinetic", "gravity"]].iloc[0].sum()
    assert np.abs(table[ENTRIES].to_numpy() - second[ENTRIES].to_numpy()).max() < 1e-9 * scale
    same = plastic_work(folder, table["step"].iloc[-1])
    assert np.abs(plastic_work(tmp_path) - same).max() < 1e-9 * scale


def test_deleted_grains_leave_the_others(bed, tmp_path):
    """The term `inserted` decreases by the energy of deleted grains and of their contacts.

    The energy of their contacts is elastic. Their plastic work stays in the total.
    """
    table = ledger("bed_thinned", tmp_path, restart=bed[0] / "middle.restart")
    before, after = table[table["run"] == 0].iloc[-1], table[table["run"] == 1].iloc[0]
    assert before["step"] == after["step"]
    change = after - before
    scale = before["kinetic"]
    gone = change["kinetic"] + change["gravity"] + change["elastic"]
    assert change["elastic"] < 0
    assert change["inserted"] == pytest.approx(gone, abs=1e-12 * scale) and gone < -scale
    for entry in ("plastic", "friction", "viscous"):
        assert change[entry] == 0
    assert change["drift"] == pytest.approx(0, abs=1e-12 * scale)
    with_all = plastic_work(tmp_path, before["step"])
    without = plastic_work(tmp_path, before["step"], "left")
    assert len(with_all) == 144 and len(without) == 96
    assert (without == with_all[without.index]).all() and without.max() > 0


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("wall", [0, 1])
@pytest.mark.parametrize(
    "change",
    ["set atom 2 type 2", "set atom 2 diameter 0.0059", "displace_atoms right move 5e-5 0 0"],
)
def test_changes_of_contacts_are_counted(change, wall, ranks, tmp_path):
    """A change of constants, sizes or positions of bodies changes the energy of their contact.

    The balance error of 20 steps is about 1e-4 of the initial energy; the changes exceed 5 % of it.
    """
    table = ledger("set_types", tmp_path, ranks, change=change, wall=wall)
    before, after = table[table["run"] == 0].iloc[-1], table[table["run"] == 1].iloc[0]
    assert before["step"] == after["step"]
    scale = table["elastic"].iloc[0] + table["plastic"].iloc[0]
    change = (after - before)[["kinetic", "elastic", "plastic", "inserted", "drift"]] / scale
    assert abs(change["elastic"] + change["plastic"]) > 0.05
    assert change["inserted"] == pytest.approx(change[["kinetic", "elastic", "plastic"]].sum())
    assert change["drift"] == pytest.approx(0, abs=1e-12)
    assert table["drift"].abs().max() < 1e-3 * scale
    said = re.findall(r"the deck changed the energy of contacts by (\S+) J", log(tmp_path))
    of_contacts = (change["elastic"] + change["plastic"]) * scale
    assert [float(number) for number in said] == pytest.approx([of_contacts], rel=1e-4)


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("wall", [0, 1])
def test_the_setup_loads_to_its_overlap(wall, ranks, tmp_path):
    """At the setup of a run, a law loads each new contact to its overlap.

    Bodies overlap beyond yield when a run begins, and then separate. Their contact unloads from
    this overlap, and plastic work does not change.
    """
    table = ledger("set_types", tmp_path, ranks, speed=0.5, wall=wall, change="run 0")
    assert table["elastic"].iloc[-1] < 0.99 * table["elastic"].iloc[0]
    assert table["plastic"].iloc[0] > 0
    assert np.ptp(table["plastic"]) == 0
    assert plastic_work(tmp_path).sum() == pytest.approx(table["plastic"].iloc[0], rel=1e-12)


def test_grains_are_inserted_and_lost_during_a_run(tmp_path):
    """The term `inserted` contains the energy of grains that are inserted or lost during a run.

    The grains are lost through the floor of the box. In the step in which a grain appears or
    disappears, half a step of gravity is missing or added. This error, m g v dt/2, is 3e-4 of the
    energy.
    """
    table = ledger("passing", tmp_path)
    mechanical = table["kinetic"] + table["gravity"]
    scale = mechanical.max()
    assert table["atoms"].iloc[0] == 0 == table["atoms"].iloc[-1] and table["atoms"].max() == 20
    assert mechanical.iloc[-1] == 0
    assert table["inserted"].max() == pytest.approx(scale, rel=1e-3)
    assert table["drift"].abs().max() < 1e-3 * scale
    falling = table[(table["run"] == 1) & (table["atoms"] == 20)]
    assert len(falling) > 5
    assert np.ptp(falling["drift"]) < 1e-12 * scale
