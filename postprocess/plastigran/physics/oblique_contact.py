# SPDX-License-Identifier: GPL-2.0-or-later
"""Oblique impacts of spheres, by the equations of motion with a normal and a tangential law."""

from __future__ import annotations

from typing import Any

import attrs
import numpy as np

from plastigran import laws

#: Recommended time step of the law / time step of the integration.
FINER = 12
#: Largest number of time steps of an impact.
MOST_STEPS = 100_000


@attrs.frozen
class ObliqueOutcome:
    """Outcome of oblique impacts of bodies without spin. All arrays have the same shape.

    Attributes:
        normal_restitution: Normal relative speed after the impact / normal relative speed before
            the impact [-].
        tangential_restitution: Tangential relative speed of the centers after the impact /
            tangential relative speed before the impact [-]; NaN for a central impact.
        spin: Spin of the first body after the impact [rad/s]. The body rolls forward if the spin
            is positive.
        rebound_angle: Angle between the relative velocity of the first body and the normal after
            the impact [degrees].
        friction_work: Energy dissipated by friction [J].
        plastic_work: Energy dissipated by plastic deformation [J].
    """

    normal_restitution: np.ndarray
    tangential_restitution: np.ndarray
    spin: np.ndarray
    rebound_angle: np.ndarray
    friction_work: np.ndarray
    plastic_work: np.ndarray


def normalized_angle(pair: laws.MaterialPair, friction: float, angle: np.ndarray) -> np.ndarray:
    """Return the normalized angle psi = tan(angle) 4 G*/(mu E*) of an oblique impact [-].

    G* and E* are the effective shear and Young's moduli. If results of elastic impacts are plotted
    versus psi, different coefficients of friction give the same curve.

    Args:
        pair: Combined constants of the two bodies.
        friction: Coefficient of friction mu [-].
        angle: Angle between the relative velocity of the surfaces and the normal [rad].

    Source: Maw, Barber & Fawcett 1976, Wear 38:101.
    """
    return 4 * pair.shear_modulus_eff / (friction * pair.youngs_modulus_eff) * np.tan(angle)


def oblique_impacts(
    law: laws.Law,
    tangential: laws.PartialSlip | laws.Incremental,
    radius_eff: float,
    mass_eff: float,
    torque_arm: float,
    speeds: np.ndarray,
    angles: np.ndarray,
) -> ObliqueOutcome:
    """Integrate oblique impacts by velocity Verlet, with 1/12 of the recommended time step.

    Both bodies are homogeneous spheres, or the second body is an immovable flat. The effective mass
    for the relative tangential motion of the two surfaces is therefore 2/7 m*, with the effective
    mass m* of the pair.

    Args:
        law: Normal law for spheres; it must not have adhesion.
        tangential: Tangential law.
        radius_eff: Effective radius R* [m].
        mass_eff: Effective mass m* [kg].
        torque_arm: Radius times mass of the first body [kg m], which determines its spin.
        speeds: Relative speeds before the impact (N,) [m/s].
        angles: Angles of the velocities from the normal (N,) [degrees].

    Raises:
        RuntimeError: An impact does not end within `MOST_STEPS` time steps.
    """
    closing, sliding = speeds * np.cos(np.radians(angles)), speeds * np.sin(np.radians(angles))
    step = law.recommended_timestep(radius_eff, mass_eff, closing) / FINER
    stiffness = 8 * law.pair.shear_modulus_eff
    normal_states = np.array([law.State() for _ in speeds])
    tangential_state: Any = tangential.State(speeds.shape)

    # `rate` is the rate of the overlap; `slip` is the relative tangential speed of the surfaces.
    rate, slip = closing.copy(), sliding.copy()
    overlap, normal, friction = np.zeros_like(rate), np.zeros_like(rate), np.zeros_like(rate)
    impulse, work, plastic = np.zeros_like(rate), np.zeros_like(rate), np.zeros_like(rate)
    moving = np.ones_like(rate)  # 1 during an impact, 0 after its end
    for _ in range(MOST_STEPS):
        half = 0.5 * step * moving
        rate, slip = rate - normal * half / mass_eff, slip - 3.5 * friction * half / mass_eff
        impulse = impulse + friction * half
        overlap = overlap + 2 * half * rate
        response = law.respond(radius_eff, overlap, normal_states, rate)
        normal = moving * np.maximum(0.0, response.force)
        answer = tangential.respond(
            np.maximum(0.0, normal - response.viscous_force * moving),
            stiffness * response.contact_radius,
            2 * half * slip,
            state=tangential_state,
        )
        friction = moving * answer.force_x
        work = work + moving * answer.friction_work
        plastic = np.asarray(response.plastic_work)
        rate, slip = rate - normal * half / mass_eff, slip - 3.5 * friction * half / mass_eff
        impulse = impulse + friction * half
        moving = np.where((rate < 0) & (normal <= 0), 0.0, moving)
        if not moving.any():
            break
    else:
        raise RuntimeError(f"an oblique impact does not end within {MOST_STEPS} time steps")
    along = sliding - impulse / mass_eff
    with np.errstate(divide="ignore", invalid="ignore"):
        tangential_restitution = np.where(sliding != 0, along / sliding, np.nan)
    return ObliqueOutcome(
        normal_restitution=-rate / closing,
        tangential_restitution=tangential_restitution,
        spin=2.5 * impulse / torque_arm,
        rebound_angle=np.degrees(np.arctan2(along, -rate)),
        friction_work=work,
        plastic_work=plastic,
    )
