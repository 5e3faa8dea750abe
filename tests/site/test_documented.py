# SPDX-License-Identifier: GPL-2.0-or-later
"""Every public function, class, method and option says what it is."""

from __future__ import annotations

import argparse
import inspect
from collections.abc import Iterator
from importlib import import_module
from pkgutil import walk_packages

import plastigran
from plastigran import laws
from plastigran.cli import parser


def modules() -> list[str]:
    """Every module but the commands, whose two functions `plastigran.cli` describes."""
    found = [module.name for module in walk_packages(plastigran.__path__, "plastigran.")]
    return [name for name in found if ".commands." not in name and "__main__" not in name]


def public(module: object) -> Iterator[tuple[str, object]]:
    """The functions, classes, methods and properties that a module defines, without `_`."""
    for name, found in vars(module).items():
        own = getattr(found, "__module__", None) == module.__name__
        if name.startswith("_") or not own:
            continue
        if inspect.isfunction(found) or inspect.isclass(found):
            yield f"{module.__name__}.{name}", found
        if inspect.isclass(found):
            for part, value in vars(found).items():
                value = value.fget if isinstance(value, property) else value
                if not part.startswith("_") and inspect.isroutine(value):
                    yield f"{module.__name__}.{name}.{part}", getattr(found, part)


def test_everything_public_has_a_docstring():
    """Its own, or that of the method it overrides."""
    found = [item for name in modules() for item in public(import_module(name))]
    assert len(found) > 500
    assert not [name for name, what in found if not inspect.getdoc(what)]


def test_the_laws_have_docstrings():
    found = [(name, what) for name, what in vars(laws).items() if not name.startswith("_")]
    found = [(name, what) for name, what in found if callable(what)]
    assert len(found) > len(laws.LAWS)
    assert not [name for name, what in found if not inspect.getdoc(what)]


def test_every_option_of_the_command_line_has_a_help():
    def actions(command: argparse.ArgumentParser) -> Iterator[tuple[str, argparse.Action]]:
        for action in command._actions:
            yield command.prog, action
            if isinstance(action, argparse._SubParsersAction):
                for inner in action.choices.values():
                    yield from actions(inner)

    found = list(actions(parser()))
    assert len(found) > 100
    bare = [
        f"{prog} {'/'.join(action.option_strings) or action.dest}"
        for prog, action in found
        if not action.help and not isinstance(action, argparse._SubParsersAction)
    ]
    assert not bare
