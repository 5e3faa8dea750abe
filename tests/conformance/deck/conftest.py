# SPDX-License-Identifier: GPL-2.0-or-later
"""What the suite of bulk decks runs over."""

from __future__ import annotations

import pytest
from deck_cases import CASES

from plastigran.bulk.outcome import BulkRun
from plastigran.declared import declarations


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """`case` runs a test for every short run, with `field` for every declared setting of it
    that not every text is a value of."""
    if "field" in metafunc.fixturenames:
        pairs = [
            pytest.param(case, field, id=f"{case.name}-{case.label}-{field}")
            for case in CASES
            for field, message in declarations(case.kind).items()
            if message.choices or message.value_type is not str
        ]
        metafunc.parametrize(("case", "field"), pairs)
    elif "case" in metafunc.fixturenames and metafunc.module.__name__ != "test_exercise_deck":
        metafunc.parametrize("case", CASES, ids=[f"{c.name}-{c.label}" for c in CASES])


@pytest.fixture
def whole(case, brief_run) -> BulkRun:
    """The short run on one rank, with two frames on the way."""
    return brief_run(case.name, case.label)
