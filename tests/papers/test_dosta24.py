# SPDX-License-Identifier: GPL-2.0-or-later
"""Benchmark of Dosta et al. 2024: published data, and small versions of the cases."""

from __future__ import annotations

import numpy as np
import pandas as pd
import pytest

from plastigran.papers import find_paper
from plastigran.papers.dosta24 import impact
from plastigran.papers.dosta24.published import eight_codes, reruns


def test_published_impact_has_the_printed_ranges():
    """The lowest and highest means of eight codes at 30, 50 and 100 ms [mm] are those of the
    paper."""
    printed = {0.03: (-136.7, -136.0), 0.05: (-115.1, -108.5), 0.1: (-67.5, -44.1)}
    for time, expected in printed.items():
        means = [
            1e3 * code.loc[code["time"].sub(time).abs().idxmin(), "mean"]
            for code in eight_codes().values()
        ]
        # Means of one column may differ from the printed ones by the rounding to 0.1 mm.
        assert [min(means), max(means)] == pytest.approx(expected, abs=0.2)


def test_published_ball_falls_freely_onto_the_bed():
    """Before the contact at 21 ms, the ball falls at 5 m/s and 9.8 m/s^2, to 0.1 mm."""
    for code in [*eight_codes().values()]:
        early = code[(code["time"] > 0) & (code["time"] < 0.02)]
        time = early["time"]
        assert (early["mean"] + 5 * time + 9.81 / 2 * time**2).abs().max() < 1e-4
    assert reruns(100000)["MUSEN"]["displacement"].iloc[-1] == pytest.approx(-0.0908, abs=5e-4)


def test_free_flight_continues_a_run():
    time = np.linspace(0, 0.04, 41)
    series = pd.DataFrame(
        {"time": time, "displacement": 2 * time - 4.905 * time**2, "velocity": 2 - 9.81 * time}
    )
    assert impact.displacement_at(0.1, series) == pytest.approx(0.2 - 0.04905, rel=1e-12)
    assert np.isnan(impact.displacement_at(0.1, series.assign(velocity=-1.0)))


def test_small_cases(coarse, coarse_table):
    """Small versions of the cases run, and the energy terms in their tables add up."""
    depth = coarse_table("dosta24", "impact").set_index("time (ms)")["thornton"]
    assert depth["largest depth"] < -10  # the bed begins 20 mm below the ball's surface
    energies = coarse_table("dosta24", "impact_energies").iloc[0]
    shares = energies.filter(like=", %")
    assert shares.sum() == pytest.approx(100, abs=1e-6) and (shares >= -1e-9).all()
    assert energies["plastic, %"] > 5 and energies["friction, %"] > 5
    assert (coarse("dosta24") / "impact.png").is_file()


def test_options_of_other_papers_are_refused():
    with pytest.raises(ValueError, match=r"zv02 has no --case\. Remove --case"):
        find_paper("zv02", case="impact")
