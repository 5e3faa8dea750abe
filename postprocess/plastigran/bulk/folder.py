# SPDX-License-Identifier: GPL-2.0-or-later
"""Files in the folder of a bulk run, and numbers that the deck printed to the log.

The folder contains `run.json` (deck, settings, ranks, versions), `deck/` (a copy of the deck and
its includes), the logs, and numbered checkpoints. After the run, it also contains `series.csv`,
`checks.csv` and `figures/`.
"""

from __future__ import annotations

import json
import re
import shutil
from itertools import islice
from pathlib import Path
from typing import TextIO

from plastigran.engine.checkpoints import (
    CHECKSUM,
    PATTERN,
    SIGNAL_FILE,
    checkpoints,
    is_numbered,
    newest_checkpoint,
)
from plastigran.engine.log import LOGS, find_excess, log_path
from plastigran.engine.process import EngineError, engines

RECORD = "run.json"
#: File in the folder of a continued run: log rows of the earlier run, up to the checkpoint from
#: which the run continues.
BEFORE = "before.csv"
SERIES = "series.csv"
CHECKS = "checks.csv"
#: File of grain positions; decks append frames to it.
DUMP = "grains.dump"
#: File of collision spectra, to which LIGGGHTS appends tables. A run that continues from a
#: checkpoint removes the tables that were written after the checkpoint.
SPECTRA = "collision_spectra.csv"
#: Names and patterns of files that are removed, in addition to checkpoints, before a run is
#: overwritten.
RUN_FILES = (
    RECORD,
    f"{RECORD}.new",
    BEFORE,
    *LOGS.values(),
    "screen.txt",
    f"{SIGNAL_FILE}_*",
    DUMP,
    "grains.data",
    SPECTRA,
    SERIES,
    CHECKS,
    f"{PATTERN}{CHECKSUM}*",
)
#: Entries of `run.json` that are JSON objects, with the type of their values.
_TABLES = {
    "values": str,
    "settings": str,
    "versions": str,
    "derived": int | float,
    "excess": int | float,
}

_DERIVED = re.compile(r"^derived (\w+) = (\S+)\s*$", re.MULTILINE)


def read_record(folder: str | Path) -> dict:
    """Read `run.json`.

    Raises:
        EngineError: The file is missing, is not valid JSON, or is not the record of a run.
    """
    path = Path(folder) / RECORD
    if not path.is_file():
        raise EngineError(
            f"{folder} contains no {RECORD}, so it is not a run of `plastigran "
            "bulk`. Check the path"
        )
    try:
        record = json.loads(path.read_text())
    except ValueError as error:
        raise EngineError(
            f"{path} is damaged: {error}. Restore the file or repeat the run"
        ) from None
    except RecursionError:
        raise EngineError(
            f"{path} is damaged: the JSON is nested too deeply. Restore the file or repeat the run"
        ) from None
    required = {"deck": str, "values": dict, "settings": dict}
    if not isinstance(record, dict) or not all(
        isinstance(record.get(name), type_) for name, type_ in required.items()
    ):
        raise EngineError(
            f"{path} is not the record of a run: the entry deck, values or settings is missing or "
            "has a wrong type. Check the path"
        )
    for name, type_ in _TABLES.items():
        table = record.get(name, {})
        if not (isinstance(table, dict) and all(isinstance(v, type_) for v in table.values())):
            raise EngineError(
                f"{path} is damaged: entry {name} has a wrong type. Restore the "
                "file or repeat the run"
            )
    if not isinstance(record.get("restart"), str | None):
        raise EngineError(
            f"{path} is damaged: entry restart must be the path of a folder. "
            "Restore the file or repeat the run"
        )
    return record


def write_record(folder: Path, record: dict) -> None:
    """Write `run.json`. If the write is interrupted, the earlier file stays unchanged."""
    draft = folder / f"{RECORD}.new"
    draft.write_text(json.dumps(record, indent=2) + "\n")
    draft.replace(folder / RECORD)


