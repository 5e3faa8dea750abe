# SPDX-License-Identifier: GPL-2.0-or-later
"""Read dumps of LIGGGHTS.

A full disk or a killed run may truncate a file. The reader then returns the complete frames, with a
`TruncatedFileWarning`.
"""

from __future__ import annotations

import io
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd

#: Prefixes of columns from computes, fixes and variables.
PREFIXES = ("c_", "f_", "v_")


class DumpError(ValueError):
    """A file has the wrong content; the message names the file, the line and its content."""


class TruncatedFileWarning(UserWarning):
    """A file ends in the middle of a frame or row; the complete part was read."""


@dataclass
class _Frame:
    step: int
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
                columns = _columns(take("ITEM:"))
                yield _Frame(step, columns, [take() for _ in range(count)])
        except EOFError:
            place = "its header" if step is None else f"the frame of step {step}"
            warnings.warn(
                f"{path} ends within {place}. Only the frames before it were read",
                TruncatedFileWarning,
                stacklevel=3,
            )
        except DumpError:
            raise
        except ValueError as error:
            raise DumpError(f"{path}: a frame header is unreadable ({error})") from error


def _columns(header: str) -> list[str]:
    """Return the column names in a frame header.

    In a local dump, a label of one or several words precedes the column names.
    """
    label, *words = header.removeprefix("ITEM:").split()
    first = 0
    while label != "ATOMS" and first < len(words) and words[first][:2] not in PREFIXES:
        first += 1
    return words[first:]


def read_dump(path: str | Path) -> pd.DataFrame:
    """Read a `dump custom` or `dump local` file.

    Returns:
        One row per frame and particle, or per frame and contact in a local dump, in the units of
        the deck. The columns are `step`, then the columns of the dump, without the prefixes `c_`,
        `f_` and `v_` of computes, fixes and variables.

    Raises:
        DumpError: The file is not a dump, no frame is complete, the columns change, or rows have
            different lengths.
    """
    frames = list(_frames(Path(path)))
    if not frames:
        raise DumpError(f"{path} contains no complete frame")
    columns = frames[0].columns
    for frame in frames:
        if frame.columns != columns:
            raise DumpError(f"{path}: the columns change at step {frame.step}")
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
    steps = np.repeat(
        np.array([frame.step for frame in frames], dtype=np.int64),
        [len(frame.rows) for frame in frames],
    )
    for row in np.flatnonzero(table.isna().any(axis=1)):
        if "nan" not in rows[row]:
            raise DumpError(
                f"{path}: a row of step {steps[row]} has fewer than {len(columns)} columns"
            )
    table.insert(0, "step", steps)
    return table.rename(columns=_without_prefix)


def _without_prefix(name: str) -> str:
    return name[2:] if name[:2] in PREFIXES else name
