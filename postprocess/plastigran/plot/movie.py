# SPDX-License-Identifier: GPL-2.0-or-later
"""A figure drawn anew frame by frame, written as GIF."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import attrs
from matplotlib.animation import PillowWriter
from matplotlib.figure import Figure


@attrs.frozen(eq=False)
class Movie:
    """What is shown.

    Attributes:
        figure: It is drawn in.
        frames: How many.
        draw: Brings the figure to a frame, `draw(number)`.
        rate: Frames a second.
        resolution: Pixels an inch.
    """

    figure: Figure
    frames: int
    draw: Callable[[int], None]
    rate: float = 15
    resolution: int = 80


def save_movie(movie: Movie, path: Path) -> Path:
    """Write a movie as GIF; returns the path."""
    path.parent.mkdir(parents=True, exist_ok=True)
    writer = PillowWriter(fps=movie.rate)
    with writer.saving(movie.figure, path, movie.resolution):
        for number in range(movie.frames):
            movie.draw(number)
            writer.grab_frame()
    return path
