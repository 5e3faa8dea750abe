# SPDX-License-Identifier: GPL-2.0-or-later
"""Input scripts of the user's own, without a class: where they run and what is said of them."""

from __future__ import annotations

import os
import re
import warnings
from difflib import get_close_matches
from pathlib import Path

import pandas as pd

from plastigran import laws
from plastigran.bulk.checks import (
    DISSIPATED,
    TAKEN,
    Check,
    energy_input,
    last_simulation,
    ledger_checks,
)
from plastigran.bulk.deck import Analysis
from plastigran.bulk.folder import restart_point
from plastigran.bulk.ledger_chart import ledger_figure
from plastigran.engine.checkpoints import PATTERN, checkpoints
from plastigran.engine.deck import MESHES, DeckSource, commands
from plastigran.engine.log import LOG
from plastigran.engine.process import EngineError, inputs_folder, misread

#: Settings by which a deck is told to go on from a restart file.
GOES_ON = ("start", "checkpoint")
#: What a deck that goes on has.
NEEDS = (
    "it needs settings `start` (fresh or checkpoint) and `checkpoint` (a file), and a `restart` "
    f"command that writes ${{output}}/{PATTERN}; `plastigran new-deck` writes a deck with them"
)

#: Commands behind which the steps to come cannot be counted here.
CONTROL = {"if", "jump", "next", "label", "reset_timestep", "read_restart"}

_COUNTS_ANEW = re.compile(r"^reset_timestep\s", re.MULTILINE)
_MODEL = re.compile(r"\bgran\s+(?:&\s*)?model\s+(\S+)")


def planned_steps(source: DeckSource) -> int:
    """Return the steps of all `run` commands of a deck together; 0 where only LIGGGHTS can tell."""
    included = [file for file in source.files[1:] if file.suffix.lower() not in MESHES]
    if any(_first_words(source, file) & {"run", *CONTROL} for file in included):
        return 0
    steps = 0
    for command in commands(source.path):
        words = source.resolve(command).split()
        if words[:1] == ["include"] and "$" in words[-1]:
            return 0
        if words and words[0] in CONTROL:
            return 0
        if words[:1] == ["run"]:
            if not words[1:] or not words[1].isdigit():
                return 0
            steps = int(words[1]) + (0 if "upto" in words else steps)
    return steps


def _first_words(source: DeckSource, file: Path) -> set[str]:
    return {source.resolve(command).partition(" ")[0] for command in commands(file)}


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


def check_laws(source: DeckSource) -> None:
    """Refuse a contact model whose name is almost a law's.

    Raises:
        ValueError: There is one.

    Warns:
        UserWarning: There is one that a law's name is part of: a model of the user's own, perhaps.
    """
    for file in source.files:
        if file.suffix.lower() in MESHES:
            continue
        for found in _MODEL.finditer("\n".join(commands(file))):
            name = source.resolve(found[1])
            if name in laws.LAWS or not (meant := get_close_matches(name, laws.LAWS, 1, 0.85)):
                continue
            said = f"{file.name}: no contact model {name!r}; is it {meant[0]}?"
            if meant[0] not in name:
                raise ValueError(said)
            warnings.warn(f"{said} A model of your own is taken as it is", stacklevel=2)


def own_restart_point(source: DeckSource, earlier: Path, record: dict) -> Path:
    """The `restart_point` of a run, for a deck that can be told to go on from it.

    Args:
        source: The deck.
        earlier: Folder of the run.
        record: What its `run.json` says.

    Raises:
        ValueError: The deck has no settings to be told by.
        EngineError: There is no such point.
    """
    if missing := [name for name in GOES_ON if name not in source.settings]:
        raise ValueError(
            f"{source.path.name} has no setting {missing[0]!r} and cannot go on from a checkpoint; "
            f"{NEEDS}"
        )
    log = earlier / LOG
    if log.is_file() and _COUNTS_ANEW.search(log.read_text(errors="replace")):
        raise EngineError(
            f"{log} counts its steps anew (reset_timestep): which checkpoint is the newest cannot "
            "be told; run the deck with -v start=checkpoint checkpoint=FILE"
        )
    try:
        return restart_point(earlier, record)
    except EngineError as error:
        if checkpoints(earlier):
            raise
        raise EngineError(f"{error}: {NEEDS}") from None


def analyse_own(series: pd.DataFrame) -> Analysis:
    """The energy ledger of a run, where its log has the entries of inputs/energy_ledger.in."""
    if not {*TAKEN, "drift"} <= set(series):
        said = (
            "nothing was checked: the deck keeps no energy balance, or its log has no terms of it"
        )
        return Analysis(series, notes=[said])
    if not energy_input(series) > 0:
        return Analysis(series, notes=["the ledger was not checked: no energy came in"])
    figures, notes, last = {}, [], last_simulation(series)
    if "time" not in series:
        notes.append(
            "the ledger was not drawn: the log has no time; `time` in thermo_style gives it"
        )
    elif energy_input(last) > 0:
        figures["ledger"] = ledger_figure(last)
    if len(last) < len(series):
        notes.append("the ledger begins anew at each `clear`: all are checked, the last is drawn")
    if not series[["elastic", *DISSIPATED]].any(axis=None):
        notes.append(
            "the energy balance was not checked: no line of the log has energy in contacts, or "
            "taken by them. Did grains meet?"
        )
        return Analysis(series, [], figures, notes=notes)
    return Analysis(series, _worst_checks(series), figures, notes=notes)


def _worst_checks(series: pd.DataFrame) -> list[Check]:
    """Checks of the energy ledger, which `clear` begins anew: each where it is worst."""
    ledgers = [series]
    if "simulation" in series:
        ledgers = [ledger for _, ledger in series.groupby("simulation") if energy_input(ledger) > 0]
    found = zip(*map(ledger_checks, ledgers), strict=True)
    return [min(checks, key=lambda check: (check.passed, -check.value)) for checks in found]
