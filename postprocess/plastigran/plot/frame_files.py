# SPDX-License-Identifier: GPL-2.0-or-later
"""Find the frames of a run, and check that their files are complete.

A frame is the output of the run at one time step. LIGGGHTS writes frames as VTK files, LAMMPS as
text dumps of the grains.

This module needs pyvista, an optional dependency: `pip install pyvista`.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

import attrs
import numpy as np
import pandas as pd

if TYPE_CHECKING:
    import pyvista


class SnapshotError(ValueError):
    """A picture cannot be drawn. The message names the missing data or library."""


class DamagedFrame(SnapshotError):
    """A file of a frame is incomplete; the message names the file."""

    def __init__(self, path: Path) -> None:
        super().__init__(f"{path} is cut short or damaged")
        self.path = path


@attrs.frozen
class Frame:
    """Output files of a run at one time step; None for files that do not exist.

    Attributes:
        step: Time step number.
        grains: File of points with radius, velocity and plastic work of the grains.
        contacts: File of lines between the centers of grains in contact, with force and overlap.
        mesh: File of the triangles of the walls.
    """

    step: int
    grains: Path
    contacts: Path | None
    mesh: Path | None


def find_frames(folder: str | Path) -> list[Frame]:
    """Return the frames of a run, sorted by step.

    Args:
        folder: Folder of the run, or its folder `frames`.

    Raises:
        SnapshotError: The folder does not exist, or it has no frames.
    """
    folder = Path(folder)
    if not folder.is_dir():
        raise SnapshotError(f"{folder} is not a folder. Give the folder of a run")
    if (folder / "frames").is_dir():
        folder = folder / "frames"

    def files_by_step(name: str) -> dict[int, Path]:
        # Select names with a step number, because LIGGGHTS also writes VTK files of bounding boxes.
        files = [*folder.glob(f"{name}_[0-9]*.vtk"), *folder.glob(f"{name}_[0-9]*.dump")]
        return {int(path.stem.removeprefix(f"{name}_")): path for path in files}

    grains, contacts, mesh = map(files_by_step, ("grains", "contacts", "mesh"))
    if not grains:
        raise SnapshotError(
            f"no frames (grains_STEP.vtk) in {folder}. Run the deck with -v frames=10. A deck "
            "of your own needs the dumps that `plastigran new-deck` writes"
        )
    return [Frame(s, grains[s], contacts.get(s), mesh.get(s)) for s in sorted(grains)]


def load_pyvista():
    """Import pyvista, configured for machines without a screen.

    Raises:
        SnapshotError: pyvista is not installed.
    """
    if not os.environ.get("DISPLAY"):
        os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")
    try:
        import pyvista
    except ImportError:
        raise SnapshotError("snapshots need pyvista. Run `pip install pyvista`") from None
    return pyvista


def whole_frames(frames: Iterable[Frame]) -> list[Frame]:
    """Return the frames whose files are all complete.

    Raises:
        SnapshotError: No frame is complete.

    Warns:
        UserWarning: A frame is omitted. The warning names its damaged file.
    """
    whole = []
    for frame in frames:
        try:
            for path in (frame.grains, frame.contacts, frame.mesh):
                if path is not None:
                    read_frame_file(path)
            whole.append(frame)
        except DamagedFrame as error:
            warnings.warn(f"{error}; the frame of step {frame.step} is left out", stacklevel=2)
    if not whole:
        raise SnapshotError("no frame is complete. Run the deck again")
    return whole


def read_frame_file(path: Path) -> pyvista.DataSet:
    """Read a file of a frame. A file without points is valid and causes no warning.

    Raises:
        DamagedFrame: The file is incomplete.
    """
    if path.suffix == ".dump":
        return _read_dump(path)
    pyvista = load_pyvista()
    content = path.read_bytes()
    if not content.endswith(b"\n"):
        raise DamagedFrame(path)
    try:
        with (
            pyvista.vtk_verbosity("off"),
            pyvista.VtkErrorCatcher(raise_errors=True, send_to_logging=False),
            warnings.catch_warnings(),
        ):
            warnings.simplefilter("ignore")
            data = pyvista.read(path)
    except (RuntimeError, ValueError, TypeError):
        raise DamagedFrame(path) from None
    # VTK reports no error for a file that ends after a complete section. So check that the points
    # and the sections after them exist.
    if not data.n_points:
        whole = b"\nPOINTS 0 " in content
    elif path.name.startswith("mesh_"):  # mesh files may have no data columns
        whole = data.n_cells > getattr(data, "n_verts", 0)
    else:
        whole = bool(data.array_names)
    if not whole:
        raise DamagedFrame(path)
    return data


def _read_dump(path: Path) -> pyvista.DataSet:
    """Read the grains in a text dump of LAMMPS as points with the columns of LIGGGHTS' VTK files.

    Raises:
        DamagedFrame: The file is incomplete.
    """
    pyvista = load_pyvista()
    text = path.read_text()
    lines = text.splitlines()
    if not text.endswith("\n") or len(lines) < 9 or len(lines) != 9 + int(lines[3]):
        raise DamagedFrame(path)
    names = lines[8].split()[2:]
    rows = np.array([line.split() for line in lines[9:]], float).reshape(-1, len(names))
    table = pd.DataFrame(rows, columns=names)
    if table.empty:
        return pyvista.PolyData()
    grains = pyvista.PolyData(table[["x", "y", "z"]].to_numpy())
    grains["v"] = table[["vx", "vy", "vz"]].to_numpy()
    for name in ("id", "type"):
        grains[name] = table[name].to_numpy(int)
    grains["radius"] = table["radius"].to_numpy()
    if "d_plastigran_work" in table:
        grains["f_plastic_work"] = table["d_plastigran_work"].to_numpy()
    return grains
