# SPDX-License-Identifier: GPL-2.0-or-later
"""In LIGGGHTS, the yield strength grows with the strain rate, and each contact keeps the strength
of its first touch. test_history.py tests how contacts keep it.

`thornton` represents the laws that are scaled to another strength, and `universal` those that are
interpolated between tables.
"""

from __future__ import annotations

import re

import pytest
from attrs import evolve
from scenes import DECKS, Spheres

from plastigran.engine.process import EngineError, run_deck
from plastigran.experiments.central import CentralImpact
from plastigran.experiments.collide import IMPACTS

LAW = "thornton"
RATE = {"rate_coefficient": 0.1, "reference_rate": 1e-3}  # factor 1.69 at 0.1 m/s, 0.1 m
SPHERES = Spheres(LAW, 0)
ALUMINIUM = evolve(SPHERES.material, **RATE)


@pytest.mark.parametrize(("law", "tolerance"), [(LAW, 1e-5), ("universal", 1e-3)])
@pytest.mark.parametrize("speed", [0.1, 1.0])
@pytest.mark.parametrize("geometry", IMPACTS["sphere"].geometries)
def test_impact_is_the_laws_at_its_rate(geometry, speed, law, tolerance, tmp_path):
    """An impact in LIGGGHTS follows the law with the yield strength at its strain rate.

    At a twentieth of the recommended time step, the relative integration error is 1e-5. If the
    plugin interpolates in tables, the relative tolerance is 1e-3.
    """
    case = CentralImpact(law, speed, ALUMINIUM, 0.1, geometry=geometry)
    plain = evolve(case, material=SPHERES.material).predict()
    found, expected = case.run(tmp_path, timestep=case.timestep / 20), case.predict()
    assert expected.coefficient_of_restitution > 1.1 * plain.coefficient_of_restitution
    for outcome in ("coefficient_of_restitution", "force_max", "overlap_max"):
        assert getattr(found, outcome) == pytest.approx(getattr(expected, outcome), rel=tolerance)


def test_history_is_as_long_as_before_when_off(tmp_path):
    """Without the rate factor, a restart file has one number less per contact and particle.

    The file also has a shorter text of constants, which this test removes.
    """
    sizes = []
    for name, rate in {"off": {}, "on": RATE}.items():
        SPHERES.run("restart_write", tmp_path / name, **rate)
        file = (tmp_path / name / "middle.restart").read_bytes()
        sizes.append(len(re.sub(rb"\tmodel [^\n]*\n", b"", file)))
    assert sizes[1] - sizes[0] == 2 * 8


def test_coefficient_that_comes_too_late_is_refused(tmp_path):
    text = (DECKS / "restart_write.in").read_text()
    wall, late = "include ${decks}/wall_${geometry}.in", "rateCoefficient peratomtype 0.1 0.1"
    deck = tmp_path / "deck.in"
    deck.write_text(
        text.replace(wall, f"{wall}\nunfix rate_coefficient\nfix c all property/global {late}")
    )
    variables = {"law": LAW, "geometry": "plane", "decks": DECKS}
    with pytest.raises(EngineError, match="rateCoefficient must be given before the wall"):
        run_deck(deck, variables, tmp_path / "run")
