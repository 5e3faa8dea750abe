# SPDX-License-Identifier: GPL-2.0-or-later
"""What cases declare of themselves: flags of a study, fields and checks several of them have."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import attrs
import numpy as np

from plastigran import laws
from plastigran.declared import Declaration
from plastigran.materials import Material
from plastigran.usable_laws import laws_for

#: Largest overlap a sphere's run is allowed, over the effective radius.
SPHERE_OVERLAP = 0.3


@attrs.frozen
class Flag:
    """A setting of an experiment's study, and the flag of its command.

    Attributes:
        default: Its value, or a tuple of values; "all" stands for every usable law.
        name: Of the flag, where it is not the setting's.
        said: What is declared of it, where it is not a field of the case.
        many: Whether it takes several values.
        span: From, to and how many: a range that it is swept over by default.
    """

    default: Any = None
    name: str = ""
    said: Declaration | None = None
    many: bool = True
    span: tuple[float, float, int] | None = None

    def values(self) -> Any:
        """The default, of a span its values, evenly apart in their logarithms."""
        return tuple(np.geomspace(*self.span)) if self.span else self.default


def several(value: Any) -> tuple:
    """One value, or an iterable of them, as a tuple."""
    if isinstance(value, str | Path | Material) or not np.iterable(value):
        return (value,)
    return tuple(value)


def law_field(default: Any = attrs.NOTHING) -> Any:
    """A field of a case for the name of a law, one that is for bodies of the case's `shape`."""

    def check(case: Any, field: attrs.Attribute, name: str) -> None:
        if name not in laws.LAWS:
            raise ValueError(f"no law {name!r}; there are {', '.join(sorted(laws.LAWS))}")
        if (meant := laws.LAWS[name].shape) != case.shape:
            raise ValueError(
                f"{name} is a law for {meant}s, not for {case.shape}s; "
                f"laws for them are {', '.join(laws_for(case.shape))}"
            )

    said = Declaration("a name that `plastigran laws` lists", kind=str)
    return attrs.field(default=default, validator=check, metadata={"declaration": said})


def options_field() -> Any:
    """A field of a case for options of its law, which `law_options` reads."""
    said = Declaration(
        "options, as 'yielding flat', for the given laws that have them; `plastigran laws LAW` "
        "lists a law's",
        kind=str,
    )
    return attrs.field(default=None, kw_only=True, metadata={"declaration": said})


def law_options(law: str, text: str | None) -> dict[str, str]:
    """The options of a law by name.

    Args:
        law: Its name.
        text: Names and choices in turn, as in decks; None for none.

    Raises:
        ValueError: The law has no such option, or not that choice of it.
    """
    words = (text or "").split()
    if len(words) % 2:
        raise ValueError(f"options is {text!r}; it must be names and choices in turn")
    chosen = dict(zip(words[::2], words[1::2], strict=True))
    choices = {option["name"]: option["choices"] for option in laws.LAWS[law].options()}
    for name, choice in chosen.items():
        if name not in choices:
            has = f"it has {', '.join(choices)}" if choices else "it has none"
            raise ValueError(f"{law} has no option {name!r}; {has}")
        if choice not in choices[name]:
            raise ValueError(f"{name} is {choice}; it must be {', '.join(choices[name])}")
    return chosen


def having_options(names: Iterable[str], text: str | None) -> list[str]:
    """Those of some laws that have each option of a text, and so take it.

    Args:
        names: Of the laws.
        text: As for `law_options`.

    Raises:
        ValueError: No law has them, or one that has an option not that choice of it.
    """
    named = [names] if isinstance(names, str) else list(names)
    asked = set((text or "").split()[::2])
    having = [name for name in named if asked <= {o["name"] for o in laws.LAWS[name].options()}]
    for name in having or named:
        law_options(name, text)
    return having


def check_overlap(case: Any, overlap: float, radius: float, limit: float, radii: str) -> None:
    """Refuse a case whose bodies would overlap too far for any law.

    Args:
        case: With `law` and `speed`.
        overlap: That is expected [m].
        radius: It is held against [m].
        limit: Of their ratio.
        radii: The radius in words, plural.

    Raises:
        ValueError: They would.
    """
    if overlap > limit * radius:
        raise ValueError(
            f"{case.law} at {case.speed:g} m/s would overlap by {overlap / radius:.2g} {radii}; "
            f"no contact law is good beyond {limit:g}"
        )
