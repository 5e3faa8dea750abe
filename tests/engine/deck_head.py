# SPDX-License-Identifier: GPL-2.0-or-later
"""How the decks that these tests write begin."""

from __future__ import annotations


def head(
    box: str, skin: float, types: int = 1, units: str = "si", space: str = "boundary f f f"
) -> str:
    """Lines up to the settings of neighbours.

    Args:
        box: Bounds of the box, as of `region block`.
        skin: Of the neighbour list [length].
        types: Atom types.
        units: The engine's name for them.
        space: Lines that say boundaries, and what else comes before the box.
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
