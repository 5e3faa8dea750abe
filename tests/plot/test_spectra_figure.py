# SPDX-License-Identifier: GPL-2.0-or-later
"""Test of the figure of collision spectra."""

from __future__ import annotations

import numpy as np
import pandas as pd

from plastigran.plot.spectra import spectra_figure


def test_classes_without_impacts_are_a_gap():
    """The histogram has a gap where an energy class has no impacts.

    The class at 1e-24 J, which is only round-off, is omitted. All energies of the test are below
    numpy's default absolute tolerance, which must not make classes equal.
    """
    lower = np.array([1e-24, 1e-15, 2e-15, 8e-15, 1e-3])
    classes = pd.DataFrame({"lower": lower, "upper": 2 * lower, "count": [7, 1, 2, 3, 4]})
    none = classes[:0]
    partners = {"particle": classes, "wall": none}
    figure = spectra_figure({"energy (J)": partners, "again (J)": partners})
    counts, edges, _ = figure.axes[0].patches[0].get_data()
    np.testing.assert_allclose(counts, [1, 2, np.nan, 3, np.nan, 4])
    np.testing.assert_allclose(edges, [1e-15, 2e-15, 4e-15, 8e-15, 16e-15, 1e-3, 2e-3], rtol=1e-9)
