# SPDX-License-Identifier: GPL-2.0-or-later
"""Movie of the frames that a run wrote. Movies need pyvista and imageio; MP4 files also need av."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from plastigran.plot.frame_files import Frame, SnapshotError, read_frame_file, whole_frames
from plastigran.plot.frames import GRAIN_QUANTITIES, contact_forces, grain_values
from plastigran.plot.snapshot import draw
from plastigran.progress import ProgressBar

SIZE = (960, 720)  # width and height in pixels; the video codec needs even numbers


def save_grain_movie(
    frames: Sequence[Frame],
    path: str | Path,
    colour: str = "plastic_work",
    contacts: bool = False,
    view: str = "corner",
    rate: float = 10.0,
    progress: bool = True,
) -> None:
    """Draw a movie of the frames of a run, all with the same view and the same color scale.

    A frame without grains shows only the walls. Incomplete frames are omitted.

    Args:
        frames: Frames in order.
        path: Name of the file, ending in .mp4 or .gif.
        colour, contacts, view: As for `plastigran.plot.snapshot.draw`.
        rate: Frames per second.
        progress: Whether to show a progress bar.

    Raises:
        SnapshotError: The file type is unknown, no frame has grains or contacts, or a library is
            not installed; or as for `draw`.

    Warns:
        UserWarning: A frame is omitted. The warning names its damaged file.
    """
    path = Path(path)
    writers = {
        ".mp4": {"plugin": "pyav", "codec": "libx264", "fps": rate},
        ".gif": {"plugin": "pillow", "loop": 0, "duration": 1000 / rate},
    }
    if path.suffix not in writers:
        raise SnapshotError(
            f"{path} cannot be a movie: its name must end in {' or '.join(writers)}"
        )
    frames = whole_frames(frames)
    if not any(read_frame_file(frame.grains).n_points for frame in frames):
        raise SnapshotError("no frame contains grains")
    values = [contact_forces(f) if contacts else grain_values(f, colour) for f in frames]
    together = np.concatenate([np.zeros(0), *values])
    from_zero = contacts or GRAIN_QUANTITIES[colour].from_zero
    low = 0.0 if from_zero else together.min(initial=np.inf)
    span = low, together.max(initial=low)
    if contacts and span == (0, 0):
        raise SnapshotError("no frame has contacts")
    imageio = _load_imageio(path.suffix)
    common = {"colour": colour, "contacts": contacts, "view": view, "size": SIZE}
    common |= {"span": span, "bounds": _bounds(frames)}
    bar = ProgressBar(frames, desc="movie", unit="frames", shown=progress)
    pictures = np.stack([draw(frame, None, **common) for frame in bar])
    path.parent.mkdir(parents=True, exist_ok=True)
    imageio.imwrite(path, pictures, **writers[path.suffix])


def _bounds(frames: Sequence[Frame]) -> list[float]:
    """Return the bounds along x, y and z [m] of all grains and meshes of all frames."""
    boxes = []
    for frame in frames:
        grains = read_frame_file(frame.grains)
        if grains.n_points:
            reach = grains["radius"].max() * np.array([-1, 1])
            boxes.append(np.reshape(grains.bounds, (3, 2)) + reach)
        if frame.mesh and (mesh := read_frame_file(frame.mesh)).n_points:
            boxes.append(np.reshape(mesh.bounds, (3, 2)))
    low, high = np.min(boxes, axis=0)[:, 0], np.max(boxes, axis=0)[:, 1]
    return np.stack([low, high], axis=1).ravel().tolist()


def _load_imageio(suffix: str):
    """Import imageio, and PyAV for MP4 files."""
    try:
        import imageio.v3

        if suffix == ".mp4":
            import av  # noqa: F401
    except ImportError as error:
        raise SnapshotError(f"movies need {error.name}. Run `pip install {error.name}`") from None
    return imageio.v3
