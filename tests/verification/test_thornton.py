# SPDX-License-Identifier: GPL-2.0-or-later
"""Thornton's law, compared with its closed forms."""

from __future__ import annotations

import numpy as np
import pytest

from plastigran import laws
from plastigran.physics import central


def thornton_restitution(speed_ratio: float) -> float:
    """Return the restitution at `speed_ratio` times the yield speed (Thornton 1997, J. Appl. Mech.
    64:383, eq. 25).
    """
    q = 1 / max(speed_ratio, 1)
    return (
        np.sqrt(6 * np.sqrt(3) / 5)
        * np.sqrt(1 - q**2 / 6)
        * (q / (q + 2 * np.sqrt(6 / 5 - q**2 / 5))) ** 0.25
    )


def test_restitution_closed_form(paper_pair, paper_mass):
    """Restitution follows the closed form to a relative 1e-9, which is the round-off of the closed
    form near yield.
    """
    law = laws.Thornton(paper_pair)
    scale = central.yield_speed(paper_pair, 0.1, paper_mass)
    for ratio in [0.5, 0.99, 1.001, *np.geomspace(1.01, 1e4, 40)]:
        found = law.central_impact(0.1, paper_mass, ratio * scale).coefficient_of_restitution
        assert found == pytest.approx(thornton_restitution(ratio), rel=1e-9)


def test_yield_speed_constant(paper_pair, paper_mass):
    """The yield speed is 3.194 (p_y^5 R*^3/(E*^4 m*))^(1/2) with the yield pressure p_y.

    For the sphere of Zhang & Vu-Quoc (2002), it is 1.66963e-3 m/s.
    """
    p, e = paper_pair.yield_pressure, paper_pair.youngs_modulus_eff
    found = central.yield_speed(paper_pair, 0.1, paper_mass)
    assert found == pytest.approx(3.193847 * np.sqrt(p**5 * 0.1**3 / (e**4 * paper_mass)), rel=1e-6)
    assert found == pytest.approx(1.66963e-3, rel=5e-6)
