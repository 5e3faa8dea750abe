# SPDX-License-Identifier: GPL-2.0-or-later
"""G. Kuwabara & K. Kono, Jpn. J. Appl. Phys. 26 (1987) 1230; N. V. Brilliantov et al., Phys. Rev. E
53 (1996) 5382.

The force is F = rho_k (d^1.5 + 1.5 A sqrt(d) d') with rho_k = 4/3 E* sqrt(R*), until it vanishes.
d is the overlap, d' its rate, A the dissipative constant [s], and m the mass. In units of the
impact speed v and of the length (m v^2/rho_k)^(2/5), the motion depends only on b = 1.5 A
(rho_k/m)^(2/5) v^(1/5) = v*^2:

    d'' = -f,  f = sqrt(d) (d + b d')

The outcome does not follow from energies by quadrature, because the force depends on the rate. The
second computation therefore uses r = d'/d as variable instead of time.
"""

from __future__ import annotations

from math import inf, sqrt

import numpy as np
from references.central_impact import CentralImpact, Outcome
from scipy.integrate import solve_ivp
from scipy.optimize import minimize_scalar

TIGHT = {"method": "DOP853", "dense_output": True, "rtol": 1e-12, "atol": 1e-15}


def motion(b: float):
    """Return sqrt(d), d' and time as functions of s, where dt = sqrt(d) ds.

    With this variable, the equation of motion contains no square root.
    """

    def slope(_, y):
        root, rate, _ = y
        return [rate / 2, -(root**4 + b * root**2 * rate), root]

    def parted(_, y):
        return y[0] ** 2 + b * y[1] if y[1] < 0 else 1.0

    parted.terminal = True
    return solve_ivp(
        slope, (0, 1e4), [0, 1, 0], events=[parted, lambda s, y: y[1]], max_step=0.05, **TIGHT
    )


def closing(b: float):
    """Return the rate d' and the time of the approach as functions of sqrt(1/r), where r = d'/d.

    The approach begins at first touch, where 1/r = 0, and this solution ends at r = 1.
    """

    def slope(z, y):
        rate, _ = y
        force = sqrt(z**2 * rate) * (z**2 * rate + b * rate)
        pace = 2 * z / (1 + z**2 * force / rate)
        return [-force * pace, pace]

    return solve_ivp(slope, (0, 1), [1, 0], max_step=0.02, **TIGHT)


def opening(b: float, begin):
    """Return the overlap d and the time as functions of r = d'/d, from r = 1 to r = -1/b.

    At r = -1/b, the force vanishes.
    """

    def slope(ratio, y):
        pace = -1 / (sqrt(y[0]) * (1 + b * ratio) + ratio**2)
        return [ratio * y[0] * pace, pace]

    return solve_ivp(slope, (1, -1 / b), begin, max_step=0.02 * (1 + 1 / b), **TIGHT)


def largest(function, begin: float, end: float) -> float:
    """Return the largest value between two points, by a scan and its refinement."""
    scan = np.linspace(begin, end, 201)
    top = int(np.argmax([function(x) for x in scan]))
    bounds = sorted((scan[max(top - 1, 0)], scan[min(top + 1, 200)]))
    options = {"xatol": 1e-9}
    found = minimize_scalar(
        lambda x: -function(x), bounds=bounds, method="bounded", options=options
    )
    return max(-found.fun, function(scan[top]))


class Reference(CentralImpact):
    cases = """\
material,radius,speed
ice,0.0275,0.0001
ice,0.0275,0.001
ice,0.0275,0.01
ice,0.0275,0.1
ice,0.01,0.02
"""

    def __init__(self, material, radius, speed):
        super().__init__(material, radius, speed)
        self.pieces = [(inf, self.hertz)]  # contact at rest
        stiffness = 4 / 3 * material.modulus * sqrt(radius)
        self.unit = (self.mass * speed**2 / stiffness) ** 0.4  # unit of overlap
        self.number = sqrt(1.5 * material.dissipative_constant * speed / self.unit)  # v*

    def two_ways(self):
        return self.by_ratio(), self.by_motion()

    def in_si(self, restitution, force_max, overlap_max, overlap_res, time) -> Outcome:
        force = self.mass * self.speed**2 / self.unit
        lengths = overlap_max * self.unit, overlap_res * self.unit
        return Outcome(restitution, force_max * force, *lengths, time * self.unit / self.speed)

    def by_motion(self):
        b = self.number**2
        found = motion(b)

        def force(s):
            root, rate, _ = found.sol(s)
            return root * (root**2 + b * rate)

        root, rate, time = found.y[:, -1]
        overlap_max = found.y_events[1][0][0] ** 2
        return self.in_si(-rate, largest(force, 0, found.t[-1]), overlap_max, root**2, time)

    def by_ratio(self):
        b = self.number**2
        first = closing(b)
        rate, time = first.y[:, -1]
        second = opening(b, [rate, time])

        def force_closing(z):
            rate = first.sol(z)[0]
            return z * rate**1.5 * (z**2 + b)

        def force_opening(ratio):
            return second.sol(ratio)[0] ** 1.5 * (1 + b * ratio)

        force_max = max(largest(force_closing, 0, 1), largest(force_opening, 1, -1 / b))
        overlap_res, time = second.y[:, -1]
        overlap_max = second.sol(0.0)[0]
        return self.in_si(overlap_res / b, force_max, overlap_max, overlap_res, time)
