# SPDX-License-Identifier: GPL-2.0-or-later
"""The chute in the engine: steady flow, weight's power, Bagnold's profile, ranks."""

from __future__ import annotations

import numpy as np
import pandas as pd
import pytest

from plastigran.bulk.decks.chute import WEIGHT, analyse, power_checks, read_case
from plastigran.bulk.run import CheckError, finish, read_record, read_series, run_bulk
from plastigran.engine.deck import Settings
from plastigran.physics.bagnold import fit_profile

#: Some hundred grains, six cells deep, for as long as it takes to show a mean.
SMALL = {
    "length": 4,
    "width": 3,
    "depth": 6,
    "duration": 0.9,
    "settling": 0.4,
    "start_speed": 0.9,
    "angle": 26,
}
SMALL |= {"rows": 180, "checkpoints": 4}
#: Some rows from the start.
SHORT = SMALL | {"duration": 0.06, "settling": 0, "rows": 12}


@pytest.fixture(scope="module")
def flowed(tmp_path_factory):
    """Folder of a flow that has come to its speed."""
    folder = tmp_path_factory.mktemp("chute") / "run"
    run_bulk("chute", SMALL, folder, show=False)
    return folder


def begin(folder, **changes):
    """A short run, whose end is not steady."""
    with pytest.raises(CheckError):
        run_bulk("chute", SHORT | changes, folder, show=False)
    return read_series(folder)


def settings(folder, **changes) -> Settings:
    return Settings(read_record(folder)["settings"] | changes)


def test_flows_with_bagnolds_profile_and_dissipates_what_weight_gives(flowed):
    checks = pd.read_csv(flowed / "checks.csv")
    assert checks["passed"].all()
    series = pd.read_csv(flowed / "series.csv")
    steady = series[series["time"] > 0.4]
    assert steady["speed"].min() > 0.05
    taken = steady[["plastic", "friction"]].iloc[-1] - steady[["plastic", "friction"]].iloc[0]
    assert (taken > 0.03 * taken.sum()).all()
    for name in ("chute", "ledger"):
        assert (flowed / "figures" / f"{name}.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize("change", [{"angle": "26.5"}, {"gravitational_acceleration": "9.9"}])
def test_another_weight_is_noticed(change, flowed, tmp_path):
    with pytest.raises(CheckError, match="weight's work off that of the centre of mass"):
        finish(analyse(settings(flowed, **change), read_series(flowed)), tmp_path)


def test_missing_dissipation_is_noticed(flowed):
    """Without friction the flow takes a fraction of what weight gives."""
    series = pd.read_csv(flowed / "series.csv")
    steady = series[series["time"] > 0.4]
    case = read_case(settings(flowed))
    assert all(check.passed for check in power_checks(case, series, steady))
    weight, taken = power_checks(case, series, steady.assign(friction=0.0))
    assert weight.passed and not taken.passed


def test_fewer_rows_leave_the_weight_its_trapezia(flowed):
    """Every fourth row, 0.02 s: trapezia miss 4e-3 of the work, as they may."""
    sparse = read_series(flowed).iloc[::4].reset_index(drop=True)
    weight = analyse(settings(flowed), sparse).checks[-2]
    assert "weight's work" in weight.name and weight.passed
    assert weight.value > WEIGHT


def test_flow_that_stops_is_noticed(tmp_path):
    """Far below the angle of friction it comes to rest."""
    with pytest.raises(CheckError, match="mean over least speed of the flow"):
        run_bulk("chute", SMALL | {"angle": 12, "duration": 0.6}, tmp_path / "run", show=False)


@pytest.mark.parametrize(("power", "fits"), [(1.5, True), (0.5, False), (3.0, False)])
def test_profile_is_told_from_others(power, fits):
    """Grains at every height with speed h^p - (h - z)^p: only p = 3/2 is Bagnold's.

    0.01: heights are taken in bins, and the depth from their mean.
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


def test_restart_continues_the_flow(gone_on, tmp_path):
    """Gone on from the second checkpoint of four: grains and ledger to rounding
    of sums: grains come out of the file in another order. 1e-10: the bed multiplies it."""
    begin(tmp_path / "whole")
    expected, found, _ = gone_on(tmp_path / "whole", kept=2, steady=False)
    # These two are what rounding leaves of the sums.
    difference = (found - expected).drop(columns=["drift", "inserted"]).abs()
    assert (difference <= 1e-10 * expected.abs().max()[difference.columns]).all(axis=None)


def test_ranks_and_glued_base(tmp_path):
    """One flow on 1 and 2 ranks to 1e-9 before its first impacts; the base stays where it is."""
    one, two = begin(tmp_path / "one"), None
    with pytest.raises(CheckError):
        run_bulk("chute", SHORT, tmp_path / "two", ranks=2, show=False)
    two = read_series(tmp_path / "two")
    assert two["atoms"].tolist() == one["atoms"].tolist()
    for name in ("kinetic", "gravity", "z"):
        assert two[name].iloc[:2].to_numpy() == pytest.approx(
            one[name].iloc[:2].to_numpy(), rel=1e-9
        )


def test_stock_hertz_flows_without_a_ledger(tmp_path):
    series = begin(tmp_path / "run", law="hertz", ledger="off")
    assert series["speed"].iloc[-1] > 0.1 and series["kinetic"].iloc[-1] > 0
    assert not (tmp_path / "run" / "figures" / "ledger.png").exists()
    names = pd.read_csv(tmp_path / "run" / "checks.csv")["name"]
    assert not names.str.contains("ledger|power").any()


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"angle": 95}, r"angle is 95; it must lie between 0 and 90 \[degrees\]"),
        ({"length": 2}, "length is 2; it must be 3 or more"),
        ({"depth": 4.5}, "depth is '4.5', not a whole number"),
        ({"size_spread": 0.5}, "size_spread is 0.5; it must lie between"),
        ({"settling": 3}, "settling is 3; it must lie between"),
        ({"settling": 2.36}, r"settling is 2.36; it must be 2.35 \[s\] or less"),
        ({"rows": 9, "checkpoints": 1}, "rows is 9; it must be 10 or more"),
        ({"start_speed": -1}, "start_speed is -1; it must lie between"),
        ({"rows": 20, "checkpoints": 3}, "checkpoints is 3; it must divide rows, 20"),
        ({"law": "hertz"}, "ledger is on; the engine's own hertz keeps none"),
    ],
)
def test_impossible_settings_are_refused_before_anything_runs(change, said, tmp_path):
    with pytest.raises(ValueError, match=said):
        run_bulk("chute", change, tmp_path / "run", show=False)
    assert not (tmp_path / "run").exists()
