# SPDX-License-Identifier: GPL-2.0-or-later
"""Fields and checks that cases of several experiments have."""

from __future__ import annotations

from typing import Any

import attrs

from plastigran import laws
from plastigran.declared import Declaration
from plastigran.materials import laws_for


def law_field(shape: str, default: Any = attrs.NOTHING) -> Any:
    """A field of a case for the name of a law that is for bodies of a shape."""

    def check(_: Any, field: attrs.Attribute, name: str) -> None:
        if name not in laws.LAWS:
            raise ValueError(f"no law {name!r}; there are {', '.join(sorted(laws.LAWS))}")
        if (meant := laws.LAWS[name].shape) != shape:
            raise ValueError(
                f"{name} is a law for {meant}s, not for {shape}s; "
                f"laws for them are {', '.join(laws_for(shape))}"
            )

    said = Declaration("name of the law", kind=str)
    return attrs.field(default=default, validator=check, metadata={"declaration": said})


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
