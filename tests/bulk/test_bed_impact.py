# SPDX-License-Identifier: GPL-2.0-or-later
"""Shot on a plate and on a bed in the engine: each against the law, all against the ledger."""

from __future__ import annotations

import numpy as np
import pandas as pd
import pytest

from plastigran.bulk.decks.bed_impact import analyse, bed_count, check_settings
from plastigran.bulk.decks.bed_impact.measurement import (
    measure_shots,
    plastic_work_by_depth,
    read_grains_dump,
)
from plastigran.bulk.run import CheckError, finish, read_record, read_series, run_bulk
from plastigran.engine.deck import Settings, read_deck

#: Thirty-six shots on a plate, fast enough to be back soon.
PLATE = {"side": 6, "slowest": 0.1, "duration": 0.02, "rows": 40}
#: Sixteen on five layers of grains.
BED = {"target": "bed", "side": 4, "shot_layers": 1, "bed_layers": 5, "duration": 0.02, "rows": 40}


def settings(**changes) -> Settings:
    return read_deck("bed_impact", changes, ".").settings


@pytest.fixture(scope="module")
def plate(tmp_path_factory):
    """Folder of a run on the plate, whose checks have passed."""
    folder = tmp_path_factory.mktemp("bed_impact") / "plate"
    run_bulk("bed_impact", PLATE, folder, show=False)
    return folder


@pytest.fixture(scope="module")
def bed(tmp_path_factory):
    """Folder of a run on the bed, whose checks have passed."""
    folder = tmp_path_factory.mktemp("bed_impact") / "bed"
    run_bulk("bed_impact", BED, folder, show=False)
    return folder


def test_every_shot_rebounds_as_the_law_says(plate):
    """To 1e-4, a tenth of what the check allows: some hundred steps an impact."""
    checks = pd.read_csv(plate / "checks.csv").set_index("name")
    assert checks["passed"].all()
    assert checks.loc["restitution of a shot against the law's, relative", "value"] < 1e-4
    shot = measure_shots(read_grains_dump(plate / "grains.dump"), 1e-3, 0)
    # Speeds are spread, and the law's curve bends over them.
    speed = shot["impact_speed"]
    assert speed.min() < 0.25 and speed.max() > 0.85 and speed.between(0.1, 1).all()
    restitution = shot["rebound_speed"] / speed
    assert restitution[speed.idxmin()] - restitution[speed.idxmax()] > 0.1
    # What a shot loses is its plastic work.
    mass = 4 / 3 * np.pi * 1e-9 * 1500
    lost = 0.5 * mass * (speed**2 - shot["rebound_speed"] ** 2)
    assert shot["plastic_work"].to_numpy() == pytest.approx(lost, rel=1e-3)


def test_other_laws(tmp_path):
    """A closed form; and a viscous law, which loses what it loses without plastic work."""
    values = PLATE | {"side": 3, "dissipative_constant": 1e-5}
    run_bulk("bed_impact", values | {"law": "thornton"}, tmp_path / "thornton", show=False)
    viscous = values | {"law": "viscoelastic_hertz"}
    run_bulk("bed_impact", viscous, tmp_path / "viscous", show=False)
    shot = measure_shots(read_grains_dump(tmp_path / "viscous" / "grains.dump"), 1e-3, 0)
    assert (shot["rebound_speed"] < 0.95 * shot["impact_speed"]).all()


def test_another_yield_strength_is_noticed(plate, tmp_path):
    stronger = Settings(read_record(plate)["settings"] | {"yield_strength": "1.1e5"})
    with pytest.raises(CheckError, match="restitution of a shot against the law's"):
        finish(analyse(stronger, read_series(plate)), tmp_path)


def test_shot_that_is_late_is_noticed(tmp_path):
    with pytest.raises(CheckError, match=r"shots that have not left the plate [1-9]"):
        values = PLATE | {"duration": 0.004, "frames": 1}
        run_bulk("bed_impact", values, tmp_path / "run", show=False)
    assert list((tmp_path / "run" / "frames").glob("contacts_*.vtk"))


