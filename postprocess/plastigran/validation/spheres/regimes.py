# SPDX-License-Identifier: GPL-2.0-or-later
"""Which regime of speed and which kind of contact a row of the table of spheres belongs to."""

from __future__ import annotations

import numpy as np
import pandas as pd

from plastigran.calibration.expected_errors import KINDS, WIDE

#: Bounds of the regimes of speed, v/v_Y; what a table ends at follows.
SPEED_RATIOS = (1, 3, 10, 100, 300)


def kind(rows: pd.DataFrame) -> np.ndarray:
    """Of each row of the table of spheres, one of `KINDS`."""
    plastic = np.where(rows["hardening_ratio"] > 0, KINDS[1], KINDS[0])
    return np.where(rows["contact_radius_over_radius"] >= WIDE, KINDS[2], plastic)
