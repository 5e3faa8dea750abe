# SPDX-License-Identifier: GPL-2.0-or-later
"""What to check and draw of each bulk deck: one module or package a deck, of the deck's name.

It has two functions; both raise ValueError for what they cannot take.

    check_settings(settings: Settings) -> None
        Before anything runs: settings out of range are named.
    analyse(settings: Settings, series: pd.DataFrame) -> Analysis
        After the run: `series` is the log from step 0, whatever checkpoints it went on from.

and may have CONTINUABLE, names of settings that `--restart` may change beside `frames`: those that
leave steps before the checkpoint and the restored grains what they were.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from importlib import import_module
from pkgutil import iter_modules
from types import ModuleType

import pandas as pd
from matplotlib.figure import Figure


@dataclass(frozen=True)
class Check:
    """An invariant of a deck.

    Attributes:
        name: What must be small, in words.
        value: What was found.
        limit: What it may be at most.
        reason: Why that much.
    """

    name: str
    value: float
    limit: float
    reason: str

    @property
    def passed(self) -> bool:
        return bool(self.value <= self.limit)  # never for nan


@dataclass(frozen=True)
class Analysis:
    """What a deck's module makes of a run.

    Attributes:
        table: One row a line of the log, written as CSV.
        checks: The deck's invariants.
        figures: By name, written as PNG and SVG.
    """

    table: pd.DataFrame
    checks: list[Check]
    figures: dict[str, Figure] = field(default_factory=dict)


def module_of(deck: str) -> ModuleType | None:
    """The module or package of a deck's name; None for a deck that has none."""
    found = {module.name for module in iter_modules(__path__)}
    return import_module(f"{__name__}.{deck}") if deck in found else None
