# SPDX-License-Identifier: GPL-2.0-or-later
"""Numbered restart files of a run, and which of them are whole."""

from __future__ import annotations

from pathlib import Path

from plastigran.engine.log import LOG, LogFollower
from plastigran.engine.process import EngineError

#: What decks give to the engine's `restart` command.
PATTERN = "checkpoint.*.restart"


def step_of(checkpoint: Path) -> int:
    """The step in a checkpoint's name. Raises ValueError when there is none."""
    return int(checkpoint.name.split(".")[1])


def newest_checkpoint(folder: str | Path) -> Path:
    """The newest checkpoint of a run that was written to its end.

    The engine writes a step's checkpoint first and its line of the log afterwards, and decks ask
    for checkpoints at steps that have a line: one the log has not come to was cut short.

    Raises:
        EngineError: There is none.
    """
    folder = Path(folder)
    progress = LogFollower(folder / LOG).read()
    whole = [file for file in folder.glob(PATTERN) if step_of(file) <= progress.step]
    if not whole:
        raise EngineError(f"no whole checkpoint ({PATTERN}) in {folder}; start the deck afresh")
    return max(whole, key=step_of)
