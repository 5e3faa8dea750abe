# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran laws`: list of the laws."""

from __future__ import annotations

import argparse

import pandas as pd

from plastigran import laws
from plastigran.cli.arguments import add_json, print_json
from plastigran.engine.deck import property_name
from plastigran.usable_laws import choose_laws

HELP = "list the laws with shape of the bodies, range, source, constants and options"
EXAMPLE = "plastigran laws universal thornton"


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "law", nargs="*", default=["all"], metavar="LAW", help="names of laws, default all"
    )
    add_json(command)


def flags(name: str) -> str:
    """Return the features of a law in words, such as "hardens, indentation"."""
    law = laws.LAWS[name]
    options = {option["name"] for option in law.options()}
    features = {
        "LIGGGHTS' own": name == "hertz",
        "no yield": not law.yields,
        "hardens": law.hardens,
        "adhesive": law.adhesive,
        "plastic from first touch": not law.elastic_first,
        "indentation": law.indentation,
        "rate dependent": law.rate_dependent,
        "energy guard": "energy_guard" in options,
    }
    return ", ".join(word for word, holds in features.items() if holds)


def constants(name: str) -> dict[str, object]:
    """Return the source, the constants (with their names in decks) and the options of a law."""
    law = laws.LAWS[name]
    parameters = [{**row, "name": property_name(row["name"])} for row in law.parameters()]
    return {"source": law.source, "constants": parameters, "options": law.options()}


def run(arguments: argparse.Namespace) -> None:
    names = sorted(laws.LAWS if "all" in arguments.law else set(choose_laws(arguments.law, "")))
    rows = [
        {
            "law": name,
            "bodies": f"{laws.LAWS[name].shape}s",
            "flags": flags(name),
            "range": laws.LAWS[name].range,
        }
        for name in names
    ]
    if arguments.json:
        print_json([row | constants(row["law"]) for row in rows])
        return
    table = pd.DataFrame(rows)
    for column in table:
        width = max(table[column].str.len().max(), len(column))
        table[column] = table[column].str.ljust(width)
    print(table.to_string(index=False, justify="left"))
    print(
        "\nEvery law needs youngsModulus [Pa] and poissonsRatio [-] of each body. A law with "
        "yield also needs\nyieldStrength [Pa] and yieldPressureFactor [-] (0: Hertz-von "
        "Mises). A law with hardening needs\ntangentModulus [Pa]. Further constants:"
    )
    for name in names:
        law = laws.LAWS[name]
        print(f"\n{name}: {law.source}")
        for row in law.parameters():
            default = "required" if row["default"] is None else f"default {row['default']:g}"
            print(
                f"  {property_name(row['name'])} [{row['unit']}], {default}, "
                f"{row['lower']:g} to {row['upper']:g}: {row['meaning']}"
            )
        for option in law.options():
            choices = "|".join(option["choices"])
            print(f"  {option['name']} {choices}, default {option['default']}: {option['meaning']}")
