# SPDX-License-Identifier: GPL-2.0-or-later
"""Decks of many grains: run, checked and drawn.

The package can be called, `plastigran.bulk("hopper", law="thornton")`: it runs the deck and hands
over what came of it, a `BulkRun`; errors are those of `run_bulk`.

    plastigran.bulk(deck, *, folder=None, show=True, force=False, ranks=1, restart=None, **settings)

Args:
    deck: Name of a deck of `inputs/bulk`, or path of an input script.
    folder: Where results go; results/DECK of the present folder without one.
    show: Show a progress bar.
    force: Overwrite an earlier run in `folder`.
    ranks: MPI ranks.
    restart: Folder of an earlier run to go on from.
    settings: Of the deck, given another value than the deck's.
"""

from __future__ import annotations

import sys
from pathlib import Path
from types import ModuleType

from plastigran.bulk.outcome import BulkRun
from plastigran.bulk.outcome import open_run as open
from plastigran.bulk.run import run_bulk
from plastigran.engine.deck import deck_name


class _Package(ModuleType):
    """The class of this module: calling the module runs a deck."""

    def __call__(
        self,
        deck: str | Path,
        /,
        *,
        folder: str | Path | None = None,
        show: bool = True,
        force: bool = False,
        ranks: int = 1,
        restart: str | Path | None = None,
        **settings: object,
    ) -> BulkRun:
        """Run a bulk deck; the package's docstring has the arguments."""
        folder = folder or Path("results") / deck_name(deck)
        return run_bulk(deck, settings, folder, ranks, restart, force, show)


__all__ = ["BulkRun", "open", "run_bulk"]

sys.modules[__name__].__class__ = _Package
