# SPDX-License-Identifier: GPL-2.0-or-later
"""The energy balance closes to the error of the integrator, and agrees with theory and ranks."""

from __future__ import annotations

from math import pi
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from ledger_runs import DECKS, ENTRIES, ledger, plastic_work

from plastigran import laws
from plastigran.engine.dumps import read_dump
from plastigran.engine.process import EngineError, run_deck
from plastigran.materials import RIGID

# Models of friction, rolling friction and damping in each geometry.
CASES = {
    "plane": {"tangential": "history"},
    "mesh": {"tangential": "no_history", "rolling": "cdt", "damping": "on"},
    "pair": {"tangential": "history", "rolling": "epsd2", "damping": "on"},
}
MOVING = ("pushing", "shaking", "shearing")


def impact(law: str, folder: Path, refine: int = 1, **variables) -> pd.DataFrame:
    """Run an impact at 0.1 m/s; return its energy terms in a hundred lines.

    A cylinder is stiffer relative to its mass, so it has a lower strength and a shorter time step.
    """
    if laws.LAWS[law].shape == "cylinder":
        variables = {"shape": "cylinder", "yield_strength": 3e7, **variables}
        timestep, steps = 1e-6, 2500
    else:
        timestep, steps = 4e-6, 400
    variables |= {"timestep": timestep / refine, "steps": steps * refine}
    return ledger("impact", folder, law=law, every=steps * refine // 100, **variables)


def share(table: pd.DataFrame, entry: str) -> float:
    """Return the largest magnitude of a term, divided by the initial kinetic energy."""
    return table[entry].abs().max() / table["kinetic"].iloc[0]


@pytest.mark.parametrize("geometry", CASES)
def test_an_impact_closes(engine_law, geometry, tmp_path):
    """The energy balance of oblique impacts with friction, rolling friction and damping closes.

    The balance error is below 2e-4 of the initial energy; velocity Verlet causes it mainly in the
    middle of the impact. A quarter of the time step reduces it to a sixteenth, or to at most a
    quarter if the force jumps or has a kink near an output line.
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


@pytest.mark.parametrize("law", ["thornton", "lim_stronge", "universal", "mdr"])
def test_an_impact_at_a_rate_closes(law, tmp_path):
    """The energy balance of an impact closes if the strength depends on the strain rate.

    The tested laws rescale a table, have a closed form, or interpolate between tables. The balance
    error is below 2e-4 of the initial energy. The strain rate raises the strength by about 15 %.
    """
    rate = {"rate_coefficient": 0.02, "reference_rate": 1e-3}
    plain = impact(law, tmp_path / "plain", geometry="plane")
    stronger = impact(law, tmp_path / "rate", geometry="plane", **rate)
    assert share(stronger, "drift") < 2e-4
    assert share(stronger, "plastic") < 0.99 * share(plain, "plastic")


@pytest.mark.parametrize("geometry", ["plane", "pair", *MOVING])
def test_closing_is_second_order(geometry, tmp_path):
    """The balance error is of second order in the time step if the force is smooth.

    Half the time step reduces the error to a quarter. The accepted ratio is 0.3, because the
    velocity of a shaken wall is constant during a step, and output lines miss the largest error.
    """
    coarse, fine = (
        impact("thornton", tmp_path / str(k), k, geometry=geometry, damping="on") for k in (2, 4)
    )
    assert 0.1 < share(fine, "drift") / share(coarse, "drift") < 0.3
    assert (share(fine, "wallwork") > 0.1) == (geometry in MOVING)


def test_plastic_work_is_the_predicted_loss(engine_law, law_between, aluminium, tmp_path):
    """The plastic work of an impact is 1/2 m v^2 (1 - e^2), with the restitution e of the law.

    It belongs to the sphere, because the wall is rigid. The tolerance is 1e-3 of the initial
    energy, because the time step changes the restitution.
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
    """Each of two equal bodies gets half of the plastic work."""
    total = impact("thornton", tmp_path, geometry="pair")["plastic"].iloc[-1]
    assert total > 0
    assert plastic_work(tmp_path).to_numpy() == pytest.approx([total / 2] * 2, rel=1e-12)


@pytest.mark.parametrize("geometry", CASES)
def test_the_ledger_changes_no_motion(geometry, tmp_path):
    """The motion with and without energy balance is bitwise identical."""
    for state in ("on", "off"):
        deck = {"decks": DECKS, "geometry": geometry, "every": 10, **CASES[geometry]}
        run_deck(DECKS / "impact.in", {**deck, "ledger": state}, tmp_path / state)
    on, off = (read_dump(tmp_path / state / "trajectory.dump") for state in ("on", "off"))
    assert len(on) > 40
    assert (on.to_numpy() == off.to_numpy()).all()


def test_a_bed_comes_to_rest(bed):
    """The energy balance of a bed that comes to rest closes; dissipated energies never decrease.

    The balance includes the work of gravity. The limit of the balance error is 1e-3 of that work;
    the time step causes a tenth of this limit.
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
def test_ranks_have_the_same_terms(bed, ranks, grid, tmp_path):
    """Energy terms on two and four ranks equal those on one rank.

    They agree to 1e-9 of the initial energy, until collisions amplify the round-off of sums.
    """
    table = ledger("bed", tmp_path, ranks, grid=grid, before=6000, after=0)
    table = table[table["run"] == 0]
    whole = bed[1].iloc[: len(table)]
    assert table["step"].iloc[-1] == 6000 and table["plastic"].iloc[-1] > 0
    scale = whole[["kinetic", "gravity"]].iloc[0].sum()
    assert np.abs(table[ENTRIES] - whole[ENTRIES]).to_numpy().max() < 1e-9 * scale


@pytest.mark.parametrize(
    ("deck", "message"),
    [
        ("newton_on", "`newton on` is not supported"),
        ("wall_alone", "a wall has this setting, so the pair_style line needs it too"),
    ],
)
def test_unsupported_decks_are_refused(deck, message, tmp_path):
    """The energy balance refuses decks for which it would be wrong, such as `newton on`.

    With `newton on`, only one of two ranks computes a contact across their border.
    """
    with pytest.raises(EngineError, match=f"energy_ledger on: {message}"):
        run_deck(DECKS / f"{deck}.in", {"pair": "off"}, tmp_path)


def test_a_wall_that_does_not_report_is_named(tmp_path):
    log = run_deck(DECKS / "wall_alone.in", {"wall": "off"}, tmp_path / "one")
    assert "the walls far have no `energy_ledger on`" in log
    log = run_deck(DECKS / "wall_alone.in", {}, tmp_path / "none")
    assert "energy_ledger" not in log.replace("energy_ledger on", "").replace(
        "energy_ledger ${", ""
    )
