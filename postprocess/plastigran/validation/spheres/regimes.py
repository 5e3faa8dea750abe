# SPDX-License-Identifier: GPL-2.0-or-later
"""Speed regime and kind of contact of a row of the table of spheres."""

from __future__ import annotations

import numpy as np
import pandas as pd

from plastigran.calibration.expected_errors import KINDS, WIDE

#: Bounds of the speed regimes, v/v_Y; the end of a table follows.
SPEED_RATIOS = (1, 3, 10, 100, 300)


def kind(rows: pd.DataFrame) -> np.ndarray:
    """Return one of `KINDS` for each row of the table of spheres."""
    plastic = np.where(rows["hardening_ratio"] > 0, KINDS[1], KINDS[0])
    return np.where(rows["contact_radius_over_radius"] >= WIDE, KINDS[2], plastic)
