# SPDX-License-Identifier: GPL-2.0-or-later
"""Central impact by the equations of a law, computed from energies and from the motion."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import astuple, dataclass, replace
from functools import cached_property
from math import pi, sqrt

import numpy as np
from references.contact import Contact, Material, work
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq


@dataclass(frozen=True)
class Outcome:
    """Outcome of an impact: restitution [-], force [N], overlaps [m] and time [s]."""

    coefficient_of_restitution: float
    force_max: float
    overlap_max: float
    overlap_res: float
    contact_time: float

    def agrees_with(self, other: Outcome) -> bool:
        """Return whether all numbers agree to a relative 1e-9; the residual overlap is compared
        relative to the largest overlap."""
        scale = astuple(replace(self, overlap_res=self.overlap_max))
        off = np.abs(np.subtract(astuple(self), astuple(other)))
        return bool((off <= 1e-9 * np.array(scale)).all())


class CentralImpact(Contact):
    """Central impact of a sphere on a rigid plane; each reference is a subclass.

    Attributes:
        cases: Impacts to compare, as a table in CSV format.
        material_name: Material for which the law is compared on loading paths.
    """

    cases = """\
material,radius,speed
aluminium_zv02,0.1,0.02
aluminium_zv02,0.1,0.10
aluminium_zv02,0.1,0.20
"""
    material_name = "aluminium_zv02"

    def __init__(self, material: Material, radius: float, speed: float) -> None:
        super().__init__(material, radius)
        self.speed = speed
        self.mass = 4 / 3 * pi * radius**3 * material.density

    def two_ways(self) -> tuple[Outcome, Outcome]:
        return self.by_energies(), self.by_motion()

    @cached_property
    def overlap_max(self) -> float:
        """Return the largest overlap [m], where the work of first loading equals the kinetic
        energy.
        """
        energy, reach = 0.5 * self.mass * self.speed**2, 1e-9 * self.radius
        while self.loading_work(reach) < energy:
            reach *= 2
        return brentq(lambda x: self.loading_work(x) - energy, 0, reach, xtol=1e-30, rtol=1e-15)

    def by_energies(self) -> Outcome:
        """Return the outcome from work and time, which are computed by quadrature."""
        top, energy = self.overlap_max, 0.5 * self.mass * self.speed**2
        force_max, (recovery, shape) = self.loading_force(top), self.rebound(top)
        returned = force_max * recovery * work(shape, 0, 1)
        time, begin = 0.0, 0.0
        for end, force in self.pieces:
            if end < top:
                time += self.duration(force, begin, end, energy - self.loading_work(end))
                begin = end
            else:
                time += self.duration(force, begin, top)
                break
        # The variable of unloading is the remaining fraction of the recovered overlap.
        time += recovery * self.duration(lambda left: force_max * recovery * shape(left), 0, 1)
        return Outcome(sqrt(returned / energy), force_max, top, top - recovery, time)

    def duration(self, force: Callable, begin: float, end: float, kinetic: float = 0) -> float:
        """Return the time [s] between two overlaps [m]. `kinetic` is the kinetic energy [J] at
        `end`. The integration variable is the root of the remaining distance, which removes the
        singularity at a turning point.
        """

        def pace(root: float) -> float:
            energy = kinetic + work(force, end - root**2, end)
            return 2 * root * sqrt(0.5 * self.mass / energy)

        return quad(pace, 0, sqrt(end - begin), epsabs=0, epsrel=1e-11, limit=200)[0]

    def by_motion(self) -> Outcome:
        """Return the outcome from the equation of motion, integrated by DOP853 in dimensionless
        variables.

        The integration stops where one formula of the force ends, so no step crosses a jump.
        """
        unit = self.overlap_max
        scale = unit / (self.mass * self.speed**2)
        state, loading = np.array([0.0, 1.0]), 0.0
        for end, force in self.pieces:
            if state[1] > 1e-9:
                closing = motion(state, lambda x, f=force: scale * f(unit * x), end / unit, 0.0)
                spent, state = closing
                loading += spent
        top = unit * state[0]
        force_max, (recovery, shape) = self.loading_force(top), self.rebound(top)

        def released(x: float) -> float:
            return scale * force_max * shape(max(0.0, 1 - (top - unit * x) / recovery))

        unloading, end = motion([state[0], 0.0], released, (top - recovery) / unit)
        duration = (loading + unloading) * unit / self.speed
        return Outcome(-end[1], force_max, top, top - recovery, duration)


def motion(begin, force: Callable, *ends: float) -> tuple[float, np.ndarray]:
    """Move a unit mass against a force; return the duration and the final [overlap, rate]. The
    motion ends when the overlap reaches ends[0] or the rate reaches ends[1].
    """
    events = [lambda _, y, i=i, end=end: y[i] - end for i, end in enumerate(ends)]
    for event in events:
        event.terminal = True
    found = solve_ivp(
        lambda _, y: [y[1], -float(force(y[0]))],
        (0, 99),
        begin,
        "DOP853",
        events=events,
        rtol=1e-12,
        atol=1e-15,
        max_step=0.02,
    )
    return found.t[-1], found.y[:, -1]
