# SPDX-License-Identifier: GPL-2.0-or-later
"""Restart files of a run: numbered checkpoints with checksums, and files written after a signal."""

from __future__ import annotations

import re
import shutil
import warnings
from contextlib import suppress
from hashlib import file_digest
from pathlib import Path

import numpy as np

from plastigran.engine.log import LogFollower, log_path
from plastigran.engine.process import EngineError

#: File pattern that decks give to the `restart` command.
PATTERN = "checkpoint.*.restart"
#: Start of the name of restart files that LIGGGHTS writes when a signal stops it.
SIGNAL_FILE = "restart_forced_liggghts"
#: Suffix of the checksum files, which `sha256sum --check` reads.
CHECKSUM = ".sha256"
#: First and last bytes of a restart file of LAMMPS.
_LAMMPS = b"LammpS RestartT\0"
#: Number of four-byte values of a file that are examined at a time.
_BLOCK = 1 << 20


def step_of(checkpoint: Path) -> int:
    """Return the step in the name of a checkpoint.

    Raises:
        ValueError: The name contains no step.
    """
    return int(checkpoint.name.split(".")[1])


def is_numbered(file: Path) -> bool:
    """Return whether a file has a name like `checkpoint.1000.restart`, with the step as number."""
    return re.fullmatch(PATTERN.replace(".", r"\.").replace("*", r"\d+"), file.name) is not None


def checkpoints(folder: str | Path) -> list[Path]:
    """Return all checkpoint files of a run, also incomplete ones, sorted by step."""
    return sorted(filter(is_numbered, Path(folder).glob(PATTERN)), key=step_of)


def newest_checkpoint(folder: str | Path) -> Path:
    """Return the newest complete checkpoint of a run.

    LIGGGHTS writes the checkpoint of a step before the log line of this step. Decks write
    checkpoints only at steps that have a log line. A checkpoint later than the last log line may
    therefore be incomplete. A complete checkpoint without checksum is accepted, because a run that
    was killed may not have written the checksum.

    Raises:
        EngineError: There is no complete checkpoint. The message names the newest checkpoint that
            is later than the log.

    Warns:
        UserWarning: A damaged checkpoint was skipped; the message names the file.
    """
    log, beyond = log_path(folder), None
    progress = LogFollower(log).read()
    for checkpoint in reversed(checkpoints(folder)):
        complete = is_complete(checkpoint)
        if step_of(checkpoint) > progress.step:
            beyond = beyond or (checkpoint if complete else None)
        elif not complete:
            warnings.warn(
                f"{checkpoint} is incomplete or damaged. Using an earlier one", stacklevel=2
            )
        elif differs(checkpoint):
            warnings.warn(f"{_damage(checkpoint)}. Using an earlier one", stacklevel=2)
        else:
            return checkpoint
    if beyond:
        ends = f"ends at step {progress.step}" if progress.run else "shows no step"
        raise EngineError(
            f"no usable checkpoint: {log} {ends if log.exists() else 'is missing'}, before the "
            f"newest checkpoint, {beyond.name}. Restore the complete log, or start the run "
            "again"
        )
    raise EngineError(f"no complete checkpoint ({PATTERN}) in {folder}. Start the run again")


class ChecksumWriter:
    """Writer of a checksum for each checkpoint of a run, as soon as the checkpoint is complete.

    Args:
        folder: Folder of the run.
        log: Path of the log of the run; the file may not exist yet.
    """

    def __init__(self, folder: Path, log: Path) -> None:
        self._folder = folder
        self._log = LogFollower(log)
        self._warned = False

    def update(self) -> None:
        """Write the missing checksums.

        Warns:
            UserWarning: A checksum cannot be written. The warning appears once per run.
        """
        try:
            self._write()
        except OSError as error:
            if not self._warned:
                warnings.warn(
                    f"cannot write a checksum: {error.strerror} ({error.filename}). A damaged "
                    "checkpoint will not be detected",
                    stacklevel=2,
                )
            self._warned = True

    def _write(self) -> None:
        step = self._log.read().step
        for checkpoint in checkpoints(self._folder):
            if step_of(checkpoint) > step:  # skip a checkpoint that LIGGGHTS may still be writing
                break
            if _lacks_checksum(checkpoint) and is_complete(checkpoint):
                draft = checkpoint.with_name(f"{checkpoint.name}{CHECKSUM}.new")
                draft.write_text(f"{_sha256(checkpoint)}  {checkpoint.name}\n")
                draft.replace(_checksum_file(checkpoint))


