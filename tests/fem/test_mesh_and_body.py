# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the mesh of a sphere, and of the forces, strains and mass of its elements."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from numpy.testing import assert_allclose
from skfem import Basis, BilinearForm, ElementQuadS2, ElementVector
from skfem.helpers import grad

from plastigran.fem.body.body import STIFFNESS_ORDER, Body
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.mesh.sphere import SphereMesh
from plastigran.fem.stepping.linear import SymmetricSystem

RADIUS, CORE, REACH = 0.1, 4e-4, 1.5e-3
MATERIAL = ElasticPlastic(youngs_modulus=70e9, poissons_ratio=0.3, density=2699.0)


@pytest.fixture(scope="module", params=[True, False], ids=["whole", "half"])
def mesh(request):
    return SphereMesh(
        radius=RADIUS, core=CORE, reach=REACH, divisions=4, whole=request.param
    ).build()


@pytest.fixture(scope="module")
def body(mesh):
    return Body(mesh, MATERIAL)


def test_elements_are_sound(mesh):
    determinants = (basis := Basis(mesh, ElementQuadS2(), intorder=5)).mapping.detDF(basis.X)
    assert np.all(determinants > 0)
    # Elements are nearly square outside the fine zone. In the fine zone, their sides have a ratio
    # of up to 3. The Jacobian varies by less than this ratio within an element.
    assert np.min(determinants.min(axis=1) / determinants.max(axis=1)) > 0.3


def test_surface_lies_on_the_circle(mesh):
    r, y = mesh.doflocs[:, np.unique(mesh.facets[:, mesh.boundaries["circle"]])]
    assert_allclose(np.hypot(r, y - RADIUS), RADIUS, rtol=1e-12)


def test_half_a_sphere_ends_at_the_equator(mesh):
    if "equator" in mesh.boundaries:
        heights = mesh.p[1, mesh.facets[:, mesh.boundaries["equator"]]]
        assert_allclose(heights, RADIUS, rtol=1e-12)
    else:
        assert mesh.p[1].max() == pytest.approx(2 * RADIUS, rel=1e-12)


def test_elements_are_fine_where_the_contact_is():
    mesh = SphereMesh(radius=RADIUS, core=CORE, reach=REACH, divisions=4).build()
    ends = np.sort(mesh.p[0][mesh.facets[:, mesh.boundaries["circle"]]], axis=0)
    size = (ends[1] - ends[0])[(ends[1] < REACH) & (ends[0] > CORE)]
    # The length of an edge is about pi/48 = 0.065 times its distance from the axis. The limit is
    # larger, because the number of rings is rounded.
    assert np.all(size < 0.08 * REACH)


def test_mass_is_that_of_the_sphere(body, mesh):
    share = 0.5 if "equator" in mesh.boundaries else 1.0
    # Element edges are parabolas through three points of the circle. With elements of 0.4 rad, the
    # mass is therefore 1e-4 too small.
    assert body.mass == pytest.approx(share * 2699 * 4 / 3 * pi * RADIUS**3, rel=2e-4)


def test_linear_displacements_strain_evenly(body):
    displacement = np.zeros(body.size)
    radial, vertical = body.dofs[:, 0::2], body.dofs[:, 1::2]
    displacement[radial] = 1e-3 * body.locations[0, radial]
    displacement[vertical] = 2e-3 * body.locations[1, vertical] + 3 * body.locations[0, vertical]
    expected = np.broadcast_to([1e-3, 2e-3, 1e-3, 3.0], (body.points, 4))
    assert_allclose(body.strain(displacement), expected, rtol=1e-6, atol=1e-9)


def test_stiffness_is_symmetric_and_free_of_rigid_motion(body):
    stiffness = body.elastic_stiffness
    scale = np.abs(stiffness).max()
    assert_allclose(stiffness, stiffness.transpose(0, 2, 1), atol=1e-12 * scale)
    up = np.tile([0.0, 1.0], 8)
    assert_allclose(stiffness @ up, 0, atol=1e-11 * scale)


def test_stiffness_is_the_one_scikit_fem_assembles(mesh, body):
    tangent = MATERIAL.elastic_tangent

    def strains(field, radius):
        slope = grad(field)
        return slope[0, 0], slope[1, 1], field[0] / radius, slope[0, 1] + slope[1, 0]

    @BilinearForm
    def form(u, v, w):
        of_u, of_v = strains(u, w.x[0]), strains(v, w.x[0])
        work = sum(
            tangent[i, j] * of_v[i] * of_u[j] for i in range(4) for j in range(4) if tangent[i, j]
        )
        return 2 * pi * w.x[0] * work

    basis = Basis(mesh, ElementVector(ElementQuadS2()), intorder=STIFFNESS_ORDER)
    load = np.zeros(body.size)
    load[body.dofs[0]] = np.arange(16.0)
    fixed = np.append(body.fixed, body.dofs[-1])
    system = SymmetricSystem([body.dofs], body.size, fixed)
    solution = system.factor([body.elastic_stiffness]).solve(load)
    answered = form.assemble(basis) @ solution
    free = system.free
    # The tolerance is round-off times the condition number for elements from 1e-5 m to 1e-2 m.
    assert_allclose(answered[free], load[free], atol=1e-6)
