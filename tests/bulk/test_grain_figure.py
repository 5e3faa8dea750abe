# SPDX-License-Identifier: GPL-2.0-or-later
"""Mean power in a moving window."""

from __future__ import annotations

import numpy as np
import pandas as pd
import pytest

from plastigran.plot.grains import mean_power


@pytest.mark.parametrize(("window", "rows"), [(0.4, 4), (1e-9, 1), (100.0, 25)])
def test_mean_power_is_that_of_the_windows_middle(window, rows):
    """The mean power of the work 3 t^2 is 6 t in the middle of any window; a window has at most a
    quarter of the rows."""
    time = pd.Series(np.arange(100) * 0.1)
    power = mean_power(3 * time**2, time, window)
    assert len(power) == 100 - rows
    assert power.index[0] == pytest.approx(rows * 0.05)
    assert power.to_numpy() == pytest.approx(6 * power.index)
