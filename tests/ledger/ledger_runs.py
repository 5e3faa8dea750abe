# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs of the ledger's decks, read."""

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
    """Run a deck; the ledger's entries [J] by output line, with the columns run and step."""
    run_deck(DECKS / f"{deck}.in", {"decks": DECKS, **variables}, folder, ranks=ranks)
    return read_thermo(folder / "log.liggghts")


def plastic_work(folder: Path, step: float | None = None, dump: str = "grains") -> pd.Series:
    """Plastic work of the particles [J] by id; at the last output when no step is given."""
    table = read_dump(folder / f"{dump}.dump")
    at = table["step"].max() if step is None else step
    return table[table["step"] == at].set_index("id")["plastic_work"]


def largest_difference(one: pd.DataFrame, other: pd.DataFrame) -> float:
    """Of any entry [J], over the rows that both have; there are some, and energy is stored."""
    both = one.merge(other, on=["run", "step"], suffixes=("", "_other"))
    assert (both["elastic"] > 0).sum() > 2
    return max(np.abs(both[entry] - both[f"{entry}_other"]).max() for entry in ENTRIES)
