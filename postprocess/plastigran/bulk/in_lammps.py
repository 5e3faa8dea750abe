# SPDX-License-Identifier: GPL-2.0-or-later
"""Bulk decks that LAMMPS can run, and the settings that it supports."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from plastigran.engine.deck import index_variables

#: Values that LAMMPS supports, by name of the setting. For other settings, it supports all values.
SUPPORTED = {
    "tangential": ("off", "history", "partial_slip", "incremental"),
    "rolling_friction": ("off",),
    "contact_history": ("0",),
}


def takes_host(script: Path) -> bool:
    """Return whether a deck of `inputs/bulk` can run in LAMMPS, that is, has the setting `host`."""
    return "host" in index_variables(script)


def refuse_settings(settings: Mapping[str, str]) -> None:
    """Reject settings that only LIGGGHTS supports.

    Raises:
        ValueError: A setting is not supported; the message names it.
    """
    for name, values in SUPPORTED.items():
        if settings.get(name, values[0]) not in values:
            raise ValueError(
                f"{name} is {settings[name]}; in LAMMPS, it must be {' or '.join(values)}"
            )
