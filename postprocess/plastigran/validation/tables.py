# SPDX-License-Identifier: GPL-2.0-or-later
"""Small things that the tables of the validation share."""

from __future__ import annotations

import numpy as np
import pandas as pd


def root_mean_square(values: pd.Series | np.ndarray) -> float:
    """Of some numbers."""
    return float(np.sqrt(np.mean(np.square(values))))


def nearest_first(rows: list[dict[str, object]]) -> pd.DataFrame:
    """A table of errors in the order of their sum, regardless of sign.

    Args:
        rows: Each with its `law` and errors by further names.
    """
    table = pd.DataFrame(rows)
    order = table.drop(columns="law").abs().sum(axis="columns").sort_values().index
    return table.loc[order].reset_index(drop=True)
