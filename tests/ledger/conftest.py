# SPDX-License-Identifier: GPL-2.0-or-later
"""The run that several tests of the energy balance use."""

from __future__ import annotations

from pathlib import Path

import pandas as pd
import pytest
from ledger_runs import ledger


@pytest.fixture(scope="session")
def bed(tmp_path_factory) -> tuple[Path, pd.DataFrame]:
    """Folder and energy terms of a bed of 144 grains that comes to rest."""
    folder = tmp_path_factory.mktemp("bed")
    return folder, ledger("bed", folder)
