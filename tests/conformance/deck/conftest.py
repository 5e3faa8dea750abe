# SPDX-License-Identifier: GPL-2.0-or-later
"""Parameters of the tests of bulk decks."""

from __future__ import annotations

import pytest
from deck_cases import CASES

from plastigran.bulk.outcome import BulkRun
from plastigran.declared import declarations


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Run a test that has the argument `case` for the short run of every deck.

    A test that also has `field` runs for every declared setting, except those that accept any text.
    """
    if "field" in metafunc.fixturenames:
        pairs = [
            pytest.param(case, field, id=f"{case.name}-{case.label}-{field}")
            for case in CASES
            for field, message in declarations(case.deck_type).items()
            if message.choices or message.value_type is not str
        ]
        metafunc.parametrize(("case", "field"), pairs)
    elif "case" in metafunc.fixturenames and metafunc.module.__name__ != "test_exercise_deck":
        metafunc.parametrize("case", CASES, ids=[f"{c.name}-{c.label}" for c in CASES])


@pytest.fixture
def whole(case, brief_run) -> BulkRun:
    """The short run of the deck of `case` on one MPI rank, with two frames."""
    return brief_run(case.name, case.label)
