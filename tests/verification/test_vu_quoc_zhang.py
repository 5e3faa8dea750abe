# SPDX-License-Identifier: GPL-2.0-or-later
"""Vu-Quoc & Zhang's law, compared with the paper's equations in references/vu_quoc_zhang.py."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from references.contact import MATERIALS
from references.vu_quoc_zhang import C_A, K_C, Reference

from plastigran import laws

RADIUS = 0.1
PAPER = Reference(MATERIALS["aluminium_zv02"], RADIUS, speed=0.2)
P_Y = PAPER.force_y


@pytest.fixture
def law(paper_pair):
    return laws.VuQuocZhang(paper_pair)


def test_yield_force_is_the_papers(law):
    """The yield force is that of the paper: it prints 36.45 N, and its formula gives 36.4471 N."""
    assert law.yield_force(RADIUS) == pytest.approx(36.4471, rel=2e-6)


def test_default_constants_are_the_papers():
    """The defaults correspond to C_a = 2.33e-7 m/N and K_c = 2.69e-4 1/N for this sphere, to the
    six digits of the header."""
    yield_radius = PAPER.elastic_radius(P_Y)
    defaults = {p["name"]: p["default"] for p in laws.VuQuocZhang.parameters()}
    assert defaults["contact_radius_coefficient"] == pytest.approx(
        C_A * P_Y / yield_radius, rel=1e-6
    )
    assert defaults["curvature_coefficient"] == pytest.approx(K_C * P_Y, rel=1e-6)


@settings(max_examples=max(100, settings.default.max_examples))
@given(turns=st.lists(st.floats(0, 1), min_size=1, max_size=6))
def test_follows_the_paper_on_any_path(turns):
    """The force follows the equations of the paper on random paths of loading and unloading.

    The paths reach up to 300 times the yield force. Forces agree to 3e-6 of the largest force. The
    constants of the header have six digits, and near the residual overlap the force is a difference
    to the power 3/2.
    """
    pair = laws.combine(laws.Body(7e10, 0.3, 1e8, 1.61), laws.Body(1e30, 0.3, 1e30, 1.61))
    reach = PAPER.overlap_under(300 * P_Y)
    path = np.concatenate([np.linspace(0, turn, 5) * reach for turn in turns])
    found = laws.VuQuocZhang(pair).follow(RADIUS, path, laws.VuQuocZhang.State())
    force = PAPER.follow(path)
    force_max = np.maximum(P_Y, np.maximum.accumulate(force))
    assert (np.abs(found["force"] - force) <= 3e-6 * force_max).all()
    pressed = force > 1e-3 * force_max
    radius = PAPER.elastic_radius(force) + C_A * np.maximum(force_max - P_Y, 0)
    assert found["contact_radius"][pressed] == pytest.approx(radius[pressed], rel=1e-4)


def test_force_driven_form_inverts_the_law(law):
    force = np.geomspace(1e-6, 400, 300) * P_Y
    for p in force:
        overlap = law.overlap(RADIUS, p, laws.VuQuocZhang.State())
        assert overlap == pytest.approx(PAPER.overlap_under(p), rel=1e-6)
        back = law.respond(RADIUS, overlap, laws.VuQuocZhang.State()).force
        assert back == pytest.approx(p, rel=1e-12)  # round-off


def test_force_driven_form_unloads_alike(law):
    state = laws.VuQuocZhang.State()
    law.overlap(RADIUS, 50 * P_Y, state)
    driven = state.copy()
    for p in np.linspace(50, 0.01, 40) * P_Y:
        overlap = law.overlap(RADIUS, p, state)
        assert law.respond(RADIUS, overlap, driven).force == pytest.approx(p, rel=1e-10)


def test_restitution_is_the_papers(law, paper_mass):
    """The restitution of the paper is 0.4773 at 0.20 m/s. The relative tolerance 1e-3 is the
    time-step error of its simulation.
    """
    found = law.central_impact(RADIUS, paper_mass, 0.2).coefficient_of_restitution
    assert found == pytest.approx(0.4773, rel=1e-3)


@pytest.mark.parametrize(
    ("radius", "youngs_modulus", "density", "yield_strength"),
    [(0.1, 7e10, 2699, 1e8), (1e-3, 7e10, 2699, 1e8), (1e-3, 2.1e11, 7850, 3e8)],
)
def test_size_and_material_drop_out(radius, youngs_modulus, density, yield_strength):
    """At a given Poisson's ratio, restitution depends only on speed / yield speed."""
    from plastigran.physics import central

    body = laws.Body(youngs_modulus, 0.3, yield_strength)
    pair = laws.combine(body, body)
    mass = 0.5 * 4 / 3 * np.pi * radius**3 * density
    law = laws.VuQuocZhang(pair)
    scale = central.yield_speed(pair, radius / 2, mass)
    found = [
        law.central_impact(radius / 2, mass, ratio * scale).coefficient_of_restitution
        for ratio in (12, 36, 60, 120)
    ]
    # The expected values come from energy quadrature and from the equation of motion.
    assert found == pytest.approx([0.838088, 0.700752, 0.614279, 0.477322], rel=2e-6)


def test_constants_that_would_create_energy_are_refused(paper_pair):
    with pytest.raises(ValueError, match=r"contact_radius_coefficient.*curvature_coefficient"):
        laws.VuQuocZhang(paper_pair, contact_radius_coefficient=1e-3, curvature_coefficient=0.1)
    with pytest.raises(ValueError, match=r"curvature_coefficient is -1; it must be between 0 and"):
        laws.VuQuocZhang(paper_pair, curvature_coefficient=-1)
    with pytest.raises(ValueError, match=r"no constant 'curvature'; it takes contact_radius_"):
        laws.VuQuocZhang(paper_pair, curvature=0.1)
