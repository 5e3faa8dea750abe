# SPDX-License-Identifier: GPL-2.0-or-later
"""Functions that add or read command-line arguments that several subcommands share."""

from __future__ import annotations

import argparse
import json
from math import inf, isfinite
from pathlib import Path
from typing import Any

from plastigran import materials


def add_subcommand(
    subparsers: Any, name: str, purpose: str, example: str = ""
) -> argparse.ArgumentParser:
    """Add a subcommand that has the flag --verbose and an example in its help.

    Args:
        subparsers: Result of `ArgumentParser.add_subparsers`.
        name: Name of the subcommand.
        purpose: Purpose in one line.
        example: One or several command lines.
    """
    lines = "".join(f"\n  {line}" for line in example.strip().splitlines())
    command = subparsers.add_parser(
        name,
        help=purpose,
        description=f"{purpose[0].upper()}{purpose[1:]}.",
        epilog=f"example:{lines}" if lines else None,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add_verbose(command)
    return command


def add_verbose(command: argparse.ArgumentParser, default: Any = argparse.SUPPRESS) -> None:
    """Add --verbose, with the short form -v except for `bulk`, where -v sets a deck variable."""
    short = () if command.prog.endswith(" bulk") else ("-v",)
    command.add_argument(
        *short,
        "--verbose",
        action="store_true",
        default=default,
        help="print the Python traceback of an error",
    )


def add_json(command: argparse.ArgumentParser) -> None:
    """Add --json, which prints JSON instead of tables."""
    command.add_argument("--json", action="store_true", help="print all numbers as JSON")


def add_dry_run(command: argparse.ArgumentParser) -> None:
    """Add --dry-run, for commands that start LIGGGHTS."""
    command.add_argument(
        "--dry-run",
        action="store_true",
        help="print command lines and folders, but start no simulation",
    )


def refuse_json_of_dry_run(arguments: argparse.Namespace) -> None:
    """Reject --json together with --dry-run.

    Raises:
        ValueError: Both flags are given.
    """
    if arguments.json and arguments.dry_run:
        raise ValueError(
            "--json cannot be used with --dry-run, which produces no results. Remove one of them"
        )


def print_json(numbers: Any) -> None:
    """Print numbers as JSON, with null for unknown and infinite values."""

    def finite(value: object) -> object:
        if isinstance(value, dict):
            return {name: finite(entry) for name, entry in value.items()}
        if isinstance(value, list | tuple):
            return [finite(entry) for entry in value]
        return None if isinstance(value, float) and not isfinite(value) else value

    print(json.dumps(finite(numbers), allow_nan=False, default=lambda value: value.item()))


def refuse_idle(arguments: argparse.Namespace, needed: str, **idle: object) -> None:
    """Reject flags that have no effect without another flag.

    Args:
        arguments: Parsed arguments.
        needed: Name of the other flag; the error message contains this name.
        **idle: Default values of the flags to check, by the names of their parsed arguments.

    Raises:
        ValueError: A flag without effect is given; the message names it.
    """
    for name, default in idle.items():
        if (value := getattr(arguments, name)) != default:
            given = "is given" if value is True else f"is {_shown(value)}"
            raise ValueError(
                f"--{name.replace('_', '-')} {given}, but has no effect without "
                f"{needed}. Add {needed}, or remove the flag"
            )


def _shown(value: object) -> str:
    if isinstance(value, list | tuple):
        return " ".join(map(_shown, value))
    return f"{value:g}" if isinstance(value, float) else str(value)


def read_as(value_type: type, text: str) -> Any:
    """Convert the text of an argument to a value of a type.

    Raises:
        ArgumentTypeError: The text is not a value of this type; argparse prints the message.
    """
    try:
        return value_type(text)
    except ValueError:
        name = "whole number" if value_type is int else "number"
        raise argparse.ArgumentTypeError(f"{text!r} is not a {name}") from None


def positive(text: str) -> float:
    """Convert the text of an argument to a positive, finite number; errors as for `read_as`."""
    value = read_as(float, text)
    if not 0 < value < inf:
        raise argparse.ArgumentTypeError(f"{text} is not allowed; use a positive, finite number")
    return value


def positive_integer(text: str) -> int:
    """Convert the text of an argument to a whole number of at least 1; errors as for `read_as`."""
    value = read_as(int, text)
    if value < 1:
        raise argparse.ArgumentTypeError(f"{text} is not allowed; use 1 or more")
    return value


def known_materials() -> str:
    """Return help text that lists the allowed values of a material argument."""
    return f"a material file NAME.in, or one of the names {', '.join(materials.names())}"


def add_laws(command: argparse.ArgumentParser, bodies: str) -> None:
    """Add `--law`. By default, it selects all laws for `bodies`, such as "spheres"."""
    command.add_argument(
        "--law",
        nargs="+",
        default=["all"],
        metavar="LAW",
        help=f"names of laws; default: all laws for {bodies} whose constants the material defines",
    )


def add_material(command: argparse.ArgumentParser, default: str | None = None) -> None:
    """Add `--material`; the flag is required if there is no default."""
    shown = f", default {default}" if default else ""
    command.add_argument(
        "--material",
        default=default,
        required=not default,
        help=f"material{shown}; {known_materials()}",
    )


def add_jobs(command: argparse.ArgumentParser) -> None:
    """Add `--jobs`, the number of LIGGGHTS processes that run at a time."""
    command.add_argument(
        "--jobs",
        type=positive_integer,
        help="number of LIGGGHTS processes that run at the same time, default number of cores",
    )


def add_output(command: argparse.ArgumentParser, default: str) -> None:
    """Add `--output`, the folder of results, and `--force`, which overwrites earlier results."""
    command.add_argument(
        "--output", type=Path, default=Path(default), help=f"folder of results, default {default}"
    )
    command.add_argument("--force", action="store_true", help="overwrite earlier results")
