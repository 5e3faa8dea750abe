# SPDX-License-Identifier: GPL-2.0-or-later
"""Fit of Heckel's line to the compaction of grains in a die."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

#: Fractions of the peak pressure between which Heckel's line is fitted. At these pressures, the
#: rearrangement of the grains has ended.
STRAIGHT = (0.3, 0.9)


def heckel_line(density: ArrayLike, pressure: ArrayLike) -> tuple[float, float]:
    """Fit Heckel's line ln(1/(1 - D)) = K P + A to the straight part of the loading.

    Args:
        density: Relative density D (n,) [-].
        pressure: Pressure P of the punch (n,) [Pa]; values after the peak are ignored.

    Returns:
        Slope K [1/Pa] and intercept A [-].

    Source: Heckel 1961, Trans. Metall. Soc. AIME 221:671. The slope is 1/(3 sigma_Y) for grains of
    yield strength sigma_Y (ibid. 221:1001).
    """
    density, pressure = np.asarray(density, dtype=float), np.asarray(pressure, dtype=float)
    top = int(np.argmax(pressure))
    share = pressure[: top + 1] / pressure[top]
    straight = (share >= STRAIGHT[0]) & (share <= STRAIGHT[1])
    from scipy.stats import linregress  # imported here: scipy.stats is slow

    fit = linregress(pressure[: top + 1][straight], -np.log1p(-density[: top + 1][straight]))
    return fit.slope, fit.intercept
