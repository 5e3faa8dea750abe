# SPDX-License-Identifier: GPL-2.0-or-later
"""The free vibrations of a sphere that an impact along its normal can excite.

It is symmetric about the normal and pushes along it, so it excites radial and spheroidal modes;
toroidal ones twist the sphere.
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
    """Radial and spheroidal modes up to a frequency, none left out.

    Args:
        youngs_modulus, poissons_ratio, density, radius: As for `sphere_modes`.
        highest: Frequency [Hz].

    Returns:
        Rows and columns of `sphere_modes`.
    """
    found, overtones = [], 1
    for degree in count():
        while True:
            modes = sphere_modes(
                youngs_modulus, poissons_ratio, density, radius, [degree], overtones
            )
            modes = modes[modes["kind"] != "toroidal"]
            if modes["frequency"].max() > highest:
                break
            overtones += 1
        found.append(modes[modes["frequency"] <= highest])
        overtones = len(found[-1]) + 1  # of the next degree as many are below `highest`, or fewer
        # From degree 2 on the gravest mode of a degree rises with it.
        if degree >= 2 and found[-1].empty:
            break
    return pd.concat(found).sort_values("frequency", ignore_index=True)


def nearest_modes(frequencies: ArrayLike, modes: pd.DataFrame) -> pd.DataFrame:
    """The mode next to each of some frequencies.

    Args:
        frequencies: (n,) [Hz].
        modes: Of `impact_modes` or `sphere_modes`.

    Returns:
        One row a frequency: the columns of `modes`, `found` (that frequency, Hz) and `difference`
        (of it from the mode's, over the mode's) [-].
    """
    found = np.asarray(frequencies, dtype=float)
    exact = modes["frequency"].to_numpy()
    nearest = np.argmin(np.abs(exact[:, None] - found), axis=0)
    table = modes.iloc[nearest].reset_index(drop=True)
    return table.assign(found=found, difference=found / exact[nearest] - 1)
