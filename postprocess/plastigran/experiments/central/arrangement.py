# SPDX-License-Identifier: GPL-2.0-or-later
"""What hits what in a central impact, in words."""

from __future__ import annotations

from plastigran.materials import NO_WALL, RIGID_WALL, USUAL
from plastigran.plot.style import title

#: Words for what a sphere hits that is no wall of a metal: a wall without yield, another sphere.
WALLS = (RIGID_WALL, NO_WALL)


def on_wall(wall: str) -> str:
    """The word "on" and the wall, as a sentence has it; nothing where there is none.

    Args:
        wall: The name of its metal, or a word of `WALLS`.
    """
    said = {NO_WALL: "", RIGID_WALL: "on a rigid wall"}
    return said.get(wall, f"on {title(wall)}")


def run_label(
    geometry: str, material: str, law: str, wall: str = RIGID_WALL, options: str = USUAL
) -> str:
    """Name of an impact's folder, behind its number, from what its row in the table says."""
    said = [geometry, material, law]
    said += [] if wall in WALLS else ["on", wall]
    said += [] if options == USUAL else options.split()
    return "_".join(said)
