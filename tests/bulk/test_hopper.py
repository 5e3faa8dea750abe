# SPDX-License-Identifier: GPL-2.0-or-later
"""The hopper in LIGGGHTS: Beverloo's law, energy of deleted grains, steady rate, meshes."""

from __future__ import annotations

import numpy as np
import pytest

from plastigran.bulk.decks.hopper import orifices
from plastigran.engine.deck import read_deck


@pytest.fixture(scope="module")
def discharged(steady_flow):
    """A run in which half of the grains flow out."""
    return steady_flow("hopper")


def test_discharge_follows_beverloo(discharged):
    """The discharge rate lies in the band of Beverloo's law, and all other checks pass.

    The discharge is steady: the statistical error of its rate is below 5 %.
    """
    assert discharged.passed and len(discharged.checks) == 5
    assert any("Beverloo" in name for name in discharged.checks["name"])
    series = discharged.series
    discharge = discharged.deck.discharge(series)
    assert discharge.rate_error < 0.05 * discharge.rate
    assert series["counted"].iloc[-1] > 0.5 * series["atoms"].iloc[0]
    # Volume fractions of spheres at rest range from loose (high friction) to dense packings.
    # Overlaps of soft grains add some hundredths.
    assert 0.54 < series["packing"].iloc[0] < 0.67


def test_deleted_grains_leave_the_energy_balance(discharged):
    """The energy balance subtracts the energy of deleted grains. Heights count from the orifice.

    A deleted grain has at most the energy of a free fall over one orifice diameter, as in the
    derivation of Beverloo's law.
    """
    series, deck = discharged.series, discharged.deck
    gone = series["atoms"].iloc[0] - series["atoms"].iloc[-1]
    assert gone > 100
    weight = deck.grains.mass * deck.gravitational_acceleration
    assert 0 < -series["inserted"].iloc[-1] / gone / weight < 8 * 2 * deck.radius


def test_a_rate_that_falls_is_noticed(discharged):
    """A check fails if the discharge rate falls, even if its mean follows Beverloo's law.

    In the test, the discharge is 1.6 times as fast in about the first half of the steady part.
    """
    series = discharged.series
    time, counted = series["time"], series["counted"]
    turn = time[counted < 0.37 * series["atoms"].iloc[0]].iloc[-1]
    then = np.where(time < turn / 1.6, 1.6 * time, time + turn - turn / 1.6)
    faster = np.interp(then, time, counted).round()
    changed = series.assign(counted=faster, held=series["atoms"].iloc[0] - faster)
    (check,) = discharged.deck.analyse(changed).failed
    assert check.name.startswith("relative change of the rate between")


def test_unmeasured_rate_gives_a_note(discharged, brief_run):
    run = brief_run("hopper")
    assert "the discharge rate was not measured" in run.notes[0]
    assert (
        "some results were not measured" in repr(run)
        and not run.checks["name"].str.contains("rate").any()
    )
    assert not discharged.notes and "not all" not in repr(discharged)


def test_meshes_are_files_of_the_deck():
    """The mesh of every orifice is copied to the results."""
    for orifice in orifices():
        files = read_deck("hopper", {"orifice": orifice}, ".").files
        assert {f"hopper_{orifice}.stl", "plate.stl"} <= {file.name for file in files}
