# SPDX-License-Identifier: GPL-2.0-or-later
"""What the tests of bulk decks share."""

from __future__ import annotations

import shutil
from contextlib import nullcontext
from pathlib import Path

import pandas as pd
import pytest

from plastigran.bulk.run import CheckError, read_record, read_series, run_bulk
from plastigran.engine.checkpoints import PATTERN, step_of


@pytest.fixture
def gone_on(tmp_path):
    """Goes on with a copy of a run from its checkpoint number `kept`, as if killed after it.

    Returns the series of the run, of the one that went on in `tmp_path / "rest"`, and the step. One
    that ends before it is `steady` breaks its checks.
    """

    def make(whole: Path, kept: int, steady: bool = True) -> tuple[pd.DataFrame, pd.DataFrame, int]:
        stopped, rest = tmp_path / "stopped", tmp_path / "rest"
        shutil.copytree(whole, stopped)
        checkpoints = sorted(stopped.glob(PATTERN), key=step_of)
        for file in checkpoints[kept:]:
            file.unlink()
        with nullcontext() if steady else pytest.raises(CheckError):
            run_bulk(read_record(whole)["deck"], {}, rest, restart=stopped, show=False)
        expected, found = read_series(whole), read_series(rest)
        step = step_of(checkpoints[kept - 1])
        assert expected["step"].iloc[0] <= step < expected["step"].iloc[-1]
        assert found["step"].tolist() == expected["step"].tolist()
        return expected, found, step

    return make
