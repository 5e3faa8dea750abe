# SPDX-License-Identifier: GPL-2.0-or-later
"""The VTK files of a run's frames: which there are, and whether they can be read whole.

Needs pyvista, an optional dependency: `pip install pyvista`.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import pyvista


class SnapshotError(ValueError):
    """There is nothing to draw, or nothing to draw with; the message says which."""


class DamagedFrame(SnapshotError):
    """A file of a frame cannot be read whole; the message names it."""

    def __init__(self, path: Path) -> None:
        super().__init__(f"{path} cannot be read whole: it is cut short or damaged")
        self.path = path


@dataclass(frozen=True)
class Frame:
    """The VTK files of one step of a run; those it does not have are None.

    Attributes:
        step: Of the engine.
        grains: Points with radius, velocity and plastic work.
        contacts: Lines between the centres of grains that touch, with force and overlap.
        mesh: Triangles of the walls.
    """

    step: int
    grains: Path
    contacts: Path | None
    mesh: Path | None

    @property
    def files(self) -> list[Path]:
        """Those that the step has."""
        return [path for path in (self.grains, self.contacts, self.mesh) if path]


def find_frames(folder: str | Path) -> list[Frame]:
    """The frames of a run, by step.

    Args:
        folder: Of the run, or its `frames`.

    Raises:
        SnapshotError: There are none.
    """
    folder = Path(folder)
    if (folder / "frames").is_dir():
        folder = folder / "frames"

    def at(kind: str) -> dict[int, Path]:
        found = folder.glob(f"{kind}_[0-9]*.vtk")  # others are boxes around the grains
        return {int(path.stem.removeprefix(f"{kind}_")): path for path in found}

    grains, contacts, mesh = at("grains"), at("contacts"), at("mesh")
    if not grains:
        raise SnapshotError(
            f"no frames (grains_STEP.vtk) in {folder}; run the deck with -v frames=10 or so, a "
            "deck of your own with the dumps that `plastigran new-deck` writes"
        )
    return [Frame(s, grains[s], contacts.get(s), mesh.get(s)) for s in sorted(grains)]


def load_pyvista():
    """pyvista, told which window to use where there is no screen."""
    if not os.environ.get("DISPLAY"):
        os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")
    try:
        import pyvista
    except ImportError:
        raise SnapshotError("snapshots need pyvista: pip install pyvista") from None
    return pyvista


def whole_frames(frames: Iterable[Frame]) -> list[Frame]:
    """The frames whose files can all be read whole.

    Raises:
        SnapshotError: There are none.

    Warns:
        UserWarning: A frame is left out; the message names the file.
    """
    whole = []
    for frame in frames:
        try:
            for path in frame.files:
                read_vtk(path)
        except DamagedFrame as error:
            warnings.warn(f"{error}; the frame of step {frame.step} is left out", stacklevel=2)
            continue
        whole.append(frame)
    if not whole:
        raise SnapshotError("no frame can be read whole")
    return whole


def read_vtk(path: Path) -> pyvista.DataSet:
    """A file of a frame. VTK would warn of one without points, which is no fault.

    Raises:
        DamagedFrame: It cannot be read whole.
    """
    pyvista = load_pyvista()
    with open(path, "rb") as file:
        head = file.read(500)
        file.seek(max(0, path.stat().st_size - 1))
        if not file.read().endswith(b"\n"):
            raise DamagedFrame(path)
    try:
        with (
            pyvista.vtk_verbosity("off"),
            pyvista.VtkErrorCatcher(raise_errors=True, send_to_logging=False),
            warnings.catch_warnings(),
        ):
            warnings.simplefilter("ignore")
            found = pyvista.read(path)
    except (RuntimeError, ValueError, TypeError):
        raise DamagedFrame(path) from None
    # VTK does not complain of a file that ends between two of its parts.
    if not found.n_points:
        whole = b"\nPOINTS 0 " in head
    elif path.name.startswith("mesh_"):  # it may have no columns
        points = found.n_verts if isinstance(found, pyvista.PolyData) else 0
        whole = found.n_cells > points
    else:
        whole = bool(found.array_names)
    if not whole:
        raise DamagedFrame(path)
    return found
