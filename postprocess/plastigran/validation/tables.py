# SPDX-License-Identifier: GPL-2.0-or-later
"""Helper functions for the tables of the validation."""

from __future__ import annotations

import numpy as np
import pandas as pd


def root_mean_square(values: pd.Series | np.ndarray) -> float:
    """Return the root mean square of numbers."""
    return float(np.sqrt(np.mean(np.square(values))))


def nearest_first(rows: list[dict[str, object]]) -> pd.DataFrame:
    """Return a table of the errors of laws, sorted by the sum of the absolute errors of each law.

    Args:
        rows: One row for each law, with the key `law`; all other keys are errors.
    """
    table = pd.DataFrame(rows)
    order = table.drop(columns="law").abs().sum(axis="columns").sort_values().index
    return table.loc[order].reset_index(drop=True)
