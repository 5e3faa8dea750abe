# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran new-deck`: write a new deck."""

from __future__ import annotations

import argparse
from pathlib import Path

from plastigran.bulk.template import range_note, write_deck
from plastigran.cli.arguments import add_material, positive

HELP = "write a new deck that runs without changes"
EXAMPLE = "plastigran new-deck plate --law universal --material steel"


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument("name", type=Path, help="folder to create; the deck gets the same name")
    command.add_argument("--law", default="universal", help="law between grains, default universal")
    add_material(command, "pmma")
    command.add_argument(
        "--radius",
        type=positive,
        default=0.003,
        help="radius of the grains, 0.0005 to 0.006 m, default 0.003",
    )


def run(arguments: argparse.Namespace) -> None:
    deck = write_deck(arguments.name, arguments.law, arguments.material, arguments.radius)
    print(f"written: {deck}\nrun it: plastigran bulk {deck}")
    if note := range_note(arguments.law, arguments.material, arguments.radius):
        print(f"note: {note}")
