# SPDX-License-Identifier: GPL-2.0-or-later
"""A deck consists only of its files: a new deck passes all tests without registration."""

from __future__ import annotations

import inspect
import shutil
import sys
from pathlib import Path

import pytest
import test_deck_runs
import test_deck_settings
from deck_cases import Case

from plastigran.bulk import decks
from plastigran.engine.process import inputs_folder

EXERCISE = Path(__file__).parent / "exercise"
TESTS = [
    test
    for module in (test_deck_runs, test_deck_settings)
    for name, test in vars(module).items()
    if name.startswith("test_") and set(inspect.signature(test).parameters) <= {"case", "whole"}
]
TESTS += [
    test_deck_runs.test_restart_continues,
    test_deck_runs.test_ranks_agree_on_the_first_impacts,
]
TESTS += [test_deck_runs.test_another_law_runs]


@pytest.fixture(scope="module")
def exercise_deck(tmp_path_factory):
    """Add the exercise to the package of decks and to a copy of the input scripts."""
    inputs = tmp_path_factory.mktemp("exercise") / "inputs"
    shutil.copytree(inputs_folder(), inputs)
    shutil.copytree(EXERCISE / "inputs", inputs, dirs_exist_ok=True)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PLASTIGRAN_INPUTS", str(inputs))
        patch.setattr(decks, "__path__", [*decks.__path__, str(EXERCISE / "decks")])
        yield
    del sys.modules[f"{decks.__name__}.falling"]


@pytest.fixture
def case(exercise_deck) -> Case:
    deck_type = decks.deck_class("falling")
    return Case("falling", "", deck_type.briefs[""], deck_type)


def test_its_fall_is_free_until_the_floor(whole):
    assert whole.passed and "fallen" in whole.series
    assert whole.series["plastic"].iloc[-1] > 0


@pytest.mark.parametrize("test", TESTS, ids=lambda test: test.__name__.removeprefix("test_"))
def test_suite(test, case, whole, tmp_path):
    given = {"case": case, "whole": whole, "tmp_path": tmp_path}
    test(**{name: given[name] for name in inspect.signature(test).parameters})
