# SPDX-License-Identifier: GPL-2.0-or-later
"""Arguments several subcommands take, and what they mean."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterable
from itertools import chain
from math import inf
from pathlib import Path

from plastigran import laws, materials
from plastigran.experiments.runs import TABLE


class UsageError(ValueError):
    """A command line that cannot be carried out."""


def positive(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number") from None
    if not 0 < value < inf:
        raise argparse.ArgumentTypeError(f"{text} is not positive and finite")
    return value


def positive_integer(text: str) -> int:
    try:
        value = int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number") from None
    if value < 1:
        raise argparse.ArgumentTypeError(f"{text} is not 1 or more")
    return value


def add_jobs(command: argparse.ArgumentParser) -> None:
    command.add_argument("--jobs", type=positive_integer, help="engines at a time, default: cores")


def add_output(command: argparse.ArgumentParser, default: str) -> None:
    command.add_argument("--output", type=Path, default=Path(default), help=f"default {default}")
    command.add_argument("--force", action="store_true", help="overwrite results")


def law_names(
    given: Iterable[str], material_names: Iterable[str], shape: str = "sphere"
) -> list[str]:
    """Names from the command line; "all" stands for every law for bodies of a shape that the
    materials have the constants for.

    Raises:
        UsageError: There is no such law.
    """
    for name in given:
        if name not in laws.LAWS and name != "all":
            raise UsageError(f"no law {name!r}; there are {', '.join(sorted(laws.LAWS))}")
    bodies = [materials.read_material(material) for material in material_names]
    usable = materials.laws_for(shape, bodies)
    left = sorted(set(materials.laws_for(shape)) - set(usable) - set(given))
    if "all" in given and left:
        print(
            f"left out, for the material lacks their constants: {', '.join(left)}", file=sys.stderr
        )
    expanded = [usable if name == "all" else [name] for name in given]
    return list(dict.fromkeys(chain.from_iterable(expanded)))


def fresh_folder(folder: Path, force: bool) -> Path:
    """A folder for results: never one that holds some, unless forced.

    Raises:
        UsageError: It holds some.
    """
    if (folder / TABLE).exists() and not force:
        raise UsageError(f"{folder} holds results; choose another --output, or add --force")
    return folder
