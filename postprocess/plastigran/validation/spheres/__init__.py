# SPDX-License-Identifier: GPL-2.0-or-later
"""Table of spheres: many metals on a rigid plane, loaded and unloaded by finite elements.

`table()` reads the file `plastigran/data/finite_elements_spheres.csv`, which
`python -m plastigran.validation.spheres.compute` writes. The file has a row for each metal and each
largest force. All quantities are dimensionless. "In yield units" means divided by the Hertzian
value at first yield: the force P_Y, the overlap alpha_Y = a_Y^2/R, the contact radius a_Y or the
work P_Y alpha_Y. The yield speed v_Y follows from 1/2 m v_Y^2 = 2/5 P_Y alpha_Y.

    metal                        name, the same for all rows of a metal
    set                          `fit`, or `held` if the metal is not in the fit of `universal`
    yield_strength_ratio         sigma_Y/E*, E* = E/(1 - nu^2)
    poissons_ratio               nu
    hardening_ratio              H/E, H = d(stress)/d(plastic strain); 0 if perfectly plastic
    strain                       `small` or `finite`: kinematics of the finite elements
    force_ratio                  largest force, in yield units
    speed_ratio                  v/v_Y of the impact that has this largest force:
                                 1/2 m v^2 = work_loading
    coefficient_of_restitution   sqrt(work_unloading/work_loading)
    overlap_ratio                overlap at the largest force, in yield units
    overlap_res_ratio            residual overlap after unloading, in yield units
    contact_radius_ratio         contact radius at the largest force, in yield units
    work_loading_ratio           work up to the largest force / (P_Y alpha_Y)
    work_unloading_ratio         released energy / (P_Y alpha_Y)
    contact_radius_over_radius   a/R at the largest force
"""

from __future__ import annotations

from importlib.resources import files

import numpy as np
import pandas as pd

from plastigran.calibration.expected_errors import KINDS, WIDE

#: Lower bounds of the speed regimes, as impact speed / yield speed. The last regime ends at the
#: largest speed of the table that is evaluated.
SPEED_RATIOS = (1, 3, 10, 100, 300)
TABLE = files("plastigran") / "data" / "finite_elements_spheres.csv"


def table() -> pd.DataFrame:
    """Read the table of finite-element results for spheres from the package."""
    with TABLE.open() as file:
        return pd.read_csv(file, comment="#")


def contact_kinds(rows: pd.DataFrame) -> np.ndarray:
    """Return the kind of contact, one of `KINDS`, for each of the n rows of `table()` (n,)."""
    plastic = np.where(rows["hardening_ratio"] > 0, KINDS[1], KINDS[0])
    return np.where(rows["contact_radius_over_radius"] >= WIDE, KINDS[2], plastic)
