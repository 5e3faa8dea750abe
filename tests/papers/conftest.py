# SPDX-License-Identifier: GPL-2.0-or-later
"""Papers, reproduced with coarse meshes once for all tests and all workers of pytest."""

from __future__ import annotations

from collections.abc import Callable
from fcntl import LOCK_EX, flock
from pathlib import Path

import pandas as pd
import pytest

from plastigran.cli import main


@pytest.fixture(scope="session")
def coarse(workers_folder) -> Callable[[str], Path]:
    """`coarse(name)` returns the folder that `plastigran reproduce NAME --coarse` writes."""

    def run(name: str) -> Path:
        folder = workers_folder / f"paper_{name}"
        with open(folder.with_suffix(".lock"), "w") as lock, pytest.MonkeyPatch.context() as patch:
            flock(lock, LOCK_EX)
            if not folder.exists():
                patch.setenv("PLASTIGRAN_CACHE", str(workers_folder / "papers_cache"))
                assert main(["reproduce", name, "--coarse", "--output", str(folder)]) == 0
        return folder

    return run


@pytest.fixture(scope="session")
def coarse_table(coarse) -> Callable[[str, str], pd.DataFrame]:
    """`coarse_table(name, table)` reads a table from the folder of `coarse(name)`."""
    return lambda name, table: pd.read_csv(coarse(name) / f"{table}.csv")
