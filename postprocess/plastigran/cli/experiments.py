# SPDX-License-Identifier: GPL-2.0-or-later
"""The command of an experiment, made from what the experiment says of itself."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from functools import partial
from typing import Any

import attrs
import numpy as np

from plastigran.cli.arguments import (
    add_jobs,
    add_output,
    known_materials,
    positive,
    positive_integer,
)
from plastigran.declared import Declaration, declaration
from plastigran.experiments.base import Experiment
from plastigran.experiments.fields import Flag


def add_command(subcommands: Any, experiment: type[Experiment]) -> None:
    """Add an experiment's command, with a flag for each setting of its study."""
    command = subcommands.add_parser(experiment.command, help=experiment.help)
    said = declaration(experiment)
    for name, flag in experiment.all_flags().items():
        _add_flag(command, name, flag, flag.said or said[name])
    add_jobs(command)
    add_output(command, f"results/{experiment.command.replace('-', '_')}")
    command.set_defaults(run=partial(run, experiment))


def _add_flag(command: argparse.ArgumentParser, name: str, flag: Flag, said: Declaration) -> None:
    word = flag.name or name.replace("_", "-")
    unit = f", {said.unit}" if said.unit != "-" else ""
    command.add_argument(
        f"--{word}",
        dest=name,
        type=_reader(word, said),
        choices=said.choices or None,
        nargs="+" if flag.many else None,
        required=flag.default is attrs.NOTHING and not flag.span,
        help=f"{said.meaning}{unit}{_usual(flag)}"
        + (f"; {known_materials()}" if name == "material" else ""),
        **({"metavar": word.upper()} if not said.choices else {}),
    )
    if flag.span:
        low, high, count = flag.span
        command.add_argument(
            f"--{word}s",
            nargs=2,
            type=positive,
            default=(low, high),
            metavar=("LOW", "HIGH"),
            help=f"range of them when --{word} is not given, default {low:g} {high:g}",
        )
        command.add_argument(
            "--points", type=positive_integer, default=count, help=f"how many, default {count}"
        )


def _usual(flag: Flag) -> str:
    if (
        flag.span
        or flag.default in (None, attrs.NOTHING)
        or isinstance(flag.default, attrs.Factory)
    ):
        return ""
    several = flag.default if isinstance(flag.default, tuple) else (flag.default,)
    shown = (f"{value:g}" if isinstance(value, float) else str(value) for value in several)
    return f", default {' '.join(shown)}"


def _reader(word: str, said: Declaration) -> Callable[[str], Any]:
    """Reads a flag's value and checks it against what is declared."""

    def read(text: str) -> Any:
        try:
            value = said.kind(text)
        except ValueError:
            kind = {int: "whole number"}.get(said.kind, "number")
            raise argparse.ArgumentTypeError(f"{text!r} is not a {kind}") from None
        if said.kind is not str and not said.allows(value):
            raise argparse.ArgumentTypeError(f"{word} is {text}; it {said.allowed()}")
        return value

    return read


def run(experiment: type[Experiment], arguments: argparse.Namespace) -> None:
    """Run the study, print its summary, write its tables and figures."""
    flags = experiment.all_flags()
    given = {name: getattr(arguments, name) for name in flags}
    for name, flag in flags.items():
        if flag.span and given[name] is None:
            given[name] = np.geomspace(
                *getattr(arguments, f"{flag.name or name}s"), arguments.points
            )
    given = {name: value for name, value in given.items() if value is not None}
    run_study(experiment, arguments.output, arguments.jobs, arguments.force, **given)


def run_study(
    experiment: type[Experiment], folder: Any, jobs: int | None, force: bool, **settings: Any
) -> None:
    """Run a study, print its summary, write its tables and figures into a folder."""
    runs = experiment.study(folder, jobs, force=force, **settings)
    print(runs)
    print("\nwritten: " + "  ".join(str(path) for path in runs.write(folder)))
