# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran reproduce`: the tables and figures of a paper beside what is computed here."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from plastigran.papers import find_paper, paper_names

HELP = "tables and figures of a paper, beside finite elements, laws and LIGGGHTS"


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument("paper", choices=paper_names(), help="a page each in docs/papers")
    command.add_argument("--output", type=Path, metavar="DIR", help="default results/PAPER")
    command.add_argument("--force", action="store_true", help="overwrite results")
    command.add_argument(
        "--docs",
        type=Path,
        metavar="FOLDER",
        help="write tables and pictures into this folder's page of the paper, too; docs/papers is "
        "the project's own",
    )
    command.add_argument(
        "--coarse", action="store_true", help="a quick look: results are off by some per cent"
    )


def run(arguments: argparse.Namespace) -> None:
    # matplotlib is slow to load
    from plastigran.papers.pages import publish, read_page, to_markdown

    paper = find_paper(arguments.paper)
    folder = arguments.output or Path("results") / paper.name
    taken = [name for name in paper.files if (folder / name).exists()]
    if taken and not arguments.force:
        raise ValueError(
            f"{folder} holds results ({taken[0]}); choose another --output, or add --force"
        )
    if arguments.docs:
        if arguments.coarse:
            raise ValueError("--docs takes whole results, not --coarse ones")
        read_page(paper, arguments.docs)
    folder.mkdir(parents=True, exist_ok=True)
    made = paper.reproduce(sys.stderr.isatty(), arguments.coarse)
    print(f"{paper.citation}: {paper.title}")
    for name, table in made.tables.items():
        print(f"\n{name}\n{to_markdown(table)}", end="")
    written = made.write(folder)
    if arguments.docs:
        written += publish(paper, made, written, arguments.docs)
    print("\nwritten: " + "  ".join(str(path) for path in written))
