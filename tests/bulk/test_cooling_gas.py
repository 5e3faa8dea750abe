# SPDX-License-Identifier: GPL-2.0-or-later
"""The cooling gas in LIGGGHTS: mean field, elastic limit, ranks."""

from __future__ import annotations

import numpy as np
import pytest

from plastigran.bulk.decks.cooling_gas import CoolingGas
from plastigran.bulk.run import run_bulk
from plastigran.engine.deck import read_deck


@pytest.fixture(scope="module")
def yielding_gas(brief_run):
    """A run of 216 grains whose temperature falls to a quarter."""
    return brief_run("cooling_gas")


def gas(**changes) -> CoolingGas:
    return CoolingGas.read(read_deck("cooling_gas", changes, ".").settings)


def test_follows_mean_field(yielding_gas):
    """The check allows 8 % for mean field and four standard deviations; the gas cools by more."""
    assert yielding_gas.passed
    series = yielding_gas.series
    assert series["temperature"].iloc[-1] < 0.4 * series["temperature"].iloc[0]
    assert series["collisions"].iloc[-1] > 15


def test_viscoelastic_gas(tmp_path):
    """Dissipation begins at step 0, after the mixing, and never stops."""
    values = {"law": "viscoelastic_hertz", "dissipative_constant": 1e-7, "timestep": 7e-8}
    values |= {"side": 6, "duration": 10, "rows": 10, "checkpoints": 1}
    run = run_bulk("cooling_gas", values, tmp_path / "run", show=False)
    temperature = run.series["temperature"]
    assert run.passed
    # Grains in contact store up to 2 % of the kinetic energy as elastic energy.
    assert temperature.iloc[0] == pytest.approx(16, rel=0.02)
    assert temperature.iloc[-1] < 0.8 * temperature.iloc[0]


def test_lost_energy_is_plastic_work(yielding_gas):
    """The relative tolerance 2e-3 is the balance error that the checks allow."""
    first, last = yielding_gas.series.iloc[0], yielding_gas.series.iloc[-1]
    lost = first["kinetic"] + first["elastic"] - last["kinetic"] - last["elastic"]
    assert last["plastic"] - first["plastic"] == pytest.approx(lost, rel=2e-3)
    assert lost > 0.5 * first["kinetic"]


def test_unyielding_gas_equals_stock_hertz(tmp_path):
    """With a huge yield strength, energy is conserved, and the gas moves as with stock hertz.

    The runs agree to 1e-9 in the first impacts; each impact multiplies round-off by ten. Later, the
    energy stored in impacts differs, with a standard deviation of 0.4 % of the total. The limit,
    0.7 %, is four standard deviations of the difference between two means of 10 rows.
    """
    runs = {}
    for law in ("hertz", "vu_quoc_zhang"):
        values = {"law": law, "yield_strength": 1e18, "mixing": 0.1, "side": 5, "ledger": "off"}
        values |= {"duration": 10, "rows": 20, "checkpoints": 1}
        run = run_bulk("cooling_gas", values, tmp_path / law, show=False)
        assert run.passed  # energy stays
        runs[law] = run.series["kinetic_energy"].to_numpy()
    stock, ours = runs.values()
    assert np.ptp(stock[:6]) > 1e-4 * stock[0], "no impact yet"
    assert ours[:6] == pytest.approx(stock[:6], rel=1e-9)
    assert ours[10:].mean() == pytest.approx(stock[10:].mean(), rel=7e-3)


def test_ranks_agree_in_the_course(tmp_path):
    """After some impacts, the gases on 1 and 2 ranks are independent. The limit of their difference
    is four times sqrt(2) times the error of one gas, plus the energy stored in impacts."""
    values = {"side": 5, "mixing": 0.1, "duration": 16, "rows": 32, "checkpoints": 1}
    runs = [
        run_bulk("cooling_gas", values, tmp_path / str(ranks), ranks, show=False)
        for ranks in (1, 2)
    ]
    one, two = (run.series["kinetic_energy"].to_numpy() for run in runs)
    assert one[4] < 0.95 * one[0], "no impacts yet"
    assert two[:5] == pytest.approx(one[:5], rel=1e-9)
    error = 4 * 2**0.5 * runs[0].series["temperature_error"].to_numpy()
    deck = runs[0].deck
    assert (np.abs(two / one - 1) < error + deck.stored_share(deck.gas())).all()


def test_options_reach_the_theory():
    """Options of the law change its restitution; other options of the model are ignored."""
    deck = gas(law="stronge", options="unloading area energy_ledger on")
    assert deck.grains.options == {"unloading": "area"}
    book, area = (
        gas(law="stronge", options=options).gas().loss(16.0) for options in ("", "unloading area")
    )
    assert area < 0.9 * book


def test_duration_is_in_collision_times(yielding_gas):
    """The deck uses the collision rate of theory. The tolerance 1e-3 covers the end, which is
    rounded to a row."""
    deck, series = yielding_gas.deck, yielding_gas.series
    times = series["time"].iloc[-1] * float(deck.gas().collision_rate(deck.temperature))
    assert times == pytest.approx(deck.duration, rel=1e-3)
