# SPDX-License-Identifier: GPL-2.0-or-later
"""Every bulk deck that has a class, and every short run it declares: found and never listed."""

from __future__ import annotations

import attrs
import pytest

from plastigran.bulk.deck import Brief, BulkDeck
from plastigran.bulk.decks import deck_class, deck_names
from plastigran.bulk.run import BulkRun
from plastigran.engine.deck import Settings, read_deck


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

    def settings(self, **changes: object) -> Settings:
        """Every setting of the run, as text."""
        return read_deck(self.name, {**self.brief.settings, **changes}, ".").settings


CASES = [
    Case(name, label, brief, deck_class(name))
    for name in deck_names()
    for label, brief in deck_class(name).briefs.items()
]


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """`case` runs a test for every short run, `field` for every declared setting of it."""
    if "field" in metafunc.fixturenames:
        pairs = [
            pytest.param(case, field, id=f"{case.name}-{case.label}-{field}")
            for case in CASES
            for field in attrs.fields_dict(case.kind)
            if field != "output"
        ]
        metafunc.parametrize(("case", "field"), pairs)
    elif "case" in metafunc.fixturenames:
        metafunc.parametrize("case", CASES, ids=[f"{c.name}-{c.label}" for c in CASES])


@pytest.fixture
def whole(case, brief_run) -> BulkRun:
    """The short run on one rank, with two frames on the way."""
    return brief_run(case.name, case.label)
