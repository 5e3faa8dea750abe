# SPDX-License-Identifier: GPL-2.0-or-later
"""Fields that only bulk decks declare, and a check that some of them share."""

from __future__ import annotations

from typing import Any

import attrs

from plastigran.declared import Declaration, require

#: Rows of the log a steady part has at least: a line goes through them.
STEADY_ROWS = 10


def text(meaning: str) -> Any:
    """A field for a setting that is words."""
    return attrs.field(converter=str, metadata={"declaration": Declaration(meaning)})


def continuable(field: Any) -> Any:
    """The declared field, of a setting that a run that goes on may change.

    Steps before the checkpoint and the restored grains must not depend on it.
    """
    field.metadata = {**field.metadata, "continuable": True}
    return field


def check_settling(deck: Any) -> None:
    """The setting `duration` goes on after `settling` for ten rows of the log or more.

    Args:
        deck: With `duration`, `settling` and `rows`.

    Raises:
        ValueError: One is out of range, or fewer rows are left.
    """
    require(deck, "settling", upper=deck.duration)
    require(deck, "rows", lower=STEADY_ROWS)
    latest = deck.duration * (1 - STEADY_ROWS / deck.rows)
    if deck.settling > latest * (1 + 1e-12):
        unit = attrs.fields_dict(type(deck))["settling"].metadata["declaration"].unit
        raise ValueError(
            f"settling is {deck.settling:g}; it must be {latest:g} [{unit}] or less, so that "
            f"{STEADY_ROWS} of {deck.rows} rows are left"
        )
