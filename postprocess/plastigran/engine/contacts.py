# SPDX-License-Identifier: GPL-2.0-or-later
"""Read dumps of contacts between particles, and between particles and walls."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd

from plastigran.engine.dumps import DumpError, read_tables

# Columns that `compute pair/gran/local` and `compute wall/gran/local` write for each field.
# LIGGGHTS always writes the fields in this order, whatever their order in the input script.
PAIR_COLUMNS = {
    "pos": ("x_i", "y_i", "z_i", "x_j", "y_j", "z_j"),
    "vel": ("vx_i", "vy_i", "vz_i", "vx_j", "vy_j", "vz_j"),
    "id": ("id_i", "id_j", "periodic"),
    "force": ("fx", "fy", "fz"),
    "force_normal": ("fnx", "fny", "fnz"),
    "force_tangential": ("ftx", "fty", "ftz"),
    "torque": ("tx", "ty", "tz"),
    "torque_normal": ("tnx", "tny", "tnz"),
    "torque_tangential": ("ttx", "tty", "ttz"),
    "history": None,  # number of columns depends on the model
    "contactArea": ("contact_area",),
    "delta": ("overlap",),
    "contactPoint": ("contact_x", "contact_y", "contact_z"),
    "ms_id": ("multisphere_i", "multisphere_j"),
    "heatFlux": ("heat_flux",),  # the heat flux is always the last column
}
WALL_COLUMNS = PAIR_COLUMNS | {
    "pos": ("contact_x", "contact_y", "contact_z", "x", "y", "z"),
    "vel": ("wall_vx", "wall_vy", "wall_vz", "vx", "vy", "vz"),
    "id": ("mesh_id", "triangle_id", "id"),
}


def contact_columns(kind: str, fields: list[str], total: int) -> list[str]:
    """Return the column names of a local dump from the fields of the compute.

    Args:
        kind: "PAIR" or "WALL".
        fields: Fields of `compute pair/gran/local` or `wall/gran/local`, in any order.
        total: Number of columns; columns without field belong to the contact history.

    Returns:
        `total` names.

    Raises:
        DumpError: A field is unknown, or the total does not match.
    """
    table = {"PAIR": PAIR_COLUMNS, "WALL": WALL_COLUMNS}[kind]
    unknown = [field for field in fields if field not in table]
    if unknown:
        raise DumpError(f"unknown contact field {unknown[0]!r}; known: {' '.join(table)}")
    spare = total - sum(len(table[field] or ()) for field in fields)
    names: list[str] = []
    for field, columns in table.items():
        if field not in fields:
            continue
        if columns is None:
            names += [f"history_{k}" for k in range(1, spare + 1)]
        else:
            names += columns
    if len(names) != total:
        raise DumpError(
            f"fields {' '.join(fields)} give {len(names)} columns, but the file has {total}"
        )
    return names


def read_contacts(
    path: str | Path, kind: str | None = None, fields: str | None = None, touching: bool = True
) -> pd.DataFrame:
    """Read a `dump local` file of a `compute pair/gran/local` or `wall/gran/local`.

    Args:
        path: File with a label for kind and fields (`dump_modify ID label "PAIR pos id ..."`).
        kind: "PAIR" or "WALL", for a file without such a label.
        fields: Fields of the compute, e.g. "pos id force delta", for a file without such a label.
        touching: Whether to drop neighbors without overlap and force, which LIGGGHTS lists too.

    Returns:
        One row per contact and frame: `step`, then columns named as in `PAIR_COLUMNS` and
        `WALL_COLUMNS`.

    Raises:
        DumpError: The file is not a local dump, or its columns do not match the fields.
    """
    ((label, _, table),) = read_tables(path, None)
    table.columns = _column_names(path, label, table, kind, fields)
    return _touching(table) if touching else table


def _column_names(
    path: str | Path, label: str, table: pd.DataFrame, kind: str | None, fields: str | None
) -> list[str]:
    """Return the column names. If kind or fields is None, use the label of the file instead."""
    if kind is None or fields is None:
        kind, _, fields = label.partition(" ")
        if kind not in ("PAIR", "WALL"):
            raise DumpError(
                f"{path}: label {label!r} does not name the columns. Pass the arguments kind (PAIR "
                "or WALL) and fields"
            )
    try:
        return ["step", *contact_columns(kind, fields.split(), table.shape[1] - 1)]
    except DumpError as error:
        raise DumpError(f"{path}: {error}") from error


def _touching(table: pd.DataFrame) -> pd.DataFrame:
    """Return the contacts with overlap or force; all contacts if the table has neither column."""
    signs = [table["overlap"] > 0] if "overlap" in table else []
    for force in (["fx", "fy", "fz"], ["fnx", "fny", "fnz"]):
        if set(force) <= set(table):
            signs.append((table[force] != 0).any(axis=1))
    return table[np.any(signs, axis=0)].reset_index(drop=True) if signs else table
