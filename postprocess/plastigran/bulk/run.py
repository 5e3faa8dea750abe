# SPDX-License-Identifier: GPL-2.0-or-later
"""Run a bulk deck, check its invariants and draw its figures."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from plastigran.bulk.decks import deck_class
from plastigran.bulk.folder import (
    BEFORE,
    CHECKS,
    SERIES,
    all_derived,
    carry_dump,
    prepare_folder,
    read_record,
    read_series,
    restart_point,
    write_record,
)
from plastigran.bulk.outcome import BulkRun, open_run
from plastigran.bulk.own import check_goes_on, own_places
from plastigran.engine.checkpoints import step_of
from plastigran.engine.deck import find_deck, read_deck
from plastigran.engine.log import LOG
from plastigran.engine.process import run_deck
from plastigran.engine.versions import versions
from plastigran.plot import style

#: Settings that name files and places; they differ between runs and are not compared.
PLACES = frozenset({"start", "checkpoint", "inputs", "output", "materials"})


def run_bulk(
    deck: str | Path,
    values: Mapping[str, object],
    folder: str | Path,
    ranks: int = 1,
    restart: str | Path | None = None,
    force: bool = False,
    show: bool = True,
) -> BulkRun:
    """Run a deck from its start or from the newest whole checkpoint of an earlier run.

    An input script without a class is the user's own: it runs in its own folder, from which its
    relative paths are, is told where results go where it reads ${output}, and goes on from a
    checkpoint where it has settings `start` and `checkpoint`.

    Args:
        deck: Name of a deck of `inputs/bulk`, or path of an input script.
        values: Settings given another value than the deck's, or with `restart` than the earlier
            run's.
        folder: Where results go.
        ranks: MPI ranks.
        restart: Folder of the earlier run.
        force: Overwrite an earlier run in `folder`.
        show: Show a progress bar.

    Returns:
        What the deck's class made of it, also written to `folder`, whether its checks passed or
        not; for a deck without a class its series alone.

    Raises:
        EngineError: No such deck, no whole checkpoint, or the engine stopped with an error.
        ValueError: An unknown setting, or one out of range, or `folder` holds results.
    """
    if not (isinstance(ranks, int) and ranks >= 1):
        raise ValueError(f"ranks is {ranks!r}; it must be 1 or more")
    folder, script = Path(folder).resolve(), find_deck(deck)
    values = {name: str(value) for name, value in values.items()}
    earlier = checkpoint = None
    if restart is not None:
        restart = Path(restart).resolve()
        earlier = _earlier(restart, folder, script.stem)
        checkpoint = restart_point(restart, earlier)
        values = earlier["values"] | values | {"start": "checkpoint", "checkpoint": str(checkpoint)}
    kind = deck_class(script.stem)
    if earlier and not kind:
        check_goes_on(read_deck(script, {}, folder))
    source = read_deck(script, values, folder)
    places = {"inputs": folder / "deck"} if kind else own_places(source, folder)
    if kind:
        if earlier:
            check_continued(source.settings, earlier["settings"], kind.continuable_settings())
        kind.read(source.settings).check_inputs()

    made_with = versions()  # raises where there is no engine, before anything is written
    prepare_folder(folder, force)
    # The engine reads a script as it goes: run one that nobody edits meanwhile.
    script = source.copy(folder / "deck")
    record = {
        "deck": source.name,
        "own": kind is None,
        "values": values,
        "settings": source.settings,
        "ranks": ranks,
        "restart": str(restart) if restart else None,
        "derived": all_derived(restart) if restart else {},
        "versions": made_with,
    }
    if checkpoint:
        step = step_of(checkpoint)
        before = read_series(restart)
        before[before["step"] <= step].to_csv(folder / BEFORE, index=False)
        carry_dump(restart, folder, step)
    write_record(folder, record)  # last: a folder with a record can be gone on from
    try:
        run_deck(
            script,
            values | places,
            folder,
            ranks,
            timeout=None,
            progress=show,
            working_folder=None if kind else source.path.parent,
        )
    finally:
        if (log := folder / LOG).exists():
            record["versions"]["engine"] = log.read_text(errors="replace").partition("\n")[0]
            write_record(folder, record)
    read_series(folder).to_csv(folder / SERIES, index=False)  # whatever comes of its analysis
    run = open_run(folder)
    write_results(run)
    return run


def write_results(run: BulkRun) -> None:
    """Write the series, checks and figures of a run into its folder."""
    run.series.to_csv(run.folder / SERIES, index=False)
    if run.analysis.checks:
        run.checks.to_csv(run.folder / CHECKS, index=False)
    for name, figure in run.figures.items():
        style.save(figure, run.folder / "figures" / name)


def check_continued(
    settings: dict[str, str], earlier: dict[str, str], continuable: frozenset[str]
) -> None:
    """A run that goes on is the same run: grains and course are in the checkpoint.

    Raises:
        ValueError: A setting has changed that may not; the message names it.
    """
    for name in settings.keys() - continuable - PLACES:
        if settings[name] != earlier.get(name, settings[name]):
            raise ValueError(
                f"{name} is {settings[name]} and was {earlier[name]}; a run that goes on may "
                f"change {', '.join(sorted(continuable))} only"
            )


def _earlier(restart: Path, folder: Path, deck: str) -> dict:
    """The record of the run to go on from. Raises ValueError when it is another deck's or ours."""
    record = read_record(restart)
    if record["deck"] != deck:
        raise ValueError(f"{restart} is a run of {record['deck']}, not of {deck}")
    if restart == folder:
        raise ValueError(f"{folder} is the run to go on from; choose another --output")
    return record
