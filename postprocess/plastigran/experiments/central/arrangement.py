# SPDX-License-Identifier: GPL-2.0-or-later
"""What hits what in a central impact, in words."""

from __future__ import annotations

from plastigran.plot.style import title

#: Words for what a sphere hits that is no wall of a metal: a wall without yield, another sphere.
WALLS = ("rigid", "none")


def on_wall(wall: str) -> str:
    """ "on" and the wall, as a sentence has it; nothing where there is none.

    Args:
        wall: The name of its metal, or a word of `WALLS`.
    """
    said = {"none": "", "rigid": "on a rigid wall"}
    return said.get(wall, f"on {title(wall)}")


def run_label(
    geometry: str, material: str, law: str, wall: str = "rigid", options: str = "default"
) -> str:
    """Name of an impact's folder, behind its number, from what its row in the table says."""
    said = [geometry, material, law]
    said += [] if wall in WALLS else ["on", wall]
    said += [] if options == "default" else options.split()
    return "_".join(said)
