# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the comparison of the elasto-plastic laws with finite elements of spheres."""

from __future__ import annotations

import pandas as pd
import pytest

from plastigran.validation import laws_on_spheres
from plastigran.validation.spheres import table


def test_every_yielding_law_and_every_row_is_compared(compared):
    rows = table()
    assert len(compared) == len(laws_on_spheres.yielding_laws()) * (rows["speed_ratio"] > 1).sum()
    assert set(compared["kind"]) <= set(laws_on_spheres.KINDS)


def test_the_errors_of_universal_are_for_metals_outside_its_fit(compared):
    """The errors of `universal` are for the held-out metals, none of which is in its fit.

    Held-out metals and metals of the fit together are all metals.
    """
    metals = compared.groupby("law")["metal"].unique().map(set)
    held_out, fitted = metals["universal"], metals[laws_on_spheres.ON_FITTED_METALS]
    assert held_out == set(table().query("set == 'held'")["metal"])
    assert held_out | fitted == metals["thornton"]
    assert not held_out & fitted


def test_errors_of_an_invented_law():
    """The errors of an invented law are grouped by speed regime.

    Two impacts with errors of 3 % and 4 % lie in one regime; their rms error is 3.54 %. One impact
    lies in another regime.
    """
    compared = pd.DataFrame(
        {
            "law": "invented",
            "kind": laws_on_spheres.KINDS[0],
            "speed_ratio": [20.0, 50.0, 500.0],
            "coefficient_of_restitution": [0.03, -0.04, 0.01],
            "force_max": [0.0, 0.0, 0.0],
        }
    )
    errors = laws_on_spheres.errors(compared)
    first = errors[errors["quantity"] == "coefficient_of_restitution"].iloc[0]
    assert (first["speed_ratio_from"], first["speed_ratio_to"], first["cases"]) == (10, 100, 2)
    assert first["rms"] == pytest.approx((0.0025 / 2) ** 0.5)
    assert first["max"] == pytest.approx(0.04)
