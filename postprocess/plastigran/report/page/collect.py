# SPDX-License-Identifier: GPL-2.0-or-later
"""What folders of results hold: sweeps of impacts, bulk runs, and tables of other commands."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from pathlib import Path

import attrs

from plastigran.bulk.folder import RECORD
from plastigran.experiments.record import STUDY, TABLE

#: Folders down from a given one in which results are looked for.
DEPTH = 4
#: Folders of a run's own files.
_INNER = {"runs", "frames", "figures", "deck"}
#: Kinds of results as a page has them: those that share a switch of laws first.
ORDER = ("sweep", "tables", "nothing", "bulk")
#: What the other commands leave.
_ENDINGS = {".csv", ".png", ".svg", ".gif", ".in"}


@attrs.frozen
class Results:
    """A folder of results.

    Attributes:
        kind: "sweep", "bulk" or "tables"; "nothing" where no command has left any.
        folder: Where they are.
        name: The folder's, seen from the one that was given.
    """

    kind: str
    folder: Path
    name: str


def collect(folders: Iterable[str | Path]) -> list[Results]:
    """The results in some folders and the folders in them, by kind, as given, as they were begun.

    Raises:
        ValueError: A folder is not there, or none was given.
    """
    found: dict[Path, Results] = {}
    for given in map(Path, folders):
        if not given.is_dir():
            raise ValueError(f"{given} is no folder; a report is made of folders of results")
        folder = given.resolve()
        here = sorted(_search(folder, folder), key=_begun) or [
            Results("nothing", folder, folder.name)
        ]
        for each in here:
            found.setdefault(each.folder, each)
    if not found:
        raise ValueError("no folder was given; a report is made of folders of results")
    names = Counter(each.name for each in found.values())
    told = [
        attrs.evolve(each, name=f"{each.folder.parent.name}/{each.name}")
        if names[each.name] > 1
        else each
        for each in found.values()
    ]
    return sorted(told, key=lambda each: ORDER.index(each.kind))


def kind(folder: Path) -> str | None:
    """What a folder itself holds; None for nothing that a command has left."""
    if (folder / RECORD).is_file():
        return "bulk"
    if any((folder / name).exists() for name in (TABLE, STUDY, "runs")):
        return "sweep"
    if any(file.suffix in _ENDINGS for file in folder.iterdir() if file.is_file()):
        return "tables"
    return None


def _begun(results: Results) -> tuple[float, str]:
    """When results were begun, as far as their files tell, and their name."""
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
