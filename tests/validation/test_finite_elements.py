# SPDX-License-Identifier: GPL-2.0-or-later
"""How far the laws are from the paper's finite elements: stated errors, not tolerances to meet.

Each bound is the error found, rounded up; docs/laws quote the same figures.
"""

from __future__ import annotations

import pytest

from plastigran import laws
from plastigran.figures import finite_elements

PAPER = finite_elements().set_index("speed")


@pytest.mark.parametrize(
    ("law", "speed", "error"),
    [
        ("vu_quoc_zhang", 0.02, -0.020),
        ("vu_quoc_zhang", 0.10, 0.121),
        ("vu_quoc_zhang", 0.20, 0.246),
        ("thornton", 0.02, -0.262),
        ("thornton", 0.10, -0.390),
        ("thornton", 0.20, -0.429),
    ],
)
def test_peak_force(law, speed, error, paper_pair, paper_mass):
    found = laws.LAWS[law](paper_pair).central_impact(0.1, paper_mass, speed).force_max
    assert found / PAPER["force_max"][speed] - 1 == pytest.approx(error, abs=5e-4)


@pytest.mark.parametrize(("law", "error"), [("vu_quoc_zhang", -0.184), ("thornton", -0.389)])
def test_restitution_at_120_times_the_yield_speed(law, error, paper_pair, paper_mass):
    found = laws.LAWS[law](paper_pair).central_impact(0.1, paper_mass, 0.2)
    paper = PAPER["coefficient_of_restitution"][0.2]
    assert found.coefficient_of_restitution / paper - 1 == pytest.approx(error, abs=5e-4)
