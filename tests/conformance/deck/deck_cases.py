# SPDX-License-Identifier: GPL-2.0-or-later
"""Every short run that a bulk deck declares: found and never listed."""

from __future__ import annotations

import attrs

from plastigran.bulk.deck import Brief, BulkDeck
from plastigran.bulk.decks import deck_class, deck_names
from plastigran.engine.deck import read_deck


@attrs.frozen
class Case:
    """A short run of a deck.

    Attributes:
        name: Of the deck.
        label: Of the short run.
        brief: The run.
        kind: The deck's class.
    """

    name: str
    label: str
    brief: Brief
    kind: type[BulkDeck]

    def settings(self, **changes: object) -> dict[str, str]:
        """Every setting of the run, as text."""
        return read_deck(self.name, {**self.brief.settings, **changes}, ".").settings


CASES = [
    Case(name, label, brief, deck_class(name))
    for name in deck_names()
    for label, brief in deck_class(name).briefs.items()
]
