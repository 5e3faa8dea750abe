# SPDX-License-Identifier: GPL-2.0-or-later
"""Names and units of the quantities on the axes of figures."""

from __future__ import annotations

import attrs
import numpy as np

#: Suffix of the columns that hold predicted values.
PREDICTED = "_predicted"
#: Name in words and SI unit of the columns of tables; the unit of a pure number is "".
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
    "surface_speed": ("surface speed", "m/s"),
    "angular_velocity": ("angular velocity", "rad/s"),
    "radius": ("radius", "m"),
    "surface_energy": ("surface energy", "J/m²"),
    "geometry": ("geometry", ""),
    "material": ("material", ""),
    "youngs_modulus": ("Young's modulus", "Pa"),
    "poissons_ratio": ("Poisson's ratio", ""),
    "timestep": ("time step", "s"),
    "time": ("time", "s"),
    "atoms": ("grains", ""),
    "kinetic_energy": ("translational kinetic energy", "J"),
    "kinetic": ("kinetic energy", "J"),
    "gravity": ("gravitational energy", "J"),
    "elastic": ("elastic energy in contacts", "J"),
    "plastic": ("plastic work", "J"),
    "friction": ("friction work", "J"),
    "viscous": ("viscous work", "J"),
    "wallwork": ("work of walls", "J"),
    "inserted": ("energy inserted", "J"),
    "drift": ("balance error", "J"),
    "surfaces": ("surface energy of contacts", "J"),
    "adhesion": ("loss by adhesion", "J"),
    "springs": ("elastic energy in tangential springs", "J"),
    "temperature": ("granular temperature", "m²/s²"),
    "temperature_error": ("relative standard deviation of the temperature", ""),
    "collisions": ("collisions of a grain", ""),
    "flow": ("speed of the mean flow", "m/s"),
    "held": ("grains in the hopper or silo", ""),
    "counted": ("grains that have left", ""),
    "packing": ("volume fraction", ""),
    "mass": ("mass of the grains", "kg"),
    "x": ("center of mass, x", "m"),
    "z": ("center of mass, z", "m"),
    "momentum": ("angular momentum", "kg m²/s"),
    "height": ("height of the punch or platen", "m"),
    "force": ("force", "N"),
    "weight_power": ("power of the weight", "W"),
    "revolutions": ("revolutions", ""),
}
#: Units that are used without SI prefix.
_WITHOUT_PREFIX = ("", "J/m²", "°", "m²/s²", "kg m²/s", "rad/s", "kg", "m/s")
_PREFIXES = {-12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}


@attrs.frozen
class Scale:
    """Axis of a chart: quantity and unit.

    Attributes:
        title: Name of the quantity.
        unit: Unit with its prefix; "" for a pure number.
        factor: Number by which a value in SI units is multiplied to get the value in `unit`.
    """

    title: str
    unit: str
    factor: float

    @property
    def axis(self) -> str:
        """Title with the unit in parentheses."""
        return f"{self.title} ({self.unit})" if self.unit else self.title


def words(column: str) -> str:
    """Return the name of a column in words."""
    return QUANTITIES.get(column, (column.replace("_", " "), ""))[0]


def scale(column: str, values: object) -> Scale:
    """Return the axis of a column, with an SI prefix that makes the largest value 1 to 1000.

    Args:
        column: Name of the column. A column whose unit is unknown gets no prefix.
        values: Values of the column in SI units; infinite values and NaN are ignored.
    """
    name, unit = QUANTITIES.get(column, (words(column), "as in the log"))
    if column not in QUANTITIES or unit in _WITHOUT_PREFIX:
        return Scale(name, unit, 1.0)
    letter, factor = prefix(values)
    return Scale(name, letter + unit, factor)


def prefix(values: object) -> tuple[str, float]:
    """Return the SI prefix that makes the largest absolute value 1 to 1000, and its factor.

    A value multiplied by the factor is in the unit with the prefix. Prefixes range from p to G. If
    all values are zero, there is no prefix and the factor is 1.

    Args:
        values: Values in a unit without prefix; infinite values and NaN are ignored.
    """
    sizes = np.abs(np.asarray(values, float))
    sizes = sizes[np.isfinite(sizes) & (sizes > 0)]
    if not sizes.size:
        return "", 1.0
    power = int(np.clip(3 * np.floor(np.log10(sizes.max()) / 3), min(_PREFIXES), max(_PREFIXES)))
    return _PREFIXES[power], 10.0**-power
