# SPDX-License-Identifier: GPL-2.0-or-later
"""Papers reproduced coarsely by the command, once for all tests and pytest's workers."""

from __future__ import annotations

from collections.abc import Callable
from fcntl import LOCK_EX, flock
from pathlib import Path

import pandas as pd
import pytest

from plastigran.cli import main


@pytest.fixture(scope="session")
def coarse(workers_folder) -> Callable[[str], Path]:
    """The folder that `plastigran reproduce NAME --coarse` writes, `coarse(name)`."""

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
    """One of its tables, `coarse_table(name, table)`."""
    return lambda name, table: pd.read_csv(coarse(name) / f"{table}.csv")
