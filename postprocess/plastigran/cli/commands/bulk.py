# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran bulk`: run a deck of many grains, check it and draw its figures."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from plastigran.cli.arguments import (
    add_dry_run,
    add_json,
    positive_integer,
    print_json,
    refuse_json_of_dry_run,
)
from plastigran.engine.checkpoints import newest_checkpoint
from plastigran.engine.deck import deck_name, deck_names
from plastigran.engine.log import find_warnings, log_path
from plastigran.engine.process import EngineError, EngineStopped
from plastigran.engine.versions import HOSTS

if TYPE_CHECKING:
    from plastigran.bulk.outcome import BulkRun

HELP = "run a bulk deck, check it and draw its figures"
EXAMPLE = """
plastigran bulk hopper --ranks 2 -v law=kogut_etsion frames=10 --output results/hopper
plastigran bulk hopper --restart results/hopper
"""


def setting(text: str) -> tuple[str, str]:
    name, equals, value = text.partition("=")
    if not name.isidentifier() or not equals:
        raise argparse.ArgumentTypeError(f"{text!r} is not name=value")
    return name, value


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "deck",
        help=f"path of an input script, or name of a deck: {', '.join(deck_names())}",
    )
    command.add_argument(
        "--ranks", type=positive_integer, default=1, help="number of MPI ranks, default 1"
    )
    command.add_argument(
        "--host",
        choices=list(HOSTS),
        help="program that runs the deck, default liggghts; with --restart DIR, the program that "
        "wrote DIR",
    )
    command.add_argument(
        "-v",
        "--variable",
        dest="settings",
        type=setting,
        nargs="+",
        action="extend",
        default=[],
        metavar="name=value",
        help="values of deck settings, which are variables of the input script",
    )
    command.add_argument(
        "--restart",
        type=Path,
        metavar="DIR",
        help="continue the run in DIR from its newest complete checkpoint",
    )
    command.add_argument(
        "--output",
        type=Path,
        help="folder of results, default results/DECK, or DIR_continued with --restart DIR",
    )
    command.add_argument("--force", action="store_true", help="overwrite earlier results")
    add_json(command)
    add_dry_run(command)


def run(arguments: argparse.Namespace) -> None:
    from plastigran.bulk.plan import plan_bulk  # import here, because matplotlib is slow to load
    from plastigran.bulk.run import run_bulk

    deck, settings, earlier = arguments.deck, dict(arguments.settings), arguments.restart
    if arguments.output is None and earlier:
        arguments.output = earlier.with_name(f"{earlier.name}_continued")
    elif arguments.output is None:
        arguments.output = Path("results") / deck_name(deck)
    case = (deck, settings, arguments.output, arguments.ranks, earlier)
    host = arguments.host
    refuse_json_of_dry_run(arguments)
    if arguments.dry_run:
        plan = plan_bulk(*case, host)
        print(plan.command_line())
        if plan.writes_inputs:
            print(f"the deck reads initial positions, which `bulk` writes to {plan.folder} first")
        print(f"results would be written to {plan.folder}; nothing was started")
        return
    try:
        bulk_run = run_bulk(*case, arguments.force, host=host)
    except KeyboardInterrupt:
        raise KeyboardInterrupt(how_to_continue(arguments.output)) from None
    except EngineStopped as error:
        raise EngineError(f"{error}; {how_to_continue(arguments.output)}") from None
    if arguments.json:
        print_json(
            {
                "checks": bulk_run.checks.to_dict("records"),
                "notes": bulk_run.notes,
                "results": bulk_run.results,
                "warnings": warnings_of(bulk_run),
                "written": str(arguments.output),
            }
        )
        bulk_run.raise_if_failed()
        return
    if earlier and has_no_new_step(bulk_run):
        advice = ". For a longer run, set a later end, for example -v duration=0.6"
        print(
            f"the run in {earlier} has reached its end, so there was nothing to "
            f"compute{advice if bulk_run.deck is None else ''}"
        )
    report(bulk_run)
    print(f"written: {arguments.output}")


def how_to_continue(folder: Path) -> str:
    try:
        newest_checkpoint(folder)
    except EngineError:
        return f"{folder} has no checkpoint to continue from"
    return f"to continue from the newest checkpoint, use --restart {folder}"


def has_no_new_step(run: BulkRun) -> bool:
    """Return whether a continued run has written no thermodynamic output beyond the earlier run."""
    import pandas as pd  # import here, because pandas is slow to load

    from plastigran.bulk.folder import BEFORE
    from plastigran.bulk.series import read_series

    return len(pd.read_csv(run.folder / BEFORE)) == len(read_series(run.folder))


def report(run: BulkRun) -> None:
    """Print results, checks and notes of a run, and the warnings in its log.

    Raises:
        CheckError: A check failed.
    """
    for name, value in run.results.items():
        print(f"{name}: {value:.4g}")
    for check in run.checks.itertuples():
        verdict = "ok" if check.passed else "NO"
        value = f"{check.value:.3g}, at most {check.limit:.3g}"
        print(f"{verdict}  {check.name}: {value} ({check.reason})")
    for note in run.notes:
        print(f"--  {note}")
    for warning in warnings_of(run):
        print(f"warning in the log: {warning}")
    run.raise_if_failed()


def warnings_of(run: BulkRun) -> list[str]:
    """Return the warnings in the log of a run."""
    return find_warnings(log_path(run.folder).read_text(errors="replace"))
