# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the finite-element table of spheres, and of its computation with coarse meshes."""

from __future__ import annotations

import numpy as np
import pytest

from plastigran.fem.settings import Settings
from plastigran.fem.sphere.press import press
from plastigran.validation.spheres import table
from plastigran.validation.spheres.compute import rows
from plastigran.validation.spheres.figures import write
from plastigran.validation.spheres.forms import Constants, unloading_work
from plastigran.validation.spheres.metals import RADIUS, SphereMetal
from plastigran.validation.spheres.release import press_and_release

COARSE = Settings(divisions=3, fineness=0.5, growth=1.3, unloading_steps=8)
METAL = SphereMetal(1.2e-3, force_ratio_max=5.0)


@pytest.fixture(scope="module")
def released():
    return press_and_release(METAL.material, RADIUS, METAL.forces, COARSE)


def test_loading_continues_where_an_unloading_began(released):
    """Results with and without reloading agree to 2e-3, because reloading is almost elastic.

    `press_and_release` continues from the state before unloading; `press` reloads the sphere.
    """
    reloaded = press(METAL.material, RADIUS, METAL.forces, COARSE)
    assert not released.stopped
    assert len(released.unloadings) == len(METAL.forces)
    for name, values in reloaded.unloadings.items():
        scale = reloaded.unloadings["approach"] if name == "residual_approach" else values
        assert (np.abs(released.unloadings[name] - values) <= 2e-3 * scale).all(), name


def test_rows_are_those_of_the_table(released):
    """Results on a coarse mesh are within 5 % of the stored table for the same metal and forces."""
    computed, stored = rows(METAL, released), table()
    stored = stored[(stored["metal"] == METAL.name) & (stored["force_ratio"] < 5.5)]
    assert list(computed.columns) == list(stored.columns)
    for name in computed.columns.drop(["overlap_res_ratio"]):
        if computed[name].dtype == float:
            expected = pytest.approx(stored[name].to_numpy(), rel=0.05)
            assert computed[name].to_numpy() == expected, name


def test_rows_are_consistent():
    rows = table()
    assert (rows["overlap_res_ratio"] < rows["overlap_ratio"]).all()
    speed = np.sqrt(rows["work_loading_ratio"] / 0.4)
    assert rows["speed_ratio"].to_numpy() == pytest.approx(speed.to_numpy(), rel=1e-5)
    squared = rows["work_unloading_ratio"] / rows["work_loading_ratio"]
    assert rows["coefficient_of_restitution"].to_numpy() ** 2 == pytest.approx(
        squared.to_numpy(), rel=2e-5
    )


def test_work_of_unloading():
    """The work of unloading is correct for two limits of the constant g of the unloading curve.

    For g = 0, the curve is a power law with the exponent 3/2. For large g, it approaches a straight
    line.
    """
    assert unloading_work(np.array([0.0, 1e12])) == pytest.approx([0.4, 0.5], rel=1e-9)


def test_figures(tmp_path):
    files = write(Constants(), table(), tmp_path)
    assert sorted(path.name for path in files) == ["universal_errors.svg", "universal_fit.svg"]
