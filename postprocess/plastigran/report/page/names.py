# SPDX-License-Identifier: GPL-2.0-or-later
"""What a page calls quantities, and their units."""

from __future__ import annotations

import attrs
import numpy as np

from plastigran.plot.prefixes import prefix

#: What the name of a column ends in that holds theory's value of another.
PREDICTED = "_predicted"
#: Column of a table: its name in words and its unit; "" where it has none.
QUANTITIES = {
    "coefficient_of_restitution": ("coefficient of restitution", ""),
    "force_max": ("largest force", "N"),
    "overlap_max": ("largest overlap", "m"),
    "overlap_res": ("residual overlap", "m"),
    "loading_time": ("loading time", "s"),
    "contact_time": ("contact time", "s"),
    "speed": ("impact speed", "m/s"),
    "speed_ratio": ("impact speed / yield speed", ""),
    "angle": ("angle", "°"),
    "coefficient_of_friction": ("coefficient of friction", ""),
    "speed_along": ("speed along the surface", "m/s"),
    "spin_after": ("spin after the impact", "rad/s"),
    "surface_speed": ("speed of the surface", "m/s"),
    "angular_velocity": ("angular velocity", "rad/s"),
    "radius": ("radius", "m"),
    "geometry": ("geometry", ""),
    "material": ("material", ""),
    "time": ("time", "s"),
    "atoms": ("grains", ""),
    "kinetic_energy": ("kinetic energy of translation", "J"),
    "kinetic": ("kinetic energy", "J"),
    "gravity": ("energy of gravity", "J"),
    "elastic": ("stored in contacts", "J"),
    "plastic": ("plastic work", "J"),
    "friction": ("work of friction", "J"),
    "viscous": ("viscous work", "J"),
    "wallwork": ("work of walls", "J"),
    "inserted": ("energy inserted", "J"),
    "drift": ("drift of the ledger", "J"),
    "springs": ("stored in friction's springs", "J"),
    "temperature": ("granular temperature", "m²/s²"),
    "temperature_error": ("error of the predicted temperature", "m²/s²"),
    "collisions": ("collisions of a grain", ""),
    "flow": ("speed of the mean flow", "m/s"),
    "held": ("grains in the hopper", ""),
    "counted": ("grains that have left", ""),
    "packing": ("volume fraction", ""),
    "mass": ("mass of the grains", "kg"),
    "x": ("centre of mass, x", "m"),
    "z": ("centre of mass, z", "m"),
    "momentum": ("momentum", "kg m/s"),
    "height": ("height of the punch", "m"),
    "force": ("force", "N"),
    "weight_power": ("power of the weight", "W"),
    "revolutions": ("revolutions", ""),
}
#: Units that do not take a prefix.
_WHOLE = ("", "°", "m²/s²", "kg m/s", "rad/s", "kg", "m/s")


@attrs.frozen
class Scale:
    """A quantity as an axis shows it: its title, the unit with a prefix, and the factor to it."""

    title: str
    unit: str
    factor: float

    @property
    def axis(self) -> str:
        """Title of an axis."""
        return f"{self.title} ({self.unit})" if self.unit else self.title


def words(column: str) -> str:
    """A column's name in words."""
    return QUANTITIES.get(column, (column.replace("_", " "), ""))[0]


def unit(column: str) -> str | None:
    """A column's unit, "" where it has none; None where it is not known."""
    return QUANTITIES[column][1] if column in QUANTITIES else None


def scale(column: str, values: object) -> Scale:
    """How an axis shows a column: its numbers between 1 and 1000, as far as the unit allows.

    Args:
        column: Its name.
        values: Numbers in SI units; what is not finite does not count.
    """
    name, base = words(column), unit(column)
    if base is None:
        return Scale(name, "as in the log", 1.0)
    if base in _WHOLE:
        return Scale(name, base, 1.0)
    small, factor = prefix(values)
    return Scale(name, small + base, factor)


def number(value: object) -> str:
    """A cell of a table: four digits, powers of ten by their sign."""
    if isinstance(value, bool | np.bool_):
        return "yes" if value else "no"
    if not isinstance(value, int | float | np.integer | np.floating):
        return "" if value is None else str(value)
    if np.isnan(value):
        return ""
    text = f"{value:.4g}"
    if "e" not in text:
        return text.replace("-", "−")
    mantissa, power = text.split("e")
    return f"{mantissa} × 10{_raised(int(power))}".replace("-", "−").removeprefix("1 × ")


def _raised(power: int) -> str:
    return str(power).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
