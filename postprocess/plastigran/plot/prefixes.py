# SPDX-License-Identifier: GPL-2.0-or-later
"""Prefixes of units."""

from __future__ import annotations

import numpy as np

_PREFIXES = {-12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}


def prefix(values: object) -> tuple[str, float]:
    """The prefix with which the largest size of some numbers is between 1 and 1000, as far as there
    is one from p to G, and the factor from the bare unit to it; none where all are zero.

    Args:
        values: Numbers in a unit without prefix; what is not finite does not count.
    """
    sizes = np.abs(np.asarray(values, float))
    sizes = sizes[np.isfinite(sizes) & (sizes > 0)]
    if not sizes.size:
        return "", 1.0
    power = int(np.clip(3 * np.floor(np.log10(sizes.max()) / 3), min(_PREFIXES), max(_PREFIXES)))
    return _PREFIXES[power], 10.0**-power
