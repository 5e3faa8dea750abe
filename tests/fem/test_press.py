# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of a sphere pressed on a plane: comparison with Hertz, finer meshes and energy balance.

The reference values of the elastic-plastic sphere are results of this solver with its default
settings, which are converged to 0.5 %. The coarse mesh and steps of the tests add 1.5 %.
"""

from __future__ import annotations

import numpy as np
import pytest
from coarse_sphere import COARSE, ELASTIC, METAL, RADIUS
from numpy.testing import assert_allclose

from plastigran.fem.limits import SmallStrainWarning, check_forces
from plastigran.fem.sphere.press import press
from plastigran.fem.stepping.increment import Equations, NoConvergence
from plastigran.fem.theory.hertz import HertzSphere

HERTZ = HertzSphere(ELASTIC, RADIUS)
COARSE_MESH = 0.02
FINE = {  # default settings
    500.0: {"approach": 6.80e-6, "residual_approach": 2.02e-6, "coefficient_of_restitution": 0.839},
    1500.0: {
        "approach": 15.61e-6,
        "residual_approach": 7.09e-6,
        "coefficient_of_restitution": 0.7359,
    },
}


def test_elastic_sphere_follows_hertz(elastic_pressing):
    history = elastic_pressing.history
    loaded = history[history["force"] > 50]
    expected = [HERTZ.approach(force) for force in loaded["force"]]
    # At 200 N, the approach of a sphere of finite size is up to 0.15 % below Hertz' value. The mesh
    # adds an error of the same size.
    assert_allclose(loaded["approach"], expected, rtol=5e-3)


def test_elastic_pressure_is_hertzian(elastic_pressing):
    at_most = elastic_pressing.snapshots[0]
    radius = HERTZ.contact_radius(200.0)
    inside = at_most.radii < 0.8 * radius
    largest = 1.5 * 200.0 / (np.pi * radius**2)
    expected = largest * np.sqrt(1 - (at_most.radii[inside] / radius) ** 2)
    assert inside.sum() > 5
    # An edge of the mesh is a tenth of the contact radius.
    assert_allclose(at_most.pressure[inside], expected, rtol=0.05)


def test_elastic_sphere_gives_all_work_back(elastic_pressing):
    row = elastic_pressing.unloadings.iloc[0]
    # The error arises from the quadrature of the work over ten steps.
    assert row["coefficient_of_restitution"] == pytest.approx(1, abs=2e-3)
    assert row["residual_approach"] == pytest.approx(0, abs=2e-3 * row["approach"])


@pytest.mark.parametrize("force", FINE)
def test_coarse_pressing_is_near_the_fine_one(plastic_pressing, force):
    table = plastic_pressing.unloadings.set_index("force")
    row = table.iloc[np.argmin(np.abs(table.index - force))]
    for name, value in FINE[force].items():
        assert row[name] == pytest.approx(value, rel=COARSE_MESH), name


def test_work_is_stored_or_dissipated(plastic_pressing):
    history = plastic_pressing.history
    energy = history[["elastic_energy", "plastic_work", "penalty_energy"]].sum(axis=1)
    top = history["branch"].eq(0).to_numpy().nonzero()[0][-1]
    work = plastic_pressing.unloadings["work_loading"].iloc[0]
    # The relative error of 1 % is the error of backward Euler in load steps of 15 %.
    assert energy.iloc[top] == pytest.approx(work, rel=0.01)


def test_pressing_again_retraces_the_unloading(plastic_pressing):
    history = plastic_pressing.history
    down, again = (history[history["branch"] == branch] for branch in (1, 2))
    retraced = np.interp(down["force"], again["force"], again["approach"])
    upper = down["force"] > 50
    # The tolerance of 2 % covers slight reverse plastic flow during unloading, and interpolation
    # between ten steps.
    assert_allclose(retraced[upper], down["approach"][upper], rtol=0.02)


def test_pressing_again_rejoins_the_loading_curve(plastic_pressing):
    at_once = press(METAL, RADIUS, [1500.0], COARSE).unloadings.iloc[0]
    again = plastic_pressing.unloadings.iloc[-1]
    for name in ("approach", "residual_approach", "coefficient_of_restitution"):
        # The additional stop at 500 N adds a load step. The tolerance is the error of load steps of
        # 15 %.
        assert again[name] == pytest.approx(at_once[name], rel=5e-3), name


def test_yield_begins_below_the_surface_at_the_force_of_hertz():
    ratio = 1.15
    force = ratio * HertzSphere(METAL, RADIUS).yield_force
    strained = press(METAL, RADIUS, [force], COARSE).snapshots[0]
    deepest = strained.positions[np.argmax(strained.plastic_strain)]
    radius = HERTZ.contact_radius(force)
    assert strained.plastic_strain.max() > 0
    # No Gauss point lies on the axis. The tolerance of the depth is the side of an element. For nu
    # = 0.3, the largest stress lies at a depth of 0.48 contact radii.
    assert deepest[0] < 0.3 * radius
    assert deepest[1] == pytest.approx(0.48 * radius, rel=0.35)


def test_forces_below_yield_leave_nothing():
    force = 0.9 * HertzSphere(METAL, RADIUS).yield_force
    pressing = press(METAL, RADIUS, [force], COARSE)
    assert pressing.snapshots[0].plastic_strain.max() == 0


def test_pressing_that_gives_up_keeps_what_it_has(monkeypatch):
    press_increment = Equations.press

    def fail_beyond(equations, start, guess, force):
        if force > 100:
            raise NoConvergence("too much")
        return press_increment(equations, start, guess, force)

    monkeypatch.setattr(Equations, "press", fail_beyond)
    pressing = press(ELASTIC, RADIUS, [200.0], COARSE)
    assert "too much; the increment from" in pressing.stopped
    assert "after 6 halvings" in pressing.stopped
    assert 50 < pressing.history["force"].max() <= 100
    assert pressing.unloadings.empty


@pytest.mark.parametrize(
    ("forces", "said"),
    [
        ([], "empty"),
        ([-1.0], "-1 N"),
        ([200.0, 100.0], "100 N after 200 N"),
        ([float("nan")], "nan N"),
        ([1e12], "times the radius; the upper limit is 0.4"),
        ([1e-15], "times the radius; the lower limit is 1e-06"),
    ],
)
def test_forces_that_cannot_be_pressed_are_refused(forces, said):
    with pytest.raises(ValueError, match=said):
        press(METAL, RADIUS, forces, COARSE)


@pytest.mark.parametrize("radius", [0.0, -0.1, float("nan"), float("inf"), "wide"])
def test_a_radius_out_of_range_is_refused(radius):
    with pytest.raises(ValueError, match="radius"):
        press(METAL, radius, [200.0], COARSE)


def test_wide_contacts_are_warned_of():
    with pytest.warns(SmallStrainWarning, match="small strain is accurate up to 0.1"):
        check_forces(HertzSphere(METAL, RADIUS), [2e5])
