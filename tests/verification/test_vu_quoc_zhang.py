# SPDX-License-Identifier: GPL-2.0-or-later
"""Vu-Quoc-Zhang against the paper's own equations, written here with dimensions."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq

from plastigran import laws

RADIUS, MODULUS, PRESSURE = 0.1, 7e10 / (1 - 0.3**2), 1.61e8
C_A, K_C = 2.33e-7, 2.69e-4  # m/N, 1/N: the paper's calibration
P_Y = np.pi**3 * RADIUS**2 * PRESSURE**3 / (6 * MODULUS**2)


def elastic_radius(force):
    return (3 * force * RADIUS / (4 * MODULUS)) ** (1 / 3)


def virgin_overlap(force):
    """Zhang & Vu-Quoc 2002, eqs 4.1-4.6, as total overlap."""
    beyond = max(force - P_Y, 0.0)
    return (elastic_radius(force) + C_A * beyond) ** 2 / ((1 + K_C * beyond) * RADIUS)


def virgin_force(overlap):
    return brentq(lambda p: virgin_overlap(p) - overlap, 0, 1e7, xtol=1e-12, rtol=1e-15)


def plastic_radius(force_max):
    return C_A * max(force_max - P_Y, 0.0)


class Twin:
    """The same law over scalar history, by root finding."""

    def __init__(self):
        self.force_max = P_Y

    def force(self, overlap):
        if overlap <= 0:
            return 0.0
        overlap_max = virgin_overlap(self.force_max)
        if overlap > overlap_max:
            self.force_max = virgin_force(overlap)
            return self.force_max
        curvature = 1 + K_C * (self.force_max - P_Y)
        residual = overlap_max - elastic_radius(self.force_max) ** 2 / (curvature * RADIUS)
        a = np.sqrt(curvature * RADIUS * max(overlap - residual, 0))
        return 4 * MODULUS * a**3 / (3 * RADIUS)


@pytest.fixture
def law(paper_pair):
    return laws.VuQuocZhang(paper_pair)


def test_yield_force_is_the_papers(law):
    """36.45 N in the paper; 36.4471 N from its formula."""
    assert law.yield_force(RADIUS) == pytest.approx(36.4471, rel=2e-6)


def test_default_constants_are_the_papers():
    """C_a = 2.33e-7 m/N and K_c = 2.69e-4 1/N on this sphere, to the digits kept in the header."""
    yield_radius = elastic_radius(P_Y)
    defaults = {p["name"]: p["default"] for p in laws.VuQuocZhang.parameters()}
    assert defaults["contact_radius_coefficient"] == pytest.approx(
        C_A * P_Y / yield_radius, rel=1e-6
    )
    assert defaults["curvature_coefficient"] == pytest.approx(K_C * P_Y, rel=1e-6)


@given(turns=st.lists(st.floats(0, 1), min_size=1, max_size=6))
def test_follows_the_twin_on_any_path(turns):
    """Loading, unloading, reloading up to 300 P_Y; 1e-6 is what the header's constants keep."""
    pair = laws.combine(laws.Material(7e10, 0.3, 1e8, 1.61), laws.Material(1e30, 0.3, 1e30, 1.61))
    law, state, twin = laws.VuQuocZhang(pair), laws.VuQuocZhang.State(), Twin()
    reach = virgin_overlap(300 * P_Y)
    for overlap in np.concatenate([np.linspace(0, turn, 5) * reach for turn in turns]):
        expected = twin.force(overlap)
        found = law.respond(RADIUS, overlap, state)
        # Near the residual overlap the force is a difference raised to 3/2: scale by the maximum.
        assert found.force == pytest.approx(expected, rel=3e-6, abs=3e-6 * twin.force_max)
        if expected > 1e-3 * twin.force_max:
            radius = elastic_radius(expected) + plastic_radius(twin.force_max)
            assert found.contact_radius == pytest.approx(radius, rel=1e-4)


def test_force_driven_form_inverts_the_law(law):
    force = np.geomspace(1e-6, 400, 300) * P_Y
    for p in force:
        overlap = law.overlap(RADIUS, p, laws.VuQuocZhang.State())
        assert overlap == pytest.approx(virgin_overlap(p), rel=1e-6)
        back = law.respond(RADIUS, overlap, laws.VuQuocZhang.State()).force
        assert back == pytest.approx(p, rel=1e-12)  # rounding


def test_force_driven_form_unloads_alike(law):
    state = laws.VuQuocZhang.State()
    law.overlap(RADIUS, 50 * P_Y, state)
    driven = state.copy()
    for p in np.linspace(50, 0.01, 40) * P_Y:
        overlap = law.overlap(RADIUS, p, state)
        assert law.respond(RADIUS, overlap, driven).force == pytest.approx(p, rel=1e-10)


