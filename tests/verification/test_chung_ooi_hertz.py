# SPDX-License-Identifier: GPL-2.0-or-later
"""For bodies that do not yield, the laws give the same benchmark impacts of Chung & Ooi (2011) as
LIGGGHTS' own hertz.
"""

from __future__ import annotations

import numpy as np
import pytest
from attrs import astuple, evolve
from chung_ooi_cases import few, middles, steps
from elastic_contact import NOT_HERTZIAN

from plastigran import laws
from plastigran.engine.dumps import read_dump
from plastigran.engine.process import run_deck
from plastigran.experiments.chung_ooi import BenchmarkImpact
from plastigran.experiments.chung_ooi.comparison import motion
from plastigran.usable_laws import laws_for

LAW = "vu_quoc_zhang"
#: Laws that yield, and that equal LIGGGHTS' hertz for bodies that do not yield.
HERTZIAN = [
    name for name in laws_for("sphere") if laws.LAWS[name].yields and name not in NOT_HERTZIAN
]


def assert_same_steps(case: BenchmarkImpact, law: str, place, steps_per_contact: int = 250) -> None:
    """Check that all columns agree with LIGGGHTS' hertz in every step. The tolerance is round-off,
    1e-13 of the largest value of the column.
    """
    ours, stock = (
        steps(evolve(case, law=name, steps_per_contact=steps_per_contact), place / name)
        for name in (law, "hertz")
    )
    assert len(ours) == len(stock)
    for column in stock.columns:
        scale = np.abs(stock[column].to_numpy()).max()
        off = np.abs(ours[column].to_numpy() - stock[column].to_numpy()).max()
        assert off <= 1e-13 * scale, (case, column)


@pytest.mark.parametrize("number", range(1, 9))
def test_unyielding_model_is_the_engines_hertz(number, tmp_path):
    """Without yield, Vu-Quoc & Zhang's law equals LIGGGHTS' hertz in all eight benchmarks.

    The impacts are on planes and between spheres, damped and undamped, sticking and sliding.
    """
    for k, case in enumerate(middles(number)):
        assert_same_steps(case, LAW, tmp_path / str(k))


@pytest.mark.parametrize("law", HERTZIAN)
@pytest.mark.parametrize("number", [4, 8])
def test_every_unyielding_law_is_the_engines_hertz(law, number, tmp_path):
    """Without yield, every law with Hertz' elastic contact equals LIGGGHTS' hertz.

    The impacts are on a plane and between spheres; the tangential spring alternately sticks and
    slides.
    """
    knob = 15.0 if number == 4 else 2.0
    assert_same_steps(evolve(few(number)[0], value=knob), law, tmp_path)


def test_tangential_dashpot_is_the_engines(tmp_path):
    """The tangential dashpot of a law equals that of LIGGGHTS' hertz; it is on by default.

    LIGGGHTS does not limit this dashpot to mu F, so a sliding sphere loses over 10 % more momentum
    than mu times the normal impulse.
    """
    case = evolve(few(6)[0], value=5.0)
    found = {}
    for law, options in ((LAW, "viscous_damping on"), ("hertz", "limitForce on")):
        variables = {**case.variables(), "law": law, "options": options}
        run_deck("collision/chung_ooi/6_spin_on_plane.in", variables, tmp_path / law)
        found[law] = motion(read_dump(tmp_path / law / "trajectory.dump"), -1)
    assert astuple(found[LAW]) == pytest.approx(astuple(found["hertz"]), rel=1e-13)
    assert found[LAW].along / case.impact().rigid_sliding().along > 1.1
