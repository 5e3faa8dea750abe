# SPDX-License-Identifier: GPL-2.0-or-later
"""Read dumps of LIGGGHTS, completely or frame by frame.

Every reader returns a pandas DataFrame in SI units with one row per item and time step. Columns
have the names of the file. A full disk or a killed run may truncate a file. The readers then return
the complete frames, with a `TruncatedFileWarning`.
"""

from __future__ import annotations

import io
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd

#: Smallest number of rows that are read at a time.
BATCH = 100_000
#: Prefixes of columns from computes, fixes and variables.
PREFIXES = ("c_", "f_", "v_")


class DumpError(ValueError):
    """A file has the wrong content; the message names the file, the line and its content."""


class TruncatedFileWarning(UserWarning):
    """A file ends in the middle of a frame or row; the complete part was read."""


@dataclass
class _Frame:
    step: int
    label: str
    columns: list[str]
    rows: list[str]


def _frames(path: Path) -> Iterator[_Frame]:
    """Read a dump frame by frame. Only this function depends on the header format."""
    with open(path, encoding="ascii", errors="replace") as file:
        lines, step = enumerate(file, start=1), None

        def take(start: str = "", may_end: bool = False) -> str:
            """Return the next line, which must begin with `start`; EOFError if it is truncated."""
            number, line = next(lines, (0, ""))
            cut = not line.endswith("\n")
            if not line.startswith(start[: len(line)] if cut else start):
                raise DumpError(
                    f"{path}, line {number}: expected '{start}', found {line.rstrip()[:60]!r}"
                )
            if cut and not (may_end and line == ""):
                raise EOFError
            return line

        try:
            while take("ITEM: TIMESTEP", may_end=True):
                step = None
                step = int(take())
                take("ITEM: NUMBER OF")
                count = int(take())
                take("ITEM: BOX BOUNDS")
                for _ in range(3):
                    take()
                label, columns = _label_and_columns(take("ITEM:"))
                yield _Frame(step, label, columns, [take() for _ in range(count)])
        except EOFError:
            place = "its header" if step is None else f"the frame of step {step}"
            warnings.warn(
                f"{path} ends within {place}. Only the frames before it were read",
                TruncatedFileWarning,
                stacklevel=4,
            )
        except DumpError:
            raise
        except ValueError as error:
            raise DumpError(f"{path}: a frame header is unreadable ({error})") from error


def _label_and_columns(header: str) -> tuple[str, list[str]]:
    """Return label and columns from a frame header; a label may have several words."""
    label, *words = header.removeprefix("ITEM:").split()
    first = 0
    while label != "ATOMS" and first < len(words) and words[first][:2] not in PREFIXES:
        first += 1
    return " ".join([label, *words[:first]]), words[first:]


def read_tables(
    path: str | Path, rows: int | None
) -> Iterator[tuple[str, list[int], pd.DataFrame]]:
    """Read complete frames in parts of at least `rows` rows; all in one part if `rows` is None.

    Raises:
        DumpError: The columns change, rows have different lengths, or no frame is complete.

    Yields:
        Label of the dump, number of rows of each frame, and table of the frames.
    """
    columns: list[str] = []
    batch: list[_Frame] = []
    count = 0
    for frame in _frames(Path(path)):
        if columns and frame.columns != columns:
            raise DumpError(f"{path}: the columns change at step {frame.step}")
        columns = frame.columns
        batch.append(frame)
        count += len(frame.rows)
        if rows is not None and count >= rows:
            yield _table(path, batch)
            batch, count = [], 0
    if not columns:
        raise DumpError(f"{path} contains no complete frame")
    if batch:
        yield _table(path, batch)


def _table(path: str | Path, frames: list[_Frame]) -> tuple[str, list[int], pd.DataFrame]:
    """Return label, row counts and table of some frames, with the step in the first column.

    Raises:
        DumpError: Rows have different lengths.
    """
    columns, counts = frames[0].columns, [len(frame.rows) for frame in frames]
    rows = [row for frame in frames for row in frame.rows]
    try:
        table = pd.read_csv(
            io.StringIO("".join(rows) or " ".join(columns)),
            sep=r"\s+",
            header=None if rows else 0,
            names=columns,
            index_col=False,
        )
    except (pd.errors.ParserError, ValueError) as error:
        raise DumpError(f"{path}: {error}") from error
    steps = np.repeat(np.array([frame.step for frame in frames], dtype=np.int64), counts)
    for row in np.flatnonzero(table.isna().any(axis=1)):
        if "nan" not in rows[row]:
            raise DumpError(
                f"{path}: a row of step {steps[row]} has fewer than {len(columns)} columns"
            )
    table.insert(0, "step", steps)
    return frames[0].label, counts, table


def _without_prefix(name: str) -> str:
    return name[2:] if name[:2] in PREFIXES else name


def read_dump(path: str | Path) -> pd.DataFrame:
    """Read a `dump custom` file.

    Returns:
        One row per atom and frame, (N_frames * N_atoms, 1 + N_columns): `step`, then the columns of
        the dump, without the prefixes `c_`, `f_` and `v_` of computes, fixes and variables.

    Raises:
        DumpError: The file is not a dump, or its rows have different lengths.
    """
    ((_, _, table),) = read_tables(path, None)
    return table.rename(columns=_without_prefix)


def read_frames(path: str | Path) -> Iterator[pd.DataFrame]:
    """Read a `dump custom` file frame by frame; the file may be larger than the memory.

    Yields:
        One frame, (N_atoms, 1 + N_columns), with the columns of `read_dump`. A column may have
        integers in one frame and floats in another.

    Raises:
        DumpError: As for `read_dump`.
    """
    for _, counts, table in read_tables(path, BATCH):
        yield from split_frames(table.rename(columns=_without_prefix), counts)


def split_frames(table: pd.DataFrame, counts: list[int]) -> Iterator[pd.DataFrame]:
    """Split the table of several frames into tables of single frames with `counts` rows."""
    ends = np.cumsum(counts)
    for first, end in zip(ends - counts, ends, strict=True):
        yield table.iloc[first:end].reset_index(drop=True)
