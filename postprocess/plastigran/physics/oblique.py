# SPDX-License-Identifier: GPL-2.0-or-later
"""Theory of oblique impacts: rigid bodies that slide, and elastic bodies that stick and slide.

The motion is in one plane. The first body moves along -x and hits the second body or a rigid plane.
The axis y is along the surface. The surface speed is the relative velocity of the two surfaces at
the contact, along y. It is positive if the surface of the first body moves faster along +y.
"""

from __future__ import annotations

from math import inf, sqrt

import attrs
import numpy as np

from plastigran import laws
from plastigran.declared import number, radius_field
from plastigran.physics import central


@attrs.frozen
class Motion:
    """Motion of two bodies along the surface, before or after an impact.

    Attributes:
        normal: Relative normal speed, closing before and separating after the impact [m/s].
        along: Speed of the first body along y [m/s].
        spin: Spin of the first body [rad/s], positive if its surface at the contact moves along +y.
        along_other: Speed of the second body along y [m/s].
        spin_other: Spin of the second body [rad/s], positive if its surface at the contact moves
            along +y.
    """

    normal: float
    along: float
    spin: float
    along_other: float = 0.0
    spin_other: float = 0.0


@attrs.frozen
class ObliqueImpact:
    """Two homogeneous spheres, or a homogeneous sphere and a rigid plane, before an impact.

    Attributes:
        pair: Combined constants of the two bodies.
        before: Motion before the impact.
        radius_other: Radius of the second body, infinite for a plane [m].
        mass_other: Mass of the second body, infinite for a plane [kg].

    Raises:
        ValueError: A field is out of range.
    """

    pair: laws.MaterialPair
    radius: float = radius_field("radius of the first sphere")
    mass: float = number("mass of the first sphere", "kg", 0)
    coefficient_of_friction: float = number("coefficient of friction", "-", 0, lower_allowed=True)
    coefficient_of_restitution: float = number(
        "coefficient of restitution for which the dashpot is set", "-", 0, 1, upper_allowed=True
    )
    before: Motion
    radius_other: float = attrs.field(default=inf, validator=attrs.validators.gt(0))
    mass_other: float = attrs.field(default=inf, validator=attrs.validators.gt(0))

    def __attrs_post_init__(self) -> None:
        if not self.before.normal > 0:
            raise ValueError(f"the closing speed is {self.before.normal:g}; it must be positive")

    @property
    def radius_eff(self) -> float:
        """Effective radius R* [m]."""
        return 1 / (1 / self.radius + 1 / self.radius_other)

    @property
    def mass_eff(self) -> float:
        """Effective mass m* [kg]."""
        return 1 / (1 / self.mass + 1 / self.mass_other)

    def surface_speed(self, motion: Motion) -> float:
        """Return the relative speed of the undeformed surfaces along y [m/s]."""
        other = motion.spin_other * self.radius_other if motion.spin_other else 0.0
        return motion.along + motion.spin * self.radius - motion.along_other - other

    def restitution(self) -> float:
        """Return the normal restitution of a contact that ends before the dashpot attracts [-]."""
        return float(central.restitution_without_pull(self.coefficient_of_restitution))

    def slides(self) -> bool:
        """Return whether the contact slides throughout the impact.

        Let v_s be the surface speed and v_n the closing speed before the impact, mu the coefficient
        of friction and e the restitution. Friction cannot stop the surfaces of rigid bodies if
        |v_s| >= 7/2 mu (1 + e) v_n. In an elastic contact, |v_s| must also be at least the growth
        rate of mu F/k_t, the stretch at which the tangential spring slips.
        """
        least = max(3.5 * (1 + self.restitution()), self.stretch_ratio)
        speed = abs(self.surface_speed(self.before))
        return speed >= least * self.coefficient_of_friction * self.before.normal

    @property
    def stretch_ratio(self) -> float:
        """Largest stretch of the undamped tangential spring / (mu overlap), E*/(6 G*) [-].

        E* and G* are the effective Young's and shear moduli, and mu is the coefficient of friction.
        """
        return self.pair.youngs_modulus_eff / (6 * self.pair.shear_modulus_eff)

    def rigid_sliding(self) -> Motion:
        """Return the motion after an impact of rigid bodies that slide throughout.

        The tangential impulse mu (1 + e) m* v_n opposes the surface speed. mu is the coefficient of
        friction, e the restitution, m* the effective mass and v_n the closing speed. For a sphere
        of radius R on a plane, the tangential speed v_t and the spin w become
        v_t' = v_t - mu (1 + e) v_n and R w' = R w - 5/2 mu (1 + e) v_n.
        Sources: Foerster et al. 1994, Phys. Fluids 6:1108; Kharaz et al. 2001, Powder Technol.
        120:281.
        """
        before, restitution = self.before, self.restitution()
        direction = -float(np.sign(self.surface_speed(before)))
        impulse = direction * (
            self.coefficient_of_friction * (1 + restitution) * self.mass_eff * before.normal
        )
        return Motion(
            normal=restitution * before.normal,
            along=before.along + impulse / self.mass,
            spin=before.spin + 2.5 * impulse / (self.mass * self.radius),
            along_other=before.along_other - impulse / self.mass_other,
            spin_other=before.spin_other - 2.5 * impulse / (self.mass_other * self.radius_other),
        )

    def spring_slider(self) -> Motion:
        """Return the motion after an impact with a tangential spring and a slider.

        The spring has Mindlin's stiffness without slip, k_t = 8 G* a, with the effective shear
        modulus G* and the contact radius a. The contact slides when the tangential force reaches
        mu F, where mu is the coefficient of friction. The normal force F includes the normal
        dashpot. There is no tangential dashpot. LIGGGHTS has the same model: `tangential history`
        with `tangential_damping off`. The model does not include the partial slip of Maw, Barber &
        Fawcett (1976, Wear 38:101). The lever arm of the friction is R - overlap/2 for a sphere of
        radius R.

        Raises:
            RuntimeError: The integration finds no end of the impact.
        """
        return _SpringSlider(self).rebound()


