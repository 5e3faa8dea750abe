# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of von Mises plasticity at material points."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plastigran.fem.material.elastic_plastic import ElasticPlastic, State
from plastigran.fem.material.hardening import LinearHardening, RateFactor, TabulatedHardening
from plastigran.fem.stepping.snapshot import mises_stress

ROUNDING = 1e-9  # tolerance of relative stress errors; the radial return converges to 1e-13
YIELD, MODULUS = 100e6, 2e9
HARDENINGS = [
    LinearHardening(YIELD),
    LinearHardening(YIELD, MODULUS),
    TabulatedHardening((0, 1e-3, 1e-2), (YIELD, 1.5 * YIELD, 2 * YIELD)),
]


def metal(hardening, rate=None):
    return ElasticPlastic(youngs_modulus=70e9, poissons_ratio=0.3, hardening=hardening, rate=rate)


@pytest.fixture
def strains():
    """Random strains in all directions, of several times the yield strain."""
    return np.random.default_rng(1).normal(scale=5e-3, size=(200, 4))


@pytest.mark.parametrize("hardening", HARDENINGS)
def test_stress_returns_to_the_flow_stress(hardening, strains):
    answer = metal(hardening).respond(strains, State.undeformed(len(strains)))
    flow, _ = hardening.flow_stress(answer.state.accumulated)
    assert answer.flowing.size > 100
    assert_allclose(mises_stress(answer.stress)[answer.flowing], flow[answer.flowing], ROUNDING)


@pytest.mark.parametrize("hardening", HARDENINGS)
def test_plastic_flow_keeps_the_volume(hardening, strains):
    answer = metal(hardening).respond(strains, State.undeformed(len(strains)))
    volumetric = answer.state.plastic_strain[:, :3].sum(axis=1)
    assert_allclose(volumetric, 0, atol=1e-15)


@pytest.mark.parametrize("rate", [None, RateFactor(0.02, 1.0)])
@pytest.mark.parametrize("hardening", HARDENINGS)
def test_tangent_is_the_derivative_of_the_stress(hardening, rate, strains):
    material, loading = metal(hardening, rate), State.undeformed(len(strains))
    answer = material.respond(strains, loading, 1e-4)
    step = 1e-8
    for component in range(4):
        change = np.zeros(4)
        change[component] = step
        above, below = (
            material.respond(strains + sign * change, loading, 1e-4).stress for sign in (1, -1)
        )
        slope = ((above - below) / (2 * step))[answer.flowing]
        # Central differences have an error of step^2 times a curvature plus round-off, 1e-16 *
        # stress / step. A point may pass a corner of the table within the step, so the limit holds
        # for 98 % of the points.
        error = (
            np.abs(slope - answer.tangent[:, :, component]).max(axis=1) / material.youngs_modulus
        )
        assert np.quantile(error, 0.98) < 1e-5


def test_tabulated_hardening_of_a_straight_line_is_linear_hardening(strains):
    table = TabulatedHardening((0, 1.0), (YIELD, YIELD + MODULUS))
    loading = State.undeformed(len(strains))
    line = metal(LinearHardening(YIELD, MODULUS)).respond(strains, loading)
    assert_allclose(metal(table).respond(strains, loading).stress, line.stress, ROUNDING, atol=1)


def test_rate_raises_the_flow_stress_by_johnson_and_cook():
    shear = np.array([[0, 0, 0, 0.02]])
    duration, coefficient = 1e-5, 0.015
    material = metal(LinearHardening(YIELD), RateFactor(coefficient, 1.0))
    answer = material.respond(shear, State.undeformed(1), duration)
    rate = answer.state.accumulated / duration
    expected = YIELD * (1 + coefficient * np.log(rate))
    assert_allclose(mises_stress(answer.stress), expected, ROUNDING)


def test_plastic_work_is_flow_stress_times_strain(strains):
    answer = metal(LinearHardening(YIELD)).respond(strains, State.undeformed(len(strains)))
    assert_allclose(answer.state.work, YIELD * answer.state.accumulated, ROUNDING)


@pytest.mark.parametrize(
    ("strains", "stresses", "named"),
    [
        ((0, 1e-3), (1e8, 2e8, 3e8), "2 strains from 0 and 3 stresses"),
        ((0, 1e-3), (1e8,), "two or more"),
        ((0.1, 0.2), (1e8, 2e8), "start at strain 0"),
        ((0, 0), (1e8, 2e8), "strains"),
        ((0, 1e-3), (2e8, 1e8), "stresses"),
        ((0, 1e-3), (-1e8, 1e8), "must be positive"),
    ],
)
def test_table_that_cannot_be_is_refused(strains, stresses, named):
    with pytest.raises(ValueError, match=named):
        TabulatedHardening(strains, stresses)


def test_bad_metal_is_refused_with_field_value_and_range():
    with pytest.raises(
        ValueError, match=r"poissons_ratio is 0\.5; it must be above -1 and below 0\.5"
    ):
        ElasticPlastic(youngs_modulus=70e9, poissons_ratio=0.5)
    with pytest.raises(ValueError, match="yield_strength is -1; it must be positive"):
        LinearHardening(-1)
