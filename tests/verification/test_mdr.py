# SPDX-License-Identifier: GPL-2.0-or-later
"""Zunker & Kamrin's law compared with LAMMPS' own `normal mdr`, and its energies."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from plastigran import laws
from plastigran.materials import RIGID

PRESSES = [
    pytest.param(table, id=f"{case[0]}-{case[2]:g}")
    for case, table in pd.read_csv(Path(__file__).parent / "mdr_lammps.csv", comment="#").groupby(
        ["geometry", "youngs_modulus", "yield_strength"]
    )
]


@pytest.mark.parametrize("table", PRESSES)
def test_force_is_lammps(table):
    """The force of `mdr` equals that of LAMMPS' own `normal mdr` along a path.

    The path is loading, partial unloading, further loading and unloading. Forces agree to a
    relative 1e-6, or to 1e-8 of the largest force near the end of unloading, where overlaps nearly
    cancel.
    """
    row = table.iloc[0]
    body = laws.Body(row["youngs_modulus"], row["poissons_ratio"], row["yield_strength"])
    two = row["geometry"] == "two_spheres"
    law = laws.Mdr(laws.combine(body, body if two else RIGID))
    radius_eff = row["radius"] / (2 if two else 1)
    found = law.follow(radius_eff, table["overlap"].to_numpy())["force"]
    expected = table["force"].to_numpy()
    assert (expected == 0).sum() > 5 and expected.max() > 10 * expected[3]
    assert found == pytest.approx(expected, rel=1e-6, abs=1e-8 * expected.max())


def test_energy_guard_acts_just_beyond_yield(paper_pair):
    """Between 1 and 1.14 overlaps at yield, the plastic work of the published law decreases by up
    to 6 %, and the energy guard keeps it constant. For larger overlaps, both are equal.
    """
    guarded, published = (laws.Mdr(paper_pair, energy_guard=word) for word in ("on", "off"))
    overlap = np.linspace(0.95, 1.5, 1101) * 7.0925e-6
    kept = guarded.follow(0.1, overlap)["plastic_work"]
    lost = published.follow(0.1, overlap)["plastic_work"]
    assert (np.diff(kept) >= -1e-13 * kept.max()).all()
    falls = np.diff(lost) < 0
    assert overlap[:-1][falls].max() < 1.15 * 7.0925e-6
    assert lost[1:][falls].min() == pytest.approx(0.94 * lost[:-1][falls].max(), rel=0.01)
    beyond = overlap > 1.15 * 7.0925e-6
    assert kept[beyond] == pytest.approx(lost[beyond], rel=1e-12)
