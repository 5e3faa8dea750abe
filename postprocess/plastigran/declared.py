# SPDX-License-Identifier: GPL-2.0-or-later
"""Quantities declared once, as attrs fields: unit, bounds and meaning beside the name.

Cases of experiments and settings of bulk decks are attrs classes of such fields. A value may be a
number or the text of a deck. It is checked when the object is created; the error names the field,
the
value and what is allowed. Command lines, tables and pages read unit, bounds and meaning from the
metadata of the field, `declaration(cls)`.
"""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from math import inf, isfinite
from typing import Any

import attrs


class SizeWarning(UserWarning):
    """A size is unusual for grains."""


@attrs.frozen
class Declaration:
    """Declaration of one field.

    Attributes:
        meaning: Meaning in words.
        unit: SI unit, "-" for none.
        lower, upper: Bounds.
        closed: Whether the bounds themselves are allowed.
        choices: Allowed words.
        kind: Type of the value: float, int or str.
        usual: Range outside of which a value gives a warning to check its unit; or None.
    """

    meaning: str
    unit: str = "-"
    lower: float = -inf
    upper: float = inf
    closed: bool = False
    choices: tuple[str, ...] = ()
    kind: type = float
    usual: tuple[float, float] | None = None

    def allowed(self) -> str:
        """Allowed range in words."""
        if self.choices:
            return f"must be {', '.join(self.choices)}"
        if (self.lower, self.upper) == (-inf, inf):
            return f"must be finite [{self.unit}]"
        if self.upper == inf:
            least = {True: f"{self.lower:g} or more", False: f"above {self.lower:g}"}[self.closed]
            return f"must be {'positive' if least == 'above 0' else least} and finite [{self.unit}]"
        ends = "from {:g} to {:g}" if self.closed else "above {:g} and below {:g}"
        return f"must lie {ends.format(self.lower, self.upper)} [{self.unit}]"

    def allows(self, value: float) -> bool:
        """Return whether a value is finite and within the bounds."""
        if not isfinite(value):
            return False
        return self.lower < value < self.upper or (
            self.closed and value in (self.lower, self.upper)
        )


def number(
    meaning: str,
    unit: str = "-",
    lower: float = -inf,
    upper: float = inf,
    closed: bool = False,
    default: Any = attrs.NOTHING,
) -> Any:
    """Declare a field for a number between two bounds.

    The bounds are allowed if `closed`. None is allowed if it is the default.
    """
    said = Declaration(meaning, unit, lower, upper, closed)
    return _field(said, to_float, default)


#: Radius of a grain, ball or tip.
RADIUS = Declaration("radius", "m", 1e-12, 1e6, closed=True, usual=(1e-9, 0.5))


def radius_field(meaning: str, default: Any = attrs.NOTHING) -> Any:
    """Declare a field for the radius of a grain, ball or tip [m]."""
    return _field(attrs.evolve(RADIUS, meaning=meaning), to_float, default)


#: The speed of an impact. Below, the overlap is lost in the rounding of LIGGGHTS' positions.
SPEED = Declaration("speed", "m/s", 1e-9, closed=True)


def speed_field(meaning: str) -> Any:
    """Declare a field for the speed of an impact [m/s]."""
    return _field(attrs.evolve(SPEED, meaning=meaning), to_float, attrs.NOTHING)


def whole(meaning: str, lower: int = 0, default: Any = attrs.NOTHING, upper: float = inf) -> Any:
    """Declare a field for a whole number from `lower` to `upper`."""
    said = Declaration(meaning, lower=lower, upper=upper, closed=True, kind=int)
    return _field(said, _to_int, default)


def word(meaning: str, choices: Sequence[str], default: Any = attrs.NOTHING) -> Any:
    """Declare a field for one of some words."""
    return _field(Declaration(meaning, choices=tuple(choices), kind=str), _to_word, default)


def declaration(cls: type) -> dict[str, Declaration]:
    """Return the declaration of each declared field of an attrs class, by name."""
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
        bounds: `lower`, `upper`, `closed`, instead of the declared ones.

    Raises:
        ValueError: The value is out of range; the message names it and the range.
    """
    said = declaration(type(instance))[name]
    _check_range(name, getattr(instance, name), attrs.evolve(said, **bounds))


def _field(said: Declaration, convert: Any, default: Any) -> Any:
    converter, validator = attrs.Converter(convert, takes_field=True), _check
    if default is None:
        converter = attrs.converters.optional(converter)
        validator = attrs.validators.optional(validator)
    return attrs.field(
        default=default,
        converter=converter,
        validator=validator,
        metadata={"declaration": said},
    )


def read_number(name: str, value: Any, said: Declaration) -> float:
    """Return a value as a number that a declaration allows.

    Raises:
        ValueError: The value is not a number or out of range; the message contains `name`.
    """
    number = _read_float(name, value, said)
    _check_range(name, number, said)
    return number


def _read_float(name: str, value: Any, said: Declaration) -> float:
    try:
        if isinstance(value, bool) or (isinstance(value, str) and "_" in value):
            raise ValueError  # Python takes both as a number, and LIGGGHTS does not
        return float(value)
    except (TypeError, ValueError):
        raise ValueError(f"{name} is {value!r}, not a number [{said.unit}]") from None


def to_float(value: Any, field: attrs.Attribute) -> float:
    """Convert the value of a declared field."""
    return _read_float(field.name, value, field.metadata["declaration"])


def _to_int(value: Any, field: attrs.Attribute) -> int:
    try:
        number = None if isinstance(value, bool) else int(value)
    except (TypeError, ValueError, OverflowError):
        number = None
    if number is None or (not isinstance(value, str) and number != value):
        raise ValueError(f"{field.name} is {value!r}, not a whole number")
    return number


def _to_word(value: Any, field: attrs.Attribute) -> str:
    return str(value)


def _check(instance: Any, field: attrs.Attribute, value: Any) -> None:
    said: Declaration = field.metadata["declaration"]
    if said.choices:
        if value not in said.choices:
            raise ValueError(f"{field.name} is {value!r}; it {said.allowed()}")
    else:
        _check_range(field.name, value, said)


def _check_range(name: str, value: float, said: Declaration) -> None:
    if not said.allows(value):
        shown = value if isinstance(value, int) else f"{value:g}"
        raise ValueError(f"{name} is {shown}; it {said.allowed()}")
    if said.usual and not said.usual[0] <= value <= said.usual[1]:
        warnings.warn(
            f"{name} is {value:g} m, which is {1e3 * value:g} mm; radii are usually between "
            f"{said.usual[0]:g} and {said.usual[1]:g} m. Check the unit: radii are in m, not mm",
            SizeWarning,
            stacklevel=1,  # one place for all, so that a text is shown once
        )
