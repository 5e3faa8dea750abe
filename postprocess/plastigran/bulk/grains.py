# SPDX-License-Identifier: GPL-2.0-or-later
"""Grains of a bulk deck and the contact law between them."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

from plastigran import laws
from plastigran.materials import Material
from plastigran.physics import central


@dataclass(frozen=True)
class Grains:
    """Equal spheres and the contact law between two of them.

    Attributes:
        law: Name of the contact law.
        options: Options of the law, by name.
        material: Material of the grains.
        radius: Radius [m].
    """

    law: str
    options: dict[str, str]
    material: Material
    radius: float

    @property
    def mass(self) -> float:
        """Mass of a grain [kg]."""
        return 4 / 3 * pi * self.radius**3 * self.material.density

    @property
    def pair(self) -> laws.MaterialPair:
        """Material pair of two grains."""
        return laws.combine(self.material.body(), self.material.body())

    @property
    def yield_speed(self) -> float | None:
        """Impact speed at which two grains begin to yield [m/s]; None for a law without yield."""
        if not laws.LAWS[self.law].yields or self.law == "hertz":
            return None
        return central.yield_speed(self.pair, self.radius / 2, self.mass / 2)

    def contact_law(self):
        """Return the law between two grains.

        Raises:
            ValueError: A constant is invalid; the message names it.
        """
        return self.material.law(self.law, self.pair, **self.options)
