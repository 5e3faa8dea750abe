# SPDX-License-Identifier: GPL-2.0-or-later
"""Sweeps of impact parameters keep finished results, refuse wrong input, and make tables."""

from __future__ import annotations

import pandas as pd
import pytest

import plastigran as pg
from plastigran.engine.process import EngineError
from plastigran.experiments.central import CentralImpact
from plastigran.experiments.record import TABLE
from plastigran.experiments.runs import sweep
from plastigran.experiments.tables import format_table


def impacts(**changes: object) -> list[CentralImpact]:
    given = {"law": "thornton", "speed": [0.05, 0.1], "material": "aluminium_zv02", "radius": 0.1}
    return CentralImpact.plan(**given | changes)


def test_finished_impacts_survive_a_failure(tmp_path):
    """If one impact of a sweep fails, the rows of the other impacts are written."""

    class Broken(CentralImpact):
        def run(self, folder, *_args, **_keys):
            raise ValueError("broken on purpose")

    broken = Broken("thornton", 0.2, "aluminium_zv02", 0.1)
    with pytest.raises(ValueError, match="on purpose"):
        sweep([*impacts(), broken], tmp_path, progress=False)
    assert sorted(pd.read_csv(tmp_path / TABLE)["speed"]) == [0.05, 0.1]


def test_a_folder_of_results_is_refused_unless_forced(tmp_path):
    """A folder with results is refused, even if its sweep has not written its table yet."""
    runs = sweep(impacts(speed=0.1), tmp_path, progress=False)
    for left in (TABLE, "nothing more"):
        with pytest.raises(ValueError, match=f"{tmp_path} contains results. Choose another"):
            pg.collide("stronge", 0.1, "steel", radius=0.1, folder=tmp_path)
        assert (tmp_path / left).exists() == (left == TABLE)
        (tmp_path / TABLE).unlink(missing_ok=True)
    (tmp_path / "runs" / "0001_of_another_sweep").mkdir()
    again = sweep(impacts(speed=0.1), tmp_path, progress=False, force=True)
    assert [run.name[:5] for run in (tmp_path / "runs").iterdir()] == ["0000_"]
    pd.testing.assert_frame_equal(again.table, runs.table)


def test_a_folder_takes_one_sweep_at_a_time(tmp_path):
    class Another(CentralImpact):
        def run(self, folder, *_args, **_keys):
            sweep(impacts(), tmp_path, progress=False, force=True)

    with pytest.raises(ValueError, match=f"{tmp_path} is in use by another plastigran command"):
        sweep([Another("thornton", 0.2, "aluminium_zv02", 0.1)], tmp_path, progress=False)


def test_without_an_engine_results_stay(tmp_path, monkeypatch):
    (tmp_path / TABLE).write_text("of an earlier sweep")
    monkeypatch.setenv("PLASTIGRAN_ENGINE", str(tmp_path / "none"))
    with pytest.raises(EngineError, match="LIGGGHTS is not at"):
        sweep(impacts(), tmp_path, progress=False, force=True)
    assert (tmp_path / TABLE).read_text() == "of an earlier sweep"


@pytest.mark.parametrize("jobs", [0, -1, 1.5, "two"])
def test_jobs_out_of_range_are_refused(jobs, tmp_path):
    with pytest.raises(ValueError, match=rf"jobs is {jobs!r}; it must be 1 or more"):
        sweep(impacts(), tmp_path / "runs", jobs)
    assert not (tmp_path / "runs").exists()


def test_varied_quantities_are_shown(tmp_path):
    """Table and legend show a quantity that varies in a sweep, here the radius, and no others."""
    runs = sweep(impacts(radius=[0.05, 0.1]), tmp_path, progress=False)
    head = str(runs).splitlines()[0].split()
    assert "radius" in head and "geometry" not in head
    one = runs.table[runs.table["radius"] == 0.1]
    assert "radius" not in format_table(one, list(one))
    legend = runs.figure("restitution").axes[0].legend_
    assert [text.get_text() for text in legend.texts] == [
        "Thornton, radius 50 mm",
        "Thornton, radius 100 mm",
    ]
    assert legend.get_title().get_text() == "points: LIGGGHTS, lines: theory"
