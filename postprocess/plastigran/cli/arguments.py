# SPDX-License-Identifier: GPL-2.0-or-later
"""Arguments several subcommands take, and what they mean."""

from __future__ import annotations

import argparse
from math import inf
from pathlib import Path

from plastigran import materials


def positive(text: str) -> float:
    """A positive, finite number. Raises ArgumentTypeError, which argparse prints, for another."""
    try:
        value = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number") from None
    if not 0 < value < inf:
        raise argparse.ArgumentTypeError(f"{text} is not positive and finite")
    return value


def positive_integer(text: str) -> int:
    """A whole number from 1. Raises ArgumentTypeError, which argparse prints, for another."""
    try:
        value = int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number") from None
    if value < 1:
        raise argparse.ArgumentTypeError(f"{text} is not 1 or more")
    return value


def known_materials() -> str:
    """A sentence for the help of a flag that takes a material."""
    return f"a name or the path of a file; there are {', '.join(materials.names())}"


def add_laws(command: argparse.ArgumentParser, bodies: str) -> None:
    """`--law`: those named, or all for some bodies, as `materials.choose_laws` takes them."""
    command.add_argument(
        "--law",
        nargs="+",
        default=["all"],
        metavar="LAW",
        help=f"laws, or all (default) for {bodies} that the material has the constants for",
    )


def add_material(command: argparse.ArgumentParser, default: str | None = None) -> None:
    """The material of a body; without a default it must be given."""
    usual = f"default {default}, " if default else ""
    command.add_argument(
        "--material", default=default, required=not default, help=usual + known_materials()
    )


def add_jobs(command: argparse.ArgumentParser) -> None:
    """How many engines run at a time."""
    command.add_argument("--jobs", type=positive_integer, help="engines at a time, default: cores")


def add_output(command: argparse.ArgumentParser, default: str) -> None:
    """Where results go, and --force to overwrite earlier ones there."""
    command.add_argument(
        "--output", type=Path, default=Path(default), help=f"folder of results, default {default}"
    )
    command.add_argument("--force", action="store_true", help="overwrite results")
