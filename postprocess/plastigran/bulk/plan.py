# SPDX-License-Identifier: GPL-2.0-or-later
"""Plan of a run of a bulk deck, checked before anything is written or started."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import attrs

from plastigran.bulk.deck import BulkDeck
from plastigran.bulk.decks import deck_class
from plastigran.bulk.folder import read_record, restart_point
from plastigran.bulk.in_lammps import refuse_settings, takes_host
from plastigran.bulk.own import check_laws, own_places, own_restart_point
from plastigran.engine.checkpoints import refuse_damaged
from plastigran.engine.deck import (
    DeckSource,
    deck_name,
    deck_names,
    find_deck,
    is_supplied,
    read_deck,
)
from plastigran.engine.process import typed_command
from plastigran.engine.versions import HOSTS

#: Settings for the start (new or from a checkpoint) and for paths. A continued run may change them.
PLACES = frozenset({"start", "checkpoint", "inputs", "output", "materials"})


@attrs.frozen
class Plan:
    """A checked bulk run, ready to start.

    Attributes:
        source: Deck and the files that it includes.
        deck_type: Class of the deck; None for a user's input script.
        folder: Folder of the results.
        ranks: Number of MPI ranks.
        values: New values of settings of the deck, by name.
        places: Settings whose values are paths of files or folders.
        earlier: Folder of the run to continue, or None.
        checkpoint: Restart file from which the run continues, or None.
        host: Name of the program that runs the deck.
    """

    source: DeckSource
    deck_type: type[BulkDeck] | None
    folder: Path
    ranks: int
    values: dict[str, str]
    places: dict[str, Path]
    earlier: Path | None
    checkpoint: Path | None
    host: str

    @property
    def working_folder(self) -> Path:
        """Folder in which the host runs; relative paths of the deck start there."""
        return self.folder if self.deck_type else self.source.path.parent

    @property
    def writes_inputs(self) -> bool:
        """Whether `run_bulk` writes initial positions to `folder` before it starts the host."""
        if self.deck_type is None or self.checkpoint:
            return False
        return self.deck_type.write_inputs is not BulkDeck.write_inputs

    def command_line(self) -> str:
        """Return the command line that runs the original deck; `run_bulk` runs a copy of it."""
        settings = self.values if self.deck_type else self.values | self.places
        return typed_command(
            self.source.path,
            settings,
            self.folder,
            self.working_folder,
            self.ranks,
            HOSTS[self.host],
        )


def plan_bulk(
    deck: str | Path,
    values: Mapping[str, object],
    folder: str | Path,
    ranks: int = 1,
    restart: str | Path | None = None,
    host: str | None = None,
) -> Plan:
    """Check the arguments of `run_bulk` and return the plan of the run.

    The arguments and errors are those of `run_bulk`.
    """
    if not (isinstance(ranks, int) and ranks >= 1):
        raise ValueError(f"ranks is {ranks!r}; it must be 1 or more")
    if "output" in values:
        raise ValueError(
            f"output is {values['output']!r}, but output is not a setting. Use --output"
        )
    folder, script = Path(folder).resolve(), find_deck(deck)
    values = {name: str(value) for name, value in values.items()}
    deck_type = deck_class(deck_name(script)) if is_supplied(script) else None
    record = checkpoint = None
    if restart is not None:
        restart = Path(restart).resolve()
        record = _read_earlier_record(restart, folder, script, own=deck_type is None)
        if deck_type:
            checkpoint = restart_point(restart, record)
        else:
            checkpoint = own_restart_point(read_deck(script, {}, folder), restart, record)
        values = record["values"] | values | {"start": "checkpoint", "checkpoint": str(checkpoint)}
        host = host or record.get("versions", {}).get("host")
    host = host or values.get("host", "liggghts")
    if deck_type and host != "liggghts":
        refuse_host(host, script)
        values["host"] = host
    # Make the path absolute, because the host runs in another folder.
    if deck_type and "materials" in values:
        values["materials"] = str(Path(values["materials"]).resolve())
    source = read_deck(script, values, folder)
    places = {"inputs": folder / "deck"} if deck_type else own_places(source, folder)
    plan = Plan(source, deck_type, folder, ranks, values, places, restart, checkpoint, host)
    if source.settings.get("start") == "checkpoint":
        refuse_damaged(plan.working_folder / source.settings.get("checkpoint", ""))
    if deck_type is None:
        check_laws(source)
    else:
        if record:
            check_continued(source.settings, record["settings"], deck_type.continuable_settings())
        deck_type.read(source.settings).check_inputs()
        if host == "lammps":
            refuse_settings(source.settings)
    return plan


def refuse_host(host: str, script: Path) -> None:
    """Reject a host that is unknown, or that cannot run the deck `script` of `inputs/bulk`.

    Raises:
        ValueError: The host is unknown or does not run the deck.
    """
    if host not in HOSTS:
        raise ValueError(f"host is {host}; it must be one of {', '.join(HOSTS)}")
    if not takes_host(script):
        decks = [name for name in deck_names() if takes_host(find_deck(name))]
        raise ValueError(
            f"host is {host}, but {script.stem} runs only in LIGGGHTS. Decks that run in "
            f"{HOSTS[host].name}: {', '.join(decks)}"
        )


def check_continued(
    settings: dict[str, str], earlier: dict[str, str], continuable: frozenset[str]
) -> None:
    """Check that a continued run changes only settings that it may change.

    Raises:
        ValueError: Another setting differs; the message names it.
    """
    for name in settings.keys() - continuable - PLACES:
        if settings[name] != earlier.get(name, settings[name]):
            raise ValueError(
                f"{name} is {settings[name]}, but the run to continue has {earlier[name]}. A "
                f"continued run may change only {', '.join(sorted(continuable))}"
            )


def _read_earlier_record(restart: Path, folder: Path, script: Path, own: bool) -> dict:
    """Read the record of the run to continue.

    Raises:
        ValueError: The run belongs to another deck, or `folder` is the run to continue.
    """
    record = read_record(restart)
    name, was_own = record["deck"], bool(record.get("own"))
    if name != deck_name(script):
        raise ValueError(
            f"{restart} is a run of {name}, not of {deck_name(script)}. Choose a run "
            "of the same deck"
        )
    if was_own != own:
        deck = "a user's deck" if was_own else f"the package's {name}"
        raise ValueError(f"{restart} is a run of {deck}, not of {script}. Choose another run")
    if restart == folder:
        raise ValueError(f"{folder} is the run to continue. Choose another --output")
    return record
