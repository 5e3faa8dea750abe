# SPDX-License-Identifier: GPL-2.0-or-later
"""Laws that attract, or are plastic from first touch, as their sources print them.

Nothing here uses the compiled laws. Each reference has `loading`, pieces of first loading, and
`unloading(top)`, pieces of the way back from a largest overlap. A piece is the overlap [m] at which
it ends and its force [N] over the overlap. The contact breaks at the end of the last piece.
"""

from __future__ import annotations

from collections.abc import Callable
from math import inf, pi, sqrt

import numpy as np
from references.central_impact import motion
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

Pieces = list[tuple[float, Callable[[float], float]]]


def restitution(reference, mass: float, speed: float) -> float:
    """Return the restitution by the equation of motion; 0 if the bodies stick.

    Args:
        reference: A reference of this module.
        mass: m* [kg].
        speed: Closing speed [m/s].
    """
    unit = reference.size(mass, speed)
    scale = unit / (mass * speed**2)
    state = np.array([0.0, 1.0])
    for end, force in reference.loading:
        if state[1] > 1e-9:
            _, state = motion(state, lambda x, f=force: scale * f(unit * x), end / unit, 0.0)
    state[1] = 0.0
    for end, force in reference.unloading(unit * state[0]):
        _, state = motion(state, lambda x, f=force: scale * f(unit * x), end / unit, 0.0)
        if state[0] > end / unit + 1e-9:
            return 0.0
    return -state[1]


class Jkr:
    """Johnson, Kendall & Roberts 1971, Proc. R. Soc. Lond. A 324:301.

    F = 4 E* a^3/(3 R*) - (8 pi E* Gamma a^3)^(1/2), overlap = a^2/R* - (2 pi a Gamma/E*)^(1/2).

    Args:
        modulus: E* [Pa].
        radius: R* [m].
        gamma: Work of adhesion [J/m2].
    """

    def __init__(self, modulus: float, radius: float, gamma: float) -> None:
        self.modulus, self.radius, self.gamma = modulus, radius, gamma
        self.loading: Pieces = [(inf, self.force_at)]

    def size(self, mass: float, speed: float) -> float:
        """Return the order of the largest overlap [m]: that of Hertz, or the pull-off distance."""
        hertz = self.radius * (mass * speed**2 / (self.modulus * self.radius**3)) ** 0.4
        return hertz - self.overlap(self.least_radius())

    def least_radius(self) -> float:
        """Return the contact radius at pull-off, where the overlap is least [m]."""
        return (pi * self.gamma * self.radius**2 / (8 * self.modulus)) ** (1 / 3)

    def overlap(self, a: float) -> float:
        return a**2 / self.radius - sqrt(2 * pi * a * self.gamma / self.modulus)

    def force(self, a: float) -> float:
        hertz = 4 * self.modulus * a**3 / (3 * self.radius)
        return hertz - sqrt(8 * pi * self.modulus * self.gamma * a**3)

    def contact_radius(self, overlap: float) -> float:
        """Return the contact radius [m] on the stable branch, by Newton in the root s of it."""
        pull = sqrt(2 * pi * self.gamma / self.modulus)
        s = (pull * self.radius) ** (1 / 3) + (self.radius * abs(overlap)) ** 0.25
        for _ in range(100):
            step = (s**4 / self.radius - pull * s - overlap) / (4 * s**3 / self.radius - pull)
            s -= step
            if not step > 1e-15 * s:
                break
        return max(s**2, self.least_radius())

    def force_at(self, overlap: float) -> float:
        return self.force(self.contact_radius(overlap))

    def unloading(self, top: float) -> Pieces:
        return [(self.overlap(self.least_radius()), self.force_at)]


