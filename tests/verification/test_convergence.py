# SPDX-License-Identifier: GPL-2.0-or-later
"""Order of the engine's time integration through our contacts, and agreement of the geometries."""

from __future__ import annotations

import numpy as np
import pytest

from plastigran import theory
from plastigran.impact import GEOMETRIES, Impact


def test_order_in_the_time_step(engine_law, aluminium, declared_jumps, tmp_path):
    """Errors of restitution, root mean square over where in a step the contact begins.

    One run's error changes sign with that phase, so single runs show no clean order. The slope over
    a 16-fold step is 2 within 0.25: eight phases leave some scatter. A law whose force jumps is
    integrated across the jump to first order only, so there it is at least 1.
    """
    model = Impact(engine_law, 0.2, aluminium, 0.1)  # beyond yield for every law
    expected = model.predicted().coefficient_of_restitution
    steps = model.time_step() * np.array([2.0, 1.0, 0.5, 0.25, 0.125])
    errors = []
    for step in steps:
        phases = [
            model.run(tmp_path / f"{step:g}_{k}", step, gap=k / 8 * step * model.speed)
            for k in range(8)
        ]
        off = [run.coefficient_of_restitution / expected - 1 for run in phases]
        errors.append(np.sqrt(np.mean(np.square(off))))
    order = np.polyfit(np.log(steps), np.log(errors), 1)[0]
    if declared_jumps[engine_law]:
        assert order > 0.75, errors
    else:
        assert order == pytest.approx(2, abs=0.25), errors
    assert errors[1] < 1e-3  # at the recommended step


@pytest.mark.parametrize("law", ["hertz"])
@pytest.mark.parametrize("speed", [0.001, 0.1])
def test_hertz_duration(law, speed, aluminium, tmp_path):
    """2.868 (m*^2/(R* E*^2 v))^(1/5) to 1e-3, as a pair and on a wall: the convention check."""
    for geometry in GEOMETRIES:
        model = Impact(law, speed, aluminium, 0.1, geometry)
        found = model.run(tmp_path / geometry, model.time_step() / 4)
        duration = theory.hertz_duration(
            model.mass_eff, model.radius_eff, model.pair.youngs_modulus_eff, model.closing_speed
        )
        assert found.contact_time == pytest.approx(float(duration), rel=1e-3)


def test_geometries_agree(engine_law, aluminium, tmp_path):
    """Pair, primitive wall and mesh wall run the same numbers; 1e-9 is rounding, grown by the
    cancellation in two positions' difference."""
    found = {
        geometry: Impact(engine_law, 0.1, aluminium, 0.1, geometry).run(tmp_path / geometry, 1e-5)
        for geometry in GEOMETRIES
    }
    wall = found["sphere_wall"]
    for geometry, other in found.items():
        factor = 2 if geometry == "two_spheres" else 1
        assert other.coefficient_of_restitution == pytest.approx(
            wall.coefficient_of_restitution, rel=1e-9
        )
        assert other.force_max == pytest.approx(wall.force_max, rel=1e-9)
        assert other.overlap_max == pytest.approx(factor * wall.overlap_max, rel=1e-9)
        assert other.overlap_res == pytest.approx(factor * wall.overlap_res, rel=1e-9)
