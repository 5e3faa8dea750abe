# SPDX-License-Identifier: GPL-2.0-or-later
"""Find results in folders: sweeps of impacts, bulk runs, and tables of other commands."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from pathlib import Path

import attrs

from plastigran.bulk.folder import RECORD
from plastigran.experiments.record import STUDY, TABLE

#: Largest depth of subfolders that are searched.
DEPTH = 4
#: Names of subfolders that belong to the results of their parent folder and are not searched.
_PARTS_OF_RUNS = {"runs", "frames", "figures", "deck"}
#: Categories of results in the order of the page. The reader of the page can hide single laws in
#: results of the categories "sweep" and "tables".
ORDER = ("sweep", "tables", "nothing", "bulk")
#: Suffixes of the files in a folder of category "tables".
_SUFFIXES = {".csv", ".png", ".svg", ".gif", ".in"}


@attrs.frozen
class Results:
    """A folder with results of one command.

    Attributes:
        category: "sweep", "bulk" or "tables"; "nothing" for a folder without results.
        folder: Path of the folder.
        title: Path of the folder, relative to the folder that the user gave.
    """

    category: str
    folder: Path
    title: str


def collect(folders: Iterable[str | Path]) -> list[Results]:
    """Return the results in folders and their subfolders.

    The results are sorted by category, then in the order of `folders`, then by start time.

    Raises:
        ValueError: A folder does not exist, or no folder is given.
    """
    by_folder: dict[Path, Results] = {}
    for argument in map(Path, folders):
        if not argument.is_dir():
            raise ValueError(f"{argument} is not a folder. Give a folder with results")
        top = argument.resolve()
        entries = sorted(_search(top, top), key=_start_time) or [Results("nothing", top, top.name)]
        for entry in entries:
            by_folder.setdefault(entry.folder, entry)
    if not by_folder:
        raise ValueError("no folder is given. Give one or more folders with results")
    titles = Counter(entry.title for entry in by_folder.values())
    distinct = [
        attrs.evolve(entry, title=f"{entry.folder.parent.name}/{entry.title}")
        if titles[entry.title] > 1
        else entry
        for entry in by_folder.values()
    ]
    return sorted(distinct, key=lambda entry: ORDER.index(entry.category))


def _category(folder: Path) -> str | None:
    """Return the category of the results in a folder, without subfolders; None without results."""
    if (folder / RECORD).is_file():
        return "bulk"
    if any((folder / name).exists() for name in (TABLE, STUDY, "runs")):
        return "sweep"
    if any(file.suffix in _SUFFIXES for file in folder.iterdir() if file.is_file()):
        return "tables"
    return None


def _start_time(results: Results) -> tuple[float, str]:
    """Return a sort key: the time of the oldest file in the folder, then the title."""
    times = [file.stat().st_mtime for file in results.folder.iterdir() if file.is_file()]
    return min(times, default=0.0), results.title


def _search(folder: Path, top: Path, depth: int = 0) -> Iterable[Results]:
    category = _category(folder)
    if category:
        yield Results(category, folder, str(folder.relative_to(top)) if depth else folder.name)
    if depth < DEPTH and category != "bulk":
        for inner in sorted(folder.iterdir()):
            hidden = inner.name.startswith(".") or inner.name in _PARTS_OF_RUNS
            if inner.is_dir() and not hidden:
                yield from _search(inner, top, depth + 1)
