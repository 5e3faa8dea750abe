# SPDX-License-Identifier: GPL-2.0-or-later
"""Read dumps of LIGGGHTS, completely or frame by frame.

Every reader returns a pandas DataFrame in SI units with one row per item and time step. Columns
have
the names of the file. A file that was cut short by a full disk or a killed run is read as far as it
is complete, with a `TruncatedFileWarning`.
"""

from __future__ import annotations

import io
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd

#: Number of rows that are read together.
BATCH = 100_000


class DumpError(ValueError):
    """A file has the wrong content; the message names file, line and what was found."""


class TruncatedFileWarning(UserWarning):
    """A file ends in the middle of a frame or row; the complete part was read."""


@dataclass
class _Frame:
    step: int
    label: str
    columns: list[str]
    rows: list[str]


def _frames(path: Path) -> Iterator[_Frame]:
    """Scan a dump frame by frame. Only this function depends on the header format."""
    with open(path, encoding="ascii", errors="replace") as file:
        lines = enumerate(file, start=1)

        def take(expected: str | None = None) -> str:
            number, line = next(lines)  # StopIteration: end of the file
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
                f"{path} ends within {where}. Only the frames before it were read",
                TruncatedFileWarning,
                stacklevel=4,
            )
        except ValueError as error:
            if isinstance(error, DumpError):
                raise
            raise DumpError(f"{path}: unreadable frame header ({error})") from error


def _is_column(header: list[str], k: int) -> bool:
    """Return whether an item is a column; other words may precede the columns of a local dump."""
    return header[0] == "ATOMS" or header[k].startswith(("c_", "f_", "v_"))


def read_tables(
    path: str | Path, rows: int | None
) -> Iterator[tuple[str, list[int], pd.DataFrame]]:
    """Read complete frames with at least `rows` rows in total, or all of them.

    Yields:
        Label of the dump, number of rows of each frame, and table of the frames.
    """
    label, columns = "", []
    steps, counts, text = [], [], []
    for frame in _frames(Path(path)):
        if columns and frame.columns != columns:
            raise DumpError(f"{path}: the columns change at step {frame.step}")
        label, columns = frame.label, frame.columns
        steps.append(frame.step)
        counts.append(len(frame.rows))
        text.extend(frame.rows)
        if rows is not None and len(text) >= rows:
            yield label, counts, _table(path, columns, steps, counts, text)
            steps, counts, text = [], [], []
    if not columns:
        raise DumpError(f"{path}: no complete frame")
    if steps:
        yield label, counts, _table(path, columns, steps, counts, text)


def _table(
    path: str | Path, columns: list[str], steps: list[int], counts: list[int], text: list[str]
) -> pd.DataFrame:
    """Return the rows of some frames with the step of each.

    Raises:
        DumpError: Rows have different lengths.
    """
    try:
        table = pd.read_csv(
            io.StringIO("".join(text) or " ".join(columns)),
            sep=r"\s+",
            header=None if text else 0,
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
    return table


def _without_prefix(name: str) -> str:
    return name[2:] if name[:2] in ("c_", "f_", "v_") else name


def read_dump(path: str | Path) -> pd.DataFrame:
    """Read a `dump custom` file.

    Args:
        path: File.

    Returns:
        One row per atom and frame, (N_frames * N_atoms, 1 + N_columns): `step`, then the columns of
        the dump; computes, fixes and variables lose their `c_`, `f_`, `v_`.

    Raises:
        DumpError: The file is not a dump, or its rows have different lengths.
    """
    ((_, _, table),) = read_tables(path, None)
    return table.rename(columns=_without_prefix)


def read_frames(path: str | Path) -> Iterator[pd.DataFrame]:
    """Read a `dump custom` file frame by frame; the file may be larger than the memory.

    Args:
        path: File.

    Yields:
        Each frame as `read_dump` returns it, (N_atoms, 1 + N_columns); a column may have integers
        in
        one frame and floats in another.

    Raises:
        DumpError: As for `read_dump`.
    """
    for _, counts, table in read_tables(path, BATCH):
        yield from split_frames(table.rename(columns=_without_prefix), counts)


def split_frames(table: pd.DataFrame, counts: list[int]) -> Iterator[pd.DataFrame]:
    """Return the table of some frames as one table per frame, given the number of rows of each."""
    ends = np.cumsum(counts)
    for first, end in zip(ends - counts, ends, strict=True):
        yield table.iloc[first:end].reset_index(drop=True)
