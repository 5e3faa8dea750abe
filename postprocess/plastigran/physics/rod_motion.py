# SPDX-License-Identifier: GPL-2.0-or-later
"""Equations of motion for the impact of a rod whose tip follows a rate-independent contact law."""

from __future__ import annotations

from math import inf, radians, sin

import numpy as np
import pandas as pd

from plastigran.physics.rod import Rod, RodOutcome

#: If the slip velocity of the tip is below this fraction of the impact speed, the tip sticks.
STICKING_SLIP = 1e-3

#: Rate at which a friction spring beyond the friction limit relaxes to this limit, as a multiple of
#: impact speed / largest overlap.
YIELDING_RATE = 1e3

#: Number of maxima and minima of the overlap after which the tip is assumed to stay in contact.
TURNS = 6

#: Number of rows of `RodOutcome.history` during loading, and during unloading.
HISTORY_ROWS = 300


class RodMotion:
    """Right-hand side of the equations of motion of the rod.

    The variables are (x, y, turn, velocity_x, velocity_y, angular velocity, spring). These are the
    displacement of the center and the rotation since first touch, their rates, and the stretch of
    the friction spring. `state` is the contact history at the largest overlap so far. Trial steps
    of the solver use copies of this history.

    Raises:
        ValueError: The law depends on the overlap rate, which these equations do not include; or
            the speed is not positive and finite.
    """

    def __init__(self, rod: Rod, law, speed: float, shear_modulus_eff: float | None) -> None:
        if law.rate_dependent:
            raise ValueError(
                f"law {law.name} depends on the overlap rate, which the equations of motion of the "
                "rod do not include. Use another law"
            )
        self.rod, self.spring = rod, shear_modulus_eff is not None
        self.law = law.at_impact(rod.tip_radius, speed)
        self.half, self.lean = rod.length / 2, radians(rod.angle)
        self.start = [0, 0, 0, 0, -speed, 0, 0]
        self.sticking = STICKING_SLIP * speed
        overlap_max = self.law.central_impact(rod.tip_radius, rod.mass_eff, speed).overlap_max
        self.yielding = YIELDING_RATE * speed / overlap_max
        self.stiffness_per_radius = 8 * (shear_modulus_eff or 0.0)
        self.state = law.State()
        self.overlap_res = -inf

    def arm(self, motion) -> tuple[float, float]:
        """Return the vector from the center of the rod to the lowest point of the tip [m]."""
        angle = self.lean + motion[2]
        return -self.half * np.cos(angle), -self.rod.tip_radius - self.half * np.sin(angle)

    def overlap(self, motion) -> float:
        """Return the overlap of tip and flat [m]."""
        return self.half * (np.sin(self.lean + motion[2]) - sin(self.lean)) - motion[1]

    def slip_velocity(self, motion) -> float:
        """Return the tangential velocity of the lowest point of the tip [m/s]."""
        return motion[3] - motion[5] * self.arm(motion)[1]

    def closing_velocity(self, _time, motion) -> float:
        """Return the rate of the overlap [m/s]."""
        return -motion[4] - motion[5] * self.arm(motion)[0]

    def left(self, _time, motion) -> float:
        """Return the overlap minus the residual overlap [m]."""
        return self.overlap(motion) - self.overlap_res

    def contact(self, motion, state=None):
        """Return the response of the law at the present overlap.

        The law updates the contact history `state`. By default, `state` is a copy of `self.state`.
        """
        state = self.state.copy() if state is None else state
        return self.law.respond(self.rod.tip_radius, self.overlap(motion), state)

    def forces(self, motion) -> tuple[float, float, float]:
        """Return normal force [N], friction [N] and the rate of the spring's stretch [m/s]."""
        contact = self.contact(motion)
        slip, limit = self.slip_velocity(motion), self.rod.coefficient_of_friction * contact.force
        if self.spring:
            stiffness = self.stiffness_per_radius * contact.contact_radius
            pull = -stiffness * motion[6]
            friction = min(max(pull, -limit), limit)
            excess = (pull - friction) / stiffness if stiffness > 0 else 0.0
            return contact.force, friction, slip + self.yielding * excess
        arm_x, arm_y = self.arm(motion)
        # `holding` is the friction F_f that keeps the slip velocity v_T constant:
        # dv_T/dt = F_f (1/m + r_y^2/I) - F_n r_x r_y/I = 0, with the normal force F_n, the vector
        # (r_x, r_y) of `arm`, and the mass m and the moment of inertia I of the rod.
        holding = arm_x * arm_y * contact.force / (self.rod.inertia / self.rod.mass + arm_y**2)
        friction = holding - slip / self.sticking * limit
        return contact.force, min(max(friction, -limit), limit), 0.0

    def rate(self, _time, motion) -> list[float]:
        """Return the time derivatives of the variables."""
        force, friction, stretching = self.forces(motion)
        arm_x, arm_y = self.arm(motion)
        return [
            *motion[3:6],
            friction / self.rod.mass,
            force / self.rod.mass - self.rod.gravitational_acceleration,
            (arm_x * force - arm_y * friction) / self.rod.inertia,
            stretching,
        ]

    def turn_back(self, motion) -> None:
        """Update the contact history and the residual overlap at a local maximum of the overlap."""
        self.contact(motion, self.state)
        low, high = 0.0, self.overlap(motion)
        while high - low > 1e-14 * self.overlap(motion):
            middle = 0.5 * (low + high)
            force = self.law.respond(self.rod.tip_radius, middle, self.state.copy()).force
            low, high = (low, middle) if force > 0 else (middle, high)
        self.overlap_res = high if low > 0 else 0.0

    def history_row(self, time, motion) -> dict[str, float]:
        """Return time, overlap, forces and motion as a row of `RodOutcome.history`."""
        force, friction, _ = self.forces(motion)
        return {
            "time": time,
            "overlap": self.overlap(motion),
            "force": force,
            "friction_force": friction,
            "displacement_x": motion[0],
            "displacement_y": motion[1],
            "velocity_x": motion[3],
            "velocity_y": motion[4],
            "angular_velocity": motion[5],
            "slip_velocity": self.slip_velocity(motion),
        }


