# SPDX-License-Identifier: GPL-2.0-or-later
"""Papers reproduced coarsely by the command, once for all tests of a paper."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

import pandas as pd
import pytest

from plastigran.cli import main


@pytest.fixture(scope="session")
def coarse(tmp_path_factory) -> Callable[[str], Path]:
    """The folder that `plastigran reproduce NAME --coarse` writes, `coarse(name)`."""

    @cache
    def run(name: str) -> Path:
        folder = tmp_path_factory.mktemp("papers") / name
        with pytest.MonkeyPatch.context() as patch:
            patch.setenv("PLASTIGRAN_CACHE", str(tmp_path_factory.mktemp("cache")))
            assert main(["reproduce", name, "--coarse", "--output", str(folder)]) == 0
        return folder

    return run


@pytest.fixture(scope="session")
def coarse_table(coarse) -> Callable[[str, str], pd.DataFrame]:
    """One of its tables, `coarse_table(name, table)`."""
    return lambda name, table: pd.read_csv(coarse(name) / f"{table}.csv")
