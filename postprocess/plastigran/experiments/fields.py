# SPDX-License-Identifier: GPL-2.0-or-later
"""Fields, flags and checks that several experiments share."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import attrs
import numpy as np

from plastigran import laws
from plastigran.declared import Declaration
from plastigran.materials import Material, law_class
from plastigran.usable_laws import laws_for

#: Largest overlap / effective radius allowed for spheres.
SPHERE_OVERLAP = 0.3


@attrs.frozen
class Flag:
    """Setting of an experiment, which is also a flag of its `plastigran` command.

    Attributes:
        default: Default value, or tuple of values; "all" means every usable law.
        name: Name of the flag, if it differs from the name of the setting.
        declaration: Unit, bounds and meaning, if the setting is not a field of the experiment.
        many: Whether the setting takes several values.
        span: Lowest value, highest value and number of values of the default sweep.
    """

    default: Any = None
    name: str = ""
    declaration: Declaration | None = None
    many: bool = True
    span: tuple[float, float, int] | None = None

    def values(self) -> Any:
        """Return the default values; those of a sweep are logarithmically spaced."""
        return tuple(np.geomspace(*self.span)) if self.span else self.default


def several(value: Any) -> tuple:
    """Convert one value, or an iterable of values, to a tuple."""
    if isinstance(value, str | Path | Material) or not np.iterable(value):
        return (value,)
    return tuple(value)


def law_field(default: Any = attrs.NOTHING) -> Any:
    """Declare a field for the name of a law; the law must support the shape of the bodies."""

    def check(case: Any, field: attrs.Attribute, name: str) -> None:
        if (shape := law_class(name).shape) != case.shape:
            raise ValueError(
                f"{name} is a law for {shape}s, not for {case.shape}s. Choose one of "
                f"{', '.join(laws_for(case.shape))}"
            )

    declaration = Declaration("name of a law that `plastigran laws` lists", value_type=str)
    return attrs.field(default=default, validator=check, metadata={"declaration": declaration})


def options_field() -> Any:
    """Declare a field for options of a law, which `law_options` reads."""
    declaration = Declaration(
        "options such as 'yielding flat', used for the laws that have them; see `plastigran "
        "laws LAW`",
        value_type=str,
    )
    return attrs.field(default=None, kw_only=True, metadata={"declaration": declaration})


def law_options(law: str, text: str | None) -> dict[str, str]:
    """Return the options of a law by name.

    Args:
        law: Name of the law.
        text: Pairs NAME CHOICE, as in decks; None for no options.

    Raises:
        ValueError: The law does not have the option or the choice.
    """
    words = (text or "").split()
    if len(words) % 2:
        raise ValueError(
            f"options is {text!r}; it must be made of pairs NAME CHOICE, such as 'yielding flat'"
        )
    chosen = dict(zip(words[::2], words[1::2], strict=True))
    choices = {option["name"]: option["choices"] for option in laws.LAWS[law].options()}
    for name, choice in chosen.items():
        if name not in choices:
            if name == "adhesion":  # only the pair_style line of a deck has this option
                raise ValueError(
                    "the option adhesion is only for decks. Use --surface-energy instead"
                )
            raise ValueError(
                f"{law} has no option {name!r}. Available options: {', '.join(choices) or 'none'}"
            )
        if choice not in choices[name]:
            raise ValueError(f"{name} is {choice}; it must be one of {', '.join(choices[name])}")
    return chosen


def having_options(names: Iterable[str], text: str | None) -> list[str]:
    """Return the names of the laws that have all given options.

    Args:
        names: Names of laws.
        text: Options, as for `law_options`.

    Raises:
        ValueError: No law has all options, or a law has an option but not the given choice.
    """
    names, options = list(names), set((text or "").split()[::2])
    having = [name for name in names if options <= {o["name"] for o in laws.LAWS[name].options()}]
    for name in having or names:
        law_options(name, text)
    return having


def check_overlap(case: Any, overlap: float, radius: float, limit: float, radii: str) -> None:
    """Reject an impact whose overlap would be too large for any law.

    Args:
        case: Impact with the attributes `law` and `speed`.
        overlap: Expected overlap [m].
        radius: Reference radius [m].
        limit: Largest allowed ratio of the overlap to the radius.
        radii: Plural noun for the reference radius in the message, such as "tip radii".

    Raises:
        ValueError: The overlap is too large.
    """
    if overlap > limit * radius:
        raise ValueError(
            f"with law {case.law} at {case.speed:g} m/s, the bodies would overlap by "
            f"{overlap / radius:.2g} {radii}; no contact law is valid beyond {limit:g}. Lower the "
            "speed, or use a harder material"
        )
