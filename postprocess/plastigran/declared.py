# SPDX-License-Identifier: GPL-2.0-or-later
"""Declarations of quantities as attrs fields, with unit, bounds and meaning.

The inputs of an experiment and the settings of a bulk deck are attrs classes with such fields. A
value may be a number or its text, such as "0.3". The constructor checks the values; its error
message names the field, the value and the allowed range. Help texts, tables and pages of the docs
take units and meanings from the `declarations` of a class.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from math import inf, isfinite
from typing import Any

import attrs


class SizeWarning(UserWarning):
    """A radius is unusually small or large for grains."""


@attrs.frozen
class Declaration:
    """Declaration of a quantity.

    Attributes:
        meaning: Meaning in words.
        unit: SI unit, "-" for none.
        lower, upper: Bounds.
        lower_allowed, upper_allowed: Whether the value may equal the bound.
        choices: Allowed words.
        value_type: Type of the value: float, int or str.
        usual: Usual range. Outside this range, a warning recommends to check the unit.
    """

    meaning: str
    unit: str = "-"
    lower: float = -inf
    upper: float = inf
    lower_allowed: bool = False
    upper_allowed: bool = False
    choices: tuple[str, ...] = ()
    value_type: type = float
    usual: tuple[float, float] | None = None

    def allowed(self) -> str:
        """Return the allowed range in words, such as "must be positive and finite [m]"."""
        if self.choices:
            return f"must be one of {', '.join(self.choices)}"
        if self.value_type is int and self.lower_allowed and self.upper == inf:
            return f"must be {self.lower:g} or more"
        if self.lower_allowed and self.upper_allowed and self.upper < inf:
            return f"must lie from {self.lower:g} to {self.upper:g} [{self.unit}]"
        least = f"{self.lower:g} or more" if self.lower_allowed else f"above {self.lower:g}"
        most = f"at most {self.upper:g}" if self.upper_allowed else f"below {self.upper:g}"
        if self.upper == inf:
            most = "finite"
            least = "positive" if least == "above 0" else least
        bounds = most if self.lower == -inf else f"{least} and {most}"
        return f"must be {bounds} [{self.unit}]"

    def allows(self, value: float) -> bool:
        """Return whether a value is finite and within the bounds."""
        return isfinite(value) and (
            self.lower < value < self.upper
            or (self.lower_allowed and value == self.lower)
            or (self.upper_allowed and value == self.upper)
        )


#: Declaration of the radius of a grain, of a ball or of the spherical tip of a rod.
RADIUS = Declaration("radius", "m", 1e-12, 1e6, True, True, usual=(1e-9, 0.5))

#: Declaration of an impact speed. Below 1e-9 m/s, the overlap of the impact would be smaller than
#: the round-off of positions in LIGGGHTS.
SPEED = Declaration("speed", "m/s", 1e-9, lower_allowed=True)


def number(
    meaning: str,
    unit: str = "-",
    lower: float = -inf,
    upper: float = inf,
    lower_allowed: bool = False,
    upper_allowed: bool = False,
    default: Any = attrs.NOTHING,
) -> Any:
    """Declare a field for a number between two bounds; None is allowed if it is the default.

    Args:
        meaning, unit, lower, upper, lower_allowed, upper_allowed: See `Declaration`.
        default: Default value; without one, the field is required.
    """
    declaration = Declaration(meaning, unit, lower, upper, lower_allowed, upper_allowed)
    return _field(declaration, read_number, default)


def radius_field(meaning: str, default: Any = attrs.NOTHING) -> Any:
    """Declare a field for the radius [m] of a grain, of a ball or of the tip of a rod."""
    return _field(attrs.evolve(RADIUS, meaning=meaning), read_number, default)


def speed_field(meaning: str) -> Any:
    """Declare a field for the speed of an impact [m/s]."""
    return _field(attrs.evolve(SPEED, meaning=meaning), read_number)


def whole(meaning: str, lower: int = 0, default: Any = attrs.NOTHING, upper: float = inf) -> Any:
    """Declare a field for a whole number from `lower` to `upper`."""
    declaration = Declaration(
        meaning, "-", lower, upper, lower_allowed=True, upper_allowed=True, value_type=int
    )
    return _field(declaration, _read_whole_number, default)


def word(meaning: str, choices: Sequence[str], default: Any = attrs.NOTHING) -> Any:
    """Declare a field whose value is one of several words."""
    declaration = Declaration(meaning, choices=tuple(choices), value_type=str)
    return _field(declaration, _read_word, default)


def _field(
    declaration: Declaration,
    read: Callable[[str, Any, Declaration], Any],
    default: Any = attrs.NOTHING,
) -> Any:
    converter = attrs.Converter(
        lambda value, field: read(field.name, value, declaration), takes_field=True
    )
    if default is None:
        converter = attrs.converters.optional(converter)
    return attrs.field(default=default, converter=converter, metadata={"declaration": declaration})


def declarations(cls: type) -> dict[str, Declaration]:
    """Return the declarations of the fields of an attrs class, by name."""
    return {
        field.name: field.metadata["declaration"]
        for field in attrs.fields(cls)
        if "declaration" in field.metadata
    }


def require(instance: Any, name: str, **bounds: float | bool) -> None:
    """Check a field against bounds that depend on other fields.

    Args:
        instance: Object of an attrs class of declared fields.
        name: Name of the field.
        bounds: Bounds that replace the declared ones: `lower`, `upper`, `lower_allowed`,
            `upper_allowed`.

    Raises:
        ValueError: The value is out of range; the message contains the value and the range.
    """
    declaration = declarations(type(instance))[name]
    _check_range(name, getattr(instance, name), attrs.evolve(declaration, **bounds))


def read_number(name: str, value: Any, declaration: Declaration) -> float:
    """Convert a value to a number, and check that a declaration allows it.

    Raises:
        ValueError: The value is not a number or out of range; the message contains `name`.
    """
    number = read_float(name, value, declaration.unit)
    _check_range(name, number, declaration)
    return number


def read_float(name: str, value: Any, unit: str) -> float:
    """Convert a value to a number, without a check of its range.

    Raises:
        ValueError: The value is not a number; the message contains `name` and the unit.
    """
    try:
        if isinstance(value, bool) or (isinstance(value, str) and "_" in value):
            raise ValueError  # reject "1_000", which LIGGGHTS does not read as a number
        return float(value)
    except (TypeError, ValueError):
        raise ValueError(f"{name} is {value!r}, not a number [{unit}]") from None


def _read_whole_number(name: str, value: Any, declaration: Declaration) -> int:
    try:
        number = None if isinstance(value, bool) else int(value)
    except (TypeError, ValueError, OverflowError):
        number = None
    if number is None or (not isinstance(value, str) and number != value):
        raise ValueError(f"{name} is {value!r}, not a whole number")
    _check_range(name, number, declaration)
    return number


def _read_word(name: str, value: Any, declaration: Declaration) -> str:
    if str(value) not in declaration.choices:
        raise ValueError(f"{name} is {str(value)!r}; it {declaration.allowed()}")
    return str(value)


def _check_range(name: str, value: float, declaration: Declaration) -> None:
    if not declaration.allows(value):
        shown = value if isinstance(value, int) else f"{value:g}"
        raise ValueError(f"{name} is {shown}; it {declaration.allowed()}")
    if declaration.usual and not declaration.usual[0] <= value <= declaration.usual[1]:
        warnings.warn(
            f"{name} is {value:g} m, which is {1e3 * value:g} mm; radii are usually between "
            f"{declaration.usual[0]:g} and {declaration.usual[1]:g} m. Check the unit: radii are "
            "in m, not mm",
            SizeWarning,
            # Report this line as the origin of the warning. Python then shows equal warnings once.
            stacklevel=1,
        )
