# SPDX-License-Identifier: GPL-2.0-or-later
"""A rod with a spherical tip falls on a flat at an angle: the rigid body and its closed forms.

The planar rigid body of Ghaednia, Cermik & Marghitu 2015 (Int. J. Impact Eng. 86:307). x is along
the flat, y its normal and the flat is y = 0; the rod leans by `angle`, its centre to the right of
its tip. Angular velocities count counterclockwise: a tip that is hit turns the rod with a negative
one. `plastigran.physics.rod_motion` integrates its equations of motion.
"""

from __future__ import annotations

from math import cos, radians, sin

import attrs
import pandas as pd

from plastigran.declared import number, radius_field


@attrs.frozen
class Rod:
    """A rod and how it meets the flat; the defaults are the paper's. The tip's centre and the far
    end are half a length from the centre.

    Raises:
        ValueError: A field is out of range, or friction would jam the rod.
    """

    angle: float = number("between rod and flat", "degrees", 0, 90, closed=True, default=45.0)
    coefficient_of_friction: float = number(
        "between tip and flat", "-", 0, closed=True, default=0.13
    )
    length: float = number("length of the rod", "m", 0, default=0.3048)
    mass: float = number("mass of the rod", "kg", 0, default=0.4607)
    tip_radius: float = radius_field("radius of the spherical tip", default=0.0088)
    gravitational_acceleration: float = number(
        "gravitational acceleration", "m/s^2", 0, closed=True, default=9.81
    )

    def __attrs_post_init__(self) -> None:
        if self.angle == 0:
            raise ValueError("angle is 0; it must be above 0 and at most 90 [degrees]")
        if not self.length > 2 * self.tip_radius:
            raise ValueError(
                f"length is {self.length:g}; it must be more than the tip's diameter "
                f"({2 * self.tip_radius:g} m)"
            )
        if not self._compliance() > 0:
            raise ValueError(
                f"coefficient_of_friction is {self.coefficient_of_friction:g}; "
                f"at {self.angle:g} degrees it would jam the rod"
            )

    @property
    def inertia(self) -> float:
        """About the centre [kg m^2], m L^2/12. The paper does not give it."""
        return self.mass * self.length**2 / 12

    @property
    def tip_mass(self) -> float:
        """Mass of each end of three equal spheres that are the rod [kg]: with the rest of the mass
        in the middle one they have its inertia, their own included."""
        return self.mass * (1 / 6 - 0.8 * (self.tip_radius / self.length) ** 2)

    @property
    def arm(self) -> tuple[float, float]:
        """The centre from the point of contact (x_c, y_c) at first touch [m]."""
        half, angle = self.length / 2, radians(self.angle)
        return half * cos(angle), self.tip_radius + half * sin(angle)

    def _compliance(self) -> float:
        x_c, y_c = self.arm
        return 1 / self.mass + x_c * (x_c - self.coefficient_of_friction * y_c) / self.inertia

    @property
    def mass_eff(self) -> float:
        """Mass the normal motion of a tip that slides throughout feels [kg].

        1/m_eff = 1/m + x_c (x_c - mu y_c)/I, with the rod where it was at first touch.
        """
        return 1 / self._compliance()

    def angular_velocity(self, impulse: float) -> float:
        """Angular velocity a normal impulse [N s] leaves [rad/s], as `mass_eff` takes the rod.

        -(x_c - mu y_c)/I times the impulse, which is m_eff v (1 + e) or the centre's change of
        velocity times the mass.
        """
        x_c, y_c = self.arm
        return -(x_c - self.coefficient_of_friction * y_c) / self.inertia * impulse


@attrs.frozen(eq=False)
class RodOutcome:
    """What one impact of a rod did, measured or predicted.

    Attributes:
        coefficient_of_restitution: Of the normal velocity of the tip [-].
        angular_velocity: When the tip lets go [rad/s].
        force_max: Largest normal force [N].
        overlap_max: Largest overlap [m].
        overlap_res: Overlap at which the force vanished [m], the permanent deformation.
        loading_time: From first touch to largest overlap [s].
        contact_time: From first touch to zero force [s].
        history: (N,) columns time [s], overlap [m], force (normal) [N], friction_force (along x)
            [N], displacement_x, displacement_y (of the centre since first touch) [m], velocity_x,
            velocity_y (of the centre) [m/s], angular_velocity [rad/s], slip_velocity (of the tip
            along x) [m/s].
    """

    coefficient_of_restitution: float
    angular_velocity: float
    force_max: float
    overlap_max: float
    overlap_res: float
    loading_time: float
    contact_time: float
    history: pd.DataFrame
