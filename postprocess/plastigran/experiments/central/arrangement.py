# SPDX-License-Identifier: GPL-2.0-or-later
"""Bodies of a central impact, in words."""

from __future__ import annotations

from plastigran.materials import NO_WALL, RIGID_WALL, USUAL
from plastigran.plot.style import title

#: Words for a counterpart that is not a metal wall: a wall without yield, another sphere.
WALLS = (RIGID_WALL, NO_WALL)


def on_wall(wall: str) -> str:
    """Return "on" and the wall for a sentence; "" without a wall.

    Args:
        wall: Name of its metal, or a word of `WALLS`.
    """
    said = {NO_WALL: "", RIGID_WALL: "on a rigid wall"}
    return said.get(wall, f"on {title(wall)}")


def run_label(
    geometry: str, material: str, law: str, wall: str = RIGID_WALL, options: str = USUAL
) -> str:
    """Return the name of an impact's folder, after its number, from its row in the table."""
    said = [geometry, material, law]
    said += [] if wall in WALLS else ["on", wall]
    said += [] if options == USUAL else options.split()
    return "_".join(said)
