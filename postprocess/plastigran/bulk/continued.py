# SPDX-License-Identifier: GPL-2.0-or-later
"""Long runs that may be interrupted: each call continues from the newest checkpoint."""

from __future__ import annotations

import shutil
from collections.abc import Mapping
from pathlib import Path

from plastigran.bulk.folder import RECORD, read_record
from plastigran.bulk.outcome import BulkRun, open_run
from plastigran.bulk.run import run_bulk
from plastigran.engine.checkpoints import checkpoints


def finish_bulk(
    deck: str, values: Mapping[str, object], folder: Path, ranks: int = 1, show: bool = True
) -> BulkRun:
    """Return a finished run of a deck; start or continue the run if it is not finished.

    The parts of an interrupted run are the folders part_1, part_2, ... in `folder`.

    Args:
        deck: Name of a deck of `inputs/bulk`.
        values: New values of settings of the deck, by name.
        folder: Folder of the parts.
        ranks: Number of MPI ranks.
        show: Whether to show a progress bar.

    Raises:
        ValueError: `folder` contains a run with other settings; or as for `run_bulk`.
        EngineError: As for `run_bulk`.
    """
    for part in _parts(folder):
        if not (part / RECORD).is_file():  # interrupted before LIGGGHTS started
            shutil.rmtree(part)
    parts = _parts(folder)
    if not parts:
        return run_bulk(deck, values, folder / "part_1", ranks, force=True, show=show)
    given = {name: str(value) for name, value in values.items()}
    earlier = read_record(parts[0])["values"]
    if given != earlier:
        raise ValueError(
            f"{folder} contains a run with the settings {earlier}, not {given}. Choose another "
            "--output"
        )
    last = open_run(parts[-1])
    if last.finished:
        return last
    with_checkpoint = [part for part in parts if checkpoints(part)]
    if not with_checkpoint:
        return run_bulk(deck, values, parts[0], ranks, force=True, show=show)
    following = folder / f"part_{len(parts) + 1}"
    return run_bulk(deck, {}, following, ranks, restart=with_checkpoint[-1], show=show)


def _parts(folder: Path) -> list[Path]:
    parts = [part for part in folder.glob("part_*") if part.name[5:].isdigit()]
    return sorted(parts, key=lambda part: int(part.name[5:]))
