# SPDX-License-Identifier: GPL-2.0-or-later
"""The cooling gas in the engine: mean field, the elastic limit, ranks."""

from __future__ import annotations

import numpy as np
import pandas as pd
import pytest

from plastigran.bulk.decks.cooling_gas import (
    analyse,
    check_settings,
    read_case,
    stored_share,
)
from plastigran.bulk.run import CheckError, finish, read_record, read_series, run_bulk
from plastigran.engine.deck import Settings, read_deck

SMALL = {"side": 6, "duration": 40, "rows": 40, "checkpoints": 4}


@pytest.fixture(scope="module")
def yielding_gas(tmp_path_factory):
    """Folder of a run of 216 grains that cool fourfold."""
    folder = tmp_path_factory.mktemp("cooling_gas") / "run"
    run_bulk("cooling_gas", SMALL, folder, show=False)
    return folder


def settings(**changes) -> Settings:
    return Settings(read_deck("cooling_gas", changes, ".").settings)


def test_follows_mean_field(yielding_gas):
    """Within 8 % for mean field and four standard deviations, while it cools by more than that."""
    checks = pd.read_csv(yielding_gas / "checks.csv")
    assert checks["passed"].all()
    series = pd.read_csv(yielding_gas / "series.csv")
    assert series["temperature"].iloc[-1] < 0.4 * series["temperature"].iloc[0]
    assert series["collisions"].iloc[-1] > 15
    for name in ("cooling_gas", "ledger"):
        assert (yielding_gas / "figures" / f"{name}.png").read_bytes().startswith(b"\x89PNG")
    assert (yielding_gas / "figures" / "cooling_gas.png").read_bytes().startswith(b"\x89PNG")


def test_viscoelastic_gas(tmp_path):
    """Its dissipation begins at step 0 too, not while the grains mix; one that never stalls."""
    values = {"law": "viscoelastic_hertz", "dissipative_constant": 1e-7, "timestep": 7e-8}
    values |= {"side": 6, "duration": 10, "rows": 10, "checkpoints": 1}
    table = run_bulk("cooling_gas", values, tmp_path / "run", show=False).table
    assert table["temperature"].iloc[0] == pytest.approx(16, rel=0.02)  # less what impacts store
    assert table["temperature"].iloc[-1] < 0.8 * table["temperature"].iloc[0]


def test_ledger_tells_where_the_energy_went(yielding_gas):
    """What the gas has lost is plastic work, to the drift the checks allow."""
    series = pd.read_csv(yielding_gas / "series.csv")
    first, last = series.iloc[0], series.iloc[-1]
    lost = first["kinetic"] + first["elastic"] - last["kinetic"] - last["elastic"]
    assert last["plastic"] - first["plastic"] == pytest.approx(lost, rel=2e-3)
    assert lost > 0.5 * first["kinetic"]


def test_another_yield_strength_is_noticed(yielding_gas, tmp_path):
    """The check fails for the same run held against bodies half as strong again."""
    harder = read_record(yielding_gas)["settings"] | {"yield_strength": "2.85e9"}
    analysis = analyse(Settings(harder), read_series(yielding_gas))
    with pytest.raises(CheckError, match="temperature against mean field"):
        finish(analysis, tmp_path)


def test_grains_that_leave_are_noticed(yielding_gas, tmp_path):
    series = read_series(yielding_gas)
    series.loc[3, "atoms"] -= 1
    with pytest.raises(CheckError, match="grains lost or gained 1, at most 0"):
        finish(analyse(read_record(yielding_gas)["settings"], series), tmp_path)


