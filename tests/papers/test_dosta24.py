# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the benchmarks of Dosta et al. 2024: the published data, and small versions."""

from __future__ import annotations

import numpy as np
import pandas as pd
import pytest

from plastigran.bulk.decks.ball_impact import STEEL
from plastigran.bulk.outcome import open_run
from plastigran.papers import find_paper
from plastigran.papers.dosta24 import impact
from plastigran.papers.dosta24.published import drum, eight_codes, silo
from plastigran.papers.dosta24.silo import RATES, whole_rate


def test_published_impact_has_the_printed_ranges():
    """The lowest and the highest displacement of the ball among the eight codes are as printed.

    The data file and the paper agree at 30, 50 and 100 ms. The displacements are in mm.
    """
    printed = {0.03: (-136.7, -136.0), 0.05: (-115.1, -108.5), 0.1: (-67.5, -44.1)}
    for time, expected in printed.items():
        means = [
            1e3 * code.loc[code["time"].sub(time).abs().idxmin(), "displacement"]
            for code in eight_codes().values()
        ]
        # The printed displacements are rounded to 0.1 mm.
        assert [min(means), max(means)] == pytest.approx(expected, abs=0.2)


def test_published_ball_falls_freely_onto_the_bed():
    """Before the contact at 21 ms, the published ball falls freely, within 0.1 mm.

    It starts at 5 m/s and accelerates at 9.81 m/s^2.
    """
    for code in [*eight_codes().values()]:
        early = code[(code["time"] > 0) & (code["time"] < 0.02)]
        time = early["time"]
        assert (early["displacement"] + 5 * time + 9.81 / 2 * time**2).abs().max() < 1e-4


def test_published_silo_discharges_at_the_printed_rate():
    """The mean discharge rate of the published silo data agrees with the paper within 5 %.

    The rates of the codes differ by 5 %. Rates are in thousand grains per second.
    """
    for orifice, expected in RATES.items():
        for table in silo(orifice).values():
            assert table["held"].iloc[0] == 100000
            assert whole_rate(table) == pytest.approx(expected, rel=0.05)


def test_an_empty_silo_has_the_rate_until_it_is_empty():
    """The mean discharge rate covers only the time until the silo is empty.

    100 000 grains leave the silo at 1000 per second. It is empty after 100 s; later values do not
    change the rate.
    """
    time = np.arange(0, 130.0, 0.9)
    held = np.maximum(100000 - 1000 * time, 0)
    table = pd.DataFrame({"time": time, "held": held})
    assert whole_rate(table) == pytest.approx(1.0, rel=1e-9)
    assert whole_rate(table[table["time"] < 50]) == pytest.approx(1.0, rel=1e-9)


def test_published_drum_begins_half_in_zone_2():
    """At the start of the published drum data, half of the grains are in zone 2, none in zone 1.

    Zone 2 is x < 0, z < 0; zone 1 is x > 0, z > 0.
    """
    start = drum()["MUSEN"].iloc[0]
    assert start[["small_1", "large_1"]].tolist() == [0, 0]
    # Half of 30000 and of 8000 grains, within the scatter of random positions.
    assert abs(start["small_2"] - 15000) < 3 * np.sqrt(30000) / 2
    assert abs(start["large_2"] - 4000) < 3 * np.sqrt(8000) / 2


def test_free_flight_continues_a_run(coarse):
    """After the end of a run, the position of the ball is known only if the ball flies freely.

    The free flight then continues the run. For a ball in the bed, the position is NaN.
    """
    run = open_run(coarse("dosta24") / "impact_800_hertz_1" / "part_1")
    end = run.series["time"].iloc[-1]
    assert np.isnan(impact.displacement_at(2 * end, run))
    last, step = run.series.index[-1], run.series["time"].diff().iloc[-1]
    run.series.loc[last - 1 :, "velocity"] = [2.0 + 9.81 * step, 2.0]
    later = 0.02
    flown = impact.displacement_at(end + later, run) - run.series["displacement"].iloc[-1]
    assert flown == pytest.approx(2 * later - 9.81 / 2 * later**2, rel=1e-9)
    assert np.isnan(impact.displacement_at(end + 0.3, run))  # the ball would fall again


def test_small_cases(coarse, coarse_table):
    """Small versions of the three benchmarks run, and their results satisfy simple bounds."""
    deck = open_run(coarse("dosta24") / "impact_800_thornton_1" / "part_1").deck
    depth = coarse_table("dosta24", "impact").set_index("quantity").loc["largest depth"]
    to_floor = -1e3 * (deck.ball_height - deck.ball_radius)
    to_bed = -1e3 * (deck.ball_height - deck.ball_radius - deck.bed_height)
    for law in ("hertz", "thornton"):  # the ball enters the bed and does not pass the floor
        assert 1.01 * to_floor < depth[law] < to_bed - 2 * 1e3 * deck.radius
    energies = coarse_table("dosta24", "impact_energies").iloc[0]
    # The energy input is the kinetic energy of the ball plus its weight times the depth. The bed
    # settles, which adds some energy.
    mass = 4 / 3 * np.pi * deck.ball_radius**3 * STEEL
    brought = mass * (deck.ball_speed**2 / 2 + 9.81 * -depth["thornton"] / 1e3)
    assert brought * 0.99 < energies["energy (J)"] < brought * 1.2
    assert energies["plastic, %"] > 5 and energies["friction, %"] > 5
    assert (coarse("dosta24") / "impact.png").is_file()
    # By Beverloo's law, the rate grows by more than the ratio of the orifice areas.
    rates = coarse_table("dosta24", "silo_rates").set_index("orifice")["hertz"].dropna()
    assert rates["large"] > (3 / 2) ** 2 * rates["small"] > 0
    for case in ("silo", "drum"):
        energies = coarse_table("dosta24", f"{case}_energies").iloc[0]
        assert energies["plastic, %"] > 1 and energies["friction, %"] > 1
    # The rotation carries the 250 small grains from zone 2 to the rising side.
    series = open_run(coarse("dosta24") / "drum_coarse_hertz_1" / "part_1").series
    assert 50 < series["small_2"].iloc[-1] < series["small_2"].iloc[0]


def test_options_of_other_papers_and_cases_are_refused():
    with pytest.raises(ValueError, match=r"--grains is an option of --case impact"):
        find_paper("dosta24", case="drum", grains=100)
    with pytest.raises(ValueError, match=r"silo and drum run only in LIGGGHTS\. Add --case impact"):
        find_paper("dosta24", case="silo", host="lammps")
    with pytest.raises(ValueError, match=r"zv02 has no --case\. Remove --case"):
        find_paper("zv02", case="impact")
