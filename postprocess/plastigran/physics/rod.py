# SPDX-License-Identifier: GPL-2.0-or-later
"""Oblique impact of a rod with a spherical tip on a flat: rigid-body constants and closed forms.

The rod is the planar rigid body of Ghaednia, Cermik & Marghitu 2015 (Int. J. Impact Eng. 86:307).
The axis x is along the flat, y is its normal, and the flat is at y = 0. The rod makes the angle
`angle` with the flat, and its center is to the right of its tip. Angular velocities are positive
counterclockwise, and an impact of the tip makes them negative. `plastigran.physics.rod_motion`
integrates the equations of motion.
"""

from __future__ import annotations

from math import cos, radians, sin

import attrs
import pandas as pd

from plastigran.declared import number, radius_field


@attrs.frozen
class Rod:
    """Rod and its angle to the flat. The defaults are the values of the paper.

    The center of the tip and the far end are half a length away from the center of the rod.

    Raises:
        ValueError: A field is out of range, or friction would jam the rod, so that its tip could
            not rebound.
    """

    angle: float = number(
        "angle between rod and flat", "degrees", 0, 90, upper_allowed=True, default=45.0
    )
    coefficient_of_friction: float = number(
        "coefficient of friction between tip and flat", "-", 0, lower_allowed=True, default=0.13
    )
    length: float = number("length of the rod", "m", 0, default=0.3048)
    mass: float = number("mass of the rod", "kg", 0, default=0.4607)
    tip_radius: float = radius_field("radius of the spherical tip", default=0.0088)
    gravitational_acceleration: float = number(
        "gravitational acceleration", "m/s^2", 0, lower_allowed=True, default=9.81
    )

    def __attrs_post_init__(self) -> None:
        if not self.length > 2 * self.tip_radius:
            raise ValueError(
                f"length is {self.length:g} m; it must exceed the diameter of the tip "
                f"({2 * self.tip_radius:g} m)"
            )
        if not self._compliance() > 0:
            raise ValueError(
                f"coefficient_of_friction is {self.coefficient_of_friction:g}; at {self.angle:g} "
                "degrees, this friction would jam the rod. Use a lower coefficient or another angle"
            )

    @property
    def inertia(self) -> float:
        """Moment of inertia about the center [kg m^2], m L^2/12. The paper gives no value."""
        return self.mass * self.length**2 / 12

    @property
    def tip_mass(self) -> float:
        """Mass of each end sphere, if three spheres of equal radius represent the rod [kg].

        The rest of the mass is in the middle sphere. The three spheres and the rod have the same
        moment of inertia.
        """
        return self.mass * (1 / 6 - 0.8 * (self.tip_radius / self.length) ** 2)

    @property
    def arm(self) -> tuple[float, float]:
        """Vector (x_c, y_c) from the contact point to the center of the rod at first touch [m]."""
        half, angle = self.length / 2, radians(self.angle)
        return half * cos(angle), self.tip_radius + half * sin(angle)

    def _compliance(self) -> float:
        x_c, y_c = self.arm
        return 1 / self.mass + x_c * (x_c - self.coefficient_of_friction * y_c) / self.inertia

    @property
    def mass_eff(self) -> float:
        """Effective mass of the normal motion if the tip slides throughout [kg].

        1/m_eff = 1/m + x_c (x_c - mu y_c)/I, with the mass m and the moment of inertia I of the
        rod, the coefficient of friction mu, and the vector (x_c, y_c) of `arm` at first touch.
        """
        return 1 / self._compliance()

    def angular_velocity(self, impulse: float) -> float:
        """Return the angular velocity [rad/s] after a normal impulse [N s].

        The result is -(x_c - mu y_c)/I times the impulse, with the symbols of `mass_eff`. It holds
        if the tip slides throughout the impact. The impulse is m_eff v (1 + e), with the impact
        speed v and the restitution e. It is also the mass of the rod times the change of its normal
        velocity.
        """
        x_c, y_c = self.arm
        return -(x_c - self.coefficient_of_friction * y_c) / self.inertia * impulse


@attrs.frozen(eq=False)
class RodOutcome:
    """Measured or predicted outcome of one impact of a rod.

    Attributes:
        coefficient_of_restitution: Restitution of the normal velocity of the tip [-].
        angular_velocity: Angular velocity at separation [rad/s].
        force_max: Largest normal force [N].
        overlap_max: Largest overlap [m].
        overlap_res: Overlap at zero force [m], the permanent deformation.
        loading_time: Time from first touch to largest overlap [s].
        contact_time: Time from first touch to zero force [s].
        history: Motion versus time. Columns are time [s], overlap [m], force (normal) [N],
            friction_force (along x) [N], displacement_x, displacement_y (of the center since first
            touch) [m], velocity_x, velocity_y (of the center) [m/s], angular_velocity [rad/s] and
            slip_velocity (of the lowest point of the tip along x) [m/s].
    """

    coefficient_of_restitution: float
    angular_velocity: float
    force_max: float
    overlap_max: float
    overlap_res: float
    loading_time: float
    contact_time: float
    history: pd.DataFrame
