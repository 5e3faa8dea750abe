# SPDX-License-Identifier: GPL-2.0-or-later
"""Fixtures: papers that are reproduced with coarse meshes, once for all workers of pytest."""

from __future__ import annotations

from collections.abc import Callable
from fcntl import LOCK_EX, flock
from pathlib import Path

import pandas as pd
import pytest

from plastigran.cli import main


@pytest.fixture(scope="session")
def coarse(workers_folder) -> Callable[[str], Path]:
    """Function that returns the results folder of `plastigran reproduce NAME --coarse`."""

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
    """Function `coarse_table(name, table)` that reads a table of a paper reproduced by `coarse`."""
    return lambda name, table: pd.read_csv(coarse(name) / f"{table}.csv")
