# SPDX-License-Identifier: GPL-2.0-or-later
"""Data of the rod experiments of Ghaednia, Cermik & Marghitu (2015, Int. J. Impact Eng. 86:307)."""

from __future__ import annotations

import attrs

from plastigran.physics.rod import Rod

#: Impact speeds of the falling rod [m/s]. The paper prints the velocities of the experiment at
#: 2.487 m/s.
PAPER_SPEEDS = (0.5, 1.0, 1.75, 2.487, 3.25, 4.0)


@attrs.frozen
class MeasuredRun:
    """Experiment whose velocities the paper prints.

    Attributes:
        angle: Angle between rod and flat [degrees].
        velocity_before, velocity_after: Normal velocity of the center of the rod before and after
            the impact [m/s].
        angular_velocity: Angular velocity after the impact [rad/s].
    """

    angle: float = 45.0
    velocity_before: float = -2.487
    velocity_after: float = -0.855
    angular_velocity: float = -19.67

    def impulse(self, rod: Rod) -> float:
        """Return the normal impulse on the rod [N s], from the change of its normal velocity."""
        return rod.mass * (self.velocity_after - self.velocity_before)

    def coefficient_of_restitution(self, rod: Rod) -> float:
        """Return the coefficient of restitution of the tip [-], impulse / (m_eff v) - 1.

        v is the impact speed, and m_eff the effective mass of a tip that slides throughout the
        impact.
        """
        return self.impulse(rod) / (rod.mass_eff * -self.velocity_before) - 1


#: Coefficient of friction [-] at the angles of the paper [degrees].
PAPER_FRICTION = {45.0: 0.13, 17.2: 0.20}


def paper_rods() -> tuple[Rod, ...]:
    """Return the rod at the two angles of the paper, with the friction of the paper."""
    return tuple(Rod(*set_up) for set_up in PAPER_FRICTION.items())


#: Measured coefficient of restitution of the tip's normal velocity [-], by the angle of the rod
#: [degrees]. The values are approximate and about the same at all speeds.
PAPER_RESTITUTION = {45.0: 0.43, 17.2: 0.55}
