# SPDX-License-Identifier: GPL-2.0-or-later
"""Leeb's rebound hardness: a body with a ball of tungsten carbide hits a flat sample.

The reading is HL = 1000 times the rebound speed over the impact speed (ISO 16859), so a contact law
and the sample's yield strength say what a tester would read. The ball is far harder than a metal
sample and is taken as elastic; the sample as thick and heavy.
"""

from __future__ import annotations

from math import sqrt

import attrs

from plastigran import laws
from plastigran.declared import number, radius_field

GRAVITATIONAL_ACCELERATION = 9.81  # m/s^2

#: Cemented tungsten carbide: 600 to 650 GPa, elastic at any speed a tester has.
TUNGSTEN_CARBIDE = laws.Body(625e9, 0.22)


@attrs.frozen
class ReboundTester:
    """What a tester throws, and how fast.

    Attributes:
        ball: Its material, which does not yield.
        sensor_height: Where the speeds are read [m]. 0 leaves gravity out; 1 mm, as testers have,
            lowers the reading of device D by 0.1 % at 800 and by 2.5 % at 300.

    Raises:
        ValueError: A number is out of range.
    """

    name: str
    ball_radius: float = radius_field("of the ball")
    mass: float = number("of the body with its ball", "kg", 0)
    speed: float = number("impact speed, read at the sensor", "m/s", 0)
    ball: laws.Body = TUNGSTEN_CARBIDE
    sensor_height: float = number("of the sensor over the sample", "m", 0, closed=True, default=0.0)

    def pair(self, sample: laws.Body) -> laws.MaterialPair:
        """The ball and a sample."""
        return laws.combine(sample, self.ball)

    def impact(self, law: str, sample: laws.Body, **constants: float | str) -> laws.ImpactOutcome:
        """The impact on a flat sample.

        Args:
            law: Name of the law.
            sample: Material of the sample.
            constants: The law's own, those without default at least.

        Raises:
            ValueError: A constant is missing or out of range.
        """
        found = laws.LAWS[law](self.pair(sample), **dented_flat(law), **constants)
        return found.central_impact(self.ball_radius, self.mass, self._speed_of_contact())

    def reading(self, law: str, sample: laws.Body, **constants: float | str) -> float:
        """Rebound hardness HL of a sample [-].

        Arguments and errors as for `impact`.
        """
        restitution = self.impact(law, sample, **constants).coefficient_of_restitution
        back = (restitution * self._speed_of_contact()) ** 2 - self._speed_lost() ** 2
        return 1000 * sqrt(max(back, 0)) / self.speed

    def restitution(self, reading: float) -> float:
        """Coefficient of restitution [-] that a reading HL stands for."""
        back = (reading / 1000 * self.speed) ** 2 + self._speed_lost() ** 2
        return sqrt(back) / self._speed_of_contact()

    def _speed_of_contact(self) -> float:
        return sqrt(self.speed**2 + self._speed_lost() ** 2)

    def _speed_lost(self) -> float:
        """What a fall from the sensor to the sample gives [m/s]."""
        return sqrt(2 * GRAVITATIONAL_ACCELERATION * self.sensor_height)


def dented_flat(law: str) -> dict[str, str]:
    """Options by which a law knows that a flat is dented and no sphere flattened."""
    words = {option["name"]: option["choices"] for option in laws.LAWS[law].options()}
    return {name: "flat" for name in ("yielding",) if "flat" in words.get(name, ())}


#: Impact devices by their letters; ISO 16859 and makers' tables.
TESTERS = {
    "D": ReboundTester("D", ball_radius=1.5e-3, mass=5.45e-3, speed=2.05),
    "G": ReboundTester("G", ball_radius=2.5e-3, mass=20e-3, speed=3.0),
    "C": ReboundTester("C", ball_radius=1.5e-3, mass=3.0e-3, speed=1.4),
}
