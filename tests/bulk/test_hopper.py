# SPDX-License-Identifier: GPL-2.0-or-later
"""The hopper in the engine: Beverloo's law, its ledger, the elastic limit, ranks, restart."""

from __future__ import annotations

import shutil

import numpy as np
import pandas as pd
import pytest

from plastigran.bulk.checks import energy_input
from plastigran.bulk.decks.hopper import analyse, orifices, read_case, since_opening
from plastigran.bulk.run import CheckError, finish, read_record, read_series, run_bulk
from plastigran.engine.checkpoints import newest_checkpoint, step_of
from plastigran.engine.deck import Settings, read_deck
from plastigran.engine.log import read_thermo
from plastigran.engine.process import run_deck

#: 2080 grains, half of them out in half a second.
SMALL = {"orifice": 8, "layers": 10, "timestep": 1.5e-5, "duration": 0.7, "rows": 150}
SMALL |= {"filling": 0.2, "checkpoints": 1}
#: 416 grains, for what needs no steady discharge.
FEW = {"orifice": 8, "layers": 2, "timestep": 2e-5, "duration": 0.5, "rows": 24}
FEW |= {"filling": 0.12, "checkpoints": 6}


@pytest.fixture(scope="module")
def discharged(tmp_path_factory):
    """Folder of a run that is half out."""
    folder = tmp_path_factory.mktemp("hopper") / "run"
    run_bulk("hopper", SMALL, folder, show=False)
    return folder


def settings_of(folder, **changes) -> Settings:
    return Settings(read_record(folder)["settings"] | changes)


def test_discharge_follows_beverloo(discharged):
    """The ledger over filling and discharge, grains counted, and the rate are within their bounds,
    and the discharge is steady: its rate is known to 5 %."""
    checks = pd.read_csv(discharged / "checks.csv").set_index("name")
    assert checks["passed"].all() and len(checks) == 5
    assert any("Beverloo" in name for name in checks.index)
    series = pd.read_csv(discharged / "series.csv")
    found = read_case(settings_of(discharged)).discharge(series)
    assert found.rate_error < 0.05 * found.rate
    assert series["counted"].iloc[-1] > 0.5 * series["atoms"].iloc[0]
    # Spheres at rest: from loose with much friction to dense, some hundredths denser for softness.
    assert 0.54 < series["packing"].iloc[0] < 0.67
    assert (discharged / "figures" / "hopper.png").read_bytes().startswith(b"\x89PNG")


def test_deleted_grains_leave_the_ledger(discharged):
    """Each takes the energy it has at the orifice, where height is zero: that of a free fall from
    somewhere within an orifice's diameter above, as Beverloo's law has it."""
    series = pd.read_csv(discharged / "series.csv")
    gone = series["atoms"].iloc[0] - series["atoms"].iloc[-1]
    assert gone > 100
    case = read_case(settings_of(discharged))
    weight = case.grains.mass * case.gravitational_acceleration
    assert 0 < -series["inserted"].iloc[-1] / gone / weight < case.orifice


@pytest.mark.parametrize(
    "change",
    [
        {"orifice": "6"},
        {"gravitational_acceleration": "3.5"},
        {"gravitational_acceleration": "16"},
    ],
)
def test_another_hopper_is_noticed(change, discharged, tmp_path):
    """The check fails for the run held against an orifice two grains narrower, 2.8 times less
    weight or 1.6 times more: near the edges of its band."""
    analysis = analyse(settings_of(discharged, **change), read_series(discharged))
    with pytest.raises(CheckError, match="discharge rate beyond Beverloo's law"):
        finish(analysis, tmp_path)


def test_a_rate_that_falls_is_noticed(discharged, tmp_path):
    """1.6 times as fast until 0.37 of the grains are out, about half of the steady part: the rate
    in the mean is still in Beverloo's band."""
    series = since_opening(read_series(discharged))
    time, counted = series["time"], series["counted"]
    turn = time[counted < 0.37 * series["atoms"].iloc[0]].iloc[-1]
    then = np.where(time < turn / 1.6, 1.6 * time, time + turn - turn / 1.6)
    faster = np.interp(then, time, counted).round()
    changed = series.assign(counted=faster, held=series["atoms"].iloc[0] - faster)
    with pytest.raises(CheckError, match=r"^change of the rate from half to half [^;]*$"):
        finish(analyse(settings_of(discharged), changed), tmp_path)


def test_a_grain_through_the_mesh_is_noticed(discharged, tmp_path):
    series = read_series(discharged)
    series.loc[40:, "held"] -= 1
    with pytest.raises(CheckError, match="neither in the hopper nor counted out 1, at most 0"):
        finish(analyse(settings_of(discharged), series), tmp_path)


def filling(folder, ranks: int = 1, **changes) -> pd.DataFrame:
    """The log of the first 30 ms of 416 grains: impacts between all of them and on the cone."""
    values = FEW | {"filling": 0.03, "duration": 0.01, "rows": 4, "checkpoints": 1} | changes
    run_deck("bulk/hopper.in", values, folder, ranks)
    log = read_thermo(folder / "log.liggghts")
    return log[log["run"] == log["run"].min()].set_index("step")


