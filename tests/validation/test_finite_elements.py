# SPDX-License-Identifier: GPL-2.0-or-later
"""How far the laws are from the paper's finite elements: stated errors, not tolerances to meet.

The errors are those of the table in docs/choose_a_law.md, which rounds them to 0.1 %.
"""

from __future__ import annotations

import re

import pytest

from plastigran import laws
from plastigran.engine.process import PROJECT
from plastigran.experiments.central.figures import finite_elements

PAPER = finite_elements().set_index("speed")
SPEEDS = (0.02, 0.10, 0.20)
STATED = {
    law: [float(error) / 100 for error in re.findall(r"([+-][\d.]+) %", line)]
    for law, line in re.findall(
        r"^\| `(\w+)` ((?:\| [+-][\d.]+ % ){4})\|$",
        (PROJECT / "docs" / "choose_a_law.md").read_text(),
        re.MULTILINE,
    )
}


def test_the_table_is_found():
    assert len(STATED) > 5
    assert set(STATED) <= set(laws.LAWS)


@pytest.mark.parametrize("law", STATED)
def test_stated_errors(law, paper_pair, paper_mass):
    impacts = [laws.LAWS[law](paper_pair).central_impact(0.1, paper_mass, v) for v in SPEEDS]
    errors = [
        impact.force_max / PAPER["force_max"][speed] - 1
        for impact, speed in zip(impacts, SPEEDS, strict=True)
    ]
    paper = PAPER["coefficient_of_restitution"][SPEEDS[-1]]
    errors.append(impacts[-1].coefficient_of_restitution / paper - 1)
    assert errors == pytest.approx(STATED[law], abs=5.5e-4)
