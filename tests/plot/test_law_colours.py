# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the colors and markers of laws in figures."""

from __future__ import annotations

import pytest

from plastigran import laws
from plastigran.plot.style import COLOURS, MARKERS, law_colour, law_number
from plastigran.usable_laws import laws_for


@pytest.mark.parametrize("shape", sorted({law.shape for law in laws.LAWS.values()}))
def test_laws_of_a_shape_have_distinct_colours_and_markers(shape):
    """Each law has its own color and marker, also `hooke`, which is a law of LIGGGHTS itself."""
    names = [*laws_for(shape), "hooke"]
    assert len({law_colour(name) for name in names}) == len(names)
    assert len({MARKERS[law_number(name)] for name in names}) == len(names)
    assert len(COLOURS) == len(MARKERS) == len(set(COLOURS)) == len(set(MARKERS))