def test_plastic_work_by_quadrature(law):
    """Work of the virgin curve less the rebound's, by adaptive quadrature of the twin."""
    for ratio in (1.001, 1.5, 5, 41, 230, 1e4):
        force = ratio * P_Y
        overlap = virgin_overlap(force)
        # Integration by parts keeps the integrand explicit: F d - int d dF.
        complementary = quad(
            virgin_overlap, 0, force, points=[P_Y], epsabs=0, epsrel=1e-13, limit=500
        )
        work = force * overlap - complementary[0]
        response = law.respond(RADIUS, overlap, laws.VuQuocZhang.State())
        assert response.elastic_energy + response.plastic_work == pytest.approx(work, rel=1e-6)


def test_restitution_by_integrating_the_motion(law, paper_mass):
    """DOP853 on the twin's loading and unloading, the paper's 0.4773 at 0.20 m/s within 1e-3."""
    speed = 0.2
    twin = Twin()

    def loading(_, y):  # a fresh twin: trial points of the integrator leave no history
        return [y[1], -Twin().force(y[0]) / paper_mass]

    def unloading(_, y):
        return [y[1], -twin.force(y[0]) / paper_mass]

    def turned(_, y):
        return y[1]

    turned.terminal, turned.direction = True, -1
    integrate = {"method": "DOP853", "rtol": 1e-11, "atol": 1e-14, "max_step": 1e-5}
    load = solve_ivp(loading, (0, 1), [0, speed], events=turned, **integrate)
    twin.force_max = virgin_force(load.y_events[0][0][0])

    def released(_, y):
        return twin.force(y[0]) - 1e-9 * twin.force_max

    released.terminal = True
    start = [load.y_events[0][0][0], -1e-12]
    back = solve_ivp(unloading, (0, 1), start, events=released, **integrate)
    restitution = -back.y[1, -1] / speed
    assert restitution == pytest.approx(0.477686, rel=1e-5)
    assert restitution == pytest.approx(0.4773, rel=1e-3)
    found = law.central_impact(RADIUS, paper_mass, speed)
    assert found.coefficient_of_restitution == pytest.approx(restitution, rel=1e-5)


@pytest.mark.parametrize(
    ("radius", "youngs_modulus", "density", "yield_strength"),
    [(0.1, 7e10, 2699, 1e8), (1e-3, 7e10, 2699, 1e8), (1e-3, 2.1e11, 7850, 3e8)],
)
def test_size_and_material_drop_out(radius, youngs_modulus, density, yield_strength):
    """Restitution depends on speed over yield speed alone (at one Poisson's ratio)."""
    from plastigran.physics import central

    body = laws.Material(youngs_modulus, 0.3, yield_strength)
    pair = laws.combine(body, body)
    mass = 0.5 * 4 / 3 * np.pi * radius**3 * density
    law = laws.VuQuocZhang(pair)
    scale = central.yield_speed(pair, radius / 2, mass)
    found = [
        law.central_impact(radius / 2, mass, ratio * scale).coefficient_of_restitution
        for ratio in (12, 36, 60, 120)
    ]
    # Four systems, energy quadrature and integration of the motion.
    assert found == pytest.approx([0.838088, 0.700752, 0.614279, 0.477322], rel=2e-6)


def test_newton_converges_from_the_left_in_few_steps(law, paper_mass):
    """Along impacts at the recommended step, four iterations on average and never more than eight;
    a cold start over a millionfold overlap stays below 60."""
    for speed in (0.02, 0.2, 1.0):
        model = law.central_impact(RADIUS, paper_mass, speed)
        step = law.recommended_time_step(RADIUS, paper_mass, speed)
        overlap_y = RADIUS * (np.pi * PRESSURE / (2 * MODULUS)) ** 2
        overlap, rate, root, counts = 0.0, speed, 1.0, []
        state = laws.VuQuocZhang.State()
        while rate > 0:
            force = law.respond(RADIUS, overlap, state).force
            rate -= step * force / paper_mass
            overlap += step * rate
            if overlap > overlap_y and rate > 0:
                root, count = law.elastic_radius(overlap / overlap_y, root)
                counts.append(count)
        assert overlap == pytest.approx(model.overlap_max, rel=0.05)
        assert np.mean(counts) <= 4.5
        assert max(counts) <= 8
    assert max(law.elastic_radius(x, 1.0)[1] for x in np.geomspace(1.0000001, 1e6, 2000)) <= 60


def test_constants_that_would_create_energy_are_refused(paper_pair):
    with pytest.raises(ValueError, match=r"contact_radius_coefficient.*curvature_coefficient"):
        laws.VuQuocZhang(paper_pair, contact_radius_coefficient=1e-3, curvature_coefficient=0.1)
    with pytest.raises(ValueError, match=r"curvature_coefficient is -1; it must be between 0 and"):
        laws.VuQuocZhang(paper_pair, curvature_coefficient=-1)
    with pytest.raises(ValueError, match=r"no constant 'curvature'; it takes contact_radius_"):
        laws.VuQuocZhang(paper_pair, curvature=0.1)
