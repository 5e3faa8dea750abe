# SPDX-License-Identifier: GPL-2.0-or-later
"""Pack the frames of a run for the page's three-dimensional view of grains."""

from __future__ import annotations

import base64
import gzip
import json
from collections.abc import Callable
from pathlib import Path

import attrs
import matplotlib
import numpy as np

from plastigran.plot.frame_files import Frame, SnapshotError, find_frames
from plastigran.plot.frames import GrainFrame, read_frames
from plastigran.plot.quantities import scale

#: Largest total number of grains in all frames; each takes 14 bytes before compression.
MOST = 90_000
#: Largest number of damaged files that a sentence names.
MOST_NAMED = 5
#: Percentile of the values at the end of the color scale; a few grains may lie far beyond.
SPANNED = 99.5
_DEEPEST = 65535  # largest 16-bit number
#: Quantities that can color grains: attribute of a frame, name, and column of the unit.
COLOURED = {
    "plastic_work": ("plastic work", "plastic"),
    "force": ("largest contact force", "force"),
    "speed": ("speed", "speed"),
}


@attrs.frozen(eq=False)
class Movie:
    """Packed frames of a run.

    Attributes:
        name: ID of the element of the page.
        data: Gzip of a line of JSON and 16-bit numbers, in base64.
        frames: Number of frames.
        colours: Words for the quantities that can color grains, by name.
        walls: Whether there are walls.
        caption: One or two sentences.
    """

    name: str
    data: str
    frames: int
    colours: dict[str, str]
    walls: bool
    caption: str


def pack_movie(
    name: str, folder: Path, clock: Callable[[int], float] | None
) -> tuple[Movie | None, list[str]]:
    """Pack the frames of a run.

    Args:
        name: ID of the element of the page.
        folder: Folder of the run.
        clock: Function from step to time as in the charts [s]; None to show steps instead.

    Returns:
        The movie, None without frames; and a sentence on damaged frames.

    Raises:
        SnapshotError: A frame lacks a column, no frame has grains, or pyvista is not installed.
    """
    try:
        found = find_frames(folder)
    except SnapshotError:
        return None, []
    found, grains, damaged = _without_damaged_ends(found)
    kept, thin = _fitting(found, grains)
    whole, others = read_frames(kept)
    missing = _left_out(damaged + others)
    if not whole:
        return None, missing
    if not any(len(frame.radii) for frame in whole):
        raise SnapshotError("no frame contains grains")
    frames = [_thinned(frame, thin) for frame in whole]
    left = []
    if len(kept) < len(found):
        left.append(f"{len(whole)} of {len(found)} frames")
    if thin > 1:
        left.append(f"every {thin}th grain")
    said = f" The page holds {' and '.join(left)}." if left else ""
    colours = {key: words for key, (words, _) in COLOURED.items() if _has(frames, key)}
    movie = Movie(
        name,
        _pack(frames, list(colours), clock),
        len(frames),
        colours,
        any(len(frame.walls) for frame in frames),
        f"{len(whole[-1].radii)} grains in the last frame, to scale. Drag to rotate, pinch or "
        f"scroll with Ctrl to zoom, point at a grain for its values.{said}",
    )
    return movie, missing


def _without_damaged_ends(found: list[Frame]) -> tuple[list[Frame], int, list[Path]]:
    """Return the complete frames, the largest number of grains at either end, and damaged files."""
    most, damaged = 0, []
    for end in (-1, 0):
        while found:
            whole, unread = read_frames([found[end]])
            if whole:
                most = max(most, len(whole[0].radii))
                break
            damaged += unread
            del found[end]
    return found, most, damaged


def _left_out(damaged: list[Path]) -> list[str]:
    if not damaged:
        return []
    names = sorted({path.name for path in damaged}, key=lambda name: (len(name), name))
    more = len(names) - MOST_NAMED
    said = ", ".join(names[:MOST_NAMED]) + (f" and {more} more" if more > 0 else "")
    frames = "A frame is" if len(names) == 1 else f"{len(names)} frames are"
    return [f"{frames} left out of the view of grains: {said} are incomplete."]


