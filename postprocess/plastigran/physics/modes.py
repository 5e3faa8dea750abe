# SPDX-License-Identifier: GPL-2.0-or-later
"""Free vibrations of a homogeneous elastic sphere, to judge quasi-static contact laws.

Toroidal modes shear the sphere along its surface. Spheroidal modes displace the surface; spheroidal
modes of degree 0 are radial. Let k and h be the wave numbers of shear and compression waves at the
frequency of a mode. The code uses x = k a and y = h a, with the radius a of the sphere. The ratio
y/x = c_t/c_l of the speeds of shear and compression waves depends only on Poisson's ratio.

Sources: Lamb 1882 (Proc. Lond. Math. Soc. s1-13:189); Love, Mathematical Theory of Elasticity
(1927), ch. XII.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from itertools import pairwise
from math import pi, sqrt

import numpy as np
import pandas as pd
from scipy.optimize import brentq
from scipy.special import spherical_jn

#: Step of x = k a in the search for spheroidal modes. Most modes are some twenty steps apart;
#: bisection separates closer modes.
STEP = 0.1

Function = Callable[[float], float]


def wave_speed_ratio(poissons_ratio: float) -> float:
    """Return the ratio c_t/c_l of the speeds of shear and compression waves [-]."""
    return sqrt((1 - 2 * poissons_ratio) / (2 * (1 - poissons_ratio)))


def sphere_modes(
    youngs_modulus: float,
    poissons_ratio: float,
    density: float,
    radius: float,
    degrees: Iterable[int] = range(5),
    overtones: int = 3,
) -> pd.DataFrame:
    """Return the lowest free vibrations of an elastic sphere for each kind and degree.

    Args:
        youngs_modulus: Young's modulus E [Pa].
        poissons_ratio: Poisson's ratio nu, between -1 and 0.5 [-].
        density: Density [kg/m^3].
        radius: Radius a of the sphere [m].
        degrees: Degrees n of the spherical harmonics; degree 0 has radial modes only.
        overtones: Number of modes for each kind and degree.

    Returns:
        One row per mode, sorted by frequency. The columns are kind (radial, spheroidal or
        toroidal), degree, overtone (0 is the lowest), ka and ha [-] (wave numbers of shear and
        compression waves times the radius), and frequency [Hz].

    Raises:
        ValueError: Poisson's ratio is out of range.
        ArithmeticError: Two spheroidal modes are too close to separate.
    """
    if not -1 < poissons_ratio < 0.5:
        raise ValueError(f"poissons_ratio is {poissons_ratio:g}; it must be between -1 and 0.5")
    rows = []
    ratio = wave_speed_ratio(poissons_ratio)
    for degree in degrees:
        if degree == 0:
            roots_by_kind = {"radial": radial_roots(poissons_ratio, overtones) / ratio}
        else:
            roots_by_kind = {
                "spheroidal": spheroidal_roots(degree, poissons_ratio, overtones),
                "toroidal": toroidal_roots(degree, overtones),
            }
        rows += [
            (kind, degree, overtone, ka, ka * ratio)
            for kind, roots in roots_by_kind.items()
            for overtone, ka in enumerate(roots)
        ]
    table = pd.DataFrame(rows, columns=["kind", "degree", "overtone", "ka", "ha"])
    shear_speed = sqrt(youngs_modulus / (2 * (1 + poissons_ratio) * density))
    table["frequency"] = table["ka"] * shear_speed / (2 * pi * radius)
    return table.sort_values("frequency", ignore_index=True)


def bessel_zeros(degree: int, count: int) -> np.ndarray:
    """Return the first positive zeros of the spherical Bessel function j_n, (count,).

    The zeros of j_0 are multiples of pi. Two adjacent zeros of j_(n-1) enclose one zero of j_n.
    """
    zeros = pi * np.arange(1, count + degree + 1)
    for n in range(1, degree + 1):
        zeros = roots_between(lambda x, n=n: spherical_jn(n, x), zeros)
    return zeros


def roots_between(function: Function, edges: np.ndarray) -> np.ndarray:
    """Return the root of a function between each two adjacent edges, (len(edges) - 1,)."""
    return np.array([brentq(function, a, b, xtol=1e-14, rtol=1e-15) for a, b in pairwise(edges)])


def toroidal(degree: int, x: float) -> float:
    """Return x j_n'(x) - j_n(x), the scaled shear stress on the surface in a toroidal motion.

    j_n is the spherical Bessel function of the degree. The stress is zero if x is the wave number
    k a of a toroidal mode.
    """
    return x * spherical_jn(degree, x, derivative=True) - spherical_jn(degree, x)


def radial(poissons_ratio: float, y: float) -> float:
    """Return y j_0(y) - 4 (c_t/c_l)^2 j_1(y), the scaled normal stress in a radial motion.

    j_0 and j_1 are spherical Bessel functions. The stress on the surface is zero if y is the wave
    number h a of a radial mode.
    """
    return y * spherical_jn(0, y) - 4 * wave_speed_ratio(poissons_ratio) ** 2 * spherical_jn(1, y)


def toroidal_roots(degree: int, count: int) -> np.ndarray:
    """Return the wave numbers k a of the first toroidal modes (count,) [-].

    With the spherical Bessel function j_n, the quotient x j_n'/j_n decreases from n at x = 0, and
    from +inf to -inf between zeros of j_n. The quotient therefore equals 1 once before each zero.
    For n = 1, the first root is x = 0, which is the rotation of the sphere and not a vibration.
    """
    zeros = bessel_zeros(degree, count + 1)
    edges = zeros if degree == 1 else np.concatenate([[1e-3 * degree], zeros[:-1]])
    return roots_between(lambda x: toroidal(degree, x), edges)


def radial_roots(poissons_ratio: float, count: int) -> np.ndarray:
    """Return the wave numbers h a of the first radial modes (count,) [-].

    With the spherical Bessel functions j_0 and j_1, the quotient y j_0/j_1 decreases from 3 at
    y = 0, and from +inf to -inf between zeros of j_1. The quotient therefore equals
    4 (c_t/c_l)^2 < 3 once before each zero.
    """
    edges = np.concatenate([[1e-6], bessel_zeros(1, count)])
    return roots_between(lambda y: radial(poissons_ratio, y), edges)


def surface(degree: int, poissons_ratio: float, x: float) -> tuple[np.ndarray, np.ndarray]:
    """Return surface displacement and surface traction of the two waves of a spheroidal mode.

    Column 0 is the compression wave grad(j_n(h r) Y), column 1 the shear wave
    curl curl(r j_n(k r) Y), with the spherical Bessel function j_n and the spherical harmonic Y.
    Row 0 is the component along r, row 1 the component along grad Y times sqrt(n(n+1)). The product
    displacement^T traction is then the work on the surface. Each wave is normalized to a
    displacement of one. Lengths are divided by the radius a, stresses by the shear modulus.

    Returns:
        displacement, traction, (2, 2) each.
    """
    square = degree * (degree + 1)
    arguments = np.array([x * wave_speed_ratio(poissons_ratio), x])
    # Compute both orders in one call, because calls of spherical_jn are slow.
    below, (p, s) = spherical_jn([[degree - 1], [degree]], arguments)
    # x j_n'(x) = x j_(n-1)(x) - (n + 1) j_n(x)
    p_slope, s_slope = arguments * below - (degree + 1) * np.array([p, s])
    displacement = np.array([[p_slope, square * s], [p, s + s_slope]])
    traction = np.array(
        [
            [(2 * square - x**2) * p - 4 * p_slope, 2 * square * (s_slope - s)],
            [2 * (p_slope - p), (2 * square - 2 - x**2) * s - 2 * s_slope],
        ]
    )
    for part in (displacement, traction):
        part[1] *= sqrt(square)
    size = np.linalg.norm(displacement, axis=0)
    return displacement / size, traction / size


def spheroidal(degree: int, poissons_ratio: float, x: float) -> float:
    """Return the determinant of the surface tractions, which is zero at x = k a of each mode."""
    return float(np.linalg.det(surface(degree, poissons_ratio, x)[1]))


def spheroidal_roots(degree: int, poissons_ratio: float, count: int) -> np.ndarray:
    """Return the wave numbers k a of the first spheroidal modes of one degree (> 0), (count,) [-].

    The two eigenvalues of the dynamic stiffness of the surface (traction/displacement) decrease
    with x from pole to pole. A mode is a zero of one eigenvalue. The number of modes below x is the
    number of negative eigenvalues plus the number of poles (Wittrick & Williams 1971, Q. J. Mech.
    Appl. Math. 24:263). An interval with several modes is bisected until the determinant changes
    its sign in a separate interval for each mode.

    Raises:
        ArithmeticError: Two modes are too close to separate.
    """

    def look(x: float) -> tuple[float, int, float, float]:
        displacement, traction = surface(degree, poissons_ratio, x)
        stiffness = np.linalg.solve(displacement.T, traction.T) / x
        eigenvalues = np.linalg.eigvalsh((stiffness + stiffness.T) / 2)
        angle = float(np.sum(np.arctan(eigenvalues)))
        negative = int(np.sum(eigenvalues < 0))
        return x, negative, angle, float(np.linalg.det(traction))

    def passed(a, b) -> int:
        """Return the number of modes between two results a and b of `look`.

        The number of poles follows from the angles arctan(eigenvalue). An angle decreases by pi
        between two poles of its eigenvalue, and jumps up by pi at a pole.
        """
        poles = int(np.ceil((b[2] - a[2]) / pi - 1e-9))
        return poles + b[1] - a[1]

    def isolate(a, b, depth: int) -> list[tuple[float, float]]:
        middle = look((a[0] + b[0]) / 2)
        if depth == 0:
            modes = passed(a, b)
            changes_sign = a[3] * b[3] < 0
            if modes == changes_sign:
                return [(a[0], b[0])] if changes_sign else []
            if b[0] - a[0] < 1e-9:
                raise ArithmeticError(
                    f"spheroidal modes near wavenumber times radius = {a[0]:g} are too close to "
                    "separate"
                )
        depth = max(depth - 1, 0)
        return isolate(a, middle, depth) + isolate(middle, b, depth)

    brackets: list[tuple[float, float]] = []
    last = look(0.02 * degree)
    while len(brackets) < count:
        here = look(last[0] + STEP)
        brackets += isolate(last, here, depth=1)
        last = here
    return np.array(
        [
            brentq(lambda x: spheroidal(degree, poissons_ratio, x), a, b, xtol=1e-14, rtol=1e-15)
            for a, b in brackets[:count]
        ]
    )
