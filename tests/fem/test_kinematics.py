# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of logarithmic finite strain, at material points and in a compressed sphere."""

from __future__ import annotations

import warnings

import attrs
import numpy as np
import pytest
from coarse_sphere import COARSE, METAL, RADIUS
from numpy.testing import assert_allclose
from scipy.linalg import logm

from plastigran.fem.limits import SmallStrainWarning, check_forces
from plastigran.fem.material.elastic_plastic import State
from plastigran.fem.material.kinematics import FiniteStrain, SmallStrain
from plastigran.fem.material.stretch import InvertedError
from plastigran.fem.sphere.press import press
from plastigran.fem.theory.hertz import HertzSphere

FINITE = FiniteStrain()
STEP = 1e-6  # step of the central differences


@pytest.fixture
def gradients():
    """Displacement gradients up to some tenths.

    Some are tiny or zero, and some have equal or nearly equal principal stretches."""
    result = np.random.default_rng(3).normal(scale=0.15, size=(300, 5))
    result[:50] *= 1e-4
    result[50:60] = 0
    result[60:80, 3:], result[60:80, 0] = 0, result[60:80, 1]
    result[80:100, 3:], result[80:100, 0] = 1e-4, result[80:100, 1] + 1e-3
    return result


def changed(gradients, component, sign):
    result = gradients.copy()
    result[:, component] += sign * STEP
    return result


def differences(function, gradients):
    """Differentiate m quantities with respect to the displacement gradient (n, m, 5)."""
    return np.stack(
        [
            (function(changed(gradients, c, 1)) - function(changed(gradients, c, -1))) / (2 * STEP)
            for c in range(5)
        ],
        axis=-1,
    )


def test_strain_is_half_the_logarithm_of_the_squared_stretch(gradients):
    strain = FINITE.strain(gradients)
    for (rr, yy, tt, ry, yr), found in zip(gradients[::5], strain[::5], strict=True):
        deformation = np.array([[1 + rr, ry], [yr, 1 + yy]])
        expected = logm(deformation.T @ deformation) / 2
        tensor = [[found[0], found[3] / 2], [found[3] / 2, found[1]]]
        assert_allclose(tensor, expected, atol=1e-13)  # scipy's round-off
        assert found[2] == pytest.approx(np.log1p(tt), abs=1e-15)


def test_stress_does_the_work_of_the_logarithmic_strain(gradients):
    stress = np.random.default_rng(4).normal(size=(len(gradients), 4))
    work = np.einsum("ni,nij->nj", stress, differences(FINITE.strain, gradients))
    # Central differences have an error of 1e-16/STEP (round-off) plus STEP^2 times a curvature.
    assert_allclose(FINITE.conjugate(gradients, stress), work, atol=1e-8)


def test_tangent_is_the_derivative_of_the_stress(gradients):
    fresh = State.undeformed(len(gradients))

    def answer(at):
        return METAL.respond(FINITE.strain(at), fresh)

    response = answer(gradients)
    assert 100 < response.flowing.size < len(gradients)
    points, tangent = FINITE.tangent(gradients, response, METAL.elastic_tangent)
    slopes = differences(lambda at: FINITE.conjugate(at, answer(at).stress), gradients)
    error = np.abs(slopes[points] - tangent).max(axis=(1, 2)) / METAL.youngs_modulus
    # The limit holds for 98 % of the points, because a point may begin to yield within the step of
    # the central difference.
    assert np.quantile(error, 0.98) < 1e-5


def test_rotation_gives_no_stress():
    angle = np.linspace(0, 3, 20)
    cosine, sine = np.cos(angle), np.sin(angle)
    turned = np.stack([cosine - 1, cosine - 1, 0 * angle, -sine, sine], axis=-1)
    assert_allclose(FINITE.strain(turned), 0, atol=1e-15)


def test_rotation_turns_the_stress_with_the_body(gradients):
    angle = 0.7
    rotation = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])

    def turn(columns):
        tensors = columns[:, [0, 3, 4, 1]].reshape(-1, 2, 2)
        turned = (rotation @ tensors).reshape(-1, 4)
        return np.insert(turned[:, [0, 3, 1, 2]], 2, columns[:, 2], axis=1)

    one = np.array([1.0, 1.0, 0.0, 0.0, 0.0])
    turned = turn(gradients + one) - one
    fresh = State.undeformed(len(gradients))
    stress, after = (METAL.respond(FINITE.strain(at), fresh).stress for at in (gradients, turned))
    scale = METAL.youngs_modulus
    assert_allclose(after, stress, atol=1e-12 * scale)
    piola = FINITE.conjugate(gradients, stress)
    assert_allclose(FINITE.conjugate(turned, after), turn(piola), atol=1e-12 * scale)


def test_plastic_flow_keeps_the_volume(gradients):
    """Plastic strain does not change the volume: ln J = tr T / 3K.

    J is the volume ratio, T the stress and K the bulk modulus.
    """
    response = METAL.respond(FINITE.strain(gradients), State.undeformed(len(gradients)))
    rr, yy, tt, ry, yr = gradients.T
    volume = ((1 + rr) * (1 + yy) - ry * yr) * (1 + tt)
    assert response.state.accumulated.max() > 0.1
    elastic = response.stress[:, :3].sum(axis=1) / (3 * METAL.bulk_modulus)
    assert_allclose(np.log(volume), elastic, atol=1e-13)


def test_small_gradients_strain_as_in_small_strain(gradients):
    tiny = 1e-6 * gradients
    small = SmallStrain()
    measured = small.matrices(tiny[:, :, None])[:, :, 0]
    # The difference is of the order of the squared gradients.
    assert_allclose(FINITE.strain(tiny), measured, atol=1e-12)


@pytest.mark.parametrize("gradient", [[-1.5, 0, 0, 0, 0], [0, 0, -1.0, 0, 0], [0, 0, 0, 2, 2]])
def test_material_turned_inside_out_is_refused(gradient):
    with pytest.raises(InvertedError, match="inside out"):
        FINITE.strain(np.array([gradient], float))


def pressed(strain, metal, force):
    """Press a coarsely meshed sphere with a force [N], unload it, and return the unloading."""
    settings = attrs.evolve(COARSE, strain=strain)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SmallStrainWarning)
        return press(metal, RADIUS, [force], settings).unloadings.iloc[0]


def test_narrow_contact_is_that_of_small_strain():
    small, finite = (pressed(strain, METAL, 200.0) for strain in ("small", "finite"))
    assert small["contact_radius"] / RADIUS == pytest.approx(0.006, rel=0.1)
    # Strains near the contact are some thousandths, so small strain has a relative error below
    # 1e-3.
    for name in ("approach", "contact_radius", "coefficient_of_restitution"):
        assert finite[name] == pytest.approx(small[name], rel=1e-3), name
    left = finite["residual_approach"] - small["residual_approach"]
    assert left == pytest.approx(0, abs=1e-3 * small["approach"])


def test_wide_contacts_are_not_warned_of_in_finite_strain():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_forces(HertzSphere(METAL, RADIUS), [2e5], strain="finite")
