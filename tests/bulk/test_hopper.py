# SPDX-License-Identifier: GPL-2.0-or-later
"""The hopper in LIGGGHTS: Beverloo's law, energy balance, elastic limit, restart."""

from __future__ import annotations

import numpy as np
import pytest

from plastigran.bulk.decks.hopper import orifices
from plastigran.bulk.run import run_bulk
from plastigran.engine.deck import read_deck
from plastigran.engine.log import read_thermo
from plastigran.engine.process import run_deck


@pytest.fixture(scope="module")
def discharged(steady_flow):
    """A run in which half of the grains flow out."""
    return steady_flow("hopper")


def test_discharge_follows_beverloo(discharged):
    """Energy balance, number of grains and rate are within their limits. The discharge is steady:
    its rate has an error below 5 %."""
    assert discharged.passed and len(discharged.checks) == 5
    assert any("Beverloo" in name for name in discharged.checks["name"])
    series = discharged.series
    discharge = discharged.deck.discharge(series)
    assert discharge.rate_error < 0.05 * discharge.rate
    assert series["counted"].iloc[-1] > 0.5 * series["atoms"].iloc[0]
    # Packing of spheres at rest, from loose (high friction) to dense; soft grains overlap, which
    # adds some hundredths.
    assert 0.54 < series["packing"].iloc[0] < 0.67


def test_deleted_grains_leave_the_energy_balance(discharged):
    """A deleted grain removes its energy at the orifice (height zero). It is at most that of a free
    fall from one orifice diameter above, as in Beverloo's law."""
    series, deck = discharged.series, discharged.deck
    gone = series["atoms"].iloc[0] - series["atoms"].iloc[-1]
    assert gone > 100
    weight = deck.grains.mass * deck.gravitational_acceleration
    assert 0 < -series["inserted"].iloc[-1] / gone / weight < 8 * 2 * deck.radius


def test_a_rate_that_falls_is_noticed(discharged):
    """The discharge is 1.6 times as fast for about half of the steady part; its mean rate is still
    in Beverloo's band."""
    series = discharged.series
    time, counted = series["time"], series["counted"]
    turn = time[counted < 0.37 * series["atoms"].iloc[0]].iloc[-1]
    then = np.where(time < turn / 1.6, 1.6 * time, time + turn - turn / 1.6)
    faster = np.interp(then, time, counted).round()
    changed = series.assign(counted=faster, held=series["atoms"].iloc[0] - faster)
    (check,) = discharged.deck.analyse(changed).failed
    assert check.name.startswith("change of the rate between the halves")


def test_unyielding_grains_equal_stock_hertz(tmp_path):
    """With a huge yield strength, dashpots and friction, `thornton` agrees with `hertz` and
    limitForce to 1e-9 in the first impacts. The dashpots already have an effect in them."""
    damped = {"yield_strength": 1e18, "coefficient_of_restitution": 0.5, "ledger": "off"}
    few = {"orifice": 8, "layers": 2, "timestep": 2e-5, "filling": 0.02, "duration": 0.01}
    few |= {"rows": 4, "checkpoints": 1}
    options = {"hertz": "limitForce on", "thornton": "viscous_damping on"}

    def early(name: str, law: str, **changes) -> np.ndarray:
        """Return the kinetic energy of 416 grains in the first steps; all of them collide."""
        values = few | damped | {"law": law, "options": options[law]} | changes
        run_deck("bulk/hopper.in", values, tmp_path / name)
        log = read_thermo(tmp_path / name / "log.liggghts")
        return log[log["step"] <= 1000]["kinetic"].to_numpy()

    stock = early("hertz", "hertz")
    assert early("thornton", "thornton") == pytest.approx(stock, rel=1e-9)
    undamped = early("undamped", "hertz", coefficient_of_restitution=1)
    assert undamped[-1] > 1.001 * stock[-1]


def test_restart_without_friction_is_bitwise_identical(tmp_path, brief_run):
    """Grains, mesh contacts and grain counter continue from the last checkpoint but one."""
    settings = {**brief_run("hopper").deck.briefs[""].settings, "tangential": "off"}
    whole = run_bulk("hopper", settings, tmp_path / "whole", show=False)
    rest = run_bulk("hopper", {}, tmp_path / "rest", restart=whole.folder, show=False)
    assert whole.series["counted"].iloc[-1] > 10
    columns = ["step", "time", "atoms", "held", "counted", "kinetic", "gravity", "elastic"]
    assert (rest.series[columns] == whole.series[columns]).all(axis=None)


def test_unmeasured_rate_gives_a_note(discharged, brief_run):
    run = brief_run("hopper")
    assert "the discharge rate was not measured" in run.notes[0]
    assert "not all measured" in repr(run) and not run.checks["name"].str.contains("rate").any()
    assert not discharged.notes and "not all" not in repr(discharged)


def test_meshes_are_files_of_the_deck():
    """The mesh of every orifice is copied to the results."""
    for orifice in orifices():
        files = read_deck("hopper", {"orifice": orifice}, ".").files
        assert {f"hopper_{orifice}.stl", "plate.stl"} <= {file.name for file in files}
