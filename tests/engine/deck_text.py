# SPDX-License-Identifier: GPL-2.0-or-later
"""Text of the decks that these tests write, and functions that run it."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastigran.engine.process import EngineStopped, run_deck


def head(
    box: str, skin: float, types: int = 1, units: str = "si", space: str = "boundary f f f"
) -> str:
    """Return the lines up to the neighbor skin.

    Args:
        box: Bounds of the box, as for `region block`.
        skin: Neighbor skin, in the unit of length of `units`.
        types: Number of atom types.
        units: Units of LIGGGHTS.
        space: Lines for boundaries, and other lines that must come before the box.
    """
    return f"""
variable output index .
variable inputs index inputs
units           {units}
atom_style      granular
{space}
newton          off
communicate     single vel yes
region          box block {box} units box
create_box      {types} box
neighbor        {skin} bin
"""


def material(youngs_modulus: object, yield_strength: object, friction: object = None) -> str:
    """Return the lines for the material of one atom type with Poisson's ratio 0.3.

    Young's modulus and yield strength are in Pa.
    """
    values = {"youngsModulus": youngs_modulus, "poissonsRatio": 0.3}
    values |= {"yieldStrength": yield_strength}
    text = "".join(
        f"fix {name} all property/global {name} peratomtype {value}\n"
        for name, value in values.items()
    )
    if friction is not None:
        text += f"fix friction all property/global coefficientFriction peratomtypepair 1 {friction}"
    return text


def run_text(folder: Path, text: str, ranks: int = 1, **variables: object) -> str:
    """Run a deck in a folder, which is created if missing, and return the log."""
    folder.mkdir(exist_ok=True)
    (folder / "deck.in").write_text(text)
    return run_deck(folder / "deck.in", variables, folder, ranks=ranks)


def error_of(folder: Path, text: str, ranks: int = 1) -> str:
    """Run a deck that LIGGGHTS stops with an error, and return the message."""
    with pytest.raises(EngineStopped) as stopped:
        run_text(folder, text, ranks)
    return str(stopped.value)
