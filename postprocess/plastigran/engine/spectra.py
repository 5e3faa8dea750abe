# SPDX-License-Identifier: GPL-2.0-or-later
"""Collision spectra: histograms of impacts that `fix collision_spectra` writes."""

from __future__ import annotations

from pathlib import Path

import pandas as pd

from plastigran.engine.dumps import DumpError

#: Quantities of the histograms: name in the column `quantity`, and description with the SI unit.
QUANTITIES = {
    "normal_speed": "normal speed of approach (m/s)",
    "dissipated_energy": "energy dissipated (J)",
    "largest_force": "largest force (N)",
}
#: Word in the column `with` for impacts between particles. For impacts on a wall, the column
#: contains the ID of the wall's fix.
PARTICLE = "particle"
_COLUMNS = ["step", "quantity", "with", "type", "other_type", "lower", "upper", "count", "sum"]


def read_spectra(path: str | Path) -> pd.DataFrame:
    """Read the tables of collision spectra in a file, one row per class that contains impacts.

    A class is a bin of the histogram.

    Args:
        path: File that `fix collision_spectra` wrote.

    Returns:
        Columns `step`, `quantity`, `with`, `type`, `other_type`, `lower`, `upper`, `count` and
        `sum`, in the units of the deck. `step` is the step at which the table was written,
        `quantity` a key of QUANTITIES, and `with` is PARTICLE or the ID of a wall's fix. `type` and
        `other_type` are atom types. `lower` and `upper` are the edges of the class, both 0 for
        the class of values that are not positive. `count` is the number of impacts, and `sum` the
        sum of their values. Each table counts the impacts that ended since the previous table.

    Raises:
        DumpError: The file is not a table of collision spectra.
    """
    path = Path(path)
    try:
        table = pd.read_csv(path)
    except (pd.errors.ParserError, pd.errors.EmptyDataError, UnicodeDecodeError) as error:
        raise DumpError(f"{path} is not a table of collision spectra ({error})") from None
    if list(table.columns) != _COLUMNS:
        raise DumpError(
            f"{path} is not a table of collision spectra: its columns are "
            f"{', '.join(table.columns)}, not {', '.join(_COLUMNS)}"
        )
    return table


def spectrum(table: pd.DataFrame, quantity: str) -> pd.DataFrame:
    """Return the number of impacts in each class, summed over time steps, atom types and walls.

    Args:
        table: Table of `read_spectra`, or a selection of its rows.
        quantity: Key of QUANTITIES.

    Returns:
        Columns `lower`, `upper`, `count` and `sum`, sorted by class, without empty classes.

    Raises:
        ValueError: The quantity is unknown.
    """
    if quantity not in QUANTITIES:
        raise ValueError(f"quantity is {quantity!r}; it must be one of {', '.join(QUANTITIES)}")
    chosen = table[table["quantity"] == quantity]
    return chosen.groupby(["lower", "upper"], as_index=False)[["count", "sum"]].sum()


def partner_spectra(table: pd.DataFrame, quantity: str) -> dict[str, pd.DataFrame]:
    """Return one `spectrum` for impacts between particles, and one for impacts on each wall.

    The keys are PARTICLE and the IDs of the walls' fixes.
    """
    partners = sorted(table["with"].unique(), key=lambda name: (name != PARTICLE, name))
    return {name: spectrum(table[table["with"] == name], quantity) for name in partners}
