# SPDX-License-Identifier: GPL-2.0-or-later
"""Grains shot at a plate and at a bed in LIGGGHTS, compared with the law and the energy balance."""

from __future__ import annotations

import numpy as np
import pandas as pd
import pytest

from plastigran.bulk.decks.bed_impact.measurement import (
    measure_shots,
    plastic_work_by_depth,
    read_grains_dump,
)
from plastigran.bulk.run import run_bulk
from plastigran.cli import main

#: Settings of a very short run on the plate.
FEW = {"side": 3, "slowest": 0.1, "duration": 0.02, "rows": 40, "dissipative_constant": 1e-5}


@pytest.fixture(scope="module")
def plate(brief_run):
    return brief_run("bed_impact", "plate")


@pytest.fixture(scope="module")
def bed(brief_run):
    return brief_run("bed_impact", "bed")


def test_every_shot_rebounds_as_the_law_says(plate):
    """Restitution and plastic work of each shot follow the law; restitution agrees to 1e-4."""
    assert plate.passed
    checks = plate.checks.set_index("name")
    assert (
        checks.loc[
            "difference between the restitution of a shot and that of the law, relative", "value"
        ]
        < 1e-4
    )
    shot = measure_shots(read_grains_dump(plate.folder / "grains.dump"), 1e-3, 0)
    # The impact speeds are spread, and restitution decreases with speed.
    speed = shot["impact_speed"]
    assert speed.min() < 0.25 and speed.max() > 0.85 and speed.between(0.1, 1).all()
    restitution = shot["rebound_speed"] / speed
    assert restitution[speed.idxmin()] - restitution[speed.idxmax()] > 0.1
    # The kinetic energy that a shot loses equals its plastic work.
    mass = 4 / 3 * np.pi * 1e-9 * 1500
    lost = 0.5 * mass * (speed**2 - shot["rebound_speed"] ** 2)
    assert shot["plastic_work"].to_numpy() == pytest.approx(lost, rel=1e-3)


def test_viscous_law(tmp_path):
    """A viscous law dissipates energy without plastic work."""
    viscous = FEW | {"law": "viscoelastic_hertz"}
    run = run_bulk("bed_impact", viscous, tmp_path / "run", show=False)
    assert run.passed
    shot = run.deck.shots(read_grains_dump(run.folder / "grains.dump"))
    assert (shot["rebound_speed"] < 0.95 * shot["impact_speed"]).all()


def test_command_names_a_late_shot(tmp_path, capsys):
    """If a shot has not left the plate at the end, the command writes all results, then fails."""
    values = [f"{name}={value}" for name, value in (FEW | {"duration": 0.004}).items()]
    line = ["bulk", "bed_impact", "--output", str(tmp_path / "run"), "-v", *values]
    assert main(line) == 1
    output = capsys.readouterr()
    assert "shots that have not left the plate" in output.err and str(tmp_path) in output.err
    assert "NO  shots that have not left the plate: " in output.out
    assert (tmp_path / "run" / "checks.csv").exists()
    assert (tmp_path / "run" / "figures" / "bed_impact.png").exists()


def test_bed_absorbs_the_shots(bed):
    """Shots rebound from a bed with little energy; most plastic work is near its surface."""
    assert bed.passed
    grains = read_grains_dump(bed.folder / "grains.dump")
    count = int(bed.deck.derived("bed"))
    assert len(grains) - count == 16
    shot = measure_shots(grains.iloc[count:], 1e-3, 9.81)
    assert (shot["rebound_speed"] ** 2).sum() < 0.1 * (shot["impact_speed"] ** 2).sum()
    # Each shot starts one radius above the surface.
    fallen = shot["impact_speed"] ** 2 - grains["vz_before"].iloc[count:] ** 2
    assert fallen.to_numpy() == pytest.approx(2 * 9.81 * 1e-3, rel=1e-6)
    surface = grains["z_before"].iloc[count:].min() - 2e-3
    work = plastic_work_by_depth(grains, surface, 2e-3)["plastic_work"]
    assert work.iloc[0] + work.iloc[1] > 0.8 * work.sum()
    assert work.iloc[-1] < 0.1 * work.max()


def test_speeds_are_those_at_the_surface():
    """Impact and rebound speeds are those at the surface, corrected for gravity.

    The first shot is 0.1 m above the surface, and left it at 2 m/s. Shots that lie below the
    surface or on another shot have not rebounded.
    """
    shot = pd.DataFrame({"z": [0.101, 0.0005, 0.003], "vz": [(4 - 0.2 * 9.81) ** 0.5, 0.0, 0.0]})
    shot = shot.assign(z_before=0.002, vz_before=-1.0, plastic_work=3.0, touching=[0, 1, 1])
    measured = measure_shots(shot, 1e-3, 9.81)
    assert measured["rebound_speed"].tolist() == pytest.approx([2, 0, 0])
    assert measured["impact_speed"].tolist() == pytest.approx([(1 + 0.002 * 9.81) ** 0.5] * 3)
    assert measured["plastic_work"].tolist() == [3, 3, 3]
