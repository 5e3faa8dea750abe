# SPDX-License-Identifier: GPL-2.0-or-later
"""Vibration modes of a sphere that a normal impact can excite."""

from __future__ import annotations

import pytest

from plastigran.physics.impact_modes import impact_modes, nearest_modes
from plastigran.physics.modes import sphere_modes

ICE = (9.3e9, 0.25, 900.0, 0.01)


def test_all_modes_but_the_toroidal_ones_are_there():
    """`impact_modes` returns all modes up to a frequency, here 255 kHz, except the toroidal ones.

    The reference table contains all of them, because it has more degrees and overtones than needed.
    """
    table = sphere_modes(*ICE, degrees=range(8), overtones=4)
    table = table[(table["kind"] != "toroidal") & (table["frequency"] <= 255e3)]
    found = impact_modes(*ICE, highest=255e3)
    assert found["frequency"].to_numpy() == pytest.approx(table["frequency"].to_numpy(), rel=1e-12)
    assert set(found["kind"]) == {"radial", "spheroidal"}


def test_a_frequency_finds_its_mode():
    table = nearest_modes([143e3, 86e3], impact_modes(*ICE, highest=200e3))
    assert list(table["kind"]) == ["radial", "spheroidal"]
    assert list(table["difference"]) == pytest.approx(
        [143 / 143.666 - 1, 86 / 85.419 - 1], abs=1e-5
    )
