# SPDX-License-Identifier: GPL-2.0-or-later
"""The scale of a picture's colours: its unit, its ends and the numbers beside it."""

from __future__ import annotations

import attrs
import numpy as np
from matplotlib.ticker import MaxNLocator

from plastigran.plot.prefixes import prefix

#: Parts of a scale, at most.
PARTS = 5


@attrs.frozen
class ColourScale:
    """What colours say.

    Attributes:
        title: Quantity and unit.
        factor: From the SI unit to that of the title.
        ends: Least and largest value, in the title's unit.
        labels: Numbers beside it, evenly from end to end.
    """

    title: str
    factor: float
    ends: tuple[float, float]
    labels: int


def colour_scale(words: str, unit: str, values: object, from_zero: bool) -> ColourScale:
    """A scale that holds some values, with round numbers beside it.

    Args:
        words: What the values are.
        unit: Of SI, without a prefix.
        values: That are to be shown, one or more.
        from_zero: Whether the scale begins at nothing, whatever the least value.
    """
    small, factor = prefix(values)
    low, high = float(np.min(values)) * factor, float(np.max(values)) * factor
    low = min(low, 0.0) if from_zero else low
    if low == high:  # one colour
        return ColourScale(f"{words} ({small}{unit})", factor, (low, high), 1)
    marks = MaxNLocator(PARTS, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high)
    ends = float(marks[0]), float(marks[-1])
    return ColourScale(f"{words} ({small}{unit})", factor, ends, len(marks))