def test_ranks(tmp_path):
    """One filling on 1, 2 and 4 ranks, its first impacts alike to 1e-9: sums in another order,
    tenfold an impact."""
    runs = [filling(tmp_path / str(ranks), ranks) for ranks in (1, 2, 4)]
    early = runs[0].index <= 1000
    for entry in ("kinetic", "plastic", "friction"):
        for run in runs[1:]:
            assert run[entry][early].to_numpy() == pytest.approx(
                runs[0][entry][early].to_numpy(), rel=1e-9, abs=1e-20
            )
    assert runs[0]["plastic"][early].max() > 1e-3 * runs[0]["kinetic"].iloc[0]


def test_unyielding_grains_are_the_engines_hertz(tmp_path):
    """Yield strength without end, with dashpots and friction: as stock hertz that does not pull, to
    1e-9 over the first impacts, in which the dashpots already tell."""
    damped = {"yield_strength": 1e18, "coefficient_of_restitution": 0.5, "ledger": "off"}
    options = {"hertz": "limitForce on", "thornton": "viscous_damping on"}

    def early(name: str, law: str, **changes) -> np.ndarray:
        values = damped | {"law": law, "options": options[law]} | changes
        return filling(tmp_path / name, **values)["kinetic"].loc[:1000].to_numpy()

    stock = early("hertz", "hertz")
    assert early("thornton", "thornton") == pytest.approx(stock, rel=1e-9)
    undamped = early("undamped", "hertz", coefficient_of_restitution=1)
    assert undamped[-1] > 1.001 * stock[-1]


@pytest.fixture(scope="module")
def restarted(tmp_path_factory):
    """Makes a run and one that goes on from its newest checkpoint, a third before its end."""

    def make(**changes) -> tuple[pd.DataFrame, pd.DataFrame, int]:
        folder = tmp_path_factory.mktemp("restart")
        whole, cut, rest = (folder / name for name in ("whole", "cut", "rest"))
        run_bulk("hopper", FEW | changes, whole, show=False)
        shutil.copytree(whole, cut)
        *before, last, _ = (whole / "log.liggghts").read_text().split("Loop time")
        kept = "".join(last.splitlines(keepends=True)[:-8])
        (cut / "log.liggghts").write_text("Loop time".join([*before, kept]))
        run_bulk("hopper", {}, rest, restart=cut, show=False)
        return read_series(whole), read_series(rest), step_of(newest_checkpoint(cut))

    return make


def test_restart_continues_the_same_trajectory(restarted):
    """Without friction, every digit: grains, mesh contacts, counter."""
    expected, found, checkpoint = restarted(tangential="off")
    assert expected["step"].iloc[0] < checkpoint < expected["step"].iloc[-1]
    assert expected["counted"].iloc[-1] > 10
    columns = ["step", "time", "atoms", "held", "counted", "kinetic", "gravity", "elastic"]
    assert (found[columns] == expected[columns]).all(axis=None)


def test_restart_with_friction(restarted):
    """Springs between grains, the law's memory and the ledger go on too. 1e-10: a grain's forces
    are summed in another order, and the bed multiplies rounding; a step lost of them costs 1e-4."""
    expected, found, _ = restarted()
    came_in = energy_input(expected)
    for entry in ("kinetic", "elastic", "plastic", "friction", "springs", "drift"):
        assert found[entry].to_numpy() == pytest.approx(
            expected[entry].to_numpy(), abs=1e-10 * came_in
        )


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"orifice": 9}, "orifice is 9; there are hoppers of 5, 6, 7, 8"),
        ({"layers": 21}, "layers is 21; the barrel takes 20"),
        ({"layers": 0}, "layers is 0; it must be 1 or more"),
        ({"law": "hertz"}, "ledger is on; .*ledger=off"),
        ({"law": "lim_stronge"}, "no law 'lim_stronge' for spheres"),
        ({"gravitational_acceleration": 0}, "gravitational_acceleration is 0; it must lie between"),
        ({"filling": 0}, r"filling is 0; it must lie between 0 and inf \[s\]"),
        ({"duration": -1}, "duration is -1; it must lie between 0 and inf"),
        ({"coefficient_of_friction": -0.1}, "coefficient_of_friction is -0.1"),
        ({"rows": 10, "checkpoints": 3}, "checkpoints is 3; it must divide rows, 10"),
        ({"frames": -1}, "frames is -1; it must be 0 or more"),
    ],
)
def test_impossible_settings_are_refused_before_anything_runs(change, said, tmp_path):
    with pytest.raises((ValueError, RuntimeError), match=said):
        run_bulk("hopper", change, tmp_path / "run", show=False)
    assert not (tmp_path / "run").exists()


def test_meshes_come_along():
    """Every orifice has its mesh among the files that are copied beside a run."""
    for orifice in orifices():
        files = read_deck("hopper", {"orifice": orifice}, ".").files
        assert {f"hopper_{orifice}.stl", "plate.stl"} <= {file.name for file in files}
