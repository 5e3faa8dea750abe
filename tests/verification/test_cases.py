# SPDX-License-Identifier: GPL-2.0-or-later
"""Impacts of every reference in LIGGGHTS, in each geometry that the law supports."""

from __future__ import annotations

import pytest
from references import impacts

from plastigran import laws
from plastigran.experiments.central import CentralImpact
from plastigran.experiments.collide import IMPACTS

CASES = {
    f"{law}-{index}-{row['speed']:g}": (law, index)
    for law in impacts.LAWS
    for index, row in enumerate(impacts.rows(law))
}
# Tolerances of the residual overlap, divided by the largest overlap, at the recommended step and at
# a twentieth of it. The residual overlap is extrapolated from the last frames, for a force that is
# a power of the remaining overlap. The force of a cylinder is not a power, and the force of `mdr`
# is one only at the very end.
END_OF_REBOUND = {"sphere": (1e-5, 0), "cylinder": (2e-3, 1e-4), "mdr": (2e-3, 0)}
OUTCOMES = ("coefficient_of_restitution", "force_max", "overlap_max", "overlap_res")


RUNS = [
    pytest.param(case, geometry, id=f"{case}-{geometry}")
    for case, (law, _) in CASES.items()
    for geometry in IMPACTS[laws.LAWS[law].shape].geometries
]


def impact(law: str, index: int, **geometry: str) -> CentralImpact:
    """Return the impact of a row in the table of a reference.

    Columns other than material, radius and speed belong to cylinders.
    """
    kind = IMPACTS[laws.LAWS[law].shape]
    return kind(law=law, **impacts.rows(law)[index], **geometry)


def end_of_rebound(law: str) -> tuple[float, float]:
    return END_OF_REBOUND.get(law, END_OF_REBOUND[laws.LAWS[law].shape])


def test_every_law_has_cases(law_name):
    assert any(law == law_name for law, _ in CASES.values())


@pytest.mark.parametrize(("case", "geometry"), RUNS)
def test_engine_at_the_recommended_step(case, geometry, tmp_path):
    """At the recommended time step, impacts in LIGGGHTS agree with the reference of the law.

    The relative error is 1e-3 in restitution, and 2e-3 in other quantities. LIGGGHTS uses a speed
    of half a step earlier, so rate-dependent forces cause first-order errors: 5e-3, and in the
    residual overlap 2 % of the largest overlap. Two equal spheres behave like the sphere on a rigid
    plane, except that each has half of the overlap.
    """
    law, index = CASES[case]
    model, expected = impact(law, index, geometry=geometry), impacts.outcome(law, index)
    found = model.run(tmp_path)
    assert found.coefficient_of_restitution == pytest.approx(
        expected.coefficient_of_restitution, rel=1e-3
    )
    late = laws.LAWS[law].rate_dependent
    rest, end = (5e-3, 2e-2) if late else (2e-3, end_of_rebound(law)[0])
    assert found.force_max == pytest.approx(expected.force_max, rel=rest)
    assert found.overlap_max / model.bodies == pytest.approx(expected.overlap_max, rel=rest)
    assert found.overlap_res / model.bodies == pytest.approx(
        expected.overlap_res, rel=2e-3, abs=end * expected.overlap_max
    )
    assert found.contact_time == pytest.approx(expected.contact_time, rel=rest)


@pytest.mark.parametrize("case", CASES)
def test_engine_at_a_twentieth_of_it(case, declared_jumps, tmp_path):
    """At a twentieth of the recommended step, LIGGGHTS agrees with the law to 1e-5.

    The integration is of second order. If the force jumps, the error is of first order, and the
    tolerance is 1e-4. For rate-dependent laws, the error is also of first order, and tolerances
    are a twentieth of those in `test_engine_at_the_recommended_step`.
    """
    law, index = CASES[case]
    model = impact(law, index)
    found = model.run(tmp_path, timestep=model.timestep / 20)
    predicted = model.predict()
    for name in OUTCOMES:
        tolerance = 1e-4 if declared_jumps[law] else 1e-5
        if laws.LAWS[law].rate_dependent:
            tolerance = 1e-3 if name == "overlap_res" else 2.5e-4
        _, end = end_of_rebound(law) if name == "overlap_res" else (0, 0)
        margin = max(1e-12 if model.shape == "sphere" else 0, end * predicted.overlap_max)
        assert getattr(found, name) == pytest.approx(
            getattr(predicted, name), rel=tolerance, abs=margin
        ), name
