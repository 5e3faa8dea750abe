# SPDX-License-Identifier: GPL-2.0-or-later
"""Docs and decks have all constants of a body that `body.h` declares."""

from __future__ import annotations

import re
from math import isfinite, isinf

import pytest

from plastigran.engine.process import PROJECT
from plastigran.materials import BODY_CONSTANTS

INPUTS = PROJECT / "inputs"
#: Files of the decks that together give the properties of all bodies.
DECKS = {
    "new-deck": ("template/deck.in",),
    "collision": ("collision/parts/properties.in",),
    "rod": ("collision/rod.in",),
    "bulk": ("bulk/parts/contact_liggghts.in", "bulk/parts/yield.in"),
}


def property_name(constant: str) -> str:
    """Return the deck's name, such as `yieldStrength` for yield_strength."""
    return re.sub("_(.)", lambda letter: letter[1].upper(), constant)


def row(constant: dict) -> str:
    """Return a constant as a row of the table in docs/deck_syntax.md."""
    default = "required" if constant["default"] is None else f"{constant['default']:g}"
    least = f"{'above' if constant['above'] else 'from'} {constant['lower']:g}"
    most = "" if isinf(constant["upper"]) else f" to {constant['upper']:g}"
    default = default.replace("inf", "required by laws that yield")
    name, unit = property_name(constant["name"]), constant["unit"].replace("-", "–")
    return (
        f"| `{name}` | {constant['symbol']} | {unit} | {least}{most} | {default} "
        f"| {constant['meaning']} |".replace("-1", "−1")
    )


def test_the_page_of_properties_has_every_constant():
    page = (PROJECT / "docs" / "deck_syntax.md").read_text()
    rows = [row(constant) for constant in BODY_CONSTANTS.values()]
    assert "\n".join(rows) in page, "\n".join(rows)


@pytest.mark.parametrize("deck", DECKS)
def test_decks_give_every_constant(deck):
    text = "".join((INPUTS / file).read_text() for file in DECKS[deck])
    given = set(re.findall(r"property/global (\w+) peratomtype", text))
    assert {property_name(name) for name in BODY_CONSTANTS} <= given


def test_decks_have_the_declared_defaults():
    """The decks have the same default values of body constants as `body.h`.

    A deck uses a default if the material does not give the constant.
    """
    compared = set()
    for file in (file for file in INPUTS.rglob("*.in") if file.parent.name != "materials"):
        for name, value in re.findall(r"^variable (\w+) +index (\S+)", file.read_text(), re.M):
            default = BODY_CONSTANTS.get(name.removesuffix("_other"), {}).get("default")
            if default is not None and isfinite(default):
                assert float(value) == default, f"{name} in {file}"
                compared.add(name)
    assert {"tangent_modulus", "rate_coefficient", "reference_rate"} <= compared
