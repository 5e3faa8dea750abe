# SPDX-License-Identifier: GPL-2.0-or-later
"""The rotating drum in the engine: angle of repose, lever arm, moving shell, ranks."""

from __future__ import annotations

from dataclasses import replace

import pandas as pd
import pytest

from plastigran.bulk.decks.drum import LEVER_ARM, analyse, power_checks, read_case
from plastigran.bulk.run import CheckError, finish, read_record, read_series, run_bulk
from plastigran.engine.deck import Settings

#: A drum ten grains wide with some hundred of them, turning fast: so it flows evenly.
SMALL = {"drum_radius": 0.05, "length": 0.03, "froude": 0.05, "duration": 0.9, "settling": 0.3}
SMALL |= {"checkpoints": 2}
#: As long as the grains take to fall, with the shell and its frames.
SHORT = SMALL | {"duration": 0.05, "settling": 0, "rows": 12, "checkpoints": 4, "frames": 12}


@pytest.fixture(scope="module")
def turned(tmp_path_factory):
    """Folder of a run over some turns of the bed."""
    folder = tmp_path_factory.mktemp("drum") / "run"
    run_bulk("drum", SMALL, folder, show=False)
    return folder


@pytest.fixture(scope="module")
def begun(tmp_path_factory):
    """Folder of a short run, its end not steady."""
    folder = tmp_path_factory.mktemp("drum") / "run"
    with pytest.raises(CheckError):
        run_bulk("drum", SHORT, folder, show=False)
    return folder


def settings(folder, **changes) -> Settings:
    return Settings(read_record(folder)["settings"] | changes)


def test_bed_leans_and_the_wall_carries_its_weight(turned):
    checks = pd.read_csv(turned / "checks.csv")
    assert checks["passed"].all()
    series = pd.read_csv(turned / "series.csv")
    assert 25 < series.query("revolutions > 0.3")["angle"].mean() < 40
    assert series["plastic"].iloc[-1] > 0.05 * series["wallwork"].iloc[-1]
    for name in ("drum", "ledger"):
        assert (turned / "figures" / f"{name}.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize("change", [{"froude": "0.051"}, {"gravitational_acceleration": "9.9"}])
def test_another_weight_or_speed_is_noticed(change, turned, tmp_path):
    """The wall's work is held against both: a hundredth off in either is seen."""
    with pytest.raises(CheckError, match="wall work off the weight's lever arm"):
        finish(analyse(settings(turned, **change), read_series(turned)), tmp_path)


def test_missing_dissipation_is_noticed(turned):
    """Without the plastic work the bed takes less than the wall gives."""
    series = pd.read_csv(turned / "series.csv").query("revolutions > 0.3")
    case = read_case(settings(turned))
    assert all(check.passed for check in power_checks(case, series, series))
    taken, lever = power_checks(case, series, series.assign(plastic=0.0))
    assert lever.passed and not taken.passed


def test_fewer_rows_make_the_lever_arm_no_tighter_than_its_trapezia(turned, tmp_path):
    """Every thirty-second row: trapezia miss 3e-3 of the work, more than half overlaps do."""
    sparse = read_series(turned).iloc[::32].reset_index(drop=True)
    case = read_case(settings(turned))
    analysis = analyse(settings(turned), sparse)
    lever = analysis.checks[-1]
    assert "lever arm" in lever.name and lever.passed
    assert LEVER_ARM < lever.value
    rolling = power_checks(replace(case, rolling_friction=True), analysis.table, analysis.table)
    assert not any("lever arm" in check.name for check in rolling)


def test_angle_rises_with_friction(turned, tmp_path):
    run_bulk("drum", SMALL | {"coefficient_of_friction": 0.15}, tmp_path / "smooth", show=False)
    smooth, rough = (
        pd.read_csv(folder / "series.csv").query("revolutions > 0.3")["angle"].mean()
        for folder in (tmp_path / "smooth", turned)
    )
    assert smooth < rough - 5


def test_restart_continues_bed_and_shell(begun, gone_on, tmp_path):
    """Gone on from the second checkpoint of four: bed, ledger and shell to rounding
    of sums: grains come out of the file in another order. 1e-10: the bed multiplies it."""
    expected, found, _ = gone_on(begun, kept=2, steady=False)
    last = expected["step"].iloc[-1]
    # These two are what rounding leaves of the sums.
    difference = (found - expected).drop(columns=["drift", "inserted"]).abs()
    assert (difference <= 1e-10 * expected.abs().max()[difference.columns]).all(axis=None)
    frames = [
        (folder / "frames" / f"mesh_{step}.vtk").read_bytes()
        for folder, step in ((begun, 0), (begun, last), (tmp_path / "rest", last))
    ]
    assert frames[1] == frames[2]
    assert frames[0] != frames[1], "the shell does not turn"


def test_ranks(begun, tmp_path):
    """One bed on 1 and 2 ranks until impacts have multiplied rounding: 1e-9 in its fall."""
    with pytest.raises(CheckError):
        run_bulk("drum", SHORT, tmp_path / "two", ranks=2, show=False)
    one, two = (read_series(folder).iloc[:4] for folder in (begun, tmp_path / "two"))
    assert two["atoms"].tolist() == one["atoms"].tolist()
    for name in ("kinetic", "gravity"):
        assert two[name].to_numpy() == pytest.approx(one[name].to_numpy(), rel=1e-9)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"froude": 1.2}, "froude is 1.2; it must lie between 0 and 1"),
        ({"drum_radius": 0.02}, r"drum_radius is 0.02; it must lie between 0.023 and inf \[m\]"),
        ({"length": 0.01}, r"length is 0.01; it must lie between 0.023 and 0.1 \[m\]"),
        ({"size_spread": 0.6}, "size_spread is 0.6; it must lie between"),
        ({"settling": 0.8}, "settling is 0.8; it must lie between"),
        ({"settling": 0.74}, r"settling is 0.74; it must be 0.7375 \[revolutions\] or less"),
        ({"rows": 9, "checkpoints": 1}, "rows is 9; it must be 10 or more"),
        ({"bed_height": 2}, "bed_height is 2; it must lie between -0.8 and 0.8"),
        ({"rows": 20, "checkpoints": 3}, "checkpoints is 3; it must divide rows, 20"),
        ({"law": "hertz"}, "ledger is on; the engine's own hertz keeps none"),
        ({"coefficient_of_friction": -0.1}, "coefficient_of_friction is -0.1; it must lie"),
    ],
)
def test_impossible_settings_are_refused_before_anything_runs(change, said, tmp_path):
    with pytest.raises(ValueError, match=said):
        run_bulk("drum", change, tmp_path / "run", show=False)
    assert not (tmp_path / "run").exists()
