# SPDX-License-Identifier: GPL-2.0-or-later
"""Thornton's law, compared with its closed forms."""

from __future__ import annotations

import numpy as np
import pytest

from plastigran import laws
from plastigran.physics import central


def test_restitution_closed_form(paper_pair, paper_mass):
    """Restitution follows the closed form to a relative 1e-9, its round-off near yield."""
    law = laws.Thornton(paper_pair)
    scale = central.yield_speed(paper_pair, 0.1, paper_mass)
    for ratio in [0.5, 0.99, 1.001, *np.geomspace(1.01, 1e4, 40)]:
        found = law.central_impact(0.1, paper_mass, ratio * scale).coefficient_of_restitution
        assert found == pytest.approx(float(central.thornton_restitution(ratio)), rel=1e-9)


def test_yield_speed_constant(paper_pair, paper_mass):
    """The yield speed is 3.194 (p_y^5 R*^3/(E*^4 m*))^(1/2), and 1.66963e-3 m/s for the paper's
    sphere."""
    p, e = paper_pair.yield_pressure, paper_pair.youngs_modulus_eff
    found = central.yield_speed(paper_pair, 0.1, paper_mass)
    assert found == pytest.approx(3.193847 * np.sqrt(p**5 * 0.1**3 / (e**4 * paper_mass)), rel=1e-6)
    assert found == pytest.approx(1.66963e-3, rel=5e-6)


def test_slope_is_continuous_at_yield(paper_pair):
    """dF/d(overlap) = pi p_y R* on both sides. The relative tolerance is 1e-5, because the slope is
    a difference between points 2e-6 of the overlap apart."""
    law = laws.Thornton(paper_pair)
    overlap_y = 0.1 * laws.yield_radius_ratio(paper_pair) ** 2

    def slope(overlap):
        step = 1e-6 * overlap_y
        force = [law.respond(0.1, overlap + k * step, laws.Thornton.State()).force for k in (-1, 1)]
        return (force[1] - force[0]) / (2 * step)

    expected = np.pi * paper_pair.yield_pressure * 0.1
    assert slope(overlap_y * (1 - 2e-6)) == pytest.approx(expected, rel=1e-5)
    assert slope(overlap_y * (1 + 2e-6)) == pytest.approx(expected, rel=1e-5)


def test_contact_radius(paper_pair):
    """a^2 = R* overlap during first loading; during unloading, the area falls linearly to zero."""
    law, state = laws.Thornton(paper_pair), laws.Thornton.State()
    overlap = 30 * 0.1 * laws.yield_radius_ratio(paper_pair) ** 2
    peak = law.respond(0.1, overlap, state)
    assert peak.contact_radius == pytest.approx(np.sqrt(0.1 * overlap), rel=1e-13)
    recovery = 3 * peak.force / (4 * paper_pair.youngs_modulus_eff * peak.contact_radius)
    for x in (0.9, 0.5, 0.1):
        found = law.respond(0.1, overlap - (1 - x) * recovery, state)
        assert found.contact_radius == pytest.approx(peak.contact_radius * np.sqrt(x), rel=1e-9)
        assert found.force == pytest.approx(peak.force * x**1.5, rel=1e-9)
