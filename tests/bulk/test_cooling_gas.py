# SPDX-License-Identifier: GPL-2.0-or-later
"""A cooling granular gas in LIGGGHTS, compared with mean-field theory."""

from __future__ import annotations

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
    """The temperature follows the mean-field theory within the limit of the deck's check.

    This limit is 8 % plus four standard deviations. The temperature falls by at least 60 %, so the
    test would detect a gas that does not cool.
    """
    assert yielding_gas.passed
    series = yielding_gas.series
    assert series["temperature"].iloc[-1] < 0.4 * series["temperature"].iloc[0]
    assert series["collisions"].iloc[-1] > 15


def test_viscoelastic_gas(tmp_path):
    """A gas with a viscoelastic law cools from its initial granular temperature, 16 m^2/s^2.

    The deck first mixes the grains without dissipation, so the temperature does not change
    before step 0.
    """
    values = {"law": "viscoelastic_hertz", "dissipative_constant": 1e-7, "timestep": 7e-8}
    values |= {"side": 6, "duration": 10, "rows": 10, "checkpoints": 1}
    run = run_bulk("cooling_gas", values, tmp_path / "run", show=False)
    temperature = run.series["temperature"]
    assert run.passed
    # Grains in contact store up to 2 % of the kinetic energy as elastic energy.
    assert temperature.iloc[0] == pytest.approx(16, rel=0.02)
    assert temperature.iloc[-1] < 0.8 * temperature.iloc[0]


def test_options_reach_the_theory():
    """The mean-field theory uses the options of the law for the mean energy loss of an impact.

    It ignores options of the contact model in LIGGGHTS, such as `energy_ledger`.
    """
    deck = gas(law="stronge", options="unloading area energy_ledger on")
    assert deck.grains.options == {"unloading": "area"}
    book, area = (
        gas(law="stronge", options=options).gas().loss(16.0) for options in ("", "unloading area")
    )
    assert area < 0.9 * book


def test_duration_is_in_collision_times(yielding_gas):
    """The setting `duration` counts collision times of the theory at the initial temperature.

    The tolerance is 1e-3, because the run ends at a whole number of log lines.
    """
    deck, series = yielding_gas.deck, yielding_gas.series
    times = series["time"].iloc[-1] * float(deck.gas().collision_rate(deck.temperature))
    assert times == pytest.approx(deck.duration, rel=1e-3)
