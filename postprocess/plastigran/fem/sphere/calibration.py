# SPDX-License-Identifier: GPL-2.0-or-later
"""Constants of Vu-Quoc and Zhang's law from a finite-element compression.

For loading at a force P beyond the yield force P_Y, the law is (Vu-Quoc and Zhang, 1999):
a = a_e + C_a (P - P_Y), a^2 = C_R R alpha, C_R = 1 + K_c (P - P_Y). Here, a is the contact radius,
a_e the Hertzian contact radius, R the sphere radius and alpha the approach.

The constants C_a and K_c are slopes of least-squares lines through zero, fitted to first loading.
C_a is the slope of a - a_e versus P - P_Y. K_c is the slope of
(a_e + C_a (P - P_Y))^2 / (R alpha) - 1 versus P - P_Y. The weight of a point is half the distance
between its neighboring forces. The fit of K_c uses the contact radius of the law, not the computed
contact radius. The law therefore reproduces the computed approach as well as possible.
"""

from __future__ import annotations

import attrs
import numpy as np

from plastigran.fem.sphere.results import ROUNDING, Pressing, first_loading_of
from plastigran.fem.theory.hertz import HertzSphere

LEAST_RATIO = 3.0  # smallest force / yield force of a fit


@attrs.frozen
class Calibration:
    """Fitted constants of the law `vu_quoc_zhang`, and their errors.

    Attributes:
        contact_radius_coefficient: C_a P_Y / a_Y, with the contact radius a_Y at yield.
        curvature_coefficient: K_c P_Y.
        contact_radius_per_force: C_a, m/N.
        curvature_per_force: K_c, 1/N.
        yield_force: P_Y, N.
        force_max: Largest force of the fit, N.
        contact_radius_error: Largest relative difference of a between law and finite elements
            beyond P_Y.
        approach_error: Largest relative difference of alpha between law and finite elements beyond
            P_Y.
    """

    contact_radius_coefficient: float
    curvature_coefficient: float
    contact_radius_per_force: float
    curvature_per_force: float
    yield_force: float
    force_max: float
    contact_radius_error: float
    approach_error: float

    to_dict = attrs.asdict


def calibrate(pressing: Pressing) -> Calibration:
    """Fit the constants C_a and K_c of the law to a compression, from P_Y to its largest force.

    Raises:
        ValueError: The largest force is below LEAST_RATIO times the yield force. Or the plane is a
            half space, for which the yield force of the law does not hold. Or a constant is not
            positive, because the metal hardens so much that it hardly yields.
    """
    if pressing.plane is not None:
        raise ValueError(
            f"plane is a half space with E = {pressing.plane.youngs_modulus:g} Pa; a fit needs "
            "a sphere on a rigid plane. Use plane=None"
        )
    sphere = HertzSphere(pressing.material, pressing.radius)
    yield_force = sphere.yield_force
    loading = first_loading_of(pressing.history)
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
                f"the fitted constant {name} would be {value:.3g}; the law needs positive values. "
                "Use a metal with less hardening"
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
    """Check that the largest force, N, is large enough for a fit of the law's constants.

    Raises:
        ValueError: The force is below LEAST_RATIO times the yield force.
    """
    least = LEAST_RATIO * sphere.yield_force
    if force < (1 - ROUNDING) * least:
        raise ValueError(
            f"the largest force is {force:.4g} N; a fit needs at least {LEAST_RATIO:g} times "
            f"the yield force, {least:.4g} N"
        )


def _slope(x: np.ndarray, y: np.ndarray, weight: np.ndarray) -> float:
    """Return the slope of the weighted least-squares line y(x) through the origin."""
    return float(np.sum(weight * x * y) / np.sum(weight * x * x))
