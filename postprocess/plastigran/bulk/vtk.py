# SPDX-License-Identifier: GPL-2.0-or-later
"""A bulk run's frames for ParaView and OVITO, with the plastic work of every contact."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from plastigran.bulk.contact_works import plastic_works, read_memories
from plastigran.bulk.outcome import BulkRun
from plastigran.engine.dumps import DumpError
from plastigran.plot.frame_files import Frame, find_frames, whole_frames
from plastigran.plot.vtk_series import (
    contact_table,
    write_contacts,
    write_grains,
    write_mesh,
    write_series,
)


def write_vtk(run: BulkRun, folder: str | Path) -> list[Path]:
    """Write the frames of a run as `grains_STEP.vtp`, `contacts_STEP.vtp` and `mesh_STEP.vtp`, and
    a list of each by time, `grains.pvd`, `contacts.pvd`, `mesh.pvd`.

    Contacts have a column `plastic_work` where the run had `contact_history=1`.

    Args:
        run: With frames.
        folder: Where they go; made when missing.

    Returns:
        The lists.

    Raises:
        SnapshotError: There are no frames, or pyvista is not installed.
        DumpError: A file of memories is damaged.

    Warns:
        UserWarning: A frame that cannot be read whole is left out; the message names the file.
    """
    folder, written = Path(folder), []
    folder.mkdir(parents=True, exist_ok=True)
    kinds: dict[str, Callable[[Frame, Path], None]] = {
        "grains": write_grains,
        "contacts": lambda frame, path: write_contacts(frame, path, contact_columns(run, frame)),
        "mesh": write_mesh,
    }
    frames = whole_frames(find_frames(run.folder))
    for kind, write in kinds.items():
        files = {}
        for frame in frames:
            if getattr(frame, kind) is not None:
                files[time_of(run, frame.step)] = path = folder / f"{kind}_{frame.step}.vtp"
                write(frame, path)
        if files:
            written.append(folder / f"{kind}.pvd")
            write_series(written[-1], files)
    return written


def contact_columns(run: BulkRun, frame: Frame) -> dict[str, np.ndarray]:
    """What a run tells of a frame's contacts beside the frame itself: `plastic_work` [J], (N,).

    Raises:
        DumpError: The file of their memories is damaged.
    """
    memories = frame.contacts.with_name(f"memories_{frame.step}.dump")
    if run.deck is None or not memories.exists():
        return {}
    contacts, remembered = contact_table(frame), read_memories(memories)
    # Both files have the engine's contacts in its order: a pair may touch through a side, too.
    if not all(np.array_equal(contacts[name], remembered[name]) for name in ("id1", "id2")):
        raise DumpError(f"{memories}: its contacts are not those of {frame.contacts}")
    near = contacts["overlap"] <= 0  # listed, but apart
    works = plastic_works(
        run.deck.grains,
        contacts["radius_eff"],
        np.where(near, 0.0, contacts["overlap"]),
        np.where(near, 0.0, remembered["memory"]),
    )
    return {"plastic_work": works}


def time_of(run: BulkRun, step: int) -> float:
    """Of a step's frame [s]; the step's number where the log has no time.

    Where a deck counts its steps anew, the engine writes the frames of later ones over the earlier.
    """
    if "time" not in run.series:
        return float(step)
    rows = run.series.drop_duplicates("step", keep="last").sort_values("step")
    return float(np.interp(step, rows["step"], rows["time"]))
