# SPDX-License-Identifier: GPL-2.0-or-later
"""Color scale of a picture: unit, range of values, and labels."""

from __future__ import annotations

import attrs
import numpy as np
from matplotlib.ticker import MaxNLocator

from plastigran.plot.quantities import Scale, prefix

#: Largest number of intervals between the labels of a color scale.
INTERVALS = 5


@attrs.frozen
class ColourScale(Scale):
    """Color scale of a picture.

    Attributes:
        ends: Smallest and largest value of the scale, in `unit`.
        labels: Number of labels, which are evenly spaced and include both ends.
    """

    ends: tuple[float, float]
    labels: int


def colour_scale(title: str, unit: str, values: object, from_zero: bool) -> ColourScale:
    """Return a color scale that covers the given values and has round numbers as labels.

    `unit` is an SI unit without prefix. With `from_zero`, the range includes zero.
    """
    letter, factor = prefix(values)
    low, high = float(np.min(values)) * factor, float(np.max(values)) * factor
    low = min(low, 0.0) if from_zero else low
    ticks = [low]  # if all values are equal, the scale has one label
    if low < high:
        ticks = MaxNLocator(INTERVALS, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high)
    ends = float(ticks[0]), float(ticks[-1])
    return ColourScale(title, letter + unit, factor, ends, len(ticks))
