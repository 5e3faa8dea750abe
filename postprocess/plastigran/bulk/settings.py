# SPDX-License-Identifier: GPL-2.0-or-later
"""Declarations of attrs fields for settings of bulk decks."""

from __future__ import annotations

from typing import Any

import attrs

from plastigran.declared import Declaration


def text(meaning: str) -> Any:
    """Declare a field for a setting that is text; `meaning` describes the setting."""
    return attrs.field(
        converter=str, metadata={"declaration": Declaration(meaning, value_type=str)}
    )


def continuable(field: Any) -> Any:
    """Mark a declared field as a setting that a continued run may change.

    Such a setting must not affect the steps before the checkpoint or the grains that the checkpoint
    restores.
    """
    field.metadata = {**field.metadata, "continuable": True}
    return field
