# SPDX-License-Identifier: GPL-2.0-or-later
"""Run a bulk deck, check its invariants and draw its figures; read a run again."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from importlib.metadata import version
from pathlib import Path
from typing import Self

import attrs
import pandas as pd
from matplotlib.figure import Figure

from plastigran.bulk.checks import Check
from plastigran.bulk.deck import Analysis, BulkDeck
from plastigran.bulk.decks import deck_class
from plastigran.bulk.folder import (
    BEFORE,
    CHECKS,
    RECORD,
    SERIES,
    all_derived,
    carry_dump,
    prepare_folder,
    read_record,
    read_series,
    write_record,
)
from plastigran.bulk.own import analyse_own
from plastigran.bulk.plan import plan_bulk
from plastigran.engine.checkpoints import step_of
from plastigran.engine.dumps import DumpError
from plastigran.engine.log import LOG
from plastigran.engine.process import EngineError, engine_path, run_deck
from plastigran.plot import style


class CheckError(ValueError):
    """A deck ran to its end but broke one of its invariants; the message says which."""


@attrs.frozen(repr=False)
class BulkRun:
    """A run of a bulk deck and what was made of it.

    Attributes:
        name: Of the deck.
        folder: Where its files are.
        deck: Its settings; None for a deck without a class.
        analysis: What the deck made of it: without checks and figures where it has not finished.
        finished: Whether the engine came to the end.
    """

    name: str
    folder: Path
    deck: BulkDeck | None
    analysis: Analysis
    finished: bool = True

    @property
    def series(self) -> pd.DataFrame:
        """One row a line of the log, with measurement and theory beside it, in SI units."""
        return self.analysis.series

    @property
    def checks(self) -> pd.DataFrame:
        """One row a check: its name, value, limit, reason, and whether it passed."""
        columns = [field.name for field in attrs.fields(Check)]
        rows = [[*attrs.astuple(check), check.passed] for check in self.analysis.checks]
        return pd.DataFrame(rows, columns=[*columns, "passed"])

    @property
    def figures(self) -> dict[str, Figure]:
        """The deck's figures by name."""
        return self.analysis.figures

    @property
    def notes(self) -> list[str]:
        """Sentences on what could not be measured."""
        return self.analysis.notes

    @property
    def passed(self) -> bool:
        """Whether the run finished and every check passed."""
        return self.finished and not self.analysis.failed

    def __repr__(self) -> str:
        state = "finished" if self.finished else "not finished"
        if failed := self.analysis.failed:
            state += f", failed: {'; '.join(check.name for check in failed)}"
        elif self.analysis.checks:
            state += f", {len(self.analysis.checks)} checks passed"
        if self.notes:
            state += ", not all measured: see notes"
        return f"<run of {self.name} in {self.folder}: {len(self.series)} rows, {state}>"

    def raise_if_failed(self) -> Self:
        """The run itself. Raises CheckError when a check failed; the message names it."""
        if failed := self.analysis.failed:
            said = "; ".join(f"{c.name} {c.value:.3g}, at most {c.limit:.3g}" for c in failed)
            raise CheckError(f"{said} (in {self.folder})")
        return self


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
    plan = plan_bulk(deck, values, folder, ranks, restart)
    source, folder, restart = plan.source, plan.folder, plan.earlier

    plugin = _fingerprint()  # raises where there is no engine, before anything is written
    prepare_folder(folder, force)
    # The engine reads a script as it goes: run one that nobody edits meanwhile.
    script = source.copy(folder / "deck")
    record = {
        "deck": source.name,
        "own": plan.kind is None,
        "values": plan.values,
        "settings": source.settings,
        "ranks": ranks,
        "restart": str(restart) if restart else None,
        "derived": all_derived(restart) if restart else {},
        "versions": {"plastigran": version("plastigran"), "plugin": plugin},
    }
    if plan.checkpoint:
        step = step_of(plan.checkpoint)
        before = read_series(restart)
        before[before["step"] <= step].to_csv(folder / BEFORE, index=False)
        carry_dump(restart, folder, step)
    write_record(folder, record)  # last: a folder with a record can be gone on from
    try:
        run_deck(
            script,
            plan.values | plan.places,
            folder,
            ranks,
            timeout=None,
            progress=show,
            working_folder=plan.working_folder,
        )
    finally:
        if (log := folder / LOG).exists():
            record["versions"]["engine"] = log.read_text(errors="replace").partition("\n")[0]
            write_record(folder, record)
    read_series(folder).to_csv(folder / SERIES, index=False)  # whatever comes of its analysis
    run = open_run(folder)
    write_results(run)
    return run


def open_run(folder: str | Path) -> BulkRun:
    """Read a run of a deck, finished or not, as `run_bulk` hands it over.

    Args:
        folder: Where its results are; it need not be where they were written.

    Raises:
        EngineError: The folder holds no run, or its record is damaged.
        DumpError: The log shows nothing yet, or a file is damaged.
    """
    folder = Path(folder).resolve()
    record, series = read_record(folder), read_series(folder)
    kind, finished = deck_class(record["deck"]), (folder / SERIES).exists()
    try:
        deck = kind.read(record["settings"] | {"output": folder}) if kind else None
    except ValueError as error:
        raise EngineError(f"{folder / RECORD}: {error}") from None
    try:
        analysis = Analysis(series)
        if finished:
            analysis = deck.analyse(series) if deck else analyse_own(series)
    except (ArithmeticError, LookupError, OSError, ValueError) as error:
        said = f"{type(error).__name__}: {error}"
        raise DumpError(
            f"{folder}: {LOG} holds no whole run of {record['deck']} ({said})"
        ) from error
    return BulkRun(record["deck"], folder, deck, analysis, finished)


def write_results(run: BulkRun) -> None:
    """Write the series, checks and figures of a run into its folder."""
    run.series.to_csv(run.folder / SERIES, index=False)
    if run.analysis.checks:
        run.checks.to_csv(run.folder / CHECKS, index=False)
    for name, figure in run.figures.items():
        style.save(figure, run.folder / "figures" / name)


def _fingerprint() -> str:
    """File and SHA-256 of the plugin beside the engine."""
    plugin = engine_path().parent / "libplastigran.so"
    if not plugin.exists():
        return f"none beside {engine_path()}"
    return f"{plugin.name} sha256 {hashlib.sha256(plugin.read_bytes()).hexdigest()}"
