# SPDX-License-Identifier: GPL-2.0-or-later
"""Papers reproduced coarsely by the command, once for all tests and pytest's workers."""

from __future__ import annotations

import os
from collections.abc import Callable
from fcntl import LOCK_EX, flock
from pathlib import Path

import pandas as pd
import pytest

from plastigran.cli import main


@pytest.fixture(scope="session")
def coarse(tmp_path_factory) -> Callable[[str], Path]:
    """The folder that `plastigran reproduce NAME --coarse` writes, `coarse(name)`."""
    base = tmp_path_factory.getbasetemp()
    shared = base.parent if "PYTEST_XDIST_WORKER" in os.environ else base

    def run(name: str) -> Path:
        folder = shared / f"paper_{name}"
        with open(folder.with_suffix(".lock"), "w") as lock, pytest.MonkeyPatch.context() as patch:
            flock(lock, LOCK_EX)
            if not folder.exists():
                patch.setenv("PLASTIGRAN_CACHE", str(shared / "papers_cache"))
                assert main(["reproduce", name, "--coarse", "--output", str(folder)]) == 0
        return folder

    return run


@pytest.fixture(scope="session")
def coarse_table(coarse) -> Callable[[str, str], pd.DataFrame]:
    """One of its tables, `coarse_table(name, table)`."""
    return lambda name, table: pd.read_csv(coarse(name) / f"{table}.csv")
