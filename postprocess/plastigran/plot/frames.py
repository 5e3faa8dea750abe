# SPDX-License-Identifier: GPL-2.0-or-later
"""Data of the VTK frames of a run: grains with their values, and triangles of the walls."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import attrs
import numpy as np

from plastigran.plot.frame_files import DamagedFrame, Frame, SnapshotError, read_vtk


@attrs.frozen(eq=False)
class GrainFrame:
    """Grains and walls of one step.

    Attributes:
        step: Time step number.
        positions: Centers of the grains (n, 3), m.
        radii: Radii (n,), m.
        speed: Speeds (n,), m/s.
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
    """Read the VTK files of a step.

    Raises:
        DamagedFrame: A file is incomplete.
        SnapshotError: A file lacks a column, or pyvista is not installed.
    """
    grains, walls = read_vtk(frame.grains), np.empty((0, 3, 3))
    if frame.mesh and (mesh := read_vtk(frame.mesh)).n_cells:
        walls = np.asarray(mesh.points, float)[mesh.regular_faces]
    if not grains.n_points:  # a file without grains has no columns
        none = np.zeros(0)
        return GrainFrame(frame.step, np.empty((0, 3)), none, none, none, none, walls)
    if missing := {"radius", "v", "id"} - set(grains.point_data):
        raise SnapshotError(f"{frame.grains} has no {', '.join(sorted(missing))}")
    positions = np.asarray(grains.points, float).reshape(-1, 3)
    work = grains.point_data.get("f_plastic_work")
    return GrainFrame(
        frame.step,
        positions,
        np.asarray(grains["radius"], float),
        np.linalg.norm(np.asarray(grains["v"], float).reshape(-1, 3), axis=1),
        None if work is None else np.asarray(work, float),
        None if frame.contacts is None else _largest_force(frame, positions),
        walls,
    )


def read_frames(frames: Iterable[Frame]) -> tuple[list[GrainFrame], list[Path]]:
    """Read frames; for an incomplete frame, return the damaged file instead.

    Raises:
        SnapshotError: As for `read_frame`.
    """
    found, damaged = [], []
    for frame in frames:
        try:
            found.append(read_frame(frame))
        except DamagedFrame as error:
            damaged.append(error.path)
    return found, damaged


def _largest_force(frame: Frame, positions: np.ndarray) -> np.ndarray:
    """Return the largest contact force on each grain; contact lines end in the grain centers."""
    from scipy.spatial import cKDTree

    found, lines = np.zeros(len(positions)), read_vtk(frame.contacts)
    if lines.n_cells:
        force = np.linalg.norm(np.asarray(lines["force"], float).reshape(-1, 3), axis=1)
        ends = np.asarray(lines.points, float).reshape(-1, 3)
        # A contact through a periodic side ends outside the grains. Coordinates have six digits.
        distance, grain = cKDTree(positions).query(ends)
        at_grain = distance < 1e-4 * np.ptp(positions, axis=0).max()
        np.maximum.at(found, grain[at_grain], np.repeat(force, 2)[at_grain])
    return found
