# SPDX-License-Identifier: GPL-2.0-or-later
"""Read what LIGGGHTS writes: thermo logs, custom dumps, pair and wall contact dumps.

Every reader returns a pandas DataFrame in SI units with one row per item and time step, whose
columns carry the names the file gives them. A file cut short by a full disk or a killed run is
read as far as it is whole, and the cut is reported as a `TruncatedFileWarning`.
"""

from __future__ import annotations

import io
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd

# Columns of `compute pair/gran/local` and `compute wall/gran/local` by field, in the order in
# which the engine writes them, whatever the order in the input script.
_XYZ = ("x", "y", "z")
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
    "history": None,  # as many as the model keeps
    "contactArea": ("contact_area",),
    "delta": ("overlap",),
    "contactPoint": ("contact_x", "contact_y", "contact_z"),
    "ms_id": ("multisphere_i", "multisphere_j"),
    "heatFlux": ("heat_flux",),  # always last
}
WALL_COLUMNS = PAIR_COLUMNS | {
    "pos": ("contact_x", "contact_y", "contact_z", "x", "y", "z"),
    "vel": ("wall_vx", "wall_vy", "wall_vz", "vx", "vy", "vz"),
    "id": ("mesh_id", "triangle_id", "id"),
}
THERMO_COLUMNS = {
    "Step": "step",
    "Dt": "timestep",
    "Time": "time",
    "Atoms": "atoms",
    "KinEng": "kinetic_energy",
    "CPU": "cpu_time",
}


class DumpError(ValueError):
    """A file that is not what it should be; the message names file, line and what was found."""


class TruncatedFileWarning(UserWarning):
    """A file that ends in the middle of a frame or row; the whole part was read."""


@dataclass
class _Frame:
    step: int
    label: str
    columns: list[str]
    rows: list[str]


def _frames(path: Path) -> Iterator[_Frame]:
    """Scan a dump frame by frame: the one place that knows the header's form."""
    with open(path, encoding="ascii", errors="replace") as file:
        lines = enumerate(file, start=1)

        def take(expected: str | None = None) -> str:
            number, line = next(lines)  # StopIteration: the file ends here
            if not line.endswith("\n"):
                raise StopIteration
            if expected and not line.startswith(expected):
                raise DumpError(
                    f"{path}, line {number}: expected '{expected}', found {line.rstrip()[:60]!r}"
                )
            return line

        step = None
        try:
            while True:
                try:
                    number, line = next(lines)
                except StopIteration:
                    return
                if not line.startswith("ITEM: TIMESTEP"):
                    if "ITEM: TIMESTEP".startswith(line.rstrip()) and line.strip():
                        raise StopIteration
                    raise DumpError(
                        f"{path}, line {number}: expected 'ITEM: TIMESTEP', "
                        f"found {line.rstrip()[:60]!r}"
                    )
                step = None
                step = int(take())
                take("ITEM: NUMBER OF")
                count = int(take())
                take("ITEM: BOX BOUNDS")
                for _ in range(3):
                    take()
                header = take("ITEM:").removeprefix("ITEM:").split()
                first = next(
                    (k for k, word in enumerate(header) if k and _is_column(header, k)), len(header)
                )
                rows = [take() for _ in range(count)]
                yield _Frame(step, " ".join(header[:first]), header[first:], rows)
        except StopIteration:
            where = "its header" if step is None else f"the frame of step {step}"
            warnings.warn(
                f"{path} ends within {where}; only the frames before it were read",
                TruncatedFileWarning,
                stacklevel=4,
            )
        except ValueError as error:
            if isinstance(error, DumpError):
                raise
            raise DumpError(f"{path}: unreadable frame header ({error})") from error


def _is_column(header: list[str], k: int) -> bool:
    """Atom dumps have the label ATOMS; local dumps any words before their c_ID[k] columns."""
    return header[0] == "ATOMS" or header[k].startswith(("c_", "f_", "v_"))


def _read(path: str | Path) -> tuple[str, pd.DataFrame]:
    path = Path(path)
    label, columns = "", []
    steps, counts, text = [], [], []
    for frame in _frames(path):
        if columns and frame.columns != columns:
            raise DumpError(f"{path}: the columns change at step {frame.step}")
        label, columns = frame.label, frame.columns
        steps.append(frame.step)
        counts.append(len(frame.rows))
        text.extend(frame.rows)
    if not columns:
        raise DumpError(f"{path}: no whole frame")
    try:
        table = pd.read_csv(
            io.StringIO("".join(text)),
            sep=r"\s+",
            header=None,
            names=columns,
            index_col=False,
        )
    except (pd.errors.ParserError, ValueError) as error:
        raise DumpError(f"{path}: {error}") from error
    incomplete = table.isna().any(axis=1).to_numpy()
    if incomplete.any() and not all("nan" in text[row] for row in np.flatnonzero(incomplete)):
        step = np.repeat(steps, counts)[incomplete.argmax()]
        raise DumpError(f"{path}: a row of step {step} has fewer than {len(columns)} columns")
    table.insert(0, "step", np.repeat(np.asarray(steps, dtype=np.int64), counts))
    return label, table


