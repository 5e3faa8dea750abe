# SPDX-License-Identifier: GPL-2.0-or-later
"""Short runs that the bulk decks declare."""

from __future__ import annotations

import attrs

from plastigran.bulk.deck import Brief, BulkDeck
from plastigran.bulk.decks import deck_class, deck_names
from plastigran.engine.deck import read_deck


@attrs.frozen
class Case:
    """A short run of a deck.

    Attributes:
        name: Name of the deck.
        label: Label of the short run.
        brief: Short run.
        deck_type: Class of the deck.
    """

    name: str
    label: str
    brief: Brief
    deck_type: type[BulkDeck]

    def settings(self, **changes: object) -> dict[str, str]:
        """Return all settings of the run, as text."""
        return read_deck(self.name, {**self.brief.settings, **changes}, ".").settings


CASES = [
    Case(name, label, brief, deck_class(name))
    for name in deck_names()
    for label, brief in deck_class(name).briefs.items()
]
