# SPDX-License-Identifier: GPL-2.0-or-later
"""Pack the frames of a bulk run for the three-dimensional view of grains on the page.

A frame is a snapshot of all grains at one step.
"""

from __future__ import annotations

import base64
import gzip
import json
from collections.abc import Callable, Sequence
from pathlib import Path

import attrs
import matplotlib
import numpy as np

from plastigran.plot.frame_files import Frame, SnapshotError, find_frames
from plastigran.plot.frames import GrainFrame, read_frames
from plastigran.plot.quantities import scale

#: Largest number of grains, summed over all frames. A grain takes 14 bytes before compression.
MOST_GRAINS = 90_000
#: Largest number of damaged files that a message names.
MOST_NAMED = 5
#: Percentile of the values at which the color scale ends. A few grains may have far larger values,
#: which would leave the other grains in one color.
SCALE_PERCENTILE = 99.5
_LARGEST = 65535  # largest 16-bit number
#: Quantities that can color grains. For each attribute of a frame: its name in words, and a key of
#: `plastigran.plot.quantities.QUANTITIES` with the same unit.
COLOURED = {
    "plastic_work": ("plastic work", "plastic"),
    "force": ("largest contact force", "force"),
    "speed": ("speed", "speed"),
}
#: Function that converts a step number to the time of the charts [s]; None to show step numbers.
Clock = Callable[[int], float] | None


@attrs.frozen(eq=False)
class GrainMovie:
    """Packed frames of a bulk run; a frame is a snapshot of all grains at one step.

    Attributes:
        data: A line of JSON followed by 16-bit numbers, compressed by `pack`.
        frames: Number of frames.
        colours: Quantities that can color grains: names in words by attribute of the frames.
        walls: Whether the frames have walls.
        caption: Caption of the view.
    """

    data: str
    frames: int
    colours: dict[str, str]
    walls: bool
    caption: str


def pack(content: bytes) -> str:
    """Compress `content` with gzip and encode the result in base64, for the page."""
    return base64.b64encode(gzip.compress(content, 9, mtime=0)).decode()


def pack_movie(folder: Path, clock: Clock) -> tuple[GrainMovie | None, list[str]]:
    """Pack the frames (snapshots of all grains) of a bulk run.

    Args:
        folder: Folder of the run.
        clock: Conversion of step numbers to times; see `Clock`.

    Returns:
        The movie, or None if there are no frames. Also a list with a sentence for the page if
        frames are damaged; otherwise an empty list.

    Raises:
        SnapshotError: A frame lacks a column, no frame has grains, or pyvista is not installed.
    """
    try:
        files = find_frames(folder)
    except SnapshotError:
        return None, []
    files, most, damaged = _without_damaged_ends(files)
    selected, stride = _select(files, most)
    frames, further_damaged = read_frames(selected)
    missing = _left_out(damaged + further_damaged)
    if not frames:
        return None, missing
    count = len(frames[-1].radii)
    if not any(len(frame.radii) for frame in frames):
        raise SnapshotError("no frame contains grains")
    frames = [_thin(frame, stride) for frame in frames]
    parts = [f"{len(frames)} of {len(files)} frames"] if len(selected) < len(files) else []
    parts += [f"one in {stride} grains"] if stride > 1 else []
    excerpt = f" The page contains {' and '.join(parts)}." if parts else ""
    colours = {
        name: words
        for name, (words, _) in COLOURED.items()
        if all(getattr(frame, name) is not None for frame in frames)
    }
    movie = GrainMovie(
        pack(_numbers(frames, list(colours), clock)),
        len(frames),
        colours,
        any(len(frame.walls) for frame in frames),
        f"The last frame has {count} grains, drawn to scale. Drag to rotate. Pinch, or scroll with "
        f"Ctrl, to zoom. Point at a grain to see its values.{excerpt}",
    )
    return movie, missing


def _without_damaged_ends(files: list[Frame]) -> tuple[list[Frame], int, list[Path]]:
    """Remove damaged frames from both ends of a list of frames.

    Returns:
        The remaining frames; the number of grains in the first or in the last of these frames,
        whichever is larger; and the damaged files.
    """
    most, damaged = 0, []
    for end in (-1, 0):
        while files:
            frames, unreadable = read_frames([files[end]])
            if frames:
                most = max(most, len(frames[0].radii))
                break
            damaged += unreadable
            del files[end]
    return files, most, damaged


