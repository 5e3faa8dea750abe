# SPDX-License-Identifier: GPL-2.0-or-later
"""A user's input scripts, without a class: where they run and how they are checked."""

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
    LEDGER,
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

#: Settings with which a deck continues from a restart file.
GOES_ON = ("start", "checkpoint")
#: Requirements of a deck that can continue.
NEEDS = (
    "it needs settings `start` (fresh or checkpoint) and `checkpoint` (a file), and a `restart` "
    f"command that writes ${{output}}/{PATTERN}; `plastigran new-deck` writes a deck with them"
)

#: Commands after which the number of steps cannot be predicted from the script.
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
    """Return the values of `inputs` and `output` that a user's deck reads; None for the others.

    Raises:
        ValueError: The deck reads ${output}, and LIGGGHTS would misread its value.
    """
    read = source.references | source.settings.keys()
    output: str | None = None
    if "output" in read:
        output = str(folder)
        if misread(output):
            output = os.path.relpath(folder, source.path.parent)
        if misread(output):
            raise ValueError(
                f"the folder of results is {output!r}, but {source.path.name} reads it as "
                f"${{output}}, and LIGGGHTS misreads white space, % and * there. Choose "
                "another folder"
            )
    return {"inputs": inputs_folder() if "inputs" in read else None, "output": output}


def check_laws(source: DeckSource) -> None:
    """Refuse a contact model whose name resembles that of a law.

    Raises:
        ValueError: There is such a model.

    Warns:
        UserWarning: The name of a model contains that of a law; it may be the user's own model.
    """
    for file in source.files:
        if file.suffix.lower() in MESHES:
            continue
        for found in _MODEL.finditer("\n".join(commands(file))):
            name = source.resolve(found[1])
            if name in laws.LAWS or not (meant := get_close_matches(name, laws.LAWS, 1, 0.85)):
                continue
            said = f"{file.name}: no contact model {name!r}. Possible misspelling of {meant[0]}"
            if meant[0] not in name:
                raise ValueError(said)
            warnings.warn(f"{said} It is used as it is, in case it is your own", stacklevel=2)


def own_restart_point(source: DeckSource, earlier: Path, record: dict) -> Path:
    """Return the `restart_point` of a run, for a deck that can continue from it.

    Args:
        source: Deck.
        earlier: Folder of the run.
        record: Contents of its `run.json`.

    Raises:
        ValueError: The deck lacks the settings for it.
        EngineError: There is no such point.
    """
    if missing := [name for name in GOES_ON if name not in source.settings]:
        raise ValueError(
            f"{source.path.name} has no setting {missing[0]!r}, so it cannot continue from a "
            f"checkpoint; {NEEDS}"
        )
    log = earlier / LOG
    if log.is_file() and _COUNTS_ANEW.search(log.read_text(errors="replace")):
        raise EngineError(
            f"{log} contains `reset_timestep`, so step numbers do not identify the newest "
            "checkpoint. Choose one yourself: -v start=checkpoint checkpoint=FILE"
        )
    try:
        return restart_point(earlier, record)
    except EngineError as error:
        if checkpoints(earlier):
            raise
        raise EngineError(f"{error}: {NEEDS}") from None


def analyse_own(series: pd.DataFrame) -> Analysis:
    """Check the energy balance of a run whose log has the terms of inputs/energy_ledger.in."""
    if not {*TAKEN, "drift"} <= set(series):
        said = (
            "nothing was checked: the deck keeps no energy balance, or its log has no terms of it"
        )
        return Analysis(series, notes=[said])
    if not energy_input(series) > 0:
        return Analysis(
            series, notes=["the energy balance was not checked, because the energy input is zero"]
        )
    figures, notes, last = {}, [], last_simulation(series)
    if "time" not in series:
        notes.append(
            "the energy balance was not drawn, because the log has no time. Add `time` to "
            "thermo_style"
        )
    elif energy_input(last) > 0:
        figures["ledger"] = ledger_figure(last, LEDGER)
    if len(last) < len(series):
        notes.append(
            "the energy balance restarts at each `clear`. All parts are checked; the "
            "last one is drawn"
        )
    if not series[["elastic", *DISSIPATED]].any(axis=None):
        notes.append(
            "the energy balance was not checked, because no line of the log has stored or "
            "dissipated energy of contacts. Did grains meet?"
        )
        return Analysis(series, [], figures, notes=notes)
    return Analysis(series, _worst_checks(series), figures, notes=notes)


def _worst_checks(series: pd.DataFrame) -> list[Check]:
    """Return the checks of the energy balance, each at its worst; `clear` restarts the balance."""
    ledgers = [series]
    if "simulation" in series:
        ledgers = [ledger for _, ledger in series.groupby("simulation") if energy_input(ledger) > 0]
    found = zip(*map(ledger_checks, ledgers), strict=True)
    return [min(checks, key=lambda check: (check.passed, -check.value)) for checks in found]
