# SPDX-License-Identifier: GPL-2.0-or-later
"""Flow down a chute in LIGGGHTS: steady flow, power of gravity, Bagnold's velocity profile."""

from __future__ import annotations

import numpy as np
import pandas as pd
import pytest
from bulk_settings import STEADY_FLOWS

from plastigran.bulk.decks.chute import WEIGHT
from plastigran.bulk.run import run_bulk
from plastigran.bulk.series import read_series
from plastigran.engine.dumps import read_dump
from plastigran.physics.bagnold import fit_profile


@pytest.fixture(scope="module")
def flowed(steady_flow):
    """A flow that has become steady."""
    return steady_flow("chute")


@pytest.fixture
def steady(flowed):
    """Rows of the series after settling."""
    return flowed.series[flowed.series["time"] > 0.8]


def test_flow_has_bagnolds_profile_and_dissipates_the_power_of_the_weight(flowed, steady):
    assert flowed.passed
    # A lattice cell contains two grains. The fixed base is one cell deep, the flow nine.
    assert flowed.deck.derived("grains") == 2 * 5 * 4 * (9 + 1)
    assert steady["speed"].min() > 0.05
    work = steady[["plastic", "friction"]].iloc[-1] - steady[["plastic", "friction"]].iloc[0]
    assert (work > 0.03 * work.sum()).all()


def test_missing_dissipation_is_noticed(flowed, steady):
    """If friction work is missing, the check of dissipation against the power of gravity fails."""
    weight, dissipation = flowed.deck.power_checks(flowed.series, steady.assign(friction=0.0))
    assert weight.passed and not dissipation.passed


def test_fewer_rows_widen_the_limit_of_the_weight(flowed):
    """The check of the work of gravity allows for the error of its integral over time.

    With output rows 0.06 s apart, the trapezoidal rule has an error of 5e-3 of the work.
    """
    sparse = read_series(flowed.folder).iloc[::12].reset_index(drop=True)
    weight = flowed.deck.analyse(sparse).checks[-2]
    assert "work of gravity" in weight.name and weight.passed
    assert weight.value > WEIGHT


def test_flow_that_stops_is_noticed(tmp_path):
    """A check fails if the flow stops: an incline far below the friction angle stops it."""
    settings = STEADY_FLOWS["chute"] | {"angle": 12, "duration": 1.2}
    run = run_bulk("chute", settings, tmp_path / "run", show=False)
    assert any("mean speed / smallest speed" in check.name for check in run.analysis.failed)


def test_glued_base_stays(flowed):
    """The fixed base, two layers of grains, stays in place while the other grains flow."""
    frames = read_dump(flowed.folder / "grains.dump").set_index("id")
    first, last = (frames[frames["step"] == step] for step in frames["step"].agg(["min", "max"]))
    base = last[(last[["vx", "vy", "vz"]] == 0).all(axis="columns")]
    assert len(base) == 2 * 5 * 4
    assert (first.loc[base.index, ["x", "y", "z"]] == base[["x", "y", "z"]]).all(axis=None)
    assert flowed.series["speed"].iloc[-1] > 0.1


@pytest.mark.parametrize(("power", "fits"), [(1.5, True), (0.5, False), (3.0, False)])
def test_profile_differs_from_others(power, fits):
    """Bagnold's profile fits a flow with p = 3/2, but not flows with other powers p.

    Grains at height z in a flow of depth h have a speed proportional to h^p - (h - z)^p. The
    relative tolerance is 0.01, because the fit sorts heights into bins and takes the depth from
    their mean.
    """
    height = np.linspace(0, 0.1, 4001)[1:]
    flow = pd.DataFrame({"z": height, "vx": 1 - (1 - height / 0.1) ** power + 1e-9})
    base = pd.DataFrame({"z": [-0.006, 0.0, -0.006, 0.0], "vx": 0.0})
    grains = pd.concat([base, flow]).assign(vy=0.0, vz=0.0, radius=0.005)
    profile = fit_profile(grains, 0.01)
    assert profile.depth == pytest.approx(0.1, rel=0.01)
    if fits:
        assert profile.residual < 0.01
        assert profile.surface_speed == pytest.approx(1, rel=0.01)
    else:
        assert profile.residual > 0.03
