# SPDX-License-Identifier: GPL-2.0-or-later
"""Functions that run the decks of the energy balance and read the results."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd

from plastigran.engine.dumps import read_dump
from plastigran.engine.log import read_thermo
from plastigran.engine.process import run_deck

DECKS = Path(__file__).parent / "decks"
ENTRIES = ["kinetic", "gravity", "elastic", "plastic", "friction", "viscous", "wallwork"]
ENTRIES += ["inserted", "drift", "springs"]


def ledger(deck: str, folder: Path, ranks: int = 1, **variables) -> pd.DataFrame:
    """Run a deck; return the energy terms [J] by line of the log, with the columns run and step."""
    run_deck(DECKS / f"{deck}.in", {"decks": DECKS, **variables}, folder, ranks=ranks)
    return read_thermo(folder / "log.liggghts")


def plastic_work(folder: Path, step: float | None = None, dump: str = "grains") -> pd.Series:
    """Return the plastic work of the particles [J] by ID, at a step or at the last output."""
    table = read_dump(folder / f"{dump}.dump")
    at = table["step"].max() if step is None else step
    return table[table["step"] == at].set_index("id")["plastic_work"]


def largest_difference(one: pd.DataFrame, other: pd.DataFrame) -> float:
    """Return the largest difference of any term [J] in the rows that both tables have.

    The function fails unless elastic energy is positive in at least three of these rows.
    """
    both = one.merge(other, on=["run", "step"], suffixes=("", "_other"))
    assert (both["elastic"] > 0).sum() > 2
    return max(np.abs(both[entry] - both[f"{entry}_other"]).max() for entry in ENTRIES)
