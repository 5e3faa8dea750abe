# SPDX-License-Identifier: GPL-2.0-or-later
"""Subcommands that run experiments. Their flags follow from the fields of the experiments."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import attrs
import numpy as np

from plastigran.cli.arguments import (
    add_dry_run,
    add_jobs,
    add_json,
    add_output,
    add_subcommand,
    known_materials,
    positive,
    positive_integer,
    print_json,
    read_as,
    refuse_json_of_dry_run,
)
from plastigran.declared import Declaration, declarations
from plastigran.engine.folder_lock import lock_folder
from plastigran.engine.process import EngineError
from plastigran.engine.versions import versions
from plastigran.experiments.base import Experiment
from plastigran.experiments.fields import Flag
from plastigran.experiments.runs import Runs, case_folders, claim


def add_command(subparsers: Any, experiment: type[Experiment]) -> None:
    """Add the subcommand of an experiment, with a flag for each setting of the experiment."""
    name, flags, declared = experiment.command, experiment.all_flags(), declarations(experiment)
    required = [_word(setting, flag) for setting, flag in flags.items() if _required(flag)]
    words = [f"plastigran {name}", *(f"--{word} {word.upper()}" for word in required)]
    example = experiment.example or " ".join(words)
    command = add_subcommand(subparsers, name, experiment.help, example)
    for setting, flag in flags.items():
        _add_flag(command, setting, flag, flag.declaration or declared[setting])
    add_jobs(command)
    add_output(command, f"results/{name.replace('-', '_')}")
    add_json(command)
    add_dry_run(command)
    if experiment.has_theory:
        command.add_argument(
            "--theory",
            action="store_true",
            help="compute the impacts from the laws alone, without LIGGGHTS",
        )
    command.set_defaults(run=partial(run, experiment))


def _word(setting: str, flag: Flag) -> str:
    return flag.name or setting.replace("_", "-")


def _required(flag: Flag) -> bool:
    return flag.values() is attrs.NOTHING


def _add_flag(
    command: argparse.ArgumentParser, setting: str, flag: Flag, declaration: Declaration
) -> None:
    word = _word(setting, flag)
    unit = f", {declaration.unit}" if declaration.unit != "-" else ""
    meaning, semicolon, remark = declaration.meaning.partition(";")
    command.add_argument(
        f"--{word}",
        dest=setting,
        type=_reader(word, declaration),
        choices=declaration.choices or None,
        nargs="+" if flag.many else None,
        required=_required(flag),
        help=f"{meaning}{unit}{semicolon}{remark}{_default(flag)}"
        + (f"; {known_materials()}" if setting == "material" else ""),
        **({"metavar": word.upper()} if not declaration.choices else {}),
    )
    if flag.span:
        lowest, highest, count = flag.span
        command.add_argument(
            f"--{word}s",
            nargs=2,
            type=positive,
            metavar=("LOW", "HIGH"),
            help=(
                f"lowest and highest {word} of the sweep if --{word} is not given, default "
                f"{lowest:g} {highest:g}"
            ),
        )
        command.add_argument(
            "--points",
            type=positive_integer,
            help=f"number of values of {word} in the sweep, default {count}",
        )


def _default(flag: Flag) -> str:
    """Return help text about the default of a flag; "" for a sweep or without default."""
    values = flag.default if isinstance(flag.default, tuple) else (flag.default,)
    if flag.span or isinstance(values[0], attrs.Factory) or values[0] in (None, attrs.NOTHING):
        return ""
    shown = (f"{value:g}" if isinstance(value, float) else str(value) for value in values)
    return f", default {' '.join(shown)}"


def _reader(word: str, declaration: Declaration) -> Callable[[str], Any]:
    """Return a function that converts the text of a flag and checks the value by a declaration."""

    def read(text: str) -> Any:
        value = read_as(declaration.value_type, text)
        if declaration.value_type is not str and not declaration.allows(value):
            raise argparse.ArgumentTypeError(f"{word} is {text}; it {declaration.allowed()}")
        return value

    return read


def run(experiment: type[Experiment], arguments: argparse.Namespace) -> None:
    """Run the impacts of an experiment, print a summary, and write tables and figures.

    Raises:
        ValueError: A value is out of range, or two flags exclude each other.
        EngineError: LIGGGHTS is missing or stopped with an error.
    """
    theory, folder = getattr(arguments, "theory", False), arguments.output
    if theory and arguments.jobs:
        raise ValueError(
            f"--jobs is {arguments.jobs}, but --theory does not start LIGGGHTS. Remove --jobs"
        )
    if theory and arguments.dry_run:
        raise ValueError(
            "--dry-run prints command lines of LIGGGHTS, but --theory needs no LIGGGHTS. Remove "
            "one of the two flags"
        )
    refuse_json_of_dry_run(arguments)
    settings = _settings(experiment, arguments)
    if arguments.dry_run:
        cases = experiment.cases(**experiment.study_settings(**settings))
        for case, place in zip(cases, case_folders(cases, folder.resolve()), strict=True):
            print(case.command_line(place))
        print(f"{len(cases)} runs; nothing was started")
    elif theory:
        runs = experiment.theory(**settings)
        with claim(folder, arguments.force):
            show_study(runs, folder, arguments.json)
    else:
        _need_engine(experiment, settings.get("host", experiment.host))
        with lock_folder(folder):  # keep the lock until the figures are written
            runs = experiment.study(folder, arguments.jobs, force=arguments.force, **settings)
            show_study(runs, folder, arguments.json)


def _need_engine(experiment: type[Experiment], host: str) -> None:
    """Check that the host (LIGGGHTS or LAMMPS) can run.

    Raises:
        EngineError: The host cannot run; the message recommends --theory if the experiment has it.
    """
    try:
        versions(host)
    except EngineError as error:
        hint = ". Use --theory to compute without LIGGGHTS" if experiment.has_theory else ""
        raise EngineError(f"{error}{hint}") from None


def _settings(experiment: type[Experiment], arguments: argparse.Namespace) -> dict[str, Any]:
    """Return the settings that the user gave as flags, with the values of a sweep as a list."""
    settings = {}
    for setting, flag in experiment.all_flags().items():
        value = getattr(arguments, setting)
        if flag.span:
            value = _values(_word(setting, flag), flag.span, value, arguments)
        if value is not None:
            settings[setting] = value
    return settings


def _values(
    word: str,
    default_range: tuple[float, float, int],
    values: list[float] | None,
    arguments: argparse.Namespace,
) -> Any:
    """Return the values that the user gave, or a geometric sequence over a range.

    Args:
        word: Name of the quantity, such as "speed". The flag --speed then gives values, the flag
            --speeds gives the ends of a range, and --points gives the number of values.
        default_range: Lowest value, highest value and number of values if no flag is given.
        values: Values of the flag --speed; None if the flag is missing.
        arguments: Parsed arguments.

    Raises:
        ValueError: The user gave both values and a range, or one point for a range with two
            different ends.
    """
    ends, points = getattr(arguments, f"{word}s"), arguments.points
    if values is not None:
        for name, value in ((f"{word}s", ends), ("points", points)):
            if value is not None:
                raise ValueError(
                    f"--{name} defines a range of values, but --{word} gives single values. "
                    "Remove one of the two flags"
                )
        return values
    if points == 1 and ends and ends[0] != ends[1]:
        raise ValueError(
            f"--points is 1, but the range --{word}s {ends[0]:g} {ends[1]:g} has two ends. "
            "Use 2 or more points"
        )
    lowest, highest, count = default_range
    return np.geomspace(*(ends or (lowest, highest)), points or count)


def show_study(runs: Runs, folder: Path, json: bool = False) -> None:
    """Print a summary of the runs, or their table as JSON; write tables and figures to `folder`."""
    written = [str(path) for path in runs.write(folder)]
    if json:
        print_json({"table": runs.table.to_dict("records"), "written": written})
    else:
        print(f"{runs}\n\nwritten: {'  '.join(written)}")