class _SpringSlider:
    """Equations of motion of an impact with a tangential spring and a slider.

    The units are the closing speed, the largest overlap and the effective mass m*. The state
    contains the overlap d, its rate, the relative tangential speed of the centers, the product of
    radius and spin of each body, and the stretch of the spring. In these units, the Hertz force is
    5/4 d^(3/2), and the tangential stiffness is 5/4 (6 G*/E*) d^(1/2), with the effective moduli G*
    and E*.
    """

    START = 2e-8  # initial overlap / largest overlap; the initial force is 1e-12 of the peak force

    def __init__(self, impact: ObliqueImpact) -> None:
        self.impact = impact
        pair, speed = impact.pair, impact.before.normal
        overlap = central.hertz_overlap_max(
            impact.radius_eff, impact.mass_eff, pair.youngs_modulus_eff, speed
        )
        self.friction = impact.coefficient_of_friction
        self.damping = float(central.damping_ratio(impact.coefficient_of_restitution))
        self.stiffness = 1 / impact.stretch_ratio
        self.flat = np.array([overlap / impact.radius, overlap / impact.radius_other])
        self.share = np.array([impact.mass_eff / impact.mass, impact.mass_eff / impact.mass_other])
        # `sense` is 0 for a sticking contact, and the sign of the stretch for a sliding contact.
        self.sense = 0

    def normal_force(self, overlap: float, rate: float) -> float:
        return 1.25 * overlap**1.5 + 2.5 * self.damping * overlap**0.25 * rate

    def reach(self, overlap: float, rate: float) -> float:
        """Return the stretch of the spring at which the contact slides.

        The stretch is the friction limit divided by the tangential stiffness.
        """
        force = max(0.0, self.normal_force(overlap, rate))
        return self.friction * force / (1.25 * self.stiffness * sqrt(overlap))

    def reach_rate(self, overlap: float, rate: float) -> float:
        dashpot = -0.25 * overlap**-1.25 * rate**2 - overlap**-0.25 * self.normal_force(
            overlap, rate
        )
        return self.friction / self.stiffness * (rate + 2 * self.damping * dashpot)

    def surface_speed(self, state: np.ndarray) -> float:
        return state[2] + float((1 - 0.5 * state[0] * self.flat) @ state[3:5])

    def rates(self, _: float, state: np.ndarray) -> np.ndarray:
        overlap, rate = max(state[0], 1e-30), state[1]
        force = self.normal_force(overlap, rate)
        if self.sense:
            tangential = -self.sense * self.friction * force
        else:
            tangential = -1.25 * self.stiffness * sqrt(overlap) * state[5]
        turning = 2.5 * self.share * (1 - 0.5 * overlap * self.flat) * tangential
        stretch = 0.0 if self.sense else self.surface_speed(state)
        return np.array([rate, -force, tangential, *turning, stretch])

    def rebound(self) -> Motion:
        from scipy.integrate import solve_ivp  # imported here: scipy.integrate is slow

        def released(_: float, state: np.ndarray) -> float:
            return self.normal_force(max(state[0], 1e-30), state[1]) - 1e-12

        def changes(_: float, state: np.ndarray) -> float:
            """Return a value that becomes negative when sticking or sliding ends."""
            overlap, rate = max(state[0], 1e-30), state[1]
            if self.friction == 0:
                return 1.0
            if self.sense:
                return self.sense * self.surface_speed(state) - self.reach_rate(overlap, rate)
            return self.reach(overlap, rate) - abs(state[5])

        for event in (released, changes):
            event.terminal, event.direction = True, -1

        before, speed = self.impact.before, self.impact.before.normal
        radii = (self.impact.radius, self.impact.radius_other)
        turning = [
            spin * radius / speed if spin else 0.0
            for spin, radius in zip((before.spin, -before.spin_other), radii, strict=True)
        ]
        state = np.array(
            [self.START, 1.0, (before.along - before.along_other) / speed, *turning, 0.0]
        )
        state[5] = self.surface_speed(state) * self.START
        time, end = 0.0, 20.0
        sticks = abs(state[5]) < self.reach(state[0], state[1])
        self.sense = 0 if sticks else int(np.sign(state[5])) or 1
        # An impact has only a few changes between sticking and sliding.
        for _ in range(100):
            part = solve_ivp(
                self.rates, (time, end), state, "DOP853", events=[released, changes],
                rtol=1e-10, atol=1e-13,
            )  # fmt: skip
            time, state = part.t[-1], part.y[:, -1]
            if part.t_events[0].size:
                return self._motion(state)
            if part.status != 1:
                break
            if self.sense:
                # Start slightly below the friction limit; otherwise round-off could end sticking.
                state[5] = self.sense * self.reach(state[0], state[1]) * (1 - 1e-9)
                self.sense = 0
            else:
                self.sense = int(np.sign(state[5]))
        raise RuntimeError(
            "the integration of the impact found no end, within 100 changes between sticking and "
            "sliding"
        )

    def _motion(self, state: np.ndarray) -> Motion:
        impact, before, speed = self.impact, self.impact.before, self.impact.before.normal
        _, rate, along, turning, turning_other, _ = (speed * float(value) for value in state)
        gained = along - (before.along - before.along_other)
        share, share_other = (float(value) for value in self.share)
        return Motion(
            normal=-rate,
            along=before.along + gained * share,
            spin=turning / impact.radius,
            along_other=before.along_other - gained * share_other,
            spin_other=-turning_other / impact.radius_other,
        )