def simulate(rod: Rod, law, speed: float, shear_modulus_eff: float | None = None) -> RodOutcome:
    """Integrate the impact of a rod from first touch until the tip separates.

    The equations are eqs 1-7 of Ghaednia, Cermik & Marghitu 2015, but with the normal force F_n
    along y and the friction F_f along x. They are m x'' = F_f, m y'' = F_n - m g,
    I turn'' = r_x F_n - r_y F_f. m and I are the mass and the moment of inertia of the rod. r is
    the vector from the center of the rod to the contact.

    Without a spring, friction is Coulomb's, as in the paper. On a sliding tip, the friction mu F_n
    opposes the slip. A tip without slip sticks if friction can hold it. Slip velocities below
    `STICKING_SLIP` times the impact speed count as zero.

    With a spring, friction is as in `tangential history` of LIGGGHTS. The spring has the stiffness
    8 G* a, with the contact radius a of the law, and holds the tip up to the force mu F_n.

    Args:
        rod: Rod, its angle and its friction.
        law: Law between rod and flat, an instance of a class of `plastigran.laws.LAWS`.
        speed: Downward speed of the rod before the impact [m/s]. The rod does not rotate before.
        shear_modulus_eff: Effective shear modulus G* for the tangential spring [Pa]; None for no
            spring.

    Raises:
        ValueError: As for `RodMotion`, or the weight of the rod keeps the tip in contact.
    """
    from scipy.integrate import solve_ivp  # imported here: scipy.integrate is slow

    body = RodMotion(rod, law, speed, shear_modulus_eff)

    def turning(time, motion):
        return body.closing_velocity(time, motion)

    def released(time, motion):
        return body.left(time, motion)

    turning.terminal = released.terminal = True
    turning.direction = released.direction = -1
    time, motion, overlap_max, loading_time, force_max = 0.0, body.start, 0.0, 0.0, 0.0
    rows = []
    for _ in range(TURNS):
        piece = solve_ivp(
            body.rate,
            (time, time + 1e3 * rod.tip_radius / speed),
            motion,
            method="DOP853",
            events=[turning, released],
            dense_output=True,
            rtol=1e-9,
            atol=1e-13,
        )
        instants = np.linspace(time, piece.t[-1], HISTORY_ROWS)[1 if rows else 0 :]
        rows += [body.history_row(t, piece.sol(t)) for t in instants]
        time, motion = piece.t[-1], piece.y[:, -1]
        if piece.t_events[1].size:
            break
        turning.direction *= -1
        if body.overlap(motion) > overlap_max:
            overlap_max, loading_time = body.overlap(motion), time
            body.turn_back(motion)
            force_max = body.contact(motion).force
    else:
        raise ValueError(
            f"speed is {speed:g} m/s; at this speed, the weight of the rod keeps its tip in "
            "contact. Use a higher speed"
        )
    return RodOutcome(
        coefficient_of_restitution=-body.closing_velocity(time, motion) / speed,
        angular_velocity=motion[5],
        force_max=force_max,
        overlap_max=overlap_max,
        overlap_res=body.overlap_res,
        loading_time=loading_time,
        contact_time=time,
        history=pd.DataFrame(rows),
    )
