# SPDX-License-Identifier: GPL-2.0-or-later
"""Plastic work of every contact between grains, from what each remembers.

`contact_history=1` makes a deck's frames tell the first value of each contact's memory. A law's
answer follows from it and from the overlap: laws are total.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike

from plastigran import laws
from plastigran.bulk.grains import Grains
from plastigran.engine.dumps import read_dump

#: Columns of a frame's file of memories: both grains' ids, 1 through a periodic side, the memory.
COLUMNS = ("id1", "id2", "periodic", "memory")


def read_memories(file: str | Path) -> pd.DataFrame:
    """The memories of a frame's contacts: one row each, columns of `COLUMNS`.

    Raises:
        DumpError: The file is damaged.
    """
    table = read_dump(file).drop(columns="step")
    return table.set_axis(COLUMNS, axis=1).astype({"id1": int, "id2": int})


def plastic_works(
    grains: Grains, radius_eff: ArrayLike, overlap: ArrayLike, memory: ArrayLike
) -> np.ndarray:
    """Plastic work of contacts between two grains.

    Args:
        grains: Their law and material.
        radius_eff: R* of each contact [m], (N,).
        overlap: Of each [m], (N,).
        memory: First value of its history, as the law's `state_names` call it, (N,).

    Returns:
        (N,) [J], a contact's whole work; not a number where the yield strength grows with the rate
        of impact, of which a contact remembers more.
    """
    law = grains.contact_law()
    radius_eff, overlap, memory = (
        np.asarray(given, dtype=float) for given in (radius_eff, overlap, memory)
    )
    if not type(law).yields:
        return np.zeros(overlap.shape)
    if grains.material.rate_coefficient:
        return np.full(overlap.shape, np.nan)
    if type(law).state_names[0] == "overlap_max":
        path = np.stack([np.maximum(memory, overlap), overlap], axis=-1)
        return law.follow(radius_eff, path)["plastic_work"][..., -1]
    states = np.empty(overlap.shape, dtype=object)
    for place, value in np.ndenumerate(memory):
        states[place] = _state(type(law), value)
    return np.asarray(law.respond(radius_eff, overlap, states).plastic_work)


def _state(law: type[laws.Law], value: float) -> laws.ContactState:
    """The state of a contact that remembers one number."""
    state = law.State.__new__(law.State)
    state.__setstate__(({law.state_names[0]: float(value)},))
    return state
