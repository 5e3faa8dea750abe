# SPDX-License-Identifier: GPL-2.0-or-later
"""Lock for a folder of results, so that only one command writes to it."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from fcntl import LOCK_EX, LOCK_NB, flock
from pathlib import Path
from threading import get_ident

# Locked folders, each with the ID of the thread of this process that has locked it.
_locked: set[tuple[Path, int]] = set()


@contextmanager
def lock_folder(folder: str | Path) -> Iterator[None]:
    """Create a folder and lock it for this thread; the thread may lock it repeatedly.

    The lock ends with the `with` block, or if the process ends early.

    Raises:
        ValueError: Another process or thread has locked the folder.
    """
    folder = Path(folder).resolve()
    holder = folder, get_ident()
    if holder in _locked:
        yield
        return
    folder.mkdir(parents=True, exist_ok=True)
    place = os.open(folder, os.O_RDONLY)
    try:
        try:
            flock(place, LOCK_EX | LOCK_NB)
        except BlockingIOError:
            raise ValueError(
                f"{folder} is in use by another plastigran command. Wait for it to end, or choose "
                "another --output"
            ) from None
        _locked.add(holder)
        yield
    finally:
        _locked.discard(holder)
        os.close(place)
