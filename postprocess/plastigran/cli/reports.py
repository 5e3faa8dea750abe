# SPDX-License-Identifier: GPL-2.0-or-later
"""Shared functions of `reproduce` and `validate`, which compute tables and figures for the docs."""

from __future__ import annotations

import argparse
from pathlib import Path

from plastigran.cli.arguments import add_json, print_json
from plastigran.report.base import Evidence, Findings


def add_evidence_arguments(command: argparse.ArgumentParser, results: str, pages: str) -> None:
    """Add the flags --output, --force, --docs, --coarse and --json.

    Args:
        command: Parser of the command.
        results: Default folder of results, as text for the help.
        pages: Folder of the pages in the project, as text for the help.
    """
    command.add_argument(
        "--output", type=Path, metavar="DIR", help=f"folder of results, default {results}"
    )
    command.add_argument("--force", action="store_true", help="overwrite earlier results")
    command.add_argument(
        "--docs",
        type=Path,
        metavar="FOLDER",
        help="also write the tables and pictures into the pages in this folder; the pages of the "
        f"project are in {pages}",
    )
    command.add_argument(
        "--coarse",
        action="store_true",
        help="use coarse meshes and few impacts for a quick look; errors reach several per cent",
    )
    add_json(command)


def run_evidence(evidence: Evidence, head: str, arguments: argparse.Namespace) -> Findings:
    """Compute tables and figures, print and write them, and update the pages that contain them.

    Args:
        evidence: Validation or reproduction of a paper, with its tables and figures.
        head: Text above the printed tables.
        arguments: Parsed arguments of `add_evidence_arguments`.

    Raises:
        ValueError: The folder contains results, the pages of the docs do not match the tables, or
            `Evidence.run` raises it.
        EngineError: LIGGGHTS stopped with an error.
    """
    # Import here, because matplotlib is slow to load.
    from plastigran.report.pages import publish, read_pages, to_markdown

    folder = arguments.output or Path("results") / evidence.name
    taken = [name for name in evidence.files if (folder / name).exists()]
    if taken and not arguments.force:
        raise ValueError(
            f"{folder} contains results ({taken[0]}). Choose another --output, or add --force"
        )
    if arguments.docs:
        if arguments.coarse:
            raise ValueError("--docs needs complete results. Remove --coarse")
        read_pages(evidence, arguments.docs)
    folder.mkdir(parents=True, exist_ok=True)
    findings = evidence.run(True, arguments.coarse)
    if not arguments.json:
        print(head)
        for name in evidence.tables:
            if len(findings.tables[name]):
                print(f"\n{name}\n{to_markdown(findings.tables[name])}", end="")
    written = findings.write(folder)
    if arguments.docs:
        written += publish(evidence, findings, written, arguments.docs)
    places = [str(path) for path in written]
    if arguments.json:
        tables = {name: findings.tables[name].to_dict("records") for name in evidence.tables}
        print_json({"tables": tables, "written": places})
    else:
        print(f"\nwritten: {'  '.join(places)}")
    return findings
