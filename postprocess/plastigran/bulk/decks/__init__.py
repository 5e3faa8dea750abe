# SPDX-License-Identifier: GPL-2.0-or-later
"""Bulk decks with checks and figures: one module or package per deck, with the name of the deck.

Each module defines one subclass of `plastigran.bulk.deck.BulkDeck`. In a package, the class is in
`__init__.py`, its measurements in `measurement.py` (if they are not in `plastigran.physics`), and
its figure in `figure.py`.
"""

from __future__ import annotations

from importlib import import_module
from pkgutil import iter_modules

from plastigran.bulk.deck import BulkDeck


def deck_names() -> list[str]:
    """Return the names of the decks that have a class."""
    return sorted(module.name for module in iter_modules(__path__))


def deck_class(name: str) -> type[BulkDeck] | None:
    """Return the class of a deck, or None if the deck has no class (then it runs without checks).

    Raises:
        TypeError: The module does not define exactly one class.
    """
    if name not in deck_names():
        return None
    module = import_module(f"{__name__}.{name}")
    classes = [
        value
        for value in vars(module).values()
        if isinstance(value, type)
        and issubclass(value, BulkDeck)
        and value.__module__ == module.__name__
    ]
    if len(classes) != 1:
        raise TypeError(
            f"{module.__name__} defines {len(classes)} subclasses of BulkDeck; it "
            "must define exactly one"
        )
    return classes[0]
