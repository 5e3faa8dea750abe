# SPDX-License-Identifier: GPL-2.0-or-later
"""The energy ledger closes: against the integrator's error, theory, ranks, restarts and change."""

from __future__ import annotations

import re
from math import pi
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from plastigran import laws
from plastigran.engine.dumps import read_dump
from plastigran.engine.log import read_thermo
from plastigran.engine.process import EngineError, run_deck
from plastigran.materials import RIGID

DECKS = Path(__file__).parent / "decks"
ENTRIES = ["kinetic", "gravity", "elastic", "plastic", "friction", "viscous", "wallwork"]
ENTRIES += ["inserted", "drift", "springs"]
# Every model a contact may have, in every geometry.
CASES = {
    "plane": {"tangential": "history"},
    "mesh": {"tangential": "no_history", "rolling": "cdt", "damping": "on"},
    "pair": {"tangential": "history", "rolling": "epsd2", "damping": "on"},
}
MOVING = ("pushing", "shaking", "shearing")


def ledger(deck: str, folder: Path, ranks: int = 1, **variables) -> pd.DataFrame:
    """Run a deck; the ledger's entries [J] by output line, with the columns run and step."""
    run_deck(DECKS / f"{deck}.in", {"decks": DECKS, **variables}, folder, ranks=ranks)
    return read_thermo(folder / "log.liggghts")


def plastic_work(folder: Path, step: float | None = None, dump: str = "grains") -> pd.Series:
    """Plastic work of the particles [J] by id; at the last output when no step is given."""
    table = read_dump(folder / f"{dump}.dump")
    at = table["step"].max() if step is None else step
    return table[table["step"] == at].set_index("id")["plastic_work"]