def _left_out(damaged: list[Path]) -> list[str]:
    """Return a list with a sentence that names the files of damaged frames, if there are any."""
    names = sorted({path.name for path in damaged}, key=lambda name: (len(name), name))
    if not names:
        return []
    more = f" and {len(names) - MOST_NAMED} more" if len(names) > MOST_NAMED else ""
    files = f"{', '.join(names[:MOST_NAMED])}{more}"
    if len(names) == 1:
        return [f"A frame is left out of the view of grains, because {files} is incomplete."]
    count = len(names)
    return [f"{count} frames are left out of the view of grains, because {files} are incomplete."]


def _select(files: list[Frame], most: int) -> tuple[list[Frame], int]:
    """Select frames so that the page contains at most `MOST_GRAINS` grains in total.

    Args:
        files: All undamaged frames.
        most: Largest number of grains of a frame.

    Returns:
        Selected frames, including the first and the last; and the stride of the grains. The page
        contains every `stride`-th grain. The stride exceeds 1 only if one frame has more than
        `MOST_GRAINS` grains.
    """
    count = max(1, MOST_GRAINS // max(most, 1))
    stride = max(1, -(-most // MOST_GRAINS))
    if count >= len(files):
        return files, stride
    if count == 1:
        return files[-1:], stride
    chosen = np.unique(np.linspace(0, len(files) - 1, count).round().astype(int))
    return [files[k] for k in chosen], stride


def _thin(frame: GrainFrame, stride: int) -> GrainFrame:
    values = {name: getattr(frame, name) for name in ("positions", "radii", *COLOURED)}
    values = {name: value[::stride] for name, value in values.items() if value is not None}
    return attrs.evolve(frame, **values)


def _numbers(frames: Sequence[GrainFrame], colours: list[str], clock: Clock) -> bytes:
    """Encode frames as a line of JSON and 16-bit numbers, for `unpackFrames` in movie.js."""
    corners = np.concatenate([np.r_[f.positions, f.walls.reshape(-1, 3)] for f in frames])
    low, size = corners.min(axis=0), max(float(np.ptp(corners, axis=0).max()), 1e-300)
    radius = max(float(f.radii.max(initial=0)) for f in frames) or 1.0
    tops = {name: max(float(getattr(f, name).max(initial=0)) for f in frames) for name in colours}

    def to_16_bits(values: np.ndarray, top: float) -> np.ndarray:
        return (np.clip(values / (top or 1.0), 0, 1) * _LARGEST).round().astype("<u2")

    arrays, heads, earlier_walls = [], [], None
    for frame in frames:
        arrays += [to_16_bits(frame.positions - low, size), to_16_bits(frame.radii, radius)]
        arrays += [to_16_bits(getattr(frame, name), tops[name]) for name in colours]
        walls = to_16_bits(frame.walls.reshape(-1, 3) - low, size)
        same = earlier_walls is not None and np.array_equal(walls, earlier_walls)
        arrays += [] if same else [walls]
        earlier_walls = walls
        corner_count = None if same else len(walls)
        label = _time_label(frame.step, clock)
        heads.append({"label": label, "grains": len(frame.radii), "corners": corner_count})
    viridis = matplotlib.colormaps["viridis"](np.linspace(0, 1, 16))
    head = {
        "size": size,
        "extent": np.ptp(corners, axis=0).tolist(),
        "radius": radius,
        "frames": heads,
        "colours": [_colour(name, frames, tops[name]) for name in colours],
        "map": [matplotlib.colors.to_hex(shade) for shade in viridis],
    }
    line = json.dumps(head)
    # Pad the line, because the 16-bit numbers must start at an even byte.
    line += " " * (len(line) % 2 == 0) + "\n"
    return line.encode() + b"".join(array.tobytes() for array in arrays)


def _colour(name: str, frames: Sequence[GrainFrame], top: float) -> dict:
    """Return the name, the unit and the color range of a quantity that colors the grains."""
    values = np.concatenate([getattr(frame, name) for frame in frames])
    end = (float(np.percentile(values, SCALE_PERCENTILE)) if values.size else 0.0) or top or 1.0
    title, column = COLOURED[name]
    axis = scale(column, [end])
    ends = {"top": top * axis.factor, "end": end * axis.factor}
    return {"name": name, "title": title, "unit": axis.unit, **ends}


def _time_label(step: int, clock: Clock) -> str:
    if clock is None:
        return f"step {step}"
    time = clock(step)
    axis = scale("time", [time])
    return f"{time * axis.factor:.3g} {axis.unit}".replace("-", "−")
