# SPDX-License-Identifier: GPL-2.0-or-later
"""Make the hopper meshes `hopper_N.stl` with the shape in inputs/bulk/hopper/shape.in.

    python inputs/meshes/make_hopper.py            # the meshes of the repository
    python inputs/meshes/make_hopper.py 5.5 6.5    # other orifices

The hopper is a barrel on a cone along z, which ends in a round orifice at z = 0. The hopper is open
at both ends. Lengths are in grain diameters; the deck scales them.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

import numpy as np
from stl import write

#: Orifice diameters N of the meshes `hopper_N.stl`, in grain diameters.
ORIFICES = (5, 6, 7, 8)

_DECK = Path(__file__).parents[1] / "bulk" / "hopper" / "shape.in"
_SHAPE = dict(re.findall(r"^variable\s+(\w+)\s+equal\s+(\S+)", _DECK.read_text(), re.MULTILINE))
BARREL, HEIGHT = float(_SHAPE["barrel"]), float(_SHAPE["height"])
SLOPE = np.radians(float(_SHAPE["slope"]))
SEGMENTS = 36


def rings(orifice: float, barrel: float, height: float, slope: float) -> np.ndarray:
    """Return diameters and heights (n, 2) of the circles between which the triangles lie.

    LIGGGHTS joins neighboring triangles to one smooth surface if their angle is below a limit. This
    limit must be smaller than all corner angles of the triangles. To avoid slender triangles, the
    height of the rings grows with the radius of the cone.
    """
    top = (barrel - orifice) / 2 * np.tan(slope)
    cone = np.geomspace(orifice, barrel, 1 + int(np.ceil(np.log(barrel / orifice) / np.log(1.6))))
    upright = np.linspace(top, height, 5)[1:]
    heights = [*(cone - orifice) / 2 * np.tan(slope), *upright]
    return np.column_stack([[*cone, *np.full(len(upright), barrel)], heights])


def triangles(
    orifice: float, barrel: float = BARREL, height: float = HEIGHT, slope: float = SLOPE
) -> np.ndarray:
    """Return the corners (n, 3, 3) of the triangles of the surface.

    Each horizontal section is a polygon with the area of the circle that it replaces.

    Args:
        orifice, barrel: Diameters of orifice and barrel.
        height: Height of the top above the orifice.
        slope: Angle of the cone from the horizontal [rad].
    """
    angle = 2 * np.pi / SEGMENTS * np.arange(SEGMENTS + 1)
    radius = np.sqrt(2 * np.pi / SEGMENTS / np.sin(2 * np.pi / SEGMENTS)) / 2
    circle = radius * np.column_stack([np.cos(angle), np.sin(angle)])
    circle[-1] = circle[0]
    nodes = np.array(
        [
            np.column_stack([d * circle, np.full(len(circle), z)])
            for d, z in rings(orifice, barrel, height, slope)
        ]
    )
    a, b, c, d = nodes[:-1, :-1], nodes[:-1, 1:], nodes[1:, 1:], nodes[1:, :-1]
    faces = np.stack([np.stack([a, b, c], axis=2), np.stack([a, c, d], axis=2)], axis=2)
    return faces.reshape(-1, 3, 3)


def check(orifice: str) -> float:
    """Return a valid orifice diameter as a number; raise SystemExit for an invalid one."""
    widest = BARREL / 2.5
    try:
        size = float(orifice)
    except ValueError:
        size = np.nan
    if not 1.4 < size <= widest:
        raise SystemExit(
            f"orifice is {orifice}; it must be a number above 1.4 and at most {widest:g}, in "
            "grain diameters"
        )
    return size


if __name__ == "__main__":
    for orifice in sys.argv[1:] or ORIFICES:
        write(Path(__file__).with_name(f"hopper_{orifice}.stl"), triangles(check(orifice)))
