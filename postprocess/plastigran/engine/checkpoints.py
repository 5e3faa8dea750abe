# SPDX-License-Identifier: GPL-2.0-or-later
"""Restart files of a run: numbered ones, which of them are whole, and that of a signal."""

from __future__ import annotations

import re
import shutil
import warnings
from contextlib import suppress
from hashlib import file_digest
from pathlib import Path

import numpy as np

from plastigran.engine.log import LOG, LogFollower
from plastigran.engine.process import EngineError

#: What decks give to the engine's `restart` command.
PATTERN = "checkpoint.*.restart"
#: How restart files begin that the engine writes where it runs when a signal stops it.
OF_A_SIGNAL = "restart_forced_liggghts"
#: Ending of the files with checksums, which `sha256sum --check` reads.
CHECKSUM = ".sha256"
#: Numbers of a file that are looked at together.
_BLOCK = 1 << 20


def step_of(checkpoint: Path) -> int:
    """The step in a checkpoint's name. Raises ValueError when there is none."""
    return int(checkpoint.name.split(".")[1])


def checkpoints(folder: str | Path) -> list[Path]:
    """The checkpoints of a run by their steps, whole or not; files of other names are left out."""
    found = [file for file in Path(folder).glob(PATTERN) if is_numbered(file)]
    return sorted(found, key=step_of)


def is_numbered(file: Path) -> bool:
    """Whether a file is called as the engine calls checkpoints."""
    return re.fullmatch(PATTERN.replace(".", r"\.").replace("*", r"\d+"), file.name) is not None


def newest_checkpoint(folder: str | Path) -> Path:
    """The newest checkpoint of a run that was written to its end.

    The engine writes a step's checkpoint first and its line of the log afterwards, and decks ask
    for checkpoints at steps that have a line: one the log has not come to was cut short. One that
    a full disk cut, or that differs from its checksum, is passed over with a warning. A killed run
    may have left a whole one without a checksum.

    Raises:
        EngineError: There is none; the message names the newest that the log has not come to, if it
            looks whole.
    """
    log, progress, beyond = Path(folder) / LOG, LogFollower(Path(folder) / LOG).read(), None
    for checkpoint in reversed(checkpoints(folder)):
        if step_of(checkpoint) > progress.step:
            beyond = beyond or (checkpoint if is_whole(checkpoint) else None)
        elif not is_whole(checkpoint):
            warnings.warn(f"{checkpoint} is cut short; an earlier one is looked for", stacklevel=2)
        elif differs(checkpoint):
            warnings.warn(f"{_damage(checkpoint)}. An earlier one is looked for", stacklevel=2)
        else:
            return checkpoint
    if beyond:
        ends = f"ends at step {progress.step}" if progress.run else "shows no step"
        raise EngineError(
            f"{log} {ends if log.exists() else 'is missing'} and does not reach the checkpoints in "
            f"its folder, the newest of which is {beyond.name}; a run goes on where its log does"
        )
    raise EngineError(f"no whole checkpoint ({PATTERN}) in {folder}; start the deck afresh")


