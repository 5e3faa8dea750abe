# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests that color scales have round numbers, and units with prefixes such as mm."""

from __future__ import annotations

import numpy as np
import pytest

from plastigran.plot.colour_scale import INTERVALS, colour_scale
from plastigran.plot.quantities import prefix


@pytest.mark.parametrize(
    ("largest", "expected"),
    [(0.0, ""), (1.0, ""), (999.0, ""), (1000.0, "k"), (0.02, "m"), (6.2e-4, "µ"), (1e-20, "p")],
)
def test_prefix_brings_the_largest_number_to_1_to_1000(largest, expected):
    small, factor = prefix([largest, -largest / 7, np.nan])
    assert small == expected
    if 1e-12 <= largest < 1e12:
        assert 1 <= factor * largest < 1000


@pytest.mark.parametrize("values", [[3.1e-5, 6.2e-4], [0.1, 0.37], [-3.0, 12.0], [5e-3, 5.01e-3]])
@pytest.mark.parametrize("from_zero", [True, False])
def test_scale_contains_the_values_and_has_round_labels(values, from_zero):
    scale = colour_scale("plastic work", "J", values, from_zero)
    low, high = np.array(values) * scale.factor
    assert scale.ends[0] <= low < high <= scale.ends[1]
    assert not from_zero or scale.ends[0] <= 0
    assert 2 <= scale.labels <= INTERVALS + 1
    marks = np.linspace(*scale.ends, scale.labels)
    assert all(float(f"{mark:.4g}") == pytest.approx(mark, abs=1e-12 * high) for mark in marks)


def test_single_value_has_one_label():
    scale = colour_scale("radius", "m", [5e-3, 5e-3], from_zero=False)
    assert (scale.axis, scale.ends, scale.labels) == ("radius (mm)", (5.0, 5.0), 1)
