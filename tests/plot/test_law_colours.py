# SPDX-License-Identifier: GPL-2.0-or-later
"""A law is known by its colour and marker in every figure."""

from __future__ import annotations

import pytest

from plastigran import laws
from plastigran.plot.style import COLOURS, MARKERS, law_colour, law_number
from plastigran.usable_laws import laws_for


@pytest.mark.parametrize("shape", sorted({law.shape for law in laws.LAWS.values()}))
def test_laws_of_a_shape_are_told_apart(shape):
    """And from a law that is not this package's."""
    names = [*laws_for(shape), "hooke"]
    assert len({law_colour(name) for name in names}) == len(names)
    assert len({MARKERS[law_number(name)] for name in names}) == len(names)
    assert len(COLOURS) == len(MARKERS) == len(set(COLOURS)) == len(set(MARKERS))
