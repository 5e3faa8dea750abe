# SPDX-License-Identifier: GPL-2.0-or-later
"""Phrases and folder names that describe the bodies of a central impact."""

from __future__ import annotations

from plastigran.materials import NO_WALL, RIGID_WALL, USUAL
from plastigran.plot.style import title

#: Words that can stand for a material in the column `wall` of the results table: rigid wall, no
#: wall.
WALLS = (RIGID_WALL, NO_WALL)


def on_wall(wall: str) -> str:
    """Return a phrase for the wall, such as "on a rigid wall"; "" without a wall.

    Args:
        wall: Name of the material of the wall, or one of the words in `WALLS`.
    """
    phrases = {NO_WALL: "", RIGID_WALL: "on a rigid wall"}
    return phrases.get(wall, f"on {title(wall)}")


def run_label(
    geometry: str, material: str, law: str, wall: str = RIGID_WALL, options: str = USUAL
) -> str:
    """Return the text that follows the number in the folder name of an impact."""
    words = [geometry, material, law]
    words += [] if wall in WALLS else ["on", wall]
    words += [] if options == USUAL else options.split()
    return "_".join(words)
