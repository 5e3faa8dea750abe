# SPDX-License-Identifier: GPL-2.0-or-later
"""Numbered restart files of a run, and which of them are whole."""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np

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
    for checkpoints at steps that have a line: one the log has not come to was cut short. One that
    a full disk cut is passed over with a warning.

    Raises:
        EngineError: There is none.
    """
    folder = Path(folder)
    progress = LogFollower(folder / LOG).read()
    written = [file for file in folder.glob(PATTERN) if step_of(file) <= progress.step]
    for checkpoint in sorted(written, key=step_of, reverse=True):
        if is_whole(checkpoint):
            return checkpoint
        warnings.warn(f"{checkpoint} is cut short; an earlier one is looked for", stacklevel=2)
    raise EngineError(f"no whole checkpoint ({PATTERN}) in {folder}; start the deck afresh")


def is_whole(checkpoint: Path) -> bool:
    """Whether a file ends as the engine's restart files do.

    Each rank's part is the number of its values, four bytes, and the values, eight bytes each. They
    are those of one particle after the other, the first of which is how many a particle has. A rank
    without particles has none.
    """
    size = checkpoint.stat().st_size
    if size == 0:
        return False
    content = np.memmap(checkpoint, np.uint8, "r")
    for end in range(size, 3, -4):
        # The last part's number stands a multiple of eight bytes before its end.
        places = np.arange((end - 4) % 8, end - 3, 8)
        numbers = content[places[0] : end].view("<i4", np.ndarray)[::2]
        for place in places[(numbers > 0) & (numbers == (end - 4 - places) // 8)]:
            if _holds_particles(content[place + 4 : end].view("<f8", np.ndarray)):
                return True
        if content[end - 4 : end].any():
            return False
    return False


def _holds_particles(values: np.ndarray) -> bool:
    """Whether values (n,) are those of whole particles, each led by the number of its own."""
    at = 0
    while at < len(values):
        count = values[at]
        if not (1 <= count <= len(values) and count == int(count)):
            return False
        at += int(count)
    return at == len(values)