def prepare_folder(folder: Path, force: bool) -> None:
    """Create the folder of a run, or check that the files of an earlier run may be removed from it.

    Raises:
        ValueError: The folder contains files and `force` is false; the folder contains files but no
            run; or a run is in progress in the folder.
    """
    if processes := engines(folder):
        raise ValueError(
            f"{folder} is in use by a run (process {processes[0]}). Wait for the "
            "run to end, stop it, or choose another --output"
        )
    folder.mkdir(parents=True, exist_ok=True)
    if not any(folder.iterdir()):
        return
    if not force:
        raise ValueError(
            f"{folder} contains results. Choose another folder with --output, or overwrite them "
            "with --force"
        )
    if not (folder / RECORD).is_file():
        raise ValueError(
            f"{folder} contains files but no {RECORD}, so --force does not overwrite it. "
            "Choose another --output"
        )


def remove_earlier_run(folder: Path) -> None:
    """Remove the files of an earlier run from its folder. Other files stay."""
    # Remove the checkpoints first. A checkpoint of the earlier run that survives an interruption
    # could later be taken for the newest checkpoint of the new run.
    for file in checkpoints(folder):
        file.unlink()
    for pattern in RUN_FILES:
        for file in folder.glob(pattern):
            file.unlink()
    for name in ("deck", "figures", "frames"):
        shutil.rmtree(folder / name, ignore_errors=True)


def _log_text(folder: str | Path) -> str:
    log = log_path(folder)
    return log.read_text(errors="replace") if log.exists() else ""


def all_derived(folder: str | Path) -> dict[str, float]:
    """Return the values that the deck printed as `derived NAME = VALUE`.

    The result includes the values of the runs that this run continues.

    Raises:
        EngineError: The folder contains no run.
    """
    printed = {name: float(value) for name, value in _DERIVED.findall(_log_text(folder))}
    return read_record(folder).get("derived", {}) | printed


def all_excess(folder: str | Path) -> dict[str, float]:
    """Return largest overlap / largest valid overlap [-], by name of the law.

    The result contains only laws for which this ratio exceeds 1, in the run or in a run that it
    continues.

    Raises:
        EngineError: The folder contains no run.
    """
    excess = find_excess(_log_text(folder))
    for law, furthest in read_record(folder).get("excess", {}).items():
        excess[law] = max(furthest, excess.get(law, 0.0))
    return excess


def read_derived(folder: str | Path, name: str) -> float:
    """Return a value that the deck printed as `derived NAME = VALUE`.

    Raises:
        ValueError: The deck did not print this value.
    """
    try:
        return all_derived(folder)[name]
    except KeyError:
        raise ValueError(
            f"{folder}: the log has no line `derived {name} = VALUE`. Let the deck print it"
        ) from None


def carry_files(earlier: Path, folder: Path, last: int) -> None:
    """Copy collision spectra and grain positions from an earlier run to the run that continues it.

    LIGGGHTS then appends the data of the continued run to these files.

    Args:
        earlier: Folder of the earlier run.
        folder: Folder of the continued run.
        last: Step of the checkpoint. Only complete frames before this step are copied.
    """
    if (earlier / SPECTRA).exists():
        shutil.copy(earlier / SPECTRA, folder)
    if not (earlier / DUMP).exists():
        return
    with open(earlier / DUMP) as dump, open(folder / DUMP, "w") as copy:
        while frame := _next_frame(dump):
            if int(frame[1]) < last:
                copy.writelines(frame)


def _next_frame(dump: TextIO) -> list[str]:
    """Return the lines of the next frame of a dump, or [] if the frame is incomplete."""
    head = list(islice(dump, 9))
    if len(head) < 9:
        return []
    frame = head + list(islice(dump, int(head[3])))
    return frame if len(frame) == 9 + int(head[3]) and frame[-1].endswith("\n") else []


def restart_point(folder: Path, record: dict) -> Path:
    """Return the newest complete checkpoint of a run, or the checkpoint from which the run started.

    Raises:
        EngineError: There is no checkpoint.
    """
    try:
        return newest_checkpoint(folder)
    except EngineError:
        start = Path(record["values"].get("checkpoint", "none"))
        if not (start.is_file() and is_numbered(start)):
            raise
        return start
