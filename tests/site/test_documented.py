# SPDX-License-Identifier: GPL-2.0-or-later
"""Every public function, class, method and option has a description."""

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
    """Return the names of all modules except commands, which `plastigran.cli` describes."""
    names = [module.name for module in walk_packages(plastigran.__path__, "plastigran.")]
    return [name for name in names if ".commands." not in name and "__main__" not in name]


def public(module: object) -> Iterator[tuple[str, object]]:
    """Yield the public functions, classes, methods and properties that a module defines."""
    for name, member in vars(module).items():
        defined_here = getattr(member, "__module__", None) == module.__name__
        if name.startswith("_") or not defined_here:
            continue
        if inspect.isfunction(member) or inspect.isclass(member):
            yield f"{module.__name__}.{name}", member
        if inspect.isclass(member):
            for part, value in vars(member).items():
                value = value.fget if isinstance(value, property) else value
                if not part.startswith("_") and inspect.isroutine(value):
                    yield f"{module.__name__}.{name}.{part}", getattr(member, part)


def test_every_public_name_has_a_docstring():
    """Every public name has a docstring; an overriding method may inherit it."""
    members = [member for name in modules() for member in public(import_module(name))]
    assert len(members) > 500
    assert not [name for name, member in members if not inspect.getdoc(member)]


def test_the_laws_have_docstrings():
    members = {n: m for n, m in vars(laws).items() if not n.startswith("_") and callable(m)}
    assert len(members) > len(laws.LAWS)
    assert not [name for name, member in members.items() if not inspect.getdoc(member)]


def test_every_option_of_the_command_line_has_a_help():
    def actions(command: argparse.ArgumentParser) -> Iterator[tuple[str, argparse.Action]]:
        for action in command._actions:
            yield command.prog, action
            if isinstance(action, argparse._SubParsersAction):
                for inner in action.choices.values():
                    yield from actions(inner)

    options = list(actions(parser()))
    assert len(options) > 100
    undescribed = [
        f"{prog} {'/'.join(action.option_strings) or action.dest}"
        for prog, action in options
        if not action.help and not isinstance(action, argparse._SubParsersAction)
    ]
    assert not undescribed
