# SPDX-License-Identifier: GPL-2.0-or-later
"""Data of the frames of a run (its output at single steps): grains, contact forces and walls."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING

import attrs
import numpy as np

from plastigran.plot.frame_files import DamagedFrame, Frame, SnapshotError, read_frame_file

if TYPE_CHECKING:
    import pyvista


@attrs.frozen
class GrainQuantity:
    """Quantity that can color grains.

    Attributes:
        title: Name of the quantity in words.
        unit: SI unit.
        values: Function that returns the values (n,) for the VTK data of the n grains of a frame.
        from_zero: Whether the color scale starts at zero.
    """

    title: str
    unit: str
    values: Callable[[pyvista.DataSet], np.ndarray]
    from_zero: bool = False


#: Quantities that can color grains in a picture.
GRAIN_QUANTITIES = {
    "plastic_work": GrainQuantity(
        "plastic work", "J", lambda grains: grains["f_plastic_work"], from_zero=True
    ),
    "speed": GrainQuantity("speed", "m/s", lambda grains: _norms(grains["v"]), from_zero=True),
    "height": GrainQuantity("height", "m", lambda grains: grains.points[:, 2]),
    "radius": GrainQuantity("radius", "m", lambda grains: grains["radius"]),
}


def _norms(vectors: np.ndarray) -> np.ndarray:
    return np.linalg.norm(np.asarray(vectors, float).reshape(-1, 3), axis=1)


def grain_values(frame: Frame, quantity: str) -> np.ndarray:
    """Return the values (n,) of a quantity of `GRAIN_QUANTITIES` for the n grains of a frame.

    Raises:
        DamagedFrame: A file is incomplete.
        SnapshotError: The frame has no values of this quantity.
    """
    grains = read_frame_file(frame.grains)
    if not grains.n_points:
        return np.zeros(0)
    try:
        return np.asarray(GRAIN_QUANTITIES[quantity].values(grains), float)
    except KeyError:
        raise SnapshotError(f"{frame.grains} has no {quantity}. Choose another color") from None


def contact_forces(frame: Frame) -> np.ndarray:
    """Return the contact forces (n,), N, of a frame.

    Raises:
        DamagedFrame: A file is incomplete.
        SnapshotError: The frame has no file of contacts.
    """
    if frame.contacts is None:
        raise SnapshotError(
            f"{frame.grains.parent} has no contacts_{frame.step}.vtk. Draw grains, not contacts"
        )
    lines = read_frame_file(frame.contacts)
    return _norms(lines["force"]) if lines.n_cells else np.zeros(0)


@attrs.frozen(eq=False)
class GrainFrame:
    """Grains and walls of one time step.

    Attributes:
        step: Time step number.
        positions: Centers of the grains (n, 3), m.
        radii: Radii of the grains (n,), m.
        speed: Speeds of the grains (n,), m/s.
        plastic_work: Plastic work of each grain (n,), J; None in a run without energy balance.
        force: Largest contact force on each grain (n,), N; None in a frame without contacts.
        walls: Corners of the triangles of the walls (m, 3, 3), m.
    """

    step: int
    positions: np.ndarray
    radii: np.ndarray
    speed: np.ndarray
    plastic_work: np.ndarray | None
    force: np.ndarray | None
    walls: np.ndarray


def read_frame(frame: Frame) -> GrainFrame:
    """Read the VTK files of a time step.

    Raises:
        DamagedFrame: A file is incomplete.
        SnapshotError: A file lacks a column, or pyvista is not installed.
    """
    grains, walls = read_frame_file(frame.grains), np.empty((0, 3, 3))
    if frame.mesh and (mesh := read_frame_file(frame.mesh)).n_cells:
        walls = np.asarray(mesh.points, float)[mesh.regular_faces]
    if not grains.n_points:  # a file without grains has no columns
        none = np.zeros(0)
        return GrainFrame(frame.step, np.empty((0, 3)), none, none, none, none, walls)
    if missing := {"radius", "v", "id"} - set(grains.point_data):
        raise SnapshotError(f"{frame.grains} has no column {', '.join(sorted(missing))}")
    positions = np.asarray(grains.points, float).reshape(-1, 3)
    work = grains.point_data.get("f_plastic_work")
    return GrainFrame(
        frame.step,
        positions,
        np.asarray(grains["radius"], float),
        _norms(grains["v"]),
        None if work is None else np.asarray(work, float),
        None if frame.contacts is None else _largest_forces(frame, positions),
        walls,
    )


def read_frames(frames: Iterable[Frame]) -> tuple[list[GrainFrame], list[Path]]:
    """Return the complete frames, and the damaged files of the other frames.

    Raises:
        SnapshotError: A file lacks a column, or pyvista is not installed.
    """
    whole, damaged = [], []
    for frame in frames:
        try:
            whole.append(read_frame(frame))
        except DamagedFrame as error:
            damaged.append(error.path)
    return whole, damaged


def _largest_forces(frame: Frame, positions: np.ndarray) -> np.ndarray:
    """Return the largest contact force (n,) [N] on each of the n grains."""
    from scipy.spatial import cKDTree

    largest, forces = np.zeros(len(positions)), contact_forces(frame)
    if len(forces):
        ends = np.asarray(read_frame_file(frame.contacts).points, float).reshape(-1, 3)
        # The file of contacts does not identify grains. Find them by the ends of the contact lines,
        # which are grain centers with six digits. Omit ends that are not at a grain center: their
        # contacts cross a periodic boundary.
        distance, grain = cKDTree(positions).query(ends)
        at_grain = distance < 1e-4 * np.ptp(positions, axis=0).max()
        np.maximum.at(largest, grain[at_grain], np.repeat(forces, 2)[at_grain])
    return largest
