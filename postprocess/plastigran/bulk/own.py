# SPDX-License-Identifier: GPL-2.0-or-later
"""Input scripts of users: their paths, restart and checks. These decks have no `BulkDeck` class."""

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
    ENERGIES,
    LEDGER,
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
from plastigran.engine.log import log_path
from plastigran.engine.process import EngineError, inputs_folder, misread

#: Settings that a deck needs in order to continue from a restart file.
CONTINUE_SETTINGS = ("start", "checkpoint")
#: Text for error messages: requirements of a deck that can continue.
CONTINUE_HINT = (
    "the deck needs settings `start` (fresh or checkpoint) and `checkpoint` (a file), and a "
    "`restart` "
    f"command that writes ${{output}}/{PATTERN}; `plastigran new-deck` writes a deck with them"
)
#: Commands after which the number of steps cannot be predicted from the script.
CONTROL = {"if", "jump", "next", "label", "reset_timestep", "read_restart"}

#: Notes for the user about checks and figures that are omitted.
NO_TERMS = (
    "no checks were made: the deck has no energy balance, or the log lacks the energy terms that "
    "inputs/energy_ledger.in defines"
)
NO_INPUT = "the energy balance was not checked, because the energy input is zero"
NO_TIME = (
    "the energy balance was not drawn, because the log has no time. Add `time` to thermo_style"
)
SEVERAL_PARTS = (
    "the energy balance restarts at each `clear`. It was checked for every simulation between "
    "`clear` commands, and drawn for the last simulation"
)
NO_CONTACTS = (
    "the energy balance was not checked, because the stored and dissipated energies of contacts "
    "are zero in every line of the log. Check whether grains touched"
)

_RESET_TIMESTEP = re.compile(r"^reset_timestep\s", re.MULTILINE)
_MODEL = re.compile(r"\bgran\s+(?:&\s*)?model\s+(\S+)")


def planned_steps(source: DeckSource) -> int:
    """Return the total number of steps of all `run` commands of a user's deck.

    Return 0 if the number cannot be determined from the script.
    """
    for file in _scripts(source)[1:]:
        names = {source.resolve(command).partition(" ")[0] for command in commands(file)}
        if names & {"run", *CONTROL}:
            return 0
    steps = 0
    for command in commands(source.path):
        name, *arguments = source.resolve(command).split() or [""]
        if name in CONTROL or (name == "include" and "$" in " ".join(arguments)):
            return 0
        if name == "run":
            if not arguments or not arguments[0].isdigit():
                return 0
            steps = int(arguments[0]) + (0 if "upto" in arguments else steps)
    return steps


def _scripts(source: DeckSource) -> list[Path]:
    """Return the paths of a deck's script and its includes."""
    return [file for file in source.files if file.suffix.lower() not in MESHES]


def own_places(source: DeckSource, folder: Path) -> dict[str, object]:
    """Return the values of the variables `inputs` and `output`; None if the deck has none.

    Raises:
        ValueError: The deck reads ${output}, and its value has characters that LIGGGHTS misreads.
    """
    variables = source.references | source.settings.keys()
    inputs = inputs_folder() if "inputs" in variables else None
    if "output" not in variables:
        return {"inputs": inputs, "output": None}
    output = str(folder)
    if misread(output):
        output = os.path.relpath(folder, source.path.parent)
    if misread(output):
        raise ValueError(
            f"the folder of results is {output!r}; it must not contain white space, % or *, which "
            f"LIGGGHTS misreads in ${{output}} of {source.path.name}. Choose another folder"
        )
    return {"inputs": inputs, "output": output}


def check_laws(source: DeckSource) -> None:
    """Reject a contact model whose name is probably a misspelled law.

    Raises:
        ValueError: The name of a contact model is probably a misspelled law.

    Warns:
        UserWarning: The name of a model contains the name of a law, but may be the user's own
            model.
    """
    for file in _scripts(source):
        for model in _MODEL.finditer("\n".join(commands(file))):
            name = source.resolve(model[1])
            similar = get_close_matches(name, laws.LAWS, 1, 0.85)
            if name in laws.LAWS or not similar:
                continue
            text = f"{file.name}: contact model {name!r} is unknown. Use {similar[0]}"
            if similar[0] not in name:
                raise ValueError(text)
            warnings.warn(f"{text}. Ignore this warning if the model is your own", stacklevel=2)


def own_restart_point(source: DeckSource, earlier: Path, record: dict) -> Path:
    """Return the checkpoint from which a run of a user's deck can continue.

    Args:
        source: The user's deck.
        earlier: Folder of the run to continue.
        record: Contents of `run.json` in this folder.

    Raises:
        ValueError: The deck lacks the settings to continue.
        EngineError: There is no complete checkpoint, or the log contains `reset_timestep`.
    """
    if missing := [name for name in CONTINUE_SETTINGS if name not in source.settings]:
        raise ValueError(
            f"{source.path.name} has no setting {missing[0]!r}, so it cannot continue from a "
            f"checkpoint; {CONTINUE_HINT}"
        )
    log = log_path(earlier)
    if log.is_file() and _RESET_TIMESTEP.search(log.read_text(errors="replace")):
        raise EngineError(
            f"{log} contains `reset_timestep`, so step numbers do not identify the newest "
            "checkpoint. Choose one yourself: -v start=checkpoint checkpoint=FILE"
        )
    try:
        return restart_point(earlier, record)
    except EngineError as error:
        if checkpoints(earlier):
            raise
        raise EngineError(f"{error}: {CONTINUE_HINT}") from None


def analyse_own(series: pd.DataFrame) -> Analysis:
    """Check the energy balance of a run whose log has the terms of inputs/energy_ledger.in."""
    if not {*ENERGIES, "drift"} <= set(series):
        return Analysis(series, notes=[NO_TERMS])
    if not energy_input(series) > 0:
        return Analysis(series, notes=[NO_INPUT])
    figures, notes, last = {}, [], last_simulation(series)
    if "time" not in series:
        notes.append(NO_TIME)
    elif energy_input(last) > 0:
        figures["ledger"] = ledger_figure(last, LEDGER)
    if len(last) < len(series):
        notes.append(SEVERAL_PARTS)
    if series[["elastic", *DISSIPATED]].any(axis=None):
        return Analysis(series, _worst_checks(series), figures, notes)
    return Analysis(series, [], figures, [*notes, NO_CONTACTS])


def _worst_checks(series: pd.DataFrame) -> list[Check]:
    """Return the worst result of each energy check in all simulations between `clear` commands."""
    parts = [series]
    if "simulation" in series:
        parts = [part for _, part in series.groupby("simulation") if energy_input(part) > 0]
    return [
        min(checks, key=lambda check: (check.passed, -check.value))
        for checks in zip(*map(ledger_checks, parts), strict=True)
    ]
