# SPDX-License-Identifier: GPL-2.0-or-later
"""Collision spectra: the tables that the engine's fix `collision_spectra` writes."""

from __future__ import annotations

from pathlib import Path

import pandas as pd

from plastigran.engine.dumps import DumpError

#: What is counted: its column's entry, and words with its unit in an SI deck.
QUANTITIES = {
    "normal_speed": "normal speed of approach (m/s)",
    "dissipated_energy": "energy dissipated (J)",
    "largest_force": "largest force (N)",
}
#: What an impact is with: another particle, or else the ID of a wall.
PARTICLE = "particle"
_COLUMNS = ["step", "quantity", "with", "type", "other_type", "lower", "upper", "count", "sum"]


def read_spectra(path: str | Path) -> pd.DataFrame:
    """Read the tables of a file, one row per class that has impacts.

    Args:
        path: The file.

    Returns:
        Columns: `step` of the table, which counts impacts that ended since the one before;
        `quantity`, of QUANTITIES; `with`, PARTICLE or the ID of a wall; atom types `type` and
        `other_type`; `lower` and `upper` edge of the class, both 0 for values that are not
        positive; `count` of impacts and `sum` of their values. In the deck's units.

    Raises:
        DumpError: It is no such file.
    """
    path = Path(path)
    try:
        table = pd.read_csv(path)
    except (pd.errors.ParserError, pd.errors.EmptyDataError, UnicodeDecodeError) as error:
        raise DumpError(f"{path}: no table of collision spectra ({error})") from None
    if list(table.columns) != _COLUMNS:
        raise DumpError(
            f"{path}: no table of collision spectra; its columns are {', '.join(table.columns)}, "
            f"not {', '.join(_COLUMNS)}"
        )
    return table


def spectrum(table: pd.DataFrame, quantity: str) -> pd.DataFrame:
    """Counts of all rows of a table together, class by class.

    Args:
        table: As `read_spectra` has it, or a selection of its rows.
        quantity: Of QUANTITIES.

    Returns:
        Columns `lower`, `upper`, `count` and `sum`, from the lowest class up, those without impacts
        left out.

    Raises:
        ValueError: There is no such quantity.
    """
    if quantity not in QUANTITIES:
        raise ValueError(f"quantity is {quantity!r}; it must be one of {', '.join(QUANTITIES)}")
    chosen = table[table["quantity"] == quantity]
    return chosen.groupby(["lower", "upper"], as_index=False)[["count", "sum"]].sum()


def partner_spectra(table: pd.DataFrame, quantity: str) -> dict[str, pd.DataFrame]:
    """`spectrum` of the impacts with particles, and with each wall, by what they are with."""
    partners = sorted(table["with"].unique(), key=lambda name: (name != PARTICLE, name))
    return {name: spectrum(table[table["with"] == name], quantity) for name in partners}
