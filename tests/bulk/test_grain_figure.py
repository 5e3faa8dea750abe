# SPDX-License-Identifier: GPL-2.0-or-later
"""Mean power in a moving time window, for figures of bulk runs."""

from __future__ import annotations

import numpy as np
import pandas as pd
import pytest

from plastigran.plot.grains import mean_power


@pytest.mark.parametrize(("window", "rows"), [(0.4, 4), (1e-9, 1), (100.0, 25)])
def test_mean_power_is_that_of_the_windows_middle(window, rows):
    """For the work W = 3 t^2, the mean power in a window is 6 t at the middle of the window.

    A window contains at most a quarter of the rows.
    """
    time = pd.Series(np.arange(100) * 0.1)
    power = mean_power(3 * time**2, time, window)
    assert len(power) == 100 - rows
    assert power.index[0] == pytest.approx(rows * 0.05)
    assert power.to_numpy() == pytest.approx(6 * power.index)
