# SPDX-License-Identifier: GPL-2.0-or-later
"""What the subcommands that make reports share."""

from __future__ import annotations

import argparse
from pathlib import Path

from plastigran.cli.arguments import add_json, print_json
from plastigran.report.base import Findings, Report


def add_report_arguments(command: argparse.ArgumentParser, results: str, pages: str) -> None:
    """Where results go, and the pages.

    Args:
        command: Takes the arguments.
        results: The default folder of results, in words.
        pages: The project's own folder of pages.
    """
    command.add_argument("--output", type=Path, metavar="DIR", help=f"default {results}")
    command.add_argument("--force", action="store_true", help="overwrite results")
    command.add_argument(
        "--docs",
        type=Path,
        metavar="FOLDER",
        help=f"write tables and pictures into this folder's pages, too; {pages} is the project's "
        "own",
    )
    command.add_argument(
        "--coarse", action="store_true", help="a quick look: results are off by some per cent"
    )
    add_json(command)


def run_report(report: Report, head: str, arguments: argparse.Namespace) -> Findings:
    """Make a report: print its tables, write them and its figures, and its pages if asked to.

    Args:
        report: Which.
        head: Printed above the tables.
        arguments: Those of `add_report_arguments`.

    Raises:
        ValueError: Results are there, the pages cannot take the tables, or as for `Report.run`.
        EngineError: The engine stopped with an error.
    """
    # matplotlib is slow to load
    from plastigran.report.pages import publish, read_pages, to_markdown

    folder = arguments.output or Path("results") / report.name
    taken = [name for name in report.files if (folder / name).exists()]
    if taken and not arguments.force:
        raise ValueError(
            f"{folder} holds results ({taken[0]}); choose another --output, or add --force"
        )
    if arguments.docs:
        if arguments.coarse:
            raise ValueError("--docs takes whole results, not --coarse ones")
        read_pages(report, arguments.docs)
    folder.mkdir(parents=True, exist_ok=True)
    made = report.run(True, arguments.coarse)
    if not arguments.json:
        print(head)
        for name in report.tables:
            print(f"\n{name}\n{to_markdown(made.tables[name])}", end="")
    written = made.write(folder)
    if arguments.docs:
        written += publish(report, made, written, arguments.docs)
    places = [str(path) for path in written]
    if arguments.json:
        tables = {name: made.tables[name].to_dict("records") for name in report.tables}
        print_json({"tables": tables, "written": places})
    else:
        print(f"\nwritten: {'  '.join(places)}")
    return made
