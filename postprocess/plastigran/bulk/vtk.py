# SPDX-License-Identifier: GPL-2.0-or-later
"""Frames of a bulk run for ParaView and OVITO, with the plastic work of every contact."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from plastigran.bulk.contact_works import plastic_works, read_histories
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
    """Write the frames of a run (its output for pictures) as VTK files.

    The files are `grains_STEP.vtp`, `contacts_STEP.vtp` and `mesh_STEP.vtp`. The lists
    `grains.pvd`, `contacts.pvd` and `mesh.pvd` name these files with their times. Contacts have a
    column `plastic_work` if the run had `contact_history=1`.

    Args:
        run: Run with frames.
        folder: Folder of the files; created if missing.

    Returns:
        Paths of the list files (.pvd).

    Raises:
        SnapshotError: The run has no frames, or pyvista is not installed.
        DumpError: A file of contact histories is damaged.

    Warns:
        UserWarning: An incomplete frame is omitted; the message names the file.
    """
    folder, lists = Path(folder), []
    folder.mkdir(parents=True, exist_ok=True)
    writers: dict[str, Callable[[Frame, Path], None]] = {
        "grains": write_grains,
        "contacts": lambda frame, path: write_contacts(frame, path, contact_columns(run, frame)),
        "mesh": write_mesh,
    }
    frames = whole_frames(find_frames(run.folder))
    for name, write in writers.items():
        files = {}
        for frame in frames:
            if getattr(frame, name) is not None:
                files[time_of(run, frame.step)] = path = folder / f"{name}_{frame.step}.vtp"
                write(frame, path)
        if files:
            lists.append(folder / f"{name}.pvd")
            write_series(lists[-1], files)
    return lists


def contact_columns(run: BulkRun, frame: Frame) -> dict[str, np.ndarray]:
    """Return additional data of the N contacts of a frame: `plastic_work` (N,) [J], if known.

    Raises:
        DumpError: The file of contact histories is damaged.
    """
    file = frame.contacts.with_name(f"memories_{frame.step}.dump")
    if run.deck is None or not file.exists():
        return {}
    contacts, histories = contact_table(frame), read_histories(file)
    # Match contacts by their order, which is the same in both files. IDs do not identify a contact,
    # because a pair may have a second contact across a periodic boundary.
    if not all(np.array_equal(contacts[name], histories[name]) for name in ("id1", "id2")):
        raise DumpError(f"{file} and {frame.contacts} list different contacts. Repeat the run")
    separated = contacts["overlap"] <= 0
    works = plastic_works(
        run.deck.grains,
        contacts["radius_eff"],
        np.where(separated, 0.0, contacts["overlap"]),
        np.where(separated, 0.0, histories["history"]),
    )
    return {"plastic_work": works}


def time_of(run: BulkRun, step: int) -> float:
    """Return the time of the frame at a step [s], or the step number if the log has no time.

    If a deck resets its step count, several log lines have the same step. The last of them gives
    the time, because LIGGGHTS overwrites an earlier frame file of the same step.
    """
    if "time" not in run.series:
        return float(step)
    rows = run.series.drop_duplicates("step", keep="last").sort_values("step")
    return float(np.interp(step, rows["step"], rows["time"]))
