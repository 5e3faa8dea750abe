# SPDX-License-Identifier: GPL-2.0-or-later
"""The law `universal`, compared with its equations, and properties that they guarantee."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from plastigran import laws
from plastigran.materials import RIGID
from plastigran.validation.spheres import table
from plastigran.validation.spheres.fit import fit
from plastigran.validation.spheres.forms import Metals, peak
from plastigran.validation.spheres.metals import METALS, SphereMetal

RADIUS = 0.01


def yield_overlap(pair: laws.MaterialPair) -> float:
    return RADIUS * laws.yield_radius_ratio(pair) ** 2


def test_the_compiled_law_has_the_equations_of_the_fit():
    """The compiled law agrees with the Python equations of its fit, to round-off.

    Both are separate code. They are compared for every metal of the table, also for hardening and
    large a/R.
    """
    constants = fit(table())
    for _, rows in table().groupby("metal"):
        pair = SphereMetal.of(rows.iloc[0]).pair
        overlap_y = yield_overlap(pair)
        force_y = 4 / 3 * pair.youngs_modulus_eff * np.sqrt(RADIUS) * overlap_y**1.5
        overlap = np.geomspace(1.01, 500, 50)
        computed = laws.Universal(pair).follow(RADIUS, overlap * overlap_y)
        expected = peak(constants, Metals.of(rows.iloc[:1]), np.sqrt(overlap))
        assert computed["force"] / force_y == pytest.approx(expected.force, rel=1e-12)
        stored = computed["elastic_energy"] / (force_y * overlap_y)
        assert stored == pytest.approx(expected.work_unloading, rel=1e-11)


def test_force_and_slope_are_continuous_at_yield():
    pair = METALS["s0.0012-nu0.3-H0.05"].pair
    for step in (1e-3, 1e-4):
        overlap = yield_overlap(pair) * np.array([1 - step, 1.0, 1 + step])
        force = laws.Universal(pair).follow(RADIUS, overlap)["force"]
        below, above = np.diff(force) / (force[1] * step)
        assert below == pytest.approx(1.5, abs=0.5 * step)  # Hertz: d ln F / d ln d
        assert above == pytest.approx(1.5, abs=0.5 * step)


@pytest.mark.parametrize("yield_strength_ratio", [1e-6, 1e-3, 0.05, 0.3])
@pytest.mark.parametrize("poissons_ratio", [0.0, 0.3, 0.4999])
def test_force_and_plastic_work_never_decrease_during_loading(yield_strength_ratio, poissons_ratio):
    """Force and plastic work of `universal` never decrease during loading, up to d = 2 R.

    Restitution is therefore at most 1 at any speed. d is the overlap, and R the radius.
    """
    for slope, mirrored in product((0.0, 0.01, 0.2, 0.999), (False, True)):
        body = laws.Body(7e10, poissons_ratio, yield_strength_ratio * 7e10, 0, slope * 7e10)
        pair = laws.combine(body, body if mirrored else RIGID)
        overlap = np.geomspace(0.5 * yield_overlap(pair), 2 * RADIUS, 3000)
        response = laws.Universal(pair).follow(RADIUS, overlap)
        assert (np.diff(response["force"]) >= 0).all()
        work = response["plastic_work"]
        total = work + response["elastic_energy"]
        assert (np.diff(work) >= -1e-13 * total[1:]).all()  # round-off
        assert (work >= -1e-13 * total).all()
