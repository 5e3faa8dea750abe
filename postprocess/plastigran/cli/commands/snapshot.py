# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran snapshot`: a picture of grains or force chains of a bulk run."""

from __future__ import annotations

import argparse
from pathlib import Path

from plastigran.cli.arguments import positive, refuse_idle
from plastigran.plot.frame_files import SnapshotError, find_frames
from plastigran.plot.frames import GRAIN_QUANTITIES
from plastigran.plot.grain_movie import save_grain_movie
from plastigran.plot.snapshot import VIEWS, draw

HELP = "draw a picture of grains or force chains of a bulk run"
EXAMPLE = """
plastigran bulk hopper -v frames=20 --output results/frames
plastigran snapshot results/frames --colour speed --view front
plastigran snapshot results/frames --movie hopper.mp4
"""


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "folder",
        type=Path,
        help="folder of a bulk run that wrote frames, for example with `-v frames=10`",
    )
    frames = command.add_mutually_exclusive_group()
    frames.add_argument(
        "--step", type=int, help="time step number of the frame to draw, default the last frame"
    )
    frames.add_argument(
        "--movie", type=Path, metavar="FILE", help="movie of all frames, .mp4 or .gif"
    )
    command.add_argument("--rate", type=positive, help="frames per second of --movie, default 10")
    command.add_argument(
        "--contacts", action="store_true", help="draw force chains instead of grains"
    )
    command.add_argument(
        "--colour",
        choices=list(GRAIN_QUANTITIES),
        help="quantity that colors the grains, default plastic_work",
    )
    command.add_argument(
        "--view", choices=list(VIEWS), default="corner", help="direction of view, default corner"
    )
    command.add_argument(
        "--output",
        type=Path,
        help="file for the picture, default FOLDER/figures/NAME_VIEW_STEP.png",
    )


def run(arguments: argparse.Namespace) -> None:
    if arguments.contacts and arguments.colour is not None:
        raise ValueError("--colour is for grains, but --contacts draws no grains. Remove one flag")
    if arguments.movie is None:
        refuse_idle(arguments, "--movie", rate=None)
    else:
        if arguments.output is not None:
            raise ValueError(
                "--output is for one picture, but --movie writes a movie. Remove one flag"
            )
        save_grain_movie(
            find_frames(arguments.folder),
            arguments.movie,
            arguments.colour or "plastic_work",
            arguments.contacts,
            arguments.view,
            rate=arguments.rate or 10.0,
        )
        print(f"written: {arguments.movie}")
        return
    colour = arguments.colour or "plastic_work"
    frames = {frame.step: frame for frame in find_frames(arguments.folder)}
    step = max(frames) if arguments.step is None else arguments.step
    if step not in frames:
        steps = ", ".join(map(str, frames))
        raise SnapshotError(
            f"no frame of step {step} in {arguments.folder}. Available steps: {steps}"
        )
    name = "contacts" if arguments.contacts else colour
    picture = (
        arguments.output or arguments.folder / "figures" / f"{name}_{arguments.view}_{step}.png"
    )
    picture.parent.mkdir(parents=True, exist_ok=True)
    draw(frames[step], picture, colour, arguments.contacts, arguments.view)
    print(f"written: {picture}")
