# SPDX-License-Identifier: GPL-2.0-or-later
"""How the table of spheres is made, with coarse finite elements."""

from __future__ import annotations

import numpy as np
import pytest

from plastigran.fem.settings import Settings
from plastigran.fem.sphere.press import press
from plastigran.validation.spheres import table
from plastigran.validation.spheres.compute import rows
from plastigran.validation.spheres.figures import write
from plastigran.validation.spheres.forms import Constants, unloading_work
from plastigran.validation.spheres.metals import METALS, RADIUS, SphereMetal
from plastigran.validation.spheres.release import press_and_release

COARSE = Settings(divisions=3, fineness=0.5, growth=1.3, unloading_steps=8)
METAL = SphereMetal(1.2e-3, force_ratio_max=5.0)


@pytest.fixture(scope="module")
def released():
    return press_and_release(METAL.material, RADIUS, METAL.forces, COARSE)


def test_loading_goes_on_where_a_release_began(released):
    """As if it were pressed again: reloading is elastic up to the force reached, so both agree
    within the tolerance of Newton's method and what little flows on the way."""
    again = press(METAL.material, RADIUS, METAL.forces, COARSE)
    assert not released.stopped
    assert len(released.unloadings) == len(METAL.forces)
    for name, values in again.unloadings.items():
        scale = again.unloadings["approach"] if name == "residual_approach" else values
        assert (np.abs(released.unloadings[name] - values) <= 2e-3 * scale).all(), name


def test_rows_are_those_of_the_table(released):
    """The same metal and forces; coarse elements are within 5 % in what the table holds."""
    found, kept = rows(METAL, released), table()
    kept = kept[(kept["metal"] == METAL.name) & (kept["force_ratio"] < 5.5)]
    assert list(found.columns) == list(kept.columns)
    for name in found.columns.drop(["overlap_res_ratio"]):
        if found[name].dtype == float:
            assert found[name].to_numpy() == pytest.approx(kept[name].to_numpy(), rel=0.05), name


def test_rows_are_consistent():
    rows = table()
    assert (rows["overlap_res_ratio"] < rows["overlap_ratio"]).all()
    speed = np.sqrt(rows["work_loading_ratio"] / 0.4)
    assert rows["speed_ratio"].to_numpy() == pytest.approx(speed.to_numpy(), rel=1e-5)
    squared = rows["work_unloading_ratio"] / rows["work_loading_ratio"]
    assert rows["coefficient_of_restitution"].to_numpy() ** 2 == pytest.approx(
        squared.to_numpy(), rel=2e-5
    )
    assert len({metal.name for metal in METALS}) == len(METALS)


def test_work_of_unloading():
    """A power 3/2 for g = 0, a straight line for g without end."""
    assert unloading_work(np.array([0.0, 1e12])) == pytest.approx([0.4, 0.5], rel=1e-9)


def test_figures(tmp_path):
    files = write(Constants(), table(), tmp_path)
    assert sorted(path.name for path in files) == ["universal_errors.svg", "universal_fit.svg"]
