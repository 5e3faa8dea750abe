# SPDX-License-Identifier: GPL-2.0-or-later
"""Movie of a figure, drawn frame by frame and written as GIF."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import attrs
from matplotlib.animation import PillowWriter
from matplotlib.figure import Figure

RESOLUTION = 80  # resolution of the frames, pixels per inch


@attrs.frozen(eq=False)
class Movie:
    """Movie of a figure.

    Attributes:
        figure: Figure to draw in.
        frames: Number of frames.
        draw: Function `draw(number)` that draws the frame of this number in the figure.
        rate: Frames per second.
    """

    figure: Figure
    frames: int
    draw: Callable[[int], None]
    rate: float


def save_movie(movie: Movie, path: Path) -> Path:
    """Write a movie as GIF and return its path."""
    path.parent.mkdir(parents=True, exist_ok=True)
    writer = PillowWriter(fps=movie.rate)
    with writer.saving(movie.figure, path, RESOLUTION):
        for number in range(movie.frames):
            movie.draw(number)
            writer.grab_frame()
    return path
