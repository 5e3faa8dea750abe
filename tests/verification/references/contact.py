# SPDX-License-Identifier: GPL-2.0-or-later
"""Base class of the references: contact laws as printed in their sources, without compiled laws.

All values are in SI units. The docstrings of the references use the symbols

    d, F, a     overlap, force, contact radius (half-width for cylinders)
    index m     at the largest overlap;  d_r: residual overlap
    y           (d - d_r)/(d_m - d_r), the remaining fraction of the unloading curve
    Y, p_y      yield strength, yield pressure
    R*, E*      effective radius and modulus;  nu: Poisson's ratio
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from math import inf, pi, sqrt

import numpy as np
from scipy.integrate import quad
from scipy.optimize import minimize_scalar


@dataclass(frozen=True)
class Material:
    """Constants of a body: Young's modulus [Pa], Poisson's ratio, density [kg/m^3], uniaxial yield
    strength [Pa], yield pressure / yield strength, dissipative constant [s], tangent modulus [Pa].
    """

    youngs_modulus: float
    poissons_ratio: float
    density: float
    yield_strength: float = inf
    yield_pressure_factor: float = 0.0
    dissipative_constant: float = 0.0
    tangent_modulus: float = 0.0

    @cached_property
    def modulus(self) -> float:
        """Return E* on a rigid plane [Pa]."""
        return self.youngs_modulus / (1 - self.poissons_ratio**2)

    @cached_property
    def yield_pressure(self) -> float:
        """Return the yield pressure p_y [Pa]."""
        return self.yield_pressure_factor * self.yield_strength


MATERIALS = {
    # Zhang & Vu-Quoc 2002, Int. J. Impact Eng. 27:317, sec. 3.
    "aluminium_zv02": Material(7e10, 0.3, 2699.0, 1e8, 1.61),
    # Katta & Polycarpou 2010, J. Tribol. 132: E* of the pair is 83.96 GPa.
    "glass_kp10": Material(83.96e9 * (1 - 0.23**2), 0.23, 2500.0, 2.41e9),
    # EN 1993-1-1, 3.2; tangent modulus E/100 from EN 1993-1-5, annex C.6.
    "steel_s355": Material(2.1e11, 0.3, 7850.0, 3.55e8, tangent_modulus=2.1e9),
    # Rounded constants of ice. The dissipative constant is fitted to measurements of Bridges,
    # Hatzes & Lin 1984, Nature 309:333.
    "ice": Material(9.3e9, 0.25, 900.0, dissipative_constant=1e-4),
}


def work(force: Callable[[float], float], begin: float, end: float) -> float:
    """Return the integral of a smooth force to round-off."""
    return quad(force, begin, end, epsabs=0, epsrel=1e-12, limit=200)[0]


class Contact:
    """Contact of a sphere, or of the body of a subclass, with a rigid plane.

    Attributes:
        pieces: Formulas of first loading in ascending order, as pairs of the overlap [m] at which a
            formula ends and the formula. The first formula is elastic; the last one ends at
            infinity.
        energy_guard: Whether the recovery is reduced where plastic work would decrease during
            loading.
        readings: Other interpretations of the source, each as an option or constant with its value.
        reading: Interpretation in use; empty for the default.
    """

    pieces: list[tuple[float, Callable]]
    energy_guard = False
    readings: tuple[str, ...] = ()
    reading = ""

    def __init__(self, material: Material, radius: float) -> None:
        self.material, self.radius = material, radius

    def hertz(self, overlap: float) -> float:
        """Return 4/3 E* sqrt(R*) d^1.5 [N]."""
        return 4 / 3 * self.material.modulus * sqrt(self.radius) * overlap**1.5

    def overlap_at(self, pressure: float) -> float:
        """Return the overlap [m], R* (pi p/2E*)^2, at which Hertz' largest pressure is p [Pa]."""
        return self.radius * (pi * pressure / (2 * self.material.modulus)) ** 2

    def published_rebound(self, overlap_max: float) -> tuple[float, Callable]:
        """Return the unloading curve of the source from a largest overlap [m] beyond yield.

        Returns:
            The recovered overlap [m], and a function for force / largest force. Its argument is the
            remaining fraction of the recovered overlap, from 1 to 0.
        """
        raise NotImplementedError

    def contact_radius(self, overlap: float) -> float:
        """Return the contact radius [m] during first loading beyond yield."""
        raise NotImplementedError

    def released_radius(self, left: float, shape: Callable) -> float:
        """Return contact radius / largest contact radius at a remaining fraction of the
        unloading curve `shape`. As for Hertz, the contact radius is proportional to the slope of
        the force. Finite differences have an error of 1e-8.
        """
        step = 1e-4

        def slope(share: float) -> float:
            return (shape(share * (1 + step)) - shape(share * (1 - step))) / share

        return slope(left) / slope(1.0)

    def loading_force(self, overlap: float) -> float:
        return next(float(force(overlap)) for end, force in self.pieces if overlap <= end)

    @cached_property
    def works(self) -> list[tuple[float, float]]:
        """Return the overlap [m] at which each formula begins, and the loading work to it [J]."""
        found = [(0.0, 0.0)]
        for end, force in self.pieces[:-1]:
            begin, before = found[-1]
            found.append((end, before + work(force, begin, end)))
        return found

    def loading_work(self, overlap: float) -> float:
        (begin, before), force = next(
            (start, force)
            for start, (end, force) in zip(self.works, self.pieces, strict=True)
            if overlap <= end
        )
        return before + work(force, begin, overlap)

    def rebound(self, overlap_max: float) -> tuple[float, Callable]:
        """Return the recovered overlap [m] and the shape of the unloading curve.

        Unlike `published_rebound`, this includes elastic contacts and the energy guard.
        """
        end, elastic = self.pieces[0]
        force_max = self.loading_force(overlap_max)
        if overlap_max <= end:
            return overlap_max, lambda left: elastic(left * overlap_max) / force_max
        recovery, shape = self.published_rebound(overlap_max)
        if self.energy_guard:
            returned = self.loading_work(overlap_max) - self.largest_loss(overlap_max)
            recovery = min(recovery, returned / force_max / work(shape, 0, 1))
        return recovery, shape

    def published_loss(self, overlap_max: float) -> float:
        recovery, shape = self.published_rebound(overlap_max)
        returned = self.loading_force(overlap_max) * recovery * work(shape, 0, 1)
        return self.loading_work(overlap_max) - returned

    def largest_loss(self, reach: float) -> float:
        """Return the largest plastic work [J] of the published law during loading to `reach`. The
        function refines the maximum of a scan.
        """
        breaks = [end * side for end, _ in self.pieces for side in (1, 1 + 1e-12)]
        scan = {*np.geomspace(breaks[1], reach, 40)[:-1], *breaks, reach}
        scan = sorted(x for x in scan if breaks[0] < x <= reach)
        loss = [self.published_loss(x) for x in scan]
        top = int(np.argmax(loss))
        if 0 < top < len(scan) - 1:
            found = minimize_scalar(
                lambda share: -self.published_loss(share * reach),
                bounds=(scan[top - 1] / reach, scan[top + 1] / reach),
                method="bounded",
                options={"xatol": 1e-9},
            )
            loss.append(-found.fun)
        return max(0.0, *loss)

    def follow(self, overlaps) -> np.ndarray:
        """Return the force [N] along a path of overlaps [m] from first touch."""
        forces, overlap_max, rebound = [], 0.0, None
        for overlap in overlaps:
            if overlap >= overlap_max:
                overlap_max, rebound = overlap, None
            if overlap == overlap_max or overlap_max <= self.pieces[0][0]:
                forces.append(self.loading_force(overlap))
                continue
            recovery, shape = rebound = rebound or self.rebound(overlap_max)
            left = max(0.0, 1 - (overlap_max - overlap) / recovery)
            forces.append(self.loading_force(overlap_max) * float(shape(left)))
        return np.array(forces)
