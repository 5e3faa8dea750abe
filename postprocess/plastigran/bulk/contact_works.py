# SPDX-License-Identifier: GPL-2.0-or-later
"""Compute the plastic work of contacts between grains from their contact histories.

A frame is the output of all grains and contacts at one step. With the setting `contact_history=1`,
the frames of a deck contain the first value of each contact history. If the yield strength does not
depend on the strain rate, this value and the overlap determine the plastic work.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike

from plastigran import laws
from plastigran.bulk.grains import Grains
from plastigran.engine.dumps import read_dump

#: Columns of the file with the contact histories of a frame: IDs of both grains, 1 for a contact
#: across a periodic boundary (else 0), first value of the contact history.
COLUMNS = ("id1", "id2", "periodic", "history")


def read_histories(file: str | Path) -> pd.DataFrame:
    """Read the contact histories of a frame: one row per contact, with the columns `COLUMNS`.

    Raises:
        DumpError: The file is damaged.
    """
    table = read_dump(file).drop(columns="step")
    return table.set_axis(COLUMNS, axis=1).astype({"id1": int, "id2": int})


def plastic_works(
    grains: Grains, radius_eff: ArrayLike, overlap: ArrayLike, history: ArrayLike
) -> np.ndarray:
    """Return the plastic work of contacts between two grains.

    Args:
        grains: Law and material of the grains.
        radius_eff: Effective radius R* of each contact (N,), m.
        overlap: Overlaps (N,), m.
        history: First value of each contact history (N,). Its name and unit depend on the law: see
            `state_names` of the law.

    Returns:
        Plastic work of each contact since it formed (N,), J. NaN if the yield strength depends on
        the strain rate, because then the first value of the history does not determine the work.
    """
    law = grains.contact_law()
    radius_eff, overlap, history = (np.asarray(a, float) for a in (radius_eff, overlap, history))
    if not type(law).yields:
        return np.zeros(overlap.shape)
    if grains.material.rate_coefficient:
        return np.full(overlap.shape, np.nan)
    if type(law).state_names[0] == "overlap_max":
        path = np.stack([np.maximum(history, overlap), overlap], axis=-1)
        return law.follow(radius_eff, path)["plastic_work"][..., -1]
    states = np.empty(overlap.shape, dtype=object)
    for place, value in np.ndenumerate(history):
        states[place] = _state(type(law), value)
    return np.asarray(law.respond(radius_eff, overlap, states).plastic_work)


def _state(law: type[laws.Law], value: float) -> laws.ContactState:
    """Return the state of a contact whose history has the given first value."""
    state = law.State.__new__(law.State)
    state.__setstate__(({law.state_names[0]: float(value)},))
    return state
