# SPDX-License-Identifier: GPL-2.0-or-later
"""Geometry, yield strengths and checks of the decks of the bulk benchmark."""

from __future__ import annotations

from math import pi

import make_silo
import numpy as np
import pandas as pd
import pytest

from plastigran import laws
from plastigran.bulk.decks import deck_class
from plastigran.bulk.decks.silo import ORIFICES
from plastigran.engine.deck import read_deck
from plastigran.materials import Material


def deck(name: str, **changes: object):
    """Return a deck with its default settings, except for `changes`."""
    return deck_class(name).read(read_deck(name, changes, ".").settings)


def test_meshes_of_the_silo_have_the_orifices_of_the_deck():
    assert {name: diameter / 2 for name, diameter in make_silo.ORIFICES.items()} == ORIFICES


@pytest.mark.parametrize("count", [1000, 100000])
def test_filling_of_the_silo_has_the_volume_fraction(count):
    """Grains fill the silo to `filling_height` with the set volume fraction.

    The volume of the silo is the sum over 1e6 slices. Its relative error, 1e-6, arises at the kink
    where the cone meets the barrel.
    """
    silo = deck("silo", grain_count=count)
    heights = (np.arange(1_000_000) + 0.5) * silo.filling_height / 1e6
    widths = np.minimum(0.1, 0.03 + heights)
    volume = pi * np.sum(widths**2) * silo.filling_height / 1e6
    grains = count * 4 / 3 * pi * silo.radius**3
    assert grains / volume == pytest.approx(silo.volume_fraction, rel=1e-6)


def test_rate_of_a_steady_discharge():
    """The rate of a linear discharge is its slope; a run with too few rows has no rate."""
    silo = deck("silo")
    time = np.linspace(0, 4, 41)
    series = pd.DataFrame({"time": time, "held": 1e5 - 23200 * time})
    assert silo.rate(series) == pytest.approx(23200, rel=1e-9)
    assert silo.rate(series.iloc[:12]) is None


def test_levels_of_the_drum():
    """The surface height of a bed in a drum follows from the area of its cross section.

    A bed that fills half of the cross section reaches the axis. Both layers of the deck
    `mixing_drum` lie below the axis.
    """
    drum = deck("mixing_drum")
    assert drum.level(pi * 0.1**2 / 2) == pytest.approx(0, abs=1e-12)
    assert -0.1 < drum.level(drum.areas[0]) < drum.level(sum(drum.areas)) < 0


def test_yield_strengths_give_the_restitutions_of_the_benchmark():
    """The yield strengths of the deck `mixing_drum` give the restitution that the benchmark states.

    At 1 m/s, it is 0.5 for grains of the material M1 and 0.4 for those of M2. The tolerance is
    1e-3, because the yield strengths have three digits.
    """
    drum = deck("mixing_drum")
    grains = (
        (drum.radius, drum.density, drum.youngs_modulus, drum.yield_strength, 0.5),
        (
            drum.large_radius,
            drum.large_density,
            drum.large_youngs_modulus,
            drum.large_yield_strength,
            0.4,
        ),
    )
    for radius, density, modulus, strength, expected in grains:
        grain = Material("grain", modulus, 0.2, density, strength)
        law = grain.law("thornton", laws.combine(grain.body(), grain.body()))
        mass = 4 / 3 * pi * radius**3 * density
        impact = law.central_impact(radius / 2, mass / 2, 1.0)
        assert impact.coefficient_of_restitution == pytest.approx(expected, abs=1e-3)


def test_a_rebound_above_the_bed_is_no_free_fall():
    """The check of free fall ends where the ball first reaches the bed, also if it rebounds."""
    ball = deck("ball_impact")
    time = np.linspace(0, 0.1, 101)
    fall = ball.ball_height - 5 * time - 9.81 / 2 * time**2
    height = np.where(time < 0.022, fall, ball.ball_height - 0.14 + 2 * (time - 0.022))
    assert height[-1] > ball.bed_height + ball.ball_radius
    series = pd.DataFrame({"time": time, "ball": height, "velocity": 0.0, "atoms": 25001})
    analysis = deck("ball_impact", law="hertz", ledger="off").analyse(series)
    assert not analysis.failed
