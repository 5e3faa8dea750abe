# SPDX-License-Identifier: GPL-2.0-or-later
"""Bulk decks (simulations of many grains): run them, check them and draw figures.

Call the package, `plastigran.bulk("hopper", law="thornton")`, to run a deck and get a `BulkRun`.
The call raises the errors of `run_bulk`.

    plastigran.bulk(deck, *, folder=None, show=True, force=False, ranks=1, restart=None, host=None,
                    **settings)

Args:
    deck: Name of a deck of `inputs/bulk`, or path of an input script.
    folder: Folder of the results, by default results/DECK in the current folder.
    show: Whether to show a progress bar.
    force: Whether to overwrite an earlier run in `folder`.
    ranks: Number of MPI ranks.
    restart: Folder of an earlier run to continue.
    host: Program that runs the deck: liggghts (default) or lammps.
    settings: New values of settings of the deck, by name.
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
    """Module type that makes the package callable: a call runs a deck."""

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
        host: str | None = None,
        **settings: object,
    ) -> BulkRun:
        """Run a bulk deck; see the docstring of the package for the arguments."""
        folder = folder or Path("results") / deck_name(deck)
        return run_bulk(deck, settings, folder, ranks, restart, force, show, host)


__all__ = ["BulkRun", "open", "run_bulk"]

sys.modules[__name__].__class__ = _Package
