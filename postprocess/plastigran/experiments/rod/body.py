# SPDX-License-Identifier: GPL-2.0-or-later
"""A rod with a spherical tip falls on a flat at an angle: what it is, and its closed forms.

The planar rigid body of Ghaednia, Cermik & Marghitu 2015 (Int. J. Impact Eng. 86:307). x is along
the flat, y its normal and the flat is y = 0; the rod leans by `angle`, its centre to the right of
its tip. Angular velocities count counterclockwise: a tip that is hit turns the rod with a negative
one. `plastigran.physics.rod` integrates its equations of motion, `plastigran.experiments.rod.runs`
runs it in the engine.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import cos, inf, radians, sin

import pandas as pd

from plastigran import laws
from plastigran.materials import Material, read_material


@dataclass(frozen=True)
class Rod:
    """A rod, the flat it falls on and how it meets it; the defaults are the paper's.

    Attributes:
        angle: Between rod and flat [degrees], above 0, at most 90.
        friction: Coefficient of friction between tip and flat [-].
        length: Of the rod [m]; the tip's centre and the far end are half of it from the centre.
        mass: [kg]
        tip_radius: Of the spherical tip [m].
        gravity: [m/s^2]
        material: Of the rod.
        flat: Material of the flat.
        indentation_pressure: For the laws that take one [Pa]. The paper prints
            (2/H_rod + 2/H_flat)^-1 of the Brinell hardnesses 327 and 105.

    Raises:
        ValueError: One of them is out of range, or friction would jam the rod.
    """

    angle: float = 45.0
    friction: float = 0.13
    length: float = 0.3048
    mass: float = 0.4607
    tip_radius: float = 0.0088
    gravity: float = 9.81
    material: Material = field(default_factory=lambda: read_material("steel_gcm15"))
    flat: Material = field(default_factory=lambda: read_material("iron_gcm15"))
    indentation_pressure: float = 3.8971e8

    def __post_init__(self) -> None:
        if not 0 < self.angle <= 90:
            raise ValueError(f"angle is {self.angle:g}; it must be above 0 and at most 90 degrees")
        for name in ("length", "mass", "tip_radius", "indentation_pressure"):
            if not 0 < getattr(self, name) < inf:
                raise ValueError(
                    f"{name} is {getattr(self, name):g}; it must be positive and finite"
                )
        for name in ("friction", "gravity"):
            if not 0 <= getattr(self, name) < inf:
                raise ValueError(
                    f"{name} is {getattr(self, name):g}; it must be finite and not < 0"
                )
        if not self.length > 2 * self.tip_radius:
            raise ValueError(
                f"length is {self.length:g}; it must be more than the tip's diameter "
                f"({2 * self.tip_radius:g} m)"
            )
        if not self._compliance() > 0:
            raise ValueError(
                f"friction is {self.friction:g}; at {self.angle:g} degrees it would jam the rod"
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
        return 1 / self.mass + x_c * (x_c - self.friction * y_c) / self.inertia

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
        return -(x_c - self.friction * y_c) / self.inertia * impulse

    @property
    def pair(self) -> laws.MaterialPair:
        return laws.combine(self.material.body(), self.flat.body())

    def law(self, name: str, **options: str | float):
        """A law between rod and flat, with the rod's indentation pressure where it takes one.

        Raises:
            ValueError: No such law, or an option it does not have or cannot take.
        """
        if name not in laws.LAWS:
            raise ValueError(f"no law {name!r}; there are {', '.join(sorted(laws.LAWS))}")
        law = laws.LAWS[name]
        if law.shape != "sphere":
            raise ValueError(f"{name} is a law for {law.shape}s; the rod's tip is a sphere")
        if any(constant["name"] == "indentation_pressure" for constant in law.parameters()):
            options = {"indentation_pressure": self.indentation_pressure, **options}
        return law(self.pair, **options)


@dataclass(frozen=True)
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
    return tuple(Rod(angle=angle, friction=friction) for angle, friction in PAPER_FRICTION.items())


#: About what the paper's experiments show at those angles, at any speed: coefficient of restitution
#: of the tip's normal velocity [-].
PAPER_RESTITUTION = {45.0: 0.43, 17.2: 0.55}


@dataclass(frozen=True)
class RodImpact:
    """What one impact of a rod did.

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
