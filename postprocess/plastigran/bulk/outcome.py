# SPDX-License-Identifier: GPL-2.0-or-later
"""Result of a run of a bulk deck, new or read from its folder."""

from __future__ import annotations

from pathlib import Path
from typing import Self

import attrs
import pandas as pd
from matplotlib.figure import Figure

from plastigran.bulk.checks import Check, range_checks
from plastigran.bulk.deck import Analysis, BulkDeck
from plastigran.bulk.decks import deck_class
from plastigran.bulk.folder import RECORD, SERIES, all_excess, read_record
from plastigran.bulk.own import analyse_own
from plastigran.bulk.series import read_series
from plastigran.engine.dumps import DumpError
from plastigran.engine.log import log_path
from plastigran.engine.process import EngineError


class CheckError(ValueError):
    """A finished run failed a check; the message names the check."""


@attrs.frozen(repr=False)
class BulkRun:
    """Run of a bulk deck and its analysis.

    Attributes:
        name: Name of the deck.
        folder: Folder of the files of the run.
        deck: Deck with its settings; None for a user's deck, which has no class.
        analysis: Analysis of the run. An unfinished run has no checks and figures.
        finished: Whether LIGGGHTS or LAMMPS reached the end of the script.
    """

    name: str
    folder: Path
    deck: BulkDeck | None
    analysis: Analysis
    finished: bool = True

    @property
    def series(self) -> pd.DataFrame:
        """Table of measured and predicted quantities in SI units, one row per line of the log."""
        return self.analysis.series

    @property
    def checks(self) -> pd.DataFrame:
        """Table with one row per check: name, value, limit, reason, and whether it passed."""
        columns = [field.name for field in attrs.fields(Check)]
        rows = [[*attrs.astuple(check), check.passed] for check in self.analysis.checks]
        return pd.DataFrame(rows, columns=[*columns, "passed"])

    @property
    def figures(self) -> dict[str, Figure]:
        """Figures of the deck by name."""
        return self.analysis.figures

    @property
    def notes(self) -> list[str]:
        """Sentences that say which quantities could not be measured, and why."""
        return self.analysis.notes

    @property
    def results(self) -> dict[str, float]:
        """Measured numbers by name, with the unit in the name; empty for most decks."""
        return self.analysis.results

    @property
    def passed(self) -> bool:
        """Whether the run finished and every check passed."""
        return self.finished and not self.analysis.failed

    def __repr__(self) -> str:
        state = "finished" if self.finished else "not finished"
        if failed := self.analysis.failed:
            state += f", failed: {'; '.join(check.name for check in failed)}"
        elif checks := self.analysis.checks:
            state += f", {len(checks)} checks passed"
        if self.notes:
            state += ", some results were not measured (see notes)"
        return f"<run of {self.name} in {self.folder}: {len(self.series)} rows, {state}>"

    def raise_if_failed(self) -> Self:
        """Return the run itself if no check failed.

        Raises:
            CheckError: A check failed; the message names it.
        """
        if failed := self.analysis.failed:
            values = "; ".join(f"{c.name} is {c.value:.3g}, limit {c.limit:.3g}" for c in failed)
            raise CheckError(f"failed checks of the run in {self.folder}: {values}")
        return self


def open_run(folder: str | Path) -> BulkRun:
    """Read a run of a deck, finished or not, from the folder that `run_bulk` wrote.

    Args:
        folder: Folder of the results. The folder may have been moved since the run.

    Raises:
        EngineError: The folder contains no run, or its record is damaged.
        DumpError: The log has no rows, or a file is damaged.
    """
    folder = Path(folder).resolve()
    record, series = read_record(folder), read_series(folder)
    name = record["deck"]
    deck_type = None if record.get("own") else deck_class(name)
    try:
        deck = deck_type.read(record["settings"] | {"output": folder}) if deck_type else None
    except ValueError as error:
        raise EngineError(f"{folder / RECORD}: {error}") from None
    if not (folder / SERIES).exists():
        return BulkRun(name, folder, deck, Analysis(series), finished=False)
    try:
        analysis = deck.analyse(series) if deck else analyse_own(series)
        checks = [*range_checks(all_excess(folder)), *analysis.checks]
    except (ArithmeticError, LookupError, OSError, ValueError) as error:
        raise DumpError(
            f"{log_path(folder)} contains no complete run of {name} "
            f"({type(error).__name__}: {error}). Repeat the run"
        ) from error
    return BulkRun(name, folder, deck, attrs.evolve(analysis, checks=checks))
