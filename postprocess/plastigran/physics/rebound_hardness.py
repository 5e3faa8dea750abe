# SPDX-License-Identifier: GPL-2.0-or-later
"""Leeb's rebound hardness: an impact body with a ball of tungsten carbide hits a flat sample.

The tester displays the hardness HL, which is 1000 times rebound speed / impact speed (ISO 16859). A
contact law predicts HL from the yield strength of the sample. The ball is much harder than a metal
sample, so the model treats it as elastic. The model treats the sample as a half space.
"""

from __future__ import annotations

from math import sqrt

import attrs

from plastigran import laws
from plastigran.declared import number, radius_field

GRAVITATIONAL_ACCELERATION = 9.81  # standard gravity [m/s^2]

#: Cemented tungsten carbide, with a Young's modulus of 600 to 650 GPa. The carbide does not yield
#: at the speeds of the testers.
TUNGSTEN_CARBIDE = laws.Body(625e9, 0.22)


@attrs.frozen
class ReboundTester:
    """Impact body of a rebound hardness tester, and its speed.

    Attributes:
        name: Letter of the impact device, such as "D".
        ball: Material of the ball, which does not yield.
        sensor_height: Height above the sample at which the tester measures the speeds [m]; 0 to
            neglect gravity. In real testers, the height is 1 mm. Gravity then lowers the displayed
            hardness of device D by 0.1 % at HL 800 and by 2.5 % at HL 300.

    Raises:
        ValueError: A number is out of range.
    """

    name: str
    ball_radius: float = radius_field("radius of the ball")
    mass: float = number("mass of the impact body with its ball", "kg", 0)
    speed: float = number("impact speed at the sensor", "m/s", 0)
    ball: laws.Body = TUNGSTEN_CARBIDE
    sensor_height: float = number(
        "height of the sensor above the sample", "m", 0, lower_allowed=True, default=0.0
    )

    def pair(self, sample: laws.Body) -> laws.MaterialPair:
        """Return the combined constants of the ball and a sample."""
        return laws.combine(sample, self.ball)

    def impact(self, law: str, sample: laws.Body, **constants: float | str) -> laws.ImpactOutcome:
        """Compute the impact on a flat sample.

        Args:
            law: Name of the law.
            sample: Material of the sample.
            constants: Constants of the law; constants without default are required.

        Raises:
            ValueError: A constant is missing or out of range.
        """
        instance = laws.LAWS[law](self.pair(sample), **dented_flat(law), **constants)
        return instance.central_impact(self.ball_radius, self.mass, self._speed_of_contact())

    def reading(self, law: str, sample: laws.Body, **constants: float | str) -> float:
        """Return the rebound hardness HL that the tester displays for a sample [-].

        Arguments and errors are as for `impact`.
        """
        restitution = self.impact(law, sample, **constants).coefficient_of_restitution
        back = (restitution * self._speed_of_contact()) ** 2 - self._speed_lost() ** 2
        return 1000 * sqrt(max(back, 0)) / self.speed

    def restitution(self, reading: float) -> float:
        """Return the coefficient of restitution [-] for a displayed hardness HL."""
        back = (reading / 1000 * self.speed) ** 2 + self._speed_lost() ** 2
        return sqrt(back) / self._speed_of_contact()

    def _speed_of_contact(self) -> float:
        return sqrt(self.speed**2 + self._speed_lost() ** 2)

    def _speed_lost(self) -> float:
        """Return the speed of a free fall from rest at the sensor to the sample [m/s]."""
        return sqrt(2 * GRAVITATIONAL_ACCELERATION * self.sensor_height)


def dented_flat(law: str) -> dict[str, str]:
    """Return the option with which a law describes a yielding flat instead of a yielding sphere.

    The result is {} if the law has no such option.
    """
    words = {option["name"]: option["choices"] for option in laws.LAWS[law].options()}
    return {name: "flat" for name in ("yielding",) if "flat" in words.get(name, ())}


#: Impact devices by letter, from ISO 16859 and makers' tables.
TESTERS = {
    "D": ReboundTester("D", ball_radius=1.5e-3, mass=5.45e-3, speed=2.05),
    "G": ReboundTester("G", ball_radius=2.5e-3, mass=20e-3, speed=3.0),
    "C": ReboundTester("C", ball_radius=1.5e-3, mass=3.0e-3, speed=1.4),
}
