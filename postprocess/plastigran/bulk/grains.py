# SPDX-License-Identifier: GPL-2.0-or-later
"""The grains of a bulk deck, from the settings all bulk decks share."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, pi

from plastigran import laws
from plastigran.engine.deck import Settings
from plastigran.materials import Material, laws_for
from plastigran.physics import central


@dataclass(frozen=True)
class Grains:
    """Equal spheres and the law between two of them.

    Attributes:
        law: Name of the law.
        options: Of the law, by name.
        material: Of the grains.
        radius: [m].
    """

    law: str
    options: dict[str, str]
    material: Material
    radius: float

    @property
    def mass(self) -> float:
        """Of a grain [kg]."""
        return 4 / 3 * pi * self.radius**3 * self.material.density

    @property
    def pair(self) -> laws.MaterialPair:
        return laws.combine(self.material.body(), self.material.body())

    @property
    def yield_speed(self) -> float | None:
        """Impact speed at which two grains begin to yield [m/s]; None for a law without yield."""
        if not laws.LAWS[self.law].yields or self.law == "hertz":
            return None
        return central.yield_speed(self.pair, self.radius / 2, self.mass / 2)

    def contact_law(self):
        """The law between two grains. Raises ValueError naming a constant it cannot take."""
        return self.material.law(self.law, self.pair, **self.options)


def read_grains(settings: Settings) -> Grains:
    """The grains of a deck's settings law, options, material with its constants, and radius.

    Raises:
        ValueError: One is unknown or out of range; the message names it.
    """
    law = settings["law"]
    if law not in laws_for("sphere"):
        raise ValueError(f"no law {law!r} for spheres; there are {', '.join(laws_for('sphere'))}")
    constants = {
        "youngs_modulus": settings.number("youngs_modulus", 0, unit="Pa"),
        "poissons_ratio": settings.number("poissons_ratio", -1, 0.5),
        "density": settings.number("density", 0, unit="kg/m^3"),
        "yield_strength": settings.number("yield_strength", 0, unit="Pa"),
        "yield_pressure_factor": settings.number("yield_pressure_factor", -inf),
    }
    dissipative_constant = settings.number("dissipative_constant", 0, unit="s", closed=True)
    if dissipative_constant:
        constants["dissipative_constant"] = dissipative_constant
    known = {option["name"] for option in laws.LAWS[law].options()}
    grains = Grains(
        law,
        {name: word for name, word in read_options(settings).items() if name in known},
        Material(settings["material"], **constants),
        settings.number("radius", 0, unit="m"),
    )
    grains.contact_law()  # raises for constants it cannot take
    return grains


def read_options(settings: Settings) -> dict[str, str]:
    """The setting `options`, words of the model on the pair_style line, by name.

    Raises:
        ValueError: They are not pairs.
    """
    words = settings["options"].split()
    if len(words) % 2:
        raise ValueError(f"options is {settings['options']!r}; it must be pairs, NAME CHOICE")
    return dict(zip(words[::2], words[1::2], strict=True))
