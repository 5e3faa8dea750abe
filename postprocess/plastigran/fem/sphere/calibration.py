# SPDX-License-Identifier: GPL-2.0-or-later
"""Constants of Vu-Quoc and Zhang's law from a pressing by finite elements.

The law says of loading beyond the force at yield P_Y (Vu-Quoc and Zhang, 1999):
a = a_e + C_a (P - P_Y), a^2 = (1 + K_c (P - P_Y)) R alpha, a_e the contact radius of Hertz. Both
constants are least-squares fits of straight lines through zero over the virgin loading, its points
weighted by their distance in force: C_a to a - a_e, K_c to C_R - 1 = (a_e + C_a (P - P_Y))^2 /
(R alpha) - 1. The curvature is taken with the law's own contact radius, so that the pair gives the
approach of the finite elements back as well as it can.
"""

from __future__ import annotations

import attrs
import numpy as np

from plastigran.fem.sphere.results import ROUNDING, Pressing, virgin_loading
from plastigran.fem.theory.hertz import HertzSphere

LEAST_RATIO = 3.0  # forces over that at yield; there is nothing to fit below


@attrs.frozen
class Calibration:
    """Fitted constants.

    Attributes:
        contact_radius_coefficient: C_a P_Y / a_Y, as the law `vu_quoc_zhang` takes it.
        curvature_coefficient: K_c P_Y, as the law takes it.
        contact_radius_per_force: C_a, m/N.
        curvature_per_force: K_c, 1/N.
        yield_force: P_Y, N.
        force_max: Largest force of the fit, N.
        contact_radius_error: Largest difference of law and finite elements beyond P_Y, of a, as a
            share.
        approach_error: The same of alpha.
    """

    contact_radius_coefficient: float
    curvature_coefficient: float
    contact_radius_per_force: float
    curvature_per_force: float
    yield_force: float
    force_max: float
    contact_radius_error: float
    approach_error: float

    def to_dict(self) -> dict[str, float]:
        """Numbers, for a file."""
        return attrs.asdict(self)


def calibrate(pressing: Pressing) -> Calibration:
    """Fit C_a and K_c to the loading of a pressing, from P_Y to its largest force.

    Raises:
        ValueError: The largest force is below LEAST_RATIO times that at yield; or the plane is a
            half space, for the law's force at yield is that of a sphere on a rigid plane; or a
            constant is not positive, for the metal hardens so much that it hardly flows.
    """
    if pressing.plane is not None:
        raise ValueError(
            f"plane is a half space with E = {pressing.plane.youngs_modulus:g} Pa; a fit needs a "
            "sphere pressed on a rigid plane"
        )
    sphere = HertzSphere(pressing.material, pressing.radius)
    yield_force = sphere.yield_force
    loading = virgin_loading(pressing.history)
    force = loading["force"].to_numpy()
    check_range(sphere, force[-1])
    beyond = force > yield_force
    excess = force[beyond] - yield_force
    radius, approach = (loading[name].to_numpy()[beyond] for name in ("contact_radius", "approach"))
    elastic = np.array([sphere.contact_radius(value) for value in force[beyond]])
    weight = np.gradient(force[beyond])
    widening = _slope(excess, radius - elastic, weight)
    fitted = elastic + widening * excess
    curvature = _slope(excess, fitted**2 / (pressing.radius * approach) - 1, weight)
    for name, value in {"C_a": widening, "K_c": curvature}.items():
        if not value > 0:
            raise ValueError(
                f"{name} would be {value:.3g}; the law takes positive ones (does the metal harden "
                "too much to flow?)"
            )
    fitted_approach = fitted**2 / (pressing.radius * (1 + curvature * excess))
    return Calibration(
        widening * yield_force / sphere.contact_radius(yield_force),
        curvature * yield_force,
        widening,
        curvature,
        yield_force,
        float(force[-1]),
        float(np.max(np.abs(fitted / radius - 1))),
        float(np.max(np.abs(fitted_approach / approach - 1))),
    )


def check_range(sphere: HertzSphere, force: float) -> None:
    """Refuse a largest force, N, that leaves nothing to fit.

    Raises:
        ValueError: It is below LEAST_RATIO times that at yield.
    """
    least = LEAST_RATIO * sphere.yield_force
    if force < (1 - ROUNDING) * least:
        raise ValueError(
            f"the largest force is {force:.4g} N; a fit needs {LEAST_RATIO:g} times the force at "
            f"yield or more, {least:.4g} N"
        )


def _slope(x: np.ndarray, y: np.ndarray, weight: np.ndarray) -> float:
    """Of the straight line through zero that is nearest in the weighted square."""
    return float(np.sum(weight * x * y) / np.sum(weight * x * x))