class ChecksumWriter:
    """Writes a checksum beside each checkpoint of a run once the checkpoint is whole.

    Args:
        folder: Folder of the run.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._log = LogFollower(folder / LOG)
        self._warned = False

    def update(self) -> None:
        """Write those that have become due since the last time.

        Warns:
            UserWarning: One cannot be written, the first time.
        """
        try:
            self._write()
        except OSError as error:
            if not self._warned:
                warnings.warn(
                    f"no checksum is written: {error.strerror} ({error.filename}). A damaged "
                    "checkpoint would not be noticed",
                    stacklevel=2,
                )
            self._warned = True

    def _write(self) -> None:
        step = self._log.read().step
        for checkpoint in checkpoints(self._folder):
            if step_of(checkpoint) > step:  # it may still be written
                break
            if _lacks_checksum(checkpoint) and is_whole(checkpoint):
                draft = checkpoint.with_name(f"{checkpoint.name}{CHECKSUM}.new")
                draft.write_text(f"{_sum(checkpoint)}  {checkpoint.name}\n")
                draft.replace(_checksum_of(checkpoint))


def differs(checkpoint: Path) -> bool:
    """Return whether a checkpoint has a checksum and differs from it."""
    file = _checksum_of(checkpoint)
    return file.exists() and file.read_text(errors="replace").split()[:1] != [_sum(checkpoint)]


def refuse_damaged(checkpoint: Path) -> None:
    """Refuse a checkpoint that differs from its checksum.

    Raises:
        EngineError: It does.
    """
    if checkpoint.is_file() and differs(checkpoint):
        raise EngineError(f"{_damage(checkpoint)}. Choose another checkpoint, or restore the file")


def _damage(checkpoint: Path) -> str:
    return f"{checkpoint} is damaged: it differs from {_checksum_of(checkpoint).name}"


def _checksum_of(checkpoint: Path) -> Path:
    return checkpoint.with_name(checkpoint.name + CHECKSUM)


def _lacks_checksum(checkpoint: Path) -> bool:
    """Whether there is none, or that of an earlier file: a deck may count its steps anew."""
    file = _checksum_of(checkpoint)
    return not file.exists() or file.stat().st_mtime_ns < checkpoint.stat().st_mtime_ns


def _sum(file: Path) -> str:
    with open(file, "rb") as content:
        return file_digest(content, "sha256").hexdigest()


def files_of_signals(working_folder: Path) -> dict[Path, int]:
    """The files of `OF_A_SIGNAL` in a folder, with the time of each."""
    found = {}
    for file in working_folder.glob(f"{OF_A_SIGNAL}_*"):
        with suppress(FileNotFoundError):  # another run has fetched it
            found[file] = file.stat().st_mtime_ns
    return found


def fetch_file_of_signal(working_folder: Path, before: dict[Path, int], folder: Path) -> None:
    """Move the restart file that a signal has made a run leave, if there is one, to its results.

    It is of the run's last step and was not there before. Other runs in that folder may leave
    others.

    Args:
        working_folder: Where the engine ran.
        before: What `files_of_signals` found as the run began.
        folder: Of the run's results.
    """
    step = LogFollower(folder / LOG).read().step
    for file, time in files_of_signals(working_folder).items():
        if file.stem == f"{OF_A_SIGNAL}_{step}" and before.get(file) != time:
            with suppress(FileNotFoundError):  # another run has stopped at the same step
                shutil.move(file, folder / file.name)


def is_whole(checkpoint: Path) -> bool:
    """Whether a file ends as the engine's restart files do.

    Each rank's part is the number of its values, four bytes, and the values, eight bytes each. They
    are those of one particle after the other, the first of which is how many a particle has. A rank
    without particles has the number 0 alone. The last part with particles is looked for: a file
    that ends, to the byte, with the part of an earlier rank passes.
    """
    size = checkpoint.stat().st_size
    if size < 4:
        return False
    content = np.memmap(checkpoint, np.uint8, "r")
    numbers = content[size % 4 :].view("<i4", np.ndarray)
    zeros = _zeros_at_the_end(numbers)
    for first in range(0, len(numbers), _BLOCK):
        counts = numbers[first : first + _BLOCK].astype(np.int64)
        begins = size % 4 + 4 * (first + 1 + np.arange(len(counts)))
        ends = begins + 8 * counts
        # What follows the last part with particles are zeros.
        for k in np.flatnonzero((counts > 0) & (ends <= size) & (ends >= size - 4 * zeros)):
            if _holds_particles(content[begins[k] : ends[k]].view("<f8", np.ndarray)):
                return True
    return False


def _zeros_at_the_end(numbers: np.ndarray) -> int:
    """How many of the numbers (n,) are 0 after the last that is not."""
    for end in range(len(numbers), 0, -_BLOCK):
        if (found := np.flatnonzero(numbers[max(0, end - _BLOCK) : end])).size:
            return len(numbers) - max(0, end - _BLOCK) - int(found[-1]) - 1
    return len(numbers)


def _holds_particles(values: np.ndarray) -> bool:
    """Whether values (n,) are those of whole particles, each led by the number of its own."""
    at = 0
    while at < len(values):
        count = values[at]
        if not (1 <= count <= len(values) and count == int(count)):
            return False
        at += int(count)
    return at == len(values)
