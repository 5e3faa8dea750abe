# SPDX-License-Identifier: GPL-2.0-or-later
"""The impact of a ball on a bed: motion without yield, and continuation of an interrupted run."""

from __future__ import annotations

import shutil

import numpy as np
import pandas as pd
import pytest

from plastigran.bulk.continued import finish_bulk
from plastigran.bulk.decks import deck_class
from plastigran.bulk.folder import read_record
from plastigran.bulk.run import run_bulk
from plastigran.bulk.series import read_series
from plastigran.engine.checkpoints import PATTERN, step_of

SHORT = dict(deck_class("ball_impact").briefs[""].settings)


def test_unlimited_strength_gives_the_motion_of_stock_hertz(tmp_path):
    """The plugin and LIGGGHTS' hertz give bitwise identical motions of the ball and of the center
    of mass of the bed.

    With `limitForce on`, the force of hertz stays repulsive, as with `viscous_damping on`.
    """
    settings = SHORT | {"duration": 0.003}
    stock = {"law": "hertz", "ledger": "off", "options": "limitForce on"}
    ours = {"yield_strength": 1e30, "options": "viscous_damping on"}
    series = {
        name: run_bulk("ball_impact", settings | given, tmp_path / name, show=False).series
        for name, given in {"stock": stock, "ours": ours}.items()
    }
    for name in ("ball", "velocity", "bed"):
        pd.testing.assert_series_equal(series["ours"][name], series["stock"][name], rtol=0, atol=0)
    slowed = np.diff(series["ours"]["velocity"]).max()
    assert slowed > 0.01  # the ball has hit the bed


def test_interrupted_run_continues_to_the_same_end(tmp_path, brief_run):
    """`finish_bulk` continues an interrupted run from a checkpoint, and only reads a finished run.

    The displacement of the ball agrees with that of an uninterrupted run only to 1e-6 of its
    largest value, because the bed amplifies round-off.
    """
    whole = brief_run("ball_impact", "")
    stopped = tmp_path / "runs" / "part_1"
    shutil.copytree(whole.folder, stopped)
    (stopped / "series.csv").unlink()
    checkpoints = sorted(stopped.glob(PATTERN), key=step_of)
    for file in checkpoints[len(checkpoints) // 2 :]:
        file.unlink()
    record = read_record(whole.folder)["values"]
    finished = finish_bulk("ball_impact", record, tmp_path / "runs", show=False)
    assert finished.folder.name == "part_2" and finished.finished
    expected = read_series(whole.folder)
    difference = (finished.series["ball"] - expected["ball"]).abs().max()
    assert difference <= 1e-6 * expected["ball"].abs().max()
    again = finish_bulk("ball_impact", record, tmp_path / "runs", show=False)
    assert again.folder == finished.folder
    with pytest.raises(ValueError, match="contains a run with the settings"):
        finish_bulk("ball_impact", record | {"seed": 7}, tmp_path / "runs", show=False)


def test_ball_must_start_above_the_bed():
    settings = SHORT | {"ball_height": 0.005}
    with pytest.raises(ValueError, match=r"ball_height is 0\.005; it must be above"):
        run_bulk("ball_impact", settings, "never", show=False)


def test_an_impossible_bed_removes_no_earlier_run(tmp_path, brief_run):
    """Refused settings of a bed leave the files of an earlier run unchanged.

    The earlier run ends at the set duration. Its number of rows, 0.004 s / 1e-6 s / 40, is slightly
    above 100 because of round-off, but this adds no steps.
    """
    whole = brief_run("ball_impact", "")
    assert whole.series["time"].iloc[-1] == pytest.approx(SHORT["duration"], rel=1e-12)
    run = tmp_path / "run"
    shutil.copytree(whole.folder, run)
    before = sorted(run.rglob("*"))
    with pytest.raises(ValueError, match="Lower volume_fraction"):
        run_bulk("ball_impact", SHORT | {"volume_fraction": 0.595}, run, force=True, show=False)
    assert sorted(run.rglob("*")) == before
