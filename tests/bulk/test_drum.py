# SPDX-License-Identifier: GPL-2.0-or-later
"""The rotating drum in LIGGGHTS: angle of repose, torque of the weight, moving shell."""

from __future__ import annotations

import shutil

import attrs
import numpy as np
import pandas as pd
import pytest
from bulk_settings import STEADY_FLOWS
from matplotlib.colors import to_rgba

from plastigran.bulk.decks.drum import LEVER_ARM, Drum
from plastigran.bulk.outcome import BulkRun
from plastigran.bulk.run import run_bulk
from plastigran.bulk.series import read_series
from plastigran.engine.checkpoints import checkpoints, step_of
from plastigran.engine.spectra import QUANTITIES, read_spectra


@pytest.fixture(scope="module")
def turned(steady_flow):
    """A run of the drum over 0.9 revolutions, in which the flow becomes steady."""
    return steady_flow("drum")


def mean_angle(run) -> float:
    return run.series.query("revolutions > 0.3")["angle"].mean()


def test_bed_leans_and_the_wall_carries_its_weight(turned):
    assert turned.passed
    assert 25 < mean_angle(turned) < 40
    assert turned.series["plastic"].iloc[-1] > 0.05 * turned.series["wallwork"].iloc[-1]


def test_missing_dissipation_is_noticed(turned):
    """If plastic work is missing, the check of dissipation against the work of the wall fails."""
    steady = turned.series.query("revolutions > 0.3")
    dissipation, lever = turned.deck.power_checks(steady, steady.assign(plastic=0.0))
    assert lever.passed and not dissipation.passed


def test_fewer_rows_widen_the_limit_of_the_lever_arm(turned):
    """The check of the torque of the weight allows for the error of the trapezoidal rule.

    With every 32nd row, this error is 3e-3 of the work, which exceeds the usual limit LEVER_ARM.
    """
    sparse = read_series(turned.folder).iloc[::32].reset_index(drop=True)
    analysis = turned.deck.analyse(sparse)
    lever = analysis.checks[-1]
    assert "weight's torque" in lever.name and lever.passed
    assert LEVER_ARM < lever.value
    rolling = attrs.evolve(turned.deck, rolling_friction="cdt")
    checks = rolling.power_checks(analysis.series, analysis.series)
    assert not any("weight's torque" in check.name for check in checks)


def test_angle_rises_with_friction(turned, tmp_path):
    settings = STEADY_FLOWS["drum"] | {"coefficient_of_friction": 0.15}
    smooth = run_bulk("drum", settings, tmp_path / "smooth", show=False)
    assert smooth.passed
    assert mean_angle(smooth) < mean_angle(turned) - 5


@pytest.fixture(scope="module")
def begun(bulk_run) -> BulkRun:
    """Short run of the drum, with collision spectra."""
    return bulk_run("drum", {**Drum.briefs[""].settings, "frames": 2, "spectra": "on"})


@pytest.fixture(scope="module")
def rest(begun, tmp_path_factory) -> BulkRun:
    """Continuation of the run `begun` from the last checkpoint before its end."""
    folder = tmp_path_factory.mktemp("drum")
    shutil.copytree(begun.folder, folder / "earlier")
    *_, before_end, end = checkpoints(folder / "earlier")
    end.unlink()
    run = run_bulk("drum", {}, folder / "rest", restart=folder / "earlier", show=False)
    assert 0 < step_of(before_end) < run.series["step"].iloc[-1]
    return run


def test_impacts_before_a_checkpoint_are_counted_after_it(begun, rest):
    """The collision spectra of a continued run include the impacts before its checkpoint.

    They equal the spectra of the uninterrupted run, except for impacts whose energy is round-off:
    the two runs differ by 1e-14. The figure shows every impact whose value exceeds round-off.
    """

    def above(round_off: float, table: pd.DataFrame) -> pd.DataFrame:
        largest = table.groupby("quantity")["upper"].transform("max")
        return table[table["lower"] > round_off * largest].reset_index(drop=True)

    spectra = [read_spectra(run.folder / "collision_spectra.csv") for run in (begun, rest)]
    assert spectra[0]["step"].nunique() > 1
    pd.testing.assert_frame_equal(*(above(1e-12, table) for table in spectra), rtol=1e-9)
    counted = above(np.finfo(float).eps, spectra[1])
    for axes, quantity in zip(rest.figures["collision_spectra"].axes, QUANTITIES, strict=True):
        partners = {to_rgba(line.get_color()): line.get_label() for line in axes.lines}
        drawn = {partners[s.get_edgecolor()]: np.nansum(s.get_data().values) for s in axes.patches}
        for partner in partners.values():
            chosen = (counted["with"] == partner) & (counted["quantity"] == quantity)
            assert drawn.get(partner, 0) == counted[chosen]["count"].sum()
        assert {line.get_label() for line in axes.lines} == {*spectra[1]["with"]} >= {"particle"}


def test_shell_turns_on_after_a_restart(begun, rest):
    """The shell of the drum continues to turn after a restart.

    The last frames of its mesh are identical in both runs, and differ from the first frame.
    """
    last = begun.series["step"].iloc[-1]
    frames = [
        (folder / "frames" / f"mesh_{step}.vtk").read_bytes()
        for folder, step in ((begun.folder, 0), (begun.folder, last), (rest.folder, last))
    ]
    assert frames[1] == frames[2]
    assert frames[0] != frames[1], "the shell does not turn"
