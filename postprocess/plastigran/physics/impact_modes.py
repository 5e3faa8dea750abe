# SPDX-License-Identifier: GPL-2.0-or-later
"""Free vibrations of a sphere that a normal impact can excite.

A normal impact is symmetric about the normal. Such an impact excites radial and spheroidal modes,
but not toroidal modes, which twist the sphere.
"""

from __future__ import annotations

from itertools import count

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike

from plastigran.physics.modes import sphere_modes


def impact_modes(
    youngs_modulus: float, poissons_ratio: float, density: float, radius: float, highest: float
) -> pd.DataFrame:
    """Return all radial and spheroidal modes of a sphere up to a frequency.

    Args:
        youngs_modulus, poissons_ratio, density, radius: As for `sphere_modes`.
        highest: Highest frequency [Hz].

    Returns:
        Rows and columns of `sphere_modes`.

    Raises:
        ValueError: Poisson's ratio is out of range.
        ArithmeticError: Two spheroidal modes are too close to separate.
    """
    by_degree, overtones = [], 1
    for degree in count():
        while True:
            modes = sphere_modes(
                youngs_modulus, poissons_ratio, density, radius, [degree], overtones
            )
            modes = modes[modes["kind"] != "toroidal"]
            if modes["frequency"].max() > highest:
                break
            overtones += 1
        by_degree.append(modes[modes["frequency"] <= highest])
        # The next degree has at most this many modes below `highest`.
        overtones = len(by_degree[-1]) + 1
        # Stop at a degree without modes, because from degree 2 on the lowest frequency increases
        # with the degree.
        if degree >= 2 and by_degree[-1].empty:
            break
    return pd.concat(by_degree).sort_values("frequency", ignore_index=True)


def nearest_modes(frequencies: ArrayLike, modes: pd.DataFrame) -> pd.DataFrame:
    """Return the mode with the closest frequency for each of the given frequencies.

    Args:
        frequencies: Frequencies (n,) [Hz].
        modes: Modes of `impact_modes` or `sphere_modes`.

    Returns:
        One row per frequency. The columns are the columns of `modes`, `measured` (the given
        frequency [Hz]) and `difference` (relative to the frequency of the mode [-]).
    """
    measured = np.asarray(frequencies, dtype=float)
    exact = modes["frequency"].to_numpy()
    nearest = np.argmin(np.abs(exact[:, None] - measured), axis=0)
    table = modes.iloc[nearest].reset_index(drop=True)
    return table.assign(measured=measured, difference=measured / exact[nearest] - 1)