def impact(law: str, folder: Path, refine: int = 1, **variables) -> pd.DataFrame:
    """An impact at 0.1 m/s, from before it to after it, with a hundred lines of the ledger.

    A cylinder's contact is stiffer against its mass: soft enough to yield, at a shorter step.
    """
    if laws.LAWS[law].shape == "cylinder":
        variables = {"shape": "cylinder", "yield_strength": 3e7, **variables}
        timestep, steps = 1e-6, 2500
    else:
        timestep, steps = 4e-6, 400
    variables |= {"timestep": timestep / refine, "steps": steps * refine}
    return ledger("impact", folder, law=law, every=steps * refine // 100, **variables)


def share(table: pd.DataFrame, entry: str) -> float:
    """Largest magnitude of an entry over the kinetic energy at the start."""
    return table[entry].abs().max() / table["kinetic"].iloc[0]


@pytest.mark.parametrize("geometry", CASES)
def test_an_impact_closes(engine_law, geometry, tmp_path):
    """Oblique, with friction, rolling friction and damping.

    2e-4: velocity Verlet's error, largest in the middle of the impact. A quarter of the step leaves
    a sixteenth of it, and a quarter at most with a law whose force jumps or has a kink, because an
    output line is then hit or missed.
    """
    coarse = impact(engine_law, tmp_path / "coarse", geometry=geometry, **CASES[geometry])
    assert share(coarse, "drift") < 2e-4
    assert coarse["elastic"].iloc[-1] == 0 == coarse["springs"].iloc[-1], "still in contact"
    assert share(coarse, "friction") > 0.01
    assert (share(coarse, "viscous") > 0.1) == ("damping" in CASES[geometry]) or (
        laws.LAWS[engine_law].rate_dependent
    )
    if geometry == "plane":
        fine = impact(engine_law, tmp_path / "fine", 4, geometry=geometry, **CASES[geometry])
        assert share(fine, "drift") < 0.25 * share(coarse, "drift")


@pytest.mark.parametrize("geometry", ["plane", "pair", *MOVING])
def test_closing_is_second_order(geometry, tmp_path):
    """A law with a smooth force: half the step leaves a quarter of the drift.

    0.3: a shaken wall's velocity is one for a step, and an output line does not fall on the
    largest drift.
    """
    coarse, fine = (
        impact("thornton", tmp_path / str(k), k, geometry=geometry, damping="on") for k in (2, 4)
    )
    assert 0.1 < share(fine, "drift") / share(coarse, "drift") < 0.3
    assert (share(fine, "wallwork") > 0.1) == (geometry in MOVING)


def test_plastic_work_is_the_predicted_loss(engine_law, law_between, aluminium, tmp_path):
    """1/2 m v^2 (1 - e^2), with e of the law by itself, all of it the sphere's.

    1e-3 of the energy: the time step's error of the restitution.
    """
    table = impact(engine_law, tmp_path, geometry="plane", tangential="off", slip=0.0)
    cylinder = laws.LAWS[engine_law].shape == "cylinder"
    body = aluminium.body()
    if cylinder:
        body = laws.Body(body.youngs_modulus, body.poissons_ratio, 3e7)
    law = law_between(engine_law, laws.combine(body, RIGID), length=1.0)
    mass = aluminium.density * (pi * 0.1**2 if cylinder else 4 / 3 * pi * 0.1**3)
    energy = 0.5 * mass * 0.1**2
    end = table.iloc[-1]
    assert table["kinetic"].iloc[0] == pytest.approx(energy, rel=1e-12)
    restitution = law.central_impact(0.1, mass, 0.1).coefficient_of_restitution
    lost = end["viscous"] if laws.LAWS[engine_law].rate_dependent else end["plastic"]
    assert lost == pytest.approx(energy * (1 - restitution**2), abs=1e-3 * energy)
    others = end["plastic"] + end["viscous"] + end["friction"] - lost
    assert abs(others) < 1e-12 * energy
    assert plastic_work(tmp_path)[1] == pytest.approx(end["plastic"], rel=1e-12)


def test_a_pair_shares_its_plastic_work(tmp_path):
    """Half to each body."""
    total = impact("thornton", tmp_path, geometry="pair")["plastic"].iloc[-1]
    assert total > 0
    assert plastic_work(tmp_path).to_numpy() == pytest.approx([total / 2] * 2, rel=1e-12)


@pytest.mark.parametrize("geometry", CASES)
def test_the_ledger_only_looks(geometry, tmp_path):
    """The motion is the same without it, to every digit."""
    for state in ("on", "off"):
        deck = {"decks": DECKS, "geometry": geometry, "every": 10, **CASES[geometry]}
        run_deck(DECKS / "impact.in", {**deck, "ledger": state}, tmp_path / state)
    on, off = (read_dump(tmp_path / state / "trajectory.dump") for state in ("on", "off"))
    assert len(on) > 40
    assert (on.to_numpy() == off.to_numpy()).all()


@pytest.fixture(scope="module")
def bed(tmp_path_factory) -> tuple[Path, pd.DataFrame]:
    """A bed of 144 grains coming to rest: its folder and its ledger."""
    folder = tmp_path_factory.mktemp("bed")
    return folder, ledger("bed", folder)


def test_a_bed_comes_to_rest(bed):
    """What gravity put in is found again, and plastic work only grows.

    1e-3 of the energy put in is asked for; the time step leaves a tenth of it.
    """
    folder, table = bed
    mechanical = table["kinetic"] + table["gravity"]
    put_in = mechanical.iloc[0] - mechanical.iloc[-1]
    assert share(table, "drift") * table["kinetic"].iloc[0] < 1e-3 * put_in
    assert table["kinetic"].iloc[-1] < 0.03 * put_in
    for entry in ("plastic", "viscous", "friction"):
        assert (table[entry].diff().dropna() >= 0).all()
        assert table[entry].iloc[-1] > 0.1 * put_in
    found = plastic_work(folder)
    assert len(found) == 144
    assert found.sum() == pytest.approx(table["plastic"].iloc[-1], rel=1e-12)


@pytest.mark.parametrize(("ranks", "grid"), [(2, "2 1"), (4, "2 2")])
def test_ranks_count_the_same(bed, ranks, grid, tmp_path):
    """1e-9 of the energy: sums in another order, before collisions have multiplied that."""
    table = ledger("bed", tmp_path, ranks, grid=grid, before=6000, after=0)
    table = table[table["run"] == 0]
    whole = bed[1].iloc[: len(table)]
    assert table["step"].iloc[-1] == 6000 and table["plastic"].iloc[-1] > 0
    scale = whole[["kinetic", "gravity"]].iloc[0].sum()
    assert np.abs(table[ENTRIES] - whole[ENTRIES]).to_numpy().max() < 1e-9 * scale


def builds(folder: Path) -> int:
    """How many lists of neighbours the engine has made in a deck's first run."""
    log = (folder / "log.liggghts").read_text()
    return int(re.findall(r"Neighbor list builds = (\d+)", log)[0])


def largest_difference(one: pd.DataFrame, other: pd.DataFrame) -> float:
    """Of any entry [J], over the rows that both have; there are some, and energy is stored."""
    both = one.merge(other, on=["run", "step"], suffixes=("", "_other"))
    assert (both["elastic"] > 0).sum() > 2
    return max(np.abs(both[entry] - both[f"{entry}_other"]).max() for entry in ENTRIES)


def test_entries_are_the_same_in_seldom_steps(bed, tmp_path):
    """What was counted before changes nothing.

    1e-12 of the energy: a log has 15 digits.
    """
    often = ledger("bed", tmp_path, before=10000, after=0, every=7)
    whole = bed[1]
    scale = whole[["kinetic", "gravity"]].iloc[0].sum()
    assert largest_difference(often, whole[whole["run"] == 0]) < 1e-12 * scale


def test_entries_are_the_same_in_the_engines_own_loop(tmp_path):
    """It runs where contacts are dumped, and counts in each contact as its force is computed; ours
    asks the contacts afterwards. Restart files are written in these steps, too, and a narrow skin
    makes lists of neighbours in many of them.

    1e-12 of the energy: a log has 15 digits.
    """
    deck = {"before": 7000, "after": 0, "every": 7, "skin": 0.0002}
    ours = ledger("bed", tmp_path / "ours", **deck)
    engines = ledger("bed", tmp_path / "engines", files=1, **deck)
    assert len(ours) == len(engines) > 1000 and builds(tmp_path / "ours") > 200
    scale = ours[["kinetic", "gravity"]].iloc[0].sum()
    assert largest_difference(ours, engines) < 1e-12 * scale


@pytest.mark.parametrize("asks", [1, 2, 3], ids=["move", "adapt", "setforce"])
@pytest.mark.parametrize("every", [1, 50])
def test_entries_are_known_when_all_forces_are(asks, every, tmp_path):
    """Within a step they are not: in its first part, before forces, or while walls' are to come. It
    does not matter whether the step before has been asked."""
    with pytest.raises(EngineError, match="asked for within a step, before all forces are known"):
        ledger("between", tmp_path, asks=asks, every=every)


@pytest.mark.parametrize("pre", ["yes", "no"])
@pytest.mark.parametrize("steps", [0, 200])
def test_what_a_deck_changes_between_runs_is_booked(pre, steps, tmp_path):
    """With or without a set-up; entries that are said between runs are those of the end. An answer
    before the walls have had their turn is not the start that drift is taken from.

    1e-3 of what is given: the time step's error is a tenth of that.
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


def test_particles_that_go_between_runs_need_a_set_up(tmp_path):
    with pytest.raises(EngineError, match="particles have come or gone since the last run, and"):
        ledger("changed", tmp_path, pre="no", remove=1)


def test_a_box_that_deforms_shifts_no_entry(tmp_path):
    """`fix deform` displaces particles before the output; the engine's own loop has counted then.

    1e-12 of the energy: a log has 15 digits.
    """
    ours = ledger("deformed", tmp_path / "ours")
    engines = ledger("deformed", tmp_path / "engines", contacts=1)
    assert len(ours) > 100
    assert largest_difference(ours, engines) < 1e-12 * ours["kinetic"].iloc[0]


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_restart_keeps_the_accounts(bed, ranks, tmp_path):
    """The second half from the file has the entries of the whole run.

    1e-9 of the energy: the digits of the file on one rank, sums in another order on two.
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


def test_grains_taken_away_leave_the_others(bed, tmp_path):
    """Their energy goes to its own entry, their plastic work stays in the total.

    What springs in their contacts held is lost without an entry, and is all that drifts.
    """
    table = ledger("bed_thinned", tmp_path, restart=bed[0] / "middle.restart")
    before, after = table[table["run"] == 0].iloc[-1], table[table["run"] == 1].iloc[0]
    assert before["step"] == after["step"]
    change = after - before
    scale = before["kinetic"]
    gone = change["kinetic"] + change["gravity"]
    assert change["inserted"] == pytest.approx(gone, abs=1e-12 * scale) and gone < -scale
    for entry in ("plastic", "friction", "viscous"):
        assert change[entry] == 0
    assert change["drift"] == pytest.approx(change["elastic"], abs=1e-12 * scale)
    with_all = plastic_work(tmp_path, before["step"])
    without = plastic_work(tmp_path, before["step"], "left")
    assert len(with_all) == 144 and len(without) == 96
    assert (without == with_all[without.index]).all() and without.max() > 0


def test_grains_come_and_go_while_the_engine_runs(tmp_path):
    """Inserted, and lost through the floor: they bring their energy and take it along.

    A grain that appears or disappears in the middle of a step has half of its kick by gravity more
    or less: m g v dt/2, here 3e-4 of the energy.
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


def test_newton_on_is_refused(tmp_path):
    """Each contact across a border between ranks is then seen from one side."""
    with pytest.raises(EngineError, match="energy_ledger on: it needs `newton off`"):
        run_deck(DECKS / "newton_on.in", {}, tmp_path)


def test_a_wall_needs_the_pair_style(tmp_path):
    with pytest.raises(EngineError, match="energy_ledger on: the pair_style line must have it too"):
        run_deck(DECKS / "wall_alone.in", {"pair": "off"}, tmp_path)


def test_a_wall_that_does_not_report_is_named(tmp_path):
    log = run_deck(DECKS / "wall_alone.in", {"wall": "off"}, tmp_path / "one")
    assert "they have no energy_ledger on: far" in log
    log = run_deck(DECKS / "wall_alone.in", {}, tmp_path / "none")
    assert "energy_ledger" not in log.replace("energy_ledger on", "").replace(
        "energy_ledger ${", ""
    )
