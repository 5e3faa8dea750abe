# SPDX-License-Identifier: GPL-2.0-or-later
"""Free vibrations of the elastic sphere, and its Hertzian impact, compared with theory."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from numpy.polynomial.legendre import leggauss
from scipy.linalg import eigh
from scipy.special import jacobi

from plastigran.experiments.central import GEOMETRIES, CentralImpact
from plastigran.materials import read_material
from plastigran.physics import central
from plastigran.physics.modes import (
    radial,
    radial_roots,
    sphere_modes,
    spheroidal,
    spheroidal_roots,
    toroidal,
    toroidal_roots,
    wave_speed_ratio,
)

RATIOS = [-0.3, 0.0, 0.25, 0.3, 0.45]
COUNT = 8


def rayleigh_ritz(kind: str, degree: int, poissons_ratio: float, count: int) -> np.ndarray:
    """Return the lowest frequencies of the modes of a sphere by the method of Rayleigh and Ritz.

    The frequencies are values of k a, with the wave number k of shear waves and the radius a. The
    displacement is (U Y, V r grad Y), or W for toroidal modes, with a spherical harmonic Y. U, V
    and W are polynomials in r of least energy, without Bessel functions. By the minimum principle,
    the n-th value is never below the n-th mode, so a missed mode would shift all higher ones.
    """
    nodes, weights = leggauss(80)
    r, dr = (nodes + 1) / 2, weights / 2
    square = degree * (degree + 1)
    lame = 1 / wave_speed_ratio(poissons_ratio) ** 2 - 2  # lambda/mu
    power = {"toroidal": degree, "radial": 1, "spheroidal": degree - 1}[kind]
    polynomials = [jacobi(order, 0, power + 0.5) for order in range(20)]  # orthogonal with r^2
    t = 2 * r**2 - 1
    f = np.array([r**power * p(t) for p in polynomials])
    slope = power * f / r + np.array([r**power * 4 * r * p.deriv()(t) for p in polynomials])
    none = np.zeros_like(f)

    def form(*strains: tuple[float, np.ndarray]) -> np.ndarray:
        return sum(factor * (s * dr * r**2) @ s.T for factor, s in strains)

    if kind == "toroidal":
        stiffness = form((1, slope - f / r), (square - 2, f / r))
        mass = form((1, f))
    elif kind == "radial":
        stiffness = form((lame, slope + 2 * f / r), (2, slope), (4, f / r))
        mass = form((1, f))
    else:
        u, v = np.vstack([f, none]), np.vstack([none, f])
        du, dv = np.vstack([slope, none]), np.vstack([none, slope])
        spread = (2 * u - square * v) / r
        shear = dv + (u - v) / r
        stiffness = form(
            (lame, du + spread),
            (2, du),
            (1, spread),
            (square, shear),
            (square * (square - 2), v / r),
        )
        mass = form((1, u), (square, v))
    values = np.sqrt(np.maximum(eigh(stiffness, mass, eigvals_only=True), 0))
    return values[values > 1e-2][:count]  # without rigid motions


@pytest.mark.parametrize("degree", [1, 2, 3, 7, 20])
@pytest.mark.parametrize("poissons_ratio", RATIOS)
def test_spheroidal_modes_are_those_of_least_energy(degree, poissons_ratio):
    """All spheroidal modes are found in order, and agree with those of `rayleigh_ritz`.

    The relative tolerance 1e-5 is the error of the polynomials for the highest mode.
    """
    found = spheroidal_roots(degree, poissons_ratio, COUNT)
    expected = rayleigh_ritz("spheroidal", degree, poissons_ratio, COUNT)
    assert found == pytest.approx(expected, rel=1e-5)
    assert (found <= expected * (1 + 1e-9)).all()


@pytest.mark.parametrize("degree", [1, 2, 3, 20])
def test_toroidal_modes_are_those_of_least_energy(degree):
    expected = rayleigh_ritz("toroidal", degree, 0.25, COUNT)
    assert toroidal_roots(degree, COUNT) == pytest.approx(expected, rel=1e-5)


@pytest.mark.parametrize("poissons_ratio", RATIOS)
def test_radial_modes_are_those_of_least_energy(poissons_ratio):
    expected = rayleigh_ritz("radial", 0, poissons_ratio, COUNT)
    found = radial_roots(poissons_ratio, COUNT) / wave_speed_ratio(poissons_ratio)
    assert found == pytest.approx(expected, rel=1e-5)


@pytest.mark.parametrize("degree", [1, 2, 5])
def test_every_root_is_one_and_none_is_missed(degree):
    """The characteristic function changes sign at each root, and nowhere else on a grid ten
    times finer than that of the search.
    """
    for roots, function in (
        (spheroidal_roots(degree, 0.25, COUNT), lambda x: spheroidal(degree, 0.25, x)),
        (toroidal_roots(degree, COUNT), lambda x: toroidal(degree, x)),
        (radial_roots(0.25, COUNT), lambda x: radial(0.25, x)),
    ):
        grid = np.arange(0.5, roots[-1] + 0.01, 1e-2)
        signs = np.sign([function(x) for x in grid])
        assert np.sum(signs[1:] != signs[:-1]) == COUNT
        for root in roots:
            assert function(root * (1 - 1e-9)) * function(root * (1 + 1e-9)) < 0


@pytest.mark.parametrize(
    ("found", "printed"),
    [
        # k a/pi and, for radial modes, h a/pi, from Lamb 1882 as in Love 1927, art. 195-196. k and
        # h are the wave numbers of shear and compression waves.
        (lambda: toroidal_roots(1, 6), [1.8346, 2.8950, 3.9225, 4.9385, 5.9489, 6.9563]),
        (lambda: toroidal_roots(2, 6), [0.7961, 2.2715, 3.3469, 4.3837, 5.4059, 6.4209]),
        (lambda: radial_roots(0.25, 6), [0.8160, 1.9285, 2.9539, 3.9658, 4.9728, 5.9774]),
        (lambda: spheroidal_roots(2, 0.25, 2), [0.840, 1.549]),
        (lambda: spheroidal_roots(2, 0.5 - 1e-7, 2), [0.848, 1.742]),  # incompressible
    ],
)
def test_lambs_and_loves_tables(found, printed):
    digits = len(str(printed[0]).split(".")[1])
    assert found() / pi == pytest.approx(printed, abs=0.51 * 10**-digits)


def test_toroidal_degree_one_is_the_textbook_equation():
    """Toroidal modes of degree 1 satisfy tan x = 3x/(3 - x^2), with x = k a.

    In these modes, the shell rotates against the core. k is the wave number of shear waves, and a
    the radius.
    """
    for x in toroidal_roots(1, 5):
        assert np.tan(x) == pytest.approx(3 * x / (3 - x**2), rel=1e-10)


def test_modes_of_the_ice_sphere():
    """The lowest modes of an ice sphere have the frequencies of docs/elastic_sphere.md.

    The radius is 10 mm, nu = 1/4, E = 9.3 GPa, and the density is 900 kg/m^3.
    """
    ice = read_material("ice")
    table = sphere_modes(ice.youngs_modulus, ice.poissons_ratio, ice.density, 0.01)
    table = table.set_index(["kind", "degree", "overtone"])["frequency"] / 1e3
    assert table["radial", 0, 0] == pytest.approx(143.67, abs=0.005)
    assert table["toroidal", 1, 0] == pytest.approx(186.49, abs=0.005)
    assert table["spheroidal", 2, 0] == pytest.approx(85.42, abs=0.005)
    assert table["spheroidal", 2, 1] == pytest.approx(157.43, abs=0.005)
    assert (table.to_numpy()[1:] >= table.to_numpy()[:-1]).all()


def test_incompressible_spheres_are_refused():
    with pytest.raises(ValueError, match=r"poissons_ratio is 0\.5; it must be between"):
        sphere_modes(youngs_modulus=1e9, poissons_ratio=0.5, density=1e3, radius=0.01)


@pytest.mark.parametrize("geometry", GEOMETRIES)
def test_hertzian_collision_of_the_ice_sphere(geometry, tmp_path):
    """Duration, largest force and overlap with LIGGGHTS' hertz agree with the closed forms.

    The time step is a tenth of the recommended one. The relative tolerance is 1e-4, because the
    largest force is known only at the steps.
    """
    model = CentralImpact("hertz", 0.1, read_material("ice"), 0.01, geometry)
    found = model.run(tmp_path, model.timestep / 10)
    bodies = (model.radius_eff, model.mass_eff, model.pair.youngs_modulus_eff, model.closing_speed)
    assert found.contact_time == pytest.approx(float(central.hertz_duration(*bodies)), rel=1e-4)
    assert found.force_max == pytest.approx(float(central.hertz_force_max(*bodies)), rel=1e-4)
    assert found.overlap_max == pytest.approx(float(central.hertz_overlap_max(*bodies)), rel=1e-4)
    assert found.coefficient_of_restitution == pytest.approx(1, abs=1e-4)


def test_duration_is_the_plane_walls_closed_form():
    """The duration of Hertz' impact of a sphere on a rigid plane has the known closed form.

    It is 2.943275 R v^(-1/5) (5 pi rho (1 - nu^2)/(4 E))^(2/5), with the density rho.
    """
    ice = read_material("ice")
    model = CentralImpact("hertz", 0.1, ice, 0.01)
    found = central.hertz_duration(
        model.radius_eff, model.mass_eff, model.pair.youngs_modulus_eff, model.closing_speed
    )
    group = 1.25 * pi * ice.density * (1 - ice.poissons_ratio**2) / ice.youngs_modulus
    assert found == pytest.approx(2.943275 * 0.01 * 0.1**-0.2 * group**0.4, rel=1e-6)
