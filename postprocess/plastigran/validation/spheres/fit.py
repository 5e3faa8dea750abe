# SPDX-License-Identifier: GPL-2.0-or-later
"""Fit the constants of the law `universal` to the finite-element table of spheres.

    python -m plastigran.validation.spheres.fit [--figures FOLDER]

This command prints the constants in the format of the law's C++ header. It also prints the errors
of the law for the metals of the fit and for held-out metals.
"""

from __future__ import annotations

import sys
from itertools import pairwise
from pathlib import Path

import attrs
import numpy as np
import pandas as pd
from scipy.optimize import least_squares

from plastigran.validation.spheres import SPEED_RATIOS, contact_kinds, table
from plastigran.validation.spheres.forms import Constants, Metals, errors, peak

#: The fit divides the relative differences of each quantity by these scales, which are close to the
#: uncertainties of the finite elements.
FORCE, CONTACT_RADIUS, WORK_UNLOADING, RECOVERY = 0.002, 0.006, 0.004, 0.008
#: Smallest force / yield force of the fit. At smaller forces, too few elements are in contact to
#: determine the contact radius.
SMALLEST_FORCE = 8.0
DIGITS = 4

#: Bounds of the speed regimes for the printed errors, as impact speed / yield speed.
REGIMES = (*SPEED_RATIOS, 1200)


def fit(rows: pd.DataFrame) -> Constants:
    """Fit the constants of the law `universal` to the finite elements of the metals of the fit.

    `rows` are rows of the table of spheres. The fit minimizes the soft L1 norm of the scaled
    differences.
    """
    rows = rows[rows["set"] == "fit"]
    metals, t = Metals.of(rows), np.sqrt(rows["overlap_ratio"].to_numpy())
    names = [field.name for field in attrs.fields(Constants)]
    start = np.array(attrs.astuple(Constants()))
    resolved = rows["force_ratio"].to_numpy() >= SMALLEST_FORCE
    measured = [
        rows["force_ratio"],
        rows["contact_radius_ratio"],
        rows["overlap_ratio"] - rows["overlap_res_ratio"],
        rows["work_unloading_ratio"],
    ]
    measured = np.log([column.to_numpy() for column in measured])
    scale = np.array([FORCE, CONTACT_RADIUS, RECOVERY, WORK_UNLOADING])

    def residuals(values: np.ndarray) -> np.ndarray:
        computed = peak(Constants(*values), metals, t)
        error = (np.log(attrs.astuple(computed)) - measured) / scale[:, None]
        error[1] *= resolved
        return error.ravel()

    solution = least_squares(
        residuals, start, loss="soft_l1", x_scale=start, ftol=1e-12, xtol=1e-12, max_nfev=5000
    )
    rounded = {name: float(f"{x:.{DIGITS}g}") for name, x in zip(names, solution.x, strict=True)}
    return Constants(**rounded)


def regimes(rows: pd.DataFrame) -> pd.DataFrame:
    """Return the speed regime and the kind of contact of each row of the table of spheres.

    The columns of the result are `regime` and `kind`.
    """
    labels = [f"{low} to {high}" for low, high in pairwise(REGIMES)]
    regime = pd.cut(rows["speed_ratio"], REGIMES, labels=labels)
    return pd.DataFrame({"regime": regime, "kind": contact_kinds(rows)}, index=rows.index)


def bands(constants: Constants, rows: pd.DataFrame) -> pd.DataFrame:
    """Return the largest errors of the law [%] by set, kind of contact and speed regime.

    The sets are the metals of the fit and the held-out metals.
    """
    error = errors(constants, rows).abs()
    where = [rows["set"], *(column for _, column in regimes(rows).items())]
    return error.groupby(where, observed=True, sort=True).max()


def main(arguments: list[str]) -> None:
    """Print the constants and their errors; `--figures` draws the two figures of the docs."""
    rows = table()
    constants = fit(rows)
    for name, value in attrs.asdict(constants).items():
        print(f"  static constexpr double {name} = {value:g};")
    print(bands(constants, rows).round(2).to_string())
    if arguments[:1] == ["--figures"]:
        from plastigran.validation.spheres.figures import write

        write(constants, rows, Path(arguments[1]))


if __name__ == "__main__":
    main(sys.argv[1:])