def test_bed_takes_what_the_plate_gives_back(bed):
    """Of the shot's energy next to nothing returns; plastic work lies near the surface."""
    grains = read_grains_dump(bed / "grains.dump")
    count = bed_count(read_record(bed)["settings"])
    assert len(grains) - count == 16
    shot = measure_shots(grains.iloc[count:], 1e-3, 9.81)
    assert (shot["rebound_speed"] ** 2).sum() < 0.1 * (shot["impact_speed"] ** 2).sum()
    # Each falls the radius to the surface under gravity.
    fallen = shot["impact_speed"] ** 2 - grains["vz_before"].iloc[count:] ** 2
    assert fallen.to_numpy() == pytest.approx(2 * 9.81 * 1e-3, rel=1e-6)
    surface = grains["z_before"].iloc[count:].min() - 2e-3
    work = plastic_work_by_depth(grains, surface, 2e-3)["plastic_work"]
    assert work.iloc[0] + work.iloc[1] > 0.8 * work.sum()
    assert work.iloc[-1] < 0.1 * work.max()


@pytest.mark.parametrize("target", ["plate", "bed"])
def test_restart(target, plate, bed, gone_on, tmp_path, request):
    """Gone on from a checkpoint; where the shot was and how fast comes along.

    On the plate to every digit. In the bed forces on a grain are summed in another order, which it
    multiplies: 1e-6 of the shot's speed and of the work.
    """
    whole = request.getfixturevalue(target)
    expected, found, _ = gone_on(whole, kept=2)
    before = read_grains_dump(whole / "grains.dump")
    after = read_grains_dump(tmp_path / "rest" / "grains.dump")
    if target == "plate":
        pd.testing.assert_frame_equal(after, before, check_exact=True)
    columns = ["z_before", "vz_before"]
    assert after[columns].to_numpy() == pytest.approx(before[columns].to_numpy(), rel=1e-12)
    assert after["vz"].to_numpy() == pytest.approx(before["vz"].to_numpy(), abs=1e-6)
    for name in ("plastic", "friction"):
        assert found[name].iloc[-1] == pytest.approx(expected[name].iloc[-1], rel=1e-6, abs=1e-18)


def test_ranks(plate, tmp_path):
    """Shot does not meet shot: 1 and 2 ranks agree to rounding, whatever the grains' numbers."""
    run_bulk("bed_impact", PLATE, tmp_path / "run", ranks=2, show=False)
    one, two = (
        measure_shots(read_grains_dump(folder / "grains.dump"), 1e-3, 0)
        .sort_values("impact_speed")
        .to_numpy()
        for folder in (plate, tmp_path / "run")
    )
    assert two == pytest.approx(one, rel=1e-9)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"target": "wall"}, "settings_wall.in, which is not there"),
        ({"law": "lim_stronge"}, "no law 'lim_stronge' for spheres"),
        ({"fastest": 0.01}, r"fastest is 0.01; it must lie between 0.05 and inf \[m/s\]"),
        ({"shot_layers": 2}, "shot_layers is 2; it must be 1 for target plate"),
        (
            {"gravitational_acceleration": 9.81},
            "gravitational_acceleration is 9.81; it must be 0 for target plate",
        ),
        ({"ledger": "off"}, "ledger is off"),
        ({"side": 1}, "side is 1; it must be 2 or more"),
        ({"options": "viscous_damping on"}, "viscous_damping on changes the restitution"),
        ({"target": "bed", "bed_layers": 0}, "bed_layers is 0; it must be 1 or more"),
        ({"rows": 10, "checkpoints": 3}, "checkpoints is 3; it must divide rows, 10"),
    ],
)
def test_impossible_settings_are_refused_before_anything_runs(change, said, tmp_path):
    with pytest.raises((ValueError, RuntimeError), match=said):
        run_bulk("bed_impact", change, tmp_path / "run", show=False)
    assert not (tmp_path / "run").exists()


def test_free_flight_is_taken_back():
    """A shot thrown up at 2 m/s from the surface, seen 0.1 m above it, left at 2 m/s; one below the
    surface, and one that lies on another, have not come back."""
    shot = pd.DataFrame({"z": [0.101, 0.0005, 0.003], "vz": [(4 - 0.2 * 9.81) ** 0.5, 0.0, 0.0]})
    shot = shot.assign(z_before=0.002, vz_before=-1.0, plastic_work=3.0, touching=[0, 1, 1])
    found = measure_shots(shot, 1e-3, 9.81)
    assert found["rebound_speed"].tolist() == pytest.approx([2, 0, 0])
    assert found["impact_speed"].tolist() == pytest.approx([(1 + 0.002 * 9.81) ** 0.5] * 3)
    assert found["plastic_work"].tolist() == [3, 3, 3]


def test_every_law_is_taken(sphere_law):
    check_settings(settings(law=sphere_law, dissipative_constant=1e-5))
