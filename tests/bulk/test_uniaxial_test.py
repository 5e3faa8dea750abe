# SPDX-License-Identifier: GPL-2.0-or-later
"""Uniaxial tests in LIGGGHTS: strength grows with adhesion and consolidation, porosity falls."""

from __future__ import annotations

import pandas as pd
import pytest

from plastigran.bulk.decks.uniaxial_test.measurement import (
    Stage,
    free_height,
    measure_strength,
    platen_height,
    platen_work,
    stage_of,
)
from plastigran.bulk.outcome import BulkRun
from plastigran.bulk.run import run_bulk
from plastigran.bulk.series import read_series


@pytest.fixture(scope="module")
def test_run(brief_run) -> BulkRun:
    """Uniaxial test of 72 adhesive grains."""
    return brief_run("uniaxial_test")


@pytest.fixture(scope="module")
def other(test_run, tmp_path_factory):
    """`other(**changes)` runs the test with changed settings."""

    def run(**changes: object) -> BulkRun:
        settings = {**test_run.deck.briefs[""].settings, **changes}
        folder = tmp_path_factory.mktemp("uniaxial") / "run"
        return run_bulk("uniaxial_test", settings, folder, show=False)

    return run


def strength_of(run: BulkRun):
    return run.deck.strength(run.series)


def test_free_sample_is_strong(test_run):
    """The sample reaches the set stress, stands without the mold, and fails at a lower stress."""
    assert test_run.passed, repr(test_run)
    strength = strength_of(test_run)
    assert strength.consolidation == pytest.approx(5e3, rel=0.01)
    assert 0.1 < strength.ratio < 0.6 and 0.4 < strength.porosity < 0.6
    assert test_run.results["unconfined yield strength (Pa)"] == strength.unconfined


def test_without_adhesion_there_is_no_strength(test_run, other):
    """Without adhesion, the sample is denser, and collapses when the mold is removed."""
    loose = strength_of(other(surface_energy=0, adhesion_ratio=0))
    assert loose.ratio < 0.01
    assert loose.porosity < strength_of(test_run).porosity - 0.02


def test_consolidation_strengthens(test_run, other):
    """At four times the consolidation stress, porosity is lower and strength is higher.

    Both changes exceed the scatter between random seeds.
    """
    weak, strong = strength_of(test_run), strength_of(other(consolidation_stress=2e4))
    assert strong.porosity < weak.porosity - 0.02
    assert strong.unconfined > 1.3 * weak.unconfined


def test_wrong_force_is_noticed(test_run):
    """An error of a tenth in the force fails the checks of work and of consolidation stress."""
    series = read_series(test_run.folder)
    series["force"] *= 1.1
    failed = {check.name for check in test_run.deck.analyse(series).failed}
    work = "relative difference between the work of the platen and force times travel"
    stress = "relative difference between stress after consolidation and consolidation_stress"
    assert {work, stress} <= failed


def test_short_strain_is_noted(test_run):
    series = read_series(test_run.folder)
    (note,) = test_run.deck.analyse(series.iloc[:-8]).notes
    assert "Raise strain" in note


def test_sample_that_stays_loaded_is_noted(test_run):
    """If the stress never falls, no strength is measured, a note says so, and a check fails."""
    series = read_series(test_run.folder)
    series["force"] += series["force"].max()
    analysis = test_run.deck.analyse(series)
    assert "Use a larger value of the setting `release`" in analysis.notes[0]
    assert any("when the mold opens" in check.name for check in analysis.failed)


def test_measurement_of_a_known_test():
    """Heights, work and strength of a synthetic test equal their known values.

    The platen goes down by 2, up by 1, waits, and goes down by 1 on a sample of height 9.
    """
    table = pd.DataFrame(
        {
            "step": range(9),
            "time": [0.0, 1, 2, 3, 4, 5, 6, 7, 8],
            "velocity": [0, -1, -1, 0.5, 0.5, 0, 0, -0.5, -0.5],
            "force": [0.0, 50, 100, 0, 0, 0, 0, 30, 20],
        }
    )
    table["stage"] = stage_of(table["step"], [2, 4, 6])
    assert table["stage"].tolist() == [0, 0, 0, 1, 1, 2, 2, 3, 3]
    table["height"] = platen_height(table, 10.0)
    assert table["height"].tolist() == [10, 9, 8, 8.5, 9, 9, 9, 8.5, 8]
    assert platen_work(table).sum() == pytest.approx(50 + 100 + 15 + 10)
    table["stress"], table["porosity"] = table["force"], 0.5
    table["strain"] = 1 - table["height"] / free_height(table)
    strength = measure_strength(table, 0.2)
    assert (strength.unconfined, strength.ratio) == (30, 0.3)
    assert strength.failure_strain == pytest.approx(0)
    table.loc[table["stage"] == Stage.CONSOLIDATION, "stress"] = 0
    with pytest.raises(ValueError, match="Raise consolidation"):
        free_height(table)