def _has(frames: list[GrainFrame], name: str) -> bool:
    return all(getattr(frame, name) is not None for frame in frames)


def _fitting(found: list[Frame], grains: int) -> tuple[list[Frame], int]:
    """Select frames within `MOST` grains, including the first and last.

    If a single frame has more grains, return the step with which they are thinned.

    Args:
        found: Frames of the run.
        grains: Larger number of grains of the first and last frame.
    """
    many = max(1, MOST // max(grains, 1))
    thin = max(1, -(-grains // MOST))
    if many >= len(found):
        return found, thin
    chosen = np.unique(np.linspace(0, len(found) - 1, many).round().astype(int))
    return [found[k] for k in (chosen if many > 1 else [-1])], thin


def _thinned(frame: GrainFrame, every: int) -> GrainFrame:
    if every == 1:
        return frame
    names = ("positions", "radii", "speed", "plastic_work", "force")
    part = {name: getattr(frame, name) for name in names}
    return attrs.evolve(
        frame, **{name: value[::every] for name, value in part.items() if value is not None}
    )


def _pack(
    frames: list[GrainFrame], colours: list[str], clock: Callable[[int], float] | None
) -> str:
    corners = np.concatenate(
        [np.concatenate([f.positions, f.walls.reshape(-1, 3)]) for f in frames]
        or [np.zeros((1, 3))]
    )
    low, size = corners.min(axis=0), max(float(np.ptp(corners, axis=0).max()), 1e-300)
    largest = max(float(f.radii.max(initial=0)) for f in frames) or 1.0
    tops = {name: max(float(getattr(f, name).max(initial=0)) for f in frames) for name in colours}

    def small(values: np.ndarray, top: float) -> np.ndarray:
        share = np.clip(np.asarray(values, float) / (top or 1.0), 0, 1)
        return (share * _DEEPEST).round().astype("<u2")

    parts, heads, walls_before = [], [], None
    for frame in frames:
        walls = small(frame.walls.reshape(-1, 3) - low, size)
        same = walls_before is not None and np.array_equal(walls, walls_before)
        walls_before = walls
        heads.append(
            {
                "said": _said(frame.step, clock),
                "grains": len(frame.radii),
                "corners": None if same else len(walls),
            }
        )
        parts += [small(frame.positions - low, size), small(frame.radii, largest)]
        parts += [small(getattr(frame, name), tops[name]) for name in colours]
        parts += [] if same else [walls]
    head = {
        "size": size,
        "extent": np.ptp(corners, axis=0).tolist(),
        "radius": largest,
        "frames": heads,
        "colours": [_colour(name, frames, tops[name]) for name in colours],
        "map": _colour_map(),
    }
    # The numbers must start at an even byte.
    line = json.dumps(head, ensure_ascii=True)
    line += " " * (len(line) % 2 == 0) + "\n"
    numbers = b"".join(part.tobytes() for part in parts)
    return base64.b64encode(gzip.compress(line.encode() + numbers, 9, mtime=0)).decode()


def _colour(name: str, frames: list[GrainFrame], top: float) -> dict:
    """Return the name, unit and color range of a quantity for the page."""
    values = np.concatenate([getattr(f, name) for f in frames])
    spanned = float(np.percentile(values, SPANNED)) if values.size else 0.0
    said, column = COLOURED[name]
    shown = scale(column, [spanned or top or 1.0])
    return {
        "name": name,
        "said": said,
        "unit": shown.unit,
        "top": top * shown.factor,
        "spanned": (spanned or top or 1.0) * shown.factor,
    }


def _said(step: int, clock: Callable[[int], float] | None) -> str:
    if clock is None:
        return f"step {step}"
    moment = clock(step)
    time = scale("time", [moment])
    return f"{moment * time.factor:.3g} {time.unit}".replace("-", "−")


def _colour_map() -> list[str]:
    shades = matplotlib.colormaps["viridis"](np.linspace(0, 1, 16))
    return [matplotlib.colors.to_hex(shade) for shade in shades]
