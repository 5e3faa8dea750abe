# SPDX-License-Identifier: GPL-2.0-or-later
"""Mark the tests that start LIGGGHTS, according to the functions that they, their fixtures and
their helpers call. `pytest -m "not engine"` runs the other tests without LIGGGHTS, so a test
without this marker fails in that run if it starts LIGGGHTS.
"""

from __future__ import annotations

from collections.abc import Iterator
from inspect import unwrap
from pathlib import Path
from types import CodeType, FunctionType

import pytest

#: Functions and methods of the package and of `subprocess` that start LIGGGHTS.
STARTERS = {
    "Popen",
    "bulk",
    "collide",
    "exec",
    "execute",
    "main",
    "run",
    "run_bulk",
    "run_deck",
    "run_lammps",
    "study",
    "sweep",
    "trajectory",
}
TESTS = Path(__file__).parent


def mark(items: list[pytest.Item]) -> None:
    """Give every test that starts LIGGGHTS the marker `engine`."""
    for item in items:
        if isinstance(item, pytest.Function) and any(map(_starts, _functions(item))):
            item.add_marker("engine")


def _functions(item: pytest.Function) -> Iterator[FunctionType]:
    """Yield the test, its fixtures, and the functions of the test files that they call."""
    fixtures = item._fixtureinfo.name2fixturedefs.values()
    waiting = [item.function, *(fixture.func for found in fixtures for fixture in found)]
    seen = set()
    while waiting:
        function = waiting.pop()
        inner = getattr(function, "hypothesis", None)  # the test inside @given
        function = unwrap(inner.inner_test if inner else function)  # the function inside a cache
        if not isinstance(function, FunctionType) or function in seen:
            continue
        if not Path(function.__code__.co_filename).is_relative_to(TESTS):
            continue
        seen.add(function)
        yield function
        waiting += [function.__globals__.get(name) for name in _names(function.__code__)]


def _starts(function: FunctionType) -> bool:
    return not STARTERS.isdisjoint(_names(function.__code__))


def _names(code: CodeType) -> set[str]:
    """Return the global names and attributes that a function and its inner functions use."""
    inside = (constant for constant in code.co_consts if isinstance(constant, CodeType))
    return set(code.co_names).union(*map(_names, inside))
