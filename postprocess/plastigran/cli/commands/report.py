# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran report`: one HTML page about runs of any kind."""

from __future__ import annotations

import argparse
from pathlib import Path

HELP = "write one HTML page of results: charts, checks, grains in 3D; the page needs no network"
EXAMPLE = "plastigran report results/demo --title 'Steel shot'"


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "folders",
        type=Path,
        nargs="+",
        metavar="DIR",
        help="folder of one or several runs, finished or not, for example results/demo",
    )
    command.add_argument(
        "--output",
        type=Path,
        metavar="FILE.html",
        help="file for the page; default: DIR/report.html, or results/report.html for several "
        "folders",
    )
    command.add_argument(
        "--title", default="", help="title of the page, default the names of the folders"
    )
    command.add_argument(
        "--force", action="store_true", help="overwrite a file that is not a report"
    )


def run(arguments: argparse.Namespace) -> None:
    from plastigran.report.page import write_report  # import here, because plotly is slow to load

    folders = arguments.folders
    default = folders[0] if len(folders) == 1 else Path("results")
    page = arguments.output or default / "report.html"
    write_report(folders, page, arguments.title, arguments.force)
    print(f"written: {page}")