def test_unyielding_gas_is_the_engines_hertz(tmp_path):
    """Yield strength without end: energy stays, and the gas moves as with stock hertz.

    1e-9 over the first impacts: rounding, tenfold an impact. Later the two gases differ in what
    impacts under way store, 0.4 % of the energy: four deviations of the difference of two means of
    10 rows, 0.7 %.
    """
    runs = {}
    for law in ("hertz", "vu_quoc_zhang"):
        values = {"law": law, "yield_strength": 1e18, "mixing": 0.1, "side": 5, "ledger": "off"}
        values |= {"duration": 10, "rows": 20, "checkpoints": 1}
        run_bulk("cooling_gas", values, tmp_path / law, show=False)  # its checks: energy stays
        runs[law] = read_series(tmp_path / law)["kinetic_energy"].to_numpy()
    stock, ours = runs.values()
    assert np.ptp(stock[:6]) > 1e-4 * stock[0], "no impact yet"
    assert ours[:6] == pytest.approx(stock[:6], rel=1e-9)
    assert ours[10:].mean() == pytest.approx(stock[10:].mean(), rel=7e-3)


def test_ranks(tmp_path):
    """One gas on 1 and 2 ranks: the first impacts alike to 1e-9, the course to its statistics.

    1e-9: sums in another order, tenfold an impact.
    """
    values = {"side": 5, "mixing": 0.1, "duration": 16, "rows": 32, "checkpoints": 1}
    runs = []
    for ranks in (1, 2):
        run_bulk("cooling_gas", values, tmp_path / str(ranks), ranks=ranks, show=False)
        log = (tmp_path / str(ranks) / "log.liggghts").read_text()
        assert f"on {ranks} procs for" in log
        runs.append(pd.read_csv(tmp_path / str(ranks) / "series.csv"))
    one, two = (run["kinetic_energy"].to_numpy() for run in runs)
    assert one[4] < 0.95 * one[0], "no impacts yet"
    assert two[:5] == pytest.approx(one[:5], rel=1e-9)
    # Two independent gases once they have parted: sqrt(2) of one's error, four times, and what
    # impacts under way store.
    case = read_case(settings(**values))
    error = 4 * 2**0.5 * runs[0]["temperature_error"].to_numpy()
    assert (np.abs(two / one - 1) < error + stored_share(case, case.gas())).all()


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"law": "lim_stronge"}, "no law 'lim_stronge' for spheres; there are brake_2012"),
        ({"volume_fraction": 0.5}, r"volume_fraction is 0.5; it must lie between 0 and 0.494"),
        ({"temperature": -1}, r"temperature is -1; it must lie between 0 and inf \[m\^2/s\^2\]"),
        ({"side": 2}, "side is 2; it must be 3 or more"),
        ({"radius": "big"}, r"radius is 'big', not a number \[m\]"),
        ({"material": "cheese"}, "includes .*cheese.in, which is not there"),
        ({"yield_strength": -1e9}, r"yield_strength is -1000000000.0; it must lie between 0"),
        ({"law": "viscoelastic_hertz"}, "dissipative_constant"),
        ({"rows": 10, "checkpoints": 3}, "checkpoints is 3; it must divide rows, 10"),
        ({"options": "viscous_damping on"}, "viscous_damping on changes the restitution"),
        ({"law": "hertz"}, "ledger is on; the engine's own hertz keeps none"),
        ({"options": "viscous"}, "options is 'viscous'; it must be pairs"),
        ({"colour": "red"}, "has no setting 'colour'; it takes law options side"),
    ],
)
def test_impossible_settings_are_refused_before_anything_runs(change, said, tmp_path):
    with pytest.raises((ValueError, RuntimeError), match=said):
        run_bulk("cooling_gas", change, tmp_path / "run", show=False)
    assert not (tmp_path / "run").exists()


def test_options_reach_the_theory():
    """Options of the law change its restitution; settings of the model that do not are let be."""
    taken = read_case(settings(law="stronge", options="unloading area energy_ledger on"))
    assert taken.grains.options == {"unloading": "area"}
    book, area = (
        read_case(settings(law="stronge", options=options)).gas().loss(16.0)
        for options in ("", "unloading area")
    )
    assert area < 0.9 * book


def test_every_law_is_taken(sphere_law):
    check_settings(settings(law=sphere_law, material="ice", timestep=1e-6))