def read_dump(path: str | Path) -> pd.DataFrame:
    """Read a `dump custom` file.

    Args:
        path: The file.

    Returns:
        One row per atom and frame, (N_frames * N_atoms, 1 + N_columns): `step`, then the dump's
        columns under their own names; computes, fixes and variables lose their `c_`, `f_`, `v_`.

    Raises:
        DumpError: The file is not a dump or has ragged rows.
    """
    _, table = _read(path)
    return table.rename(columns=lambda name: name[2:] if name[:2] in ("c_", "f_", "v_") else name)


def contact_columns(kind: str, fields: list[str], total: int) -> list[str]:
    """Names of a local dump's columns from the compute's fields.

    Args:
        kind: "PAIR" or "WALL".
        fields: Fields of `compute pair/gran/local` or `wall/gran/local`, in any order.
        total: Number of columns; what the other fields leave is the contact history's.

    Returns:
        `total` names.

    Raises:
        DumpError: Unknown field, or a total that does not fit.
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
            f"fields {' '.join(fields)} make {len(names)} columns, the file has {total}"
        )
    return names


def read_contacts(
    path: str | Path, kind: str | None = None, fields: str | None = None, touching: bool = True
) -> pd.DataFrame:
    """Read a `dump local` file of a `compute pair/gran/local` or `wall/gran/local`.

    Args:
        path: The file. Its label says kind and fields (`dump_modify ID label "PAIR pos id ..."`).
        kind: "PAIR" or "WALL", for a file without such a label.
        fields: The compute's fields, e.g. "pos id force delta", for a file without such a label.
        touching: Drop the near neighbours without overlap and force that the engine lists too.

    Returns:
        One row per contact and frame: `step`, then columns named as in `PAIR_COLUMNS` and
        `WALL_COLUMNS`.

    Raises:
        DumpError: The file is not a local dump, or its columns do not fit the fields.
    """
    label, table = _read(path)
    words = label.split()
    if kind is None or fields is None:
        if not words or words[0] not in ("PAIR", "WALL"):
            raise DumpError(f"{path}: label {label!r} names no fields; pass kind and fields")
        kind, fields = words[0], " ".join(words[1:])
    try:
        names = contact_columns(kind, fields.split(), table.shape[1] - 1)
    except DumpError as error:
        raise DumpError(f"{path}: {error}") from error
    table.columns = ["step", *names]
    if touching:
        keep = np.zeros(len(table), dtype=bool)
        judged = False
        if "overlap" in table:
            keep |= table["overlap"].to_numpy() > 0
            judged = True
        for group in (("fx", "fy", "fz"), ("fnx", "fny", "fnz")):
            if set(group) <= set(names):
                keep |= (table[list(group)].to_numpy() != 0).any(axis=1)
                judged = True
        if judged:
            table = table[keep].reset_index(drop=True)
    return table


def read_thermo(path: str | Path) -> pd.DataFrame:
    """Read the thermodynamic output of a log file.

    Args:
        path: The log.

    Returns:
        One row per output line: `run` (0, 1, … in the order of the `run` commands), then the
        log's columns, the common ones under the names of `THERMO_COLUMNS`.

    Raises:
        DumpError: The log holds no thermodynamic output.
    """
    path = Path(path)
    tables, header, rows, whole = [], None, [], True
    run = -1
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            words = line.split()
            if words[:1] == ["Step"]:
                header, rows, whole = words, [], False
                run += 1
                tables.append((run, header, rows))
            elif header and line.startswith("Loop time of"):
                header, whole = None, True
            elif header and len(words) == len(header) and line.endswith("\n"):
                try:
                    rows.append([float(word) for word in words])
                except ValueError:
                    continue  # a message between two rows
    if not tables:
        raise DumpError(f"{path}: no thermodynamic output (no line starting with 'Step')")
    if not whole:
        warnings.warn(
            f"{path} ends within run {run}; the rows before the end were read",
            TruncatedFileWarning,
            stacklevel=2,
        )
    frames = []
    for number, names, values in tables:
        frame = pd.DataFrame(values, columns=[THERMO_COLUMNS.get(name, name) for name in names])
        frame.insert(0, "run", number)
        frames.append(frame)
    table = pd.concat(frames, ignore_index=True)
    return table.astype({"step": np.int64})
