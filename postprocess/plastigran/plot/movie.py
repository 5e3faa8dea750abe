# SPDX-License-Identifier: GPL-2.0-or-later
"""Movie of a matplotlib figure, which is drawn frame by frame and written as a GIF file."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import attrs
from matplotlib.animation import PillowWriter
from matplotlib.figure import Figure

RESOLUTION = 80  # resolution of the frames, pixels per inch


@attrs.frozen(eq=False)
class Movie:
    """Movie whose frames are drawn in one matplotlib figure.

    Attributes:
        figure: Figure to draw in.
        frames: Number of frames.
        draw: Function `draw(number)` that draws a frame in `figure`. Frames are counted from 0.
        rate: Frames per second.
    """

    figure: Figure
    frames: int
    draw: Callable[[int], None]
    rate: float


def save_movie(movie: Movie, path: Path) -> Path:
    """Write a movie to a GIF file and return the path of this file."""
    path.parent.mkdir(parents=True, exist_ok=True)
    writer = PillowWriter(fps=movie.rate)
    with writer.saving(movie.figure, path, RESOLUTION):
        for number in range(movie.frames):
            movie.draw(number)
            writer.grab_frame()
    return path