def differs(checkpoint: Path) -> bool:
    """Return whether a checkpoint differs from its checksum; False if there is no checksum."""
    file = _checksum_file(checkpoint)
    return file.exists() and file.read_text(errors="replace").split()[:1] != [_sha256(checkpoint)]


def refuse_damaged(checkpoint: Path) -> None:
    """Reject a checkpoint that differs from its checksum.

    Raises:
        EngineError: The checkpoint differs from its checksum.
    """
    if checkpoint.is_file() and differs(checkpoint):
        raise EngineError(f"{_damage(checkpoint)}. Choose another checkpoint, or restore the file")


def _damage(checkpoint: Path) -> str:
    return f"{checkpoint} is damaged: it differs from {_checksum_file(checkpoint).name}"


def _checksum_file(checkpoint: Path) -> Path:
    return checkpoint.with_name(checkpoint.name + CHECKSUM)


def _lacks_checksum(checkpoint: Path) -> bool:
    """Return whether the checksum is missing, or older than the checkpoint.

    The checksum is older if a deck resets its step count: it then overwrites checkpoints of the
    same steps.
    """
    file = _checksum_file(checkpoint)
    return not file.exists() or file.stat().st_mtime_ns < checkpoint.stat().st_mtime_ns


def _sha256(file: Path) -> str:
    with open(file, "rb") as content:
        return file_digest(content, "sha256").hexdigest()


def signal_files(working_folder: Path) -> dict[Path, int]:
    """Return the modification time [ns] of each restart file that LIGGGHTS wrote after a signal."""
    times = {}
    for file in working_folder.glob(f"{SIGNAL_FILE}_*"):
        with suppress(FileNotFoundError):  # another run may have moved the file
            times[file] = file.stat().st_mtime_ns
    return times


def fetch_signal_file(working_folder: Path, earlier: dict[Path, int], folder: Path) -> None:
    """Move the restart file of a run that a signal stopped into the folder of results.

    LIGGGHTS writes this file into its working folder. The name of the file contains the last step
    of the run, and the file did not exist before the run. Other such files may belong to other
    runs.

    Args:
        working_folder: Folder in which LIGGGHTS ran.
        earlier: Result of `signal_files` before the run.
        folder: Folder of the results.
    """
    name = f"{SIGNAL_FILE}_{LogFollower(log_path(folder)).read().step}"
    for file, time in signal_files(working_folder).items():
        if file.stem == name and earlier.get(file) != time:
            # Another run that stopped at the same step may have moved the file.
            with suppress(FileNotFoundError):
                shutil.move(file, folder / file.name)


def is_complete(checkpoint: Path) -> bool:
    """Return whether a restart file is complete.

    A file of LAMMPS begins and ends with the same 16 bytes. In a file of LIGGGHTS, each rank writes
    the number of its values (four bytes) and then the values (eight bytes each). The first value of
    each particle is the number of values of this particle. A rank without particles writes only the
    number 0. The function looks for the last rank with particles. The values of this rank must end
    at the end of the file, or be followed only by zeros. The function cannot detect a file that
    ends exactly after the values of an earlier rank.
    """
    size = checkpoint.stat().st_size
    if size < 4:
        return False
    content = np.memmap(checkpoint, np.uint8, "r")
    if content[: len(_LAMMPS)].tobytes() == _LAMMPS:
        return size > len(_LAMMPS) and content[-len(_LAMMPS) :].tobytes() == _LAMMPS
    numbers = content[size % 4 :].view("<i4", np.ndarray)
    earliest_end = size - 4 * _trailing_zeros(numbers)
    for first in range(0, len(numbers), _BLOCK):
        counts = numbers[first : first + _BLOCK].astype(np.int64)
        begins = size % 4 + 4 * (first + 1 + np.arange(len(counts)))
        ends = begins + 8 * counts
        for k in np.flatnonzero((counts > 0) & (earliest_end <= ends) & (ends <= size)):
            if _holds_particles(content[begins[k] : ends[k]].view("<f8", np.ndarray)):
                return True
    return False


def _trailing_zeros(numbers: np.ndarray) -> int:
    """Return the number of zeros at the end of the numbers (n,)."""
    for end in range(len(numbers), 0, -_BLOCK):
        start = max(0, end - _BLOCK)
        if (nonzero := np.flatnonzero(numbers[start:end])).size:
            return len(numbers) - start - int(nonzero[-1]) - 1
    return len(numbers)


def _holds_particles(values: np.ndarray) -> bool:
    """Return whether values (n,) are complete particle records, each starting with its length."""
    at = 0
    while at < len(values):
        count = values[at]
        if not (1 <= count <= len(values) and count == int(count)):
            return False
        at += int(count)
    return at == len(values)
