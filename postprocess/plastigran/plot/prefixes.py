# SPDX-License-Identifier: GPL-2.0-or-later
"""Prefixes of units."""

from __future__ import annotations

import numpy as np

_PREFIXES = {-12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}


def prefix(values: object) -> tuple[str, float]:
    """Return the prefix that brings the largest absolute value to 1 to 1000, and its factor.

    Prefixes range from p to G. If all values are zero, there is no prefix and the factor is 1.

    Args:
        values: Numbers in a unit without prefix; infinite values and NaN are ignored.
    """
    sizes = np.abs(np.asarray(values, float))
    sizes = sizes[np.isfinite(sizes) & (sizes > 0)]
    if not sizes.size:
        return "", 1.0
    power = int(np.clip(3 * np.floor(np.log10(sizes.max()) / 3), min(_PREFIXES), max(_PREFIXES)))
    return _PREFIXES[power], 10.0**-power
