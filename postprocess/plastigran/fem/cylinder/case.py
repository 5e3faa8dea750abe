# SPDX-License-Identifier: GPL-2.0-or-later
"""Input of the impact of a rigid cylinder on a body, and estimates of its contact."""

from __future__ import annotations

import attrs

from plastigran.declared import number, radius_field, speed_field
from plastigran.fem.limits import check_subsonic
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.theory.line import HertzLine

LARGEST = 0.6  # largest contact half width / radius of the circle
PLASTIC_PRESSURE = 2.0  # lower estimate of mean pressure / flow stress
MARGIN = 1.2  # safety factor on the thickness below which waves return during the contact


@attrs.frozen(kw_only=True)
class CylinderStrike:
    """Impact of a rigid cylinder on a body; all input of the computation.

    Attributes:
        material: Material of the body; the cylinder is rigid.

    Raises:
        ValueError: A field is out of range, or the contact becomes too large.
    """

    material: ElasticPlastic
    radius: float = radius_field("radius of the cylinder")
    length: float = number("length of the cylinder", "m", 0)
    mass: float = number("total mass that moves with the cylinder", "kg", 0)
    speed: float = speed_field("speed toward the body")
    sliding_speed: float = number(
        "speed along the surface", "m/s", 0, lower_allowed=True, default=0.0
    )
    coefficient_of_friction: float = number(
        "coefficient of friction", "-", 0, 1, lower_allowed=True, upper_allowed=True, default=0.0
    )
    thickness: float | None = number(
        "thickness of the body; by default so large that no wave returns during the contact",
        "m",
        0,
        default=None,
    )

    def __attrs_post_init__(self) -> None:
        sound = self.material.wave_speed
        for name in ("speed", "sliding_speed"):
            check_subsonic(name, getattr(self, name), sound)
        if self.reach > min(LARGEST * self.radius, self.line.thickness / 4):
            raise ValueError(
                f"speed is {self.speed:g} m/s, which gives a contact half width of "
                f"{self.reach:.3g} m. The largest half width is {LARGEST:g} times the radius, "
                f"{self.radius:g} m, and a quarter of the thickness, {self.line.thickness:g} m. "
                "Use a lower speed, or check the units: Pa, kg/m3, m"
            )

    @property
    def line(self) -> HertzLine:
        """Elastic line contact of the cylinder and the body.

        Without `thickness`, the body is so thick that no wave returns during the contact.
        """
        if self.thickness is not None:
            return self._line(self.thickness)
        thickness = 10 * self.radius
        for _ in range(20):
            duration = self._line(thickness).duration(self.mass, self.speed)
            thickness = max(MARGIN * self.material.wave_speed * duration / 2, 10 * self.radius)
        return self._line(thickness)

    def _line(self, thickness: float) -> HertzLine:
        return HertzLine(
            material=self.material, radius=self.radius, length=self.length, thickness=thickness
        )

    @property
    def reach(self) -> float:
        """Largest expected half width of the elastic or plastic contact, m."""
        line = self.line
        force = line.impact_force(self.mass, self.speed)
        if force <= line.yield_force:
            return line.half_width(force)
        strength = self.material.hardening.yield_strength
        return max(line.half_width(force), force / (2 * PLASTIC_PRESSURE * strength * self.length))

    @property
    def oblique(self) -> bool:
        """Whether the cylinder slides along the body, which breaks the symmetry."""
        return self.sliding_speed > 0
