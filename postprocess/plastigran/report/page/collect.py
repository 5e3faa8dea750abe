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
#: Subfolders that belong to a run.
_INNER = {"runs", "frames", "figures", "deck"}
#: Order of the kinds on a page. Kinds that share the switch of laws come first.
ORDER = ("sweep", "tables", "nothing", "bulk")
#: File types that other commands write.
_ENDINGS = {".csv", ".png", ".svg", ".gif", ".in"}


@attrs.frozen
class Results:
    """Folder of results.

    Attributes:
        kind: "sweep", "bulk" or "tables"; "nothing" for a folder without results.
        folder: Path of the folder.
        name: Path relative to the given folder.
    """

    kind: str
    folder: Path
    name: str


def collect(folders: Iterable[str | Path]) -> list[Results]:
    """Return the results in folders and their subfolders, sorted by kind, argument and start time.

    Raises:
        ValueError: A folder does not exist, or no folder is given.
    """
    found: dict[Path, Results] = {}
    for given in map(Path, folders):
        if not given.is_dir():
            raise ValueError(f"{given} is not a folder. A report needs folders of results")
        folder = given.resolve()
        here = sorted(_search(folder, folder), key=_begun) or [
            Results("nothing", folder, folder.name)
        ]
        for each in here:
            found.setdefault(each.folder, each)
    if not found:
        raise ValueError("no folder given. A report needs folders of results")
    names = Counter(each.name for each in found.values())
    told = [
        attrs.evolve(each, name=f"{each.folder.parent.name}/{each.name}")
        if names[each.name] > 1
        else each
        for each in found.values()
    ]
    return sorted(told, key=lambda each: ORDER.index(each.kind))


def kind(folder: Path) -> str | None:
    """Return the kind of results that a folder itself contains; None if there are none."""
    if (folder / RECORD).is_file():
        return "bulk"
    if any((folder / name).exists() for name in (TABLE, STUDY, "runs")):
        return "sweep"
    if any(file.suffix in _ENDINGS for file in folder.iterdir() if file.is_file()):
        return "tables"
    return None


def _begun(results: Results) -> tuple[float, str]:
    """Return the start time of results, from their files, and their name."""
    times = [file.stat().st_mtime for file in results.folder.iterdir() if file.is_file()]
    return min(times, default=0.0), results.name


def _search(folder: Path, top: Path, depth: int = 0) -> Iterable[Results]:
    if holds := kind(folder):
        name = folder.relative_to(top).as_posix()
        yield Results(holds, folder, folder.name if name == "." else name)
    if depth < DEPTH and holds != "bulk":
        for inner in sorted(folder.iterdir()):
            if inner.is_dir() and inner.name not in _INNER and not inner.name.startswith("."):
                yield from _search(inner, top, depth + 1)
