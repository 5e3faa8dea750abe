# SPDX-License-Identifier: GPL-2.0-or-later
"""Color scale of a picture: unit, ends and labels."""

from __future__ import annotations

import attrs
import numpy as np
from matplotlib.ticker import MaxNLocator

from plastigran.plot.prefixes import prefix

#: Largest number of intervals between labels.
PARTS = 5


@attrs.frozen
class ColourScale:
    """Color scale of a picture.

    Attributes:
        title: Quantity and unit.
        factor: Factor from the SI unit to the unit of the title.
        ends: Smallest and largest value, in the unit of the title.
        labels: Number of labels, evenly spaced from end to end.
    """

    title: str
    factor: float
    ends: tuple[float, float]
    labels: int


def colour_scale(words: str, unit: str, values: object, from_zero: bool) -> ColourScale:
    """Return a scale that contains some values and has round labels.

    Args:
        words: Name of the quantity.
        unit: SI unit without prefix.
        values: One or more values to show.
        from_zero: Whether the scale starts at zero even if the smallest value is larger.
    """
    small, factor = prefix(values)
    low, high = float(np.min(values)) * factor, float(np.max(values)) * factor
    low = min(low, 0.0) if from_zero else low
    if low == high:  # a single color
        return ColourScale(f"{words} ({small}{unit})", factor, (low, high), 1)
    marks = MaxNLocator(PARTS, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high)
    ends = float(marks[0]), float(marks[-1])
    return ColourScale(f"{words} ({small}{unit})", factor, ends, len(marks))
