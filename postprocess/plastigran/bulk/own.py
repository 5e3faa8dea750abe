# SPDX-License-Identifier: GPL-2.0-or-later
"""Input scripts of the user's own, without a class: where they run and what is said of them."""

from __future__ import annotations

import os
from pathlib import Path

import pandas as pd

from plastigran.bulk.checks import DISSIPATED, LEDGER, TAKEN, energy_input, ledger_checks
from plastigran.bulk.deck import Analysis
from plastigran.engine.deck import DeckSource
from plastigran.engine.process import inputs_folder, misread
from plastigran.plot.ledger import ledger_figure

#: Settings by which a deck is told to go on from a restart file.
GOES_ON = ("start", "checkpoint")


def own_places(source: DeckSource, folder: Path) -> dict[str, object]:
    """Values of `inputs` and `output` for a deck that runs in its own folder; None for one that it
    does not read.

    Raises:
        ValueError: The deck reads ${output}, and the engine would misread its value.
    """
    read = source.references | source.settings.keys()
    output: str | None = None
    if "output" in read:
        output = str(folder)
        if misread(output):
            output = os.path.relpath(folder, source.path.parent)
        if misread(output):
            raise ValueError(
                f"results would go to {output!r}; the engine misreads white space, % and * in what "
                f"{source.path.name} reads as ${{output}}: choose another folder"
            )
    return {"inputs": inputs_folder() if "inputs" in read else None, "output": output}


def check_goes_on(source: DeckSource) -> None:
    """Raises ValueError when a deck cannot be told to go on from a restart file."""
    if missing := [name for name in GOES_ON if name not in source.settings]:
        raise ValueError(
            f"{source.path.name} has no setting {missing[0]!r} and cannot go on from a checkpoint; "
            "a deck of `plastigran new-deck` shows how"
        )


def analyse_own(series: pd.DataFrame) -> Analysis:
    """The energy ledger of a run, where its log has the entries of inputs/energy_ledger.in."""
    if not {*TAKEN, "drift"} <= set(series):
        return Analysis(series)
    came_in = energy_input(series)
    if not came_in > 0:
        return Analysis(series, notes=["the ledger was not checked: no energy came in"])
    figure = ledger_figure(series, TAKEN, came_in, LEDGER)
    notes = []
    if not series[["elastic", *DISSIPATED]].any(axis=None):
        notes = ["no line of the log has energy in contacts, or taken by them: did grains meet?"]
    return Analysis(series, ledger_checks(series), {"ledger": figure}, notes=notes)
