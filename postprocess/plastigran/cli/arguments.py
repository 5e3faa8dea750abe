# SPDX-License-Identifier: GPL-2.0-or-later
"""Arguments several subcommands take, and what they mean."""

from __future__ import annotations

import argparse
import json
from math import inf, isfinite
from pathlib import Path
from typing import Any

from plastigran import materials


class Subparsers:
    """What makes subcommands, all with an example in their help and --verbose.

    Args:
        made_by: What `ArgumentParser.add_subparsers` has made.
    """

    def __init__(self, made_by: Any) -> None:
        self._made_by = made_by

    def add(self, name: str, said: str, example: str = "") -> argparse.ArgumentParser:
        """A subcommand.

        Args:
            name: Of it.
            said: What it does, in a line.
            example: A command line or several.
        """
        lines = "".join(f"\n  {line}" for line in example.strip().splitlines())
        command = self._made_by.add_parser(
            name,
            help=said,
            description=f"{said[0].upper()}{said[1:]}.",
            epilog=f"example:{lines}" if lines else None,
            formatter_class=argparse.RawDescriptionHelpFormatter,
        )
        add_verbose(command)
        return command


def add_verbose(command: argparse.ArgumentParser, default: Any = argparse.SUPPRESS) -> None:
    """--verbose, which all commands take; -v is a variable of a deck where there are decks."""
    short = () if command.prog.endswith(" bulk") else ("-v",)
    command.add_argument(
        *short, "--verbose", action="store_true", default=default, help="trace of an error"
    )


def add_json(command: argparse.ArgumentParser) -> None:
    """--json, in place of the tables that are printed."""
    command.add_argument("--json", action="store_true", help="all numbers, as JSON")


def add_dry_run(command: argparse.ArgumentParser) -> None:
    """--dry-run, of commands that start the engine."""
    command.add_argument(
        "--dry-run", action="store_true", help="print command lines and folders, start nothing"
    )


def print_json(numbers: Any) -> None:
    """Print numbers, with null where one is not known or not finite."""

    def known(value: object) -> object:
        if isinstance(value, dict):
            return {name: known(entry) for name, entry in value.items()}
        if isinstance(value, list | tuple):
            return [known(entry) for entry in value]
        return None if isinstance(value, float) and not isfinite(value) else value

    print(json.dumps(known(numbers), allow_nan=False, default=lambda value: value.item()))


def refuse_idle(arguments: argparse.Namespace, needed: str, **idle: object) -> None:
    """Refuse flags that say nothing without another one.

    Args:
        arguments: What was given.
        needed: The other flag, in words.
        **idle: By name of the argument, its default.

    Raises:
        ValueError: One of them was given; the message names it.
    """
    for name, default in idle.items():
        if (value := getattr(arguments, name)) != default:
            said = "is given" if value is True else f"is {_shown(value)}"
            raise ValueError(f"--{name.replace('_', '-')} {said}; it needs {needed}")


def _shown(value: object) -> str:
    if isinstance(value, list | tuple):
        return " ".join(map(_shown, value))
    return f"{value:g}" if isinstance(value, float) else str(value)


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
    """`--law`: those named, or all for some bodies, as `usable_laws.choose_laws` takes them."""
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