class ThorntonNing(Jkr):
    """Thornton & Ning 1998, Powder Technol. 99:154.

    Loading beyond yield is the integral of dF/d overlap = (3 pi R* p_y P_1^(1/2) - 2 E* a_y
    P_c^(1/2))/(3 P_1^(1/2) - P_c^(1/2)); unloading is JKR with the radius R_p*.

    Args:
        modulus, radius, gamma: As for `Jkr`.
        pressure: p_y [Pa].
    """

    def __init__(self, modulus: float, radius: float, gamma: float, pressure: float) -> None:
        super().__init__(modulus, radius, gamma)
        self.pressure, pull = pressure, sqrt(2 * gamma * modulus / pi)

        def excess(a: float) -> float:
            return 2 * modulus * a / (pi * radius) - pull / sqrt(a) - pressure

        self.yield_radius = brentq(excess, 1e-12, radius, xtol=1e-24, rtol=1e-14)
        largest = 0.5 * radius
        self.beyond = solve_ivp(
            self.rise,
            (self.yield_radius, largest),
            [self.force(self.yield_radius)],
            "DOP853",
            dense_output=True,
            rtol=1e-13,
            atol=1e-20,
        ).sol
        self.loading = [
            (self.overlap(self.yield_radius), self.force_at),
            (inf, lambda overlap: self.plastic_force(self.contact_radius(overlap))),
        ]

    def rise(self, a: float, _) -> float:
        """Return the growth of the force with the contact radius, dF/da [N/m]."""
        equivalent = sqrt(4 * self.modulus * a**3 / (3 * self.radius))  # root of P_1
        pull_off = sqrt(1.5 * pi * self.gamma * self.radius)  # root of P_c
        slope = 3 * pi * self.radius * self.pressure * equivalent
        slope = (slope - 2 * self.modulus * self.yield_radius * pull_off) / (
            3 * equivalent - pull_off
        )
        stretch = sqrt(2 * pi * self.gamma / self.modulus)
        return slope * (2 * a / self.radius - stretch / (2 * sqrt(a)))

    def plastic_force(self, a: float) -> float:
        return float(self.beyond(a)[0])

    def flattened(self, top: float) -> tuple[Jkr, float]:
        """Return the contact of radius R_p* and the overlap at which its surfaces touch."""
        a = self.contact_radius(top)
        if a <= self.yield_radius:
            return self, 0.0
        equivalent = 4 * self.modulus * a**3 / (3 * self.radius)
        pull_off = 1.5 * pi * self.gamma * self.radius
        force = self.plastic_force(a) + sqrt(4 * pull_off * equivalent)
        contact = Jkr(self.modulus, self.radius * equivalent / force, self.gamma)
        return contact, top - contact.overlap(a)

    def unloading(self, top: float) -> Pieces:
        contact, shift = self.flattened(top)
        end = contact.overlap(contact.least_radius()) + shift
        return [(end, lambda overlap: contact.force_at(overlap - shift))]


class WaltonBraun:
    """Walton & Braun 1986, J. Rheol. 30:949: F = k_1 d, and F = k_2 (d - d_0) on the way back.

    Args:
        first, second: k_1 and k_2 [N/m].
    """

    def __init__(self, first: float, second: float) -> None:
        self.first, self.second = first, second
        self.loading: Pieces = [(inf, lambda overlap: first * overlap)]

    def size(self, mass: float, speed: float) -> float:
        """Return the largest overlap [m]."""
        return speed * sqrt(mass / self.first)

    def unloading(self, top: float) -> Pieces:
        rest = (1 - self.first / self.second) * top
        return [(rest, lambda overlap: self.second * (overlap - rest))]


class Luding:
    """Luding 2008, Granular Matter 10:235.

    Args:
        first, second, adhesive: k_1, k_2 and k_c [N/m].
        depth: phi [-].
        radius: R* [m]; 2 R* is 2 a_1 a_2/(a_1 + a_2) of the source.
    """

    def __init__(
        self, first: float, second: float, adhesive: float, depth: float, radius: float
    ) -> None:
        self.first, self.second, self.adhesive = first, second, adhesive
        self.limit = limit = second / (second - first) * depth * 2 * radius
        self.loading: Pieces = [
            (limit, lambda overlap: first * overlap),
            (inf, lambda overlap: first * limit + second * (overlap - limit)),
        ]

    def size(self, mass: float, speed: float) -> float:
        """Return the order of the largest overlap [m]."""
        return speed * sqrt(mass / self.first)

    def unloading(self, top: float) -> Pieces:
        top = min(top, self.limit)
        stiffness = self.first + (self.second - self.first) * top / self.limit
        rest = (1 - self.first / stiffness) * top
        return [
            (stiffness * rest / (stiffness + self.adhesive), lambda d: stiffness * (d - rest)),
            (0.0, lambda d: -self.adhesive * d),
        ]


class Edinburgh:
    """Thakur et al. 2014, Granular Matter 16:383, with the exponent 3/2 and f_0 = 0.

    Args:
        modulus: E* [Pa].
        radius: R* [m].
        ratio, adhesion: k_2/k_1 and k_adh/k_1 [-].
    """

    def __init__(self, modulus: float, radius: float, ratio: float, adhesion: float) -> None:
        self.modulus, self.radius, self.ratio, self.adhesion = modulus, radius, ratio, adhesion
        self.first = 4 / 3 * modulus * sqrt(radius)
        self.loading: Pieces = [(inf, lambda overlap: self.first * max(overlap, 0) ** 1.5)]

    def size(self, mass: float, speed: float) -> float:
        """Return the largest overlap [m]."""
        return (1.25 * mass * speed**2 / self.first) ** 0.4

    def unloading(self, top: float) -> Pieces:
        rest = (1 - 1 / self.ratio) * top**1.5
        second, adhesive = self.ratio * self.first, self.adhesion * self.first
        begin = (second * rest / (second + adhesive)) ** (2 / 3)
        return [
            (begin, lambda overlap: second * (max(overlap, 0) ** 1.5 - rest)),
            (0.0, lambda overlap: -adhesive * max(overlap, 0) ** 1.5),
        ]
