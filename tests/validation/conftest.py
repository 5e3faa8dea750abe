# SPDX-License-Identifier: GPL-2.0-or-later
"""Fixture: the comparison of every law with finite elements of spheres, computed once."""

from __future__ import annotations

import pandas as pd
import pytest

from plastigran.validation import laws_on_spheres


@pytest.fixture(scope="session")
def compared() -> pd.DataFrame:
    return laws_on_spheres.compare()
