# SPDX-License-Identifier: GPL-2.0-or-later
"""Command of an experiment, made from the declarations of the experiment."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import attrs
import numpy as np

from plastigran.cli.arguments import (
    Subparsers,
    add_dry_run,
    add_jobs,
    add_json,
    add_output,
    known_materials,
    positive,
    positive_integer,
    print_json,
)
from plastigran.declared import Declaration, declarations
from plastigran.engine.folder_lock import lock_folder
from plastigran.engine.process import EngineError, engine_path
from plastigran.experiments.base import Experiment
from plastigran.experiments.fields import Flag
from plastigran.experiments.runs import Runs, case_folders, claim


def add_command(subcommands: Subparsers, experiment: type[Experiment]) -> None:
    """Add the command of an experiment, with a flag for each setting of its study."""
    needed = [_word(name, flag) for name, flag in experiment.all_flags().items() if _needed(flag)]
    words = [f"plastigran {experiment.command}", *(f"--{word} {word.upper()}" for word in needed)]
    example = experiment.example or " ".join(words)
    command = subcommands.add(experiment.command, experiment.help, example)
    said = declarations(experiment)
    for name, flag in experiment.all_flags().items():
        _add_flag(command, name, flag, flag.declaration or said[name])
    add_jobs(command)
    add_output(command, f"results/{experiment.command.replace('-', '_')}")
    add_json(command)
    add_dry_run(command)
    if experiment.has_theory:
        command.add_argument(
            "--theory", action="store_true", help="use theory alone, without LIGGGHTS"
        )
    command.set_defaults(run=partial(run, experiment))


def _word(name: str, flag: Flag) -> str:
    return flag.name or name.replace("_", "-")


def _needed(flag: Flag) -> bool:
    return flag.default is attrs.NOTHING and not flag.span


def _add_flag(command: argparse.ArgumentParser, name: str, flag: Flag, said: Declaration) -> None:
    word = _word(name, flag)
    unit = f", {said.unit}" if said.unit != "-" else ""
    command.add_argument(
        f"--{word}",
        dest=name,
        type=_reader(word, said),
        choices=said.choices or None,
        nargs="+" if flag.many else None,
        required=_needed(flag),
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
            metavar=("LOW", "HIGH"),
            help=(
                f"lowest and highest {word} of the sweep if --{word} is not given, default "
                f"{low:g} {high:g}"
            ),
        )
        command.add_argument(
            "--points",
            type=positive_integer,
            help=f"number of values in the sweep, default {count}",
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
    """Return a function that reads the value of a flag and checks it against its declaration."""

    def read(text: str) -> Any:
        try:
            value = said.value_type(text)
        except ValueError:
            kind = {int: "whole number"}.get(said.value_type, "number")
            raise argparse.ArgumentTypeError(f"{text!r} is not a {kind}") from None
        if said.value_type is not str and not said.allows(value):
            raise argparse.ArgumentTypeError(f"{word} is {text}; it {said.allowed()}")
        return value

    return read


def run(experiment: type[Experiment], arguments: argparse.Namespace) -> None:
    """Run the study, print its summary, write its tables and figures.

    Raises:
        ValueError: A value is out of range, a range is given together with values, or --jobs is
            given with --theory.
    """
    theory = getattr(arguments, "theory", False)
    if theory and arguments.jobs:
        raise ValueError(f"--jobs is {arguments.jobs}, but --theory starts no LIGGGHTS process")
    if theory and arguments.dry_run:
        raise ValueError("--dry-run prints the input of LIGGGHTS, but --theory starts none")
    if arguments.json and arguments.dry_run:
        raise ValueError(
            "--json cannot be used with --dry-run, which produces no results. Remove one of them"
        )
    flags = experiment.all_flags()
    given = {name: getattr(arguments, name) for name in flags}
    for name, flag in flags.items():
        if flag.span:
            given[name] = _spanned(flag.name or name, flag, given[name], arguments)
    given = {name: value for name, value in given.items() if value is not None}
    if arguments.dry_run:
        plan_study(experiment, arguments.output, **given)
        return
    if theory:
        runs = experiment.theory(**given)
        with claim(arguments.output, arguments.force):
            show_study(runs, arguments.output, arguments.json)
    else:
        _need_engine(experiment)
        with lock_folder(arguments.output):  # keep the lock until the figures are written
            runs = experiment.study(
                arguments.output, arguments.jobs, force=arguments.force, **given
            )
            show_study(runs, arguments.output, arguments.json)


def _need_engine(experiment: type[Experiment]) -> None:
    """Check that LIGGGHTS can run.

    Raises:
        EngineError: It cannot; the message names an alternative if there is one.
    """
    try:
        engine_path()
    except EngineError as error:
        way = ". Use --theory to compute without LIGGGHTS" if experiment.has_theory else ""
        raise EngineError(f"{error}{way}") from None


def _spanned(
    word: str, flag: Flag, given: list[float] | None, arguments: argparse.Namespace
) -> Any:
    """Return the values of a flag that may be given as a range."""
    ends, points = getattr(arguments, f"{word}s"), arguments.points
    if given is not None:
        for name, value in ((f"{word}s", ends), ("points", points)):
            if value is not None:
                raise ValueError(
                    f"--{name} belongs to a range, but --{word} gives the values. "
                    "Remove one of them"
                )
        return given
    low, high, count = flag.span
    if points == 1 and ends and ends[0] != ends[1]:
        raise ValueError(
            f"--points is 1, but the range --{word}s {ends[0]:g} {ends[1]:g} has two ends"
        )
    return np.geomspace(*(ends or (low, high)), points or count)


def plan_study(experiment: type[Experiment], folder: Path, **settings: Any) -> None:
    """Print the command line of every case and its folder; start nothing."""
    cases = experiment.cases(**experiment.study_settings(**settings))
    for case, place in zip(cases, case_folders(cases, folder.resolve()), strict=True):
        print(case.command_line(place))
    print(f"{len(cases)} runs; nothing was started")


def run_study(
    experiment: type[Experiment], folder: Path, jobs: int | None, force: bool, **settings: Any
) -> None:
    """Run a study, print its summary, write its tables and figures into a folder."""
    with lock_folder(folder):
        show_study(experiment.study(folder, jobs, force=force, **settings), folder)


def show_study(runs: Runs, folder: Path, json: bool = False) -> None:
    """Print a study's summary, or its table as JSON; write its tables and figures into a folder."""
    written = [str(path) for path in runs.write(folder)]
    if json:
        print_json({"table": runs.table.to_dict("records"), "written": written})
    else:
        print(f"{runs}\n\nwritten: {'  '.join(written)}")
