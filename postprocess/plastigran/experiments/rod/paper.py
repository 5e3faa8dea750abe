# SPDX-License-Identifier: GPL-2.0-or-later
"""What Ghaednia, Cermik & Marghitu 2015 (Int. J. Impact Eng. 86:307) print of their rod."""

from __future__ import annotations

import attrs

from plastigran.physics.rod import Rod

#: Speeds of the drops [m/s]; 2.487 is that of the run whose velocities are printed.
PAPER_SPEEDS = (0.5, 1.0, 1.75, 2.487, 3.25, 4.0)


@attrs.frozen
class MeasuredRun:
    """The one run whose velocities the paper prints.

    Attributes:
        angle: [degrees]
        velocity_before, velocity_after: Of the rod's centre, along the normal [m/s].
        angular_velocity: Afterwards [rad/s].
    """

    angle: float = 45.0
    velocity_before: float = -2.487
    velocity_after: float = -0.855
    angular_velocity: float = -19.67

    def impulse(self, rod: Rod) -> float:
        """Normal impulse on the rod [N s], from the change of its centre's velocity."""
        return rod.mass * (self.velocity_after - self.velocity_before)

    def coefficient_of_restitution(self, rod: Rod) -> float:
        """What that impulse is of a sliding tip's m_eff v, less 1 [-]."""
        return self.impulse(rod) / (rod.mass_eff * -self.velocity_before) - 1


#: Coefficient of friction [-] at the paper's angles [degrees].
PAPER_FRICTION = {45.0: 0.13, 17.2: 0.20}


def paper_rods() -> tuple[Rod, ...]:
    """The paper's two set-ups."""
    return tuple(Rod(*set_up) for set_up in PAPER_FRICTION.items())


#: About what the paper's experiments show at those angles, at any speed: coefficient of restitution
#: of the tip's normal velocity [-].
PAPER_RESTITUTION = {45.0: 0.43, 17.2: 0.55}
