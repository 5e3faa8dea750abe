# SPDX-License-Identifier: GPL-2.0-or-later
"""Makes the hoppers of inputs/bulk/hopper/shape.in, `hopper_N.stl` beside this file.

    python inputs/meshes/make_hopper.py            # those committed
    python inputs/meshes/make_hopper.py 5.5 6.5    # others

A barrel on a cone that ends in a round orifice at z = 0, along z, open at both ends. Lengths in
diameters of a grain: the deck scales them.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

import numpy as np
from stl import write

#: Diameters of the orifice, in N of `hopper_N.stl`.
ORIFICES = (5, 6, 7, 8)

_DECK = Path(__file__).parents[1] / "bulk" / "hopper" / "shape.in"
_SHAPE = dict(re.findall(r"^variable\s+(\w+)\s+equal\s+(\S+)", _DECK.read_text(), re.MULTILINE))
BARREL, HEIGHT = float(_SHAPE["barrel"]), float(_SHAPE["height"])
SLOPE = np.radians(float(_SHAPE["slope"]))
SEGMENTS = 36


def rings(orifice: float) -> np.ndarray:
    """Diameter and height of the circles the surface is spanned between: shape (n, 2).

    The engine takes neighbouring triangles for one smooth surface below an angle that must be less
    than any corner's, so none may be slender: rings of the cone grow with its radius.
    """
    top = (BARREL - orifice) / 2 * np.tan(SLOPE)
    cone = np.geomspace(orifice, BARREL, 1 + int(np.ceil(np.log(BARREL / orifice) / np.log(1.6))))
    barrel = np.linspace(top, HEIGHT, 5)[1:]
    heights = [*(cone - orifice) / 2 * np.tan(SLOPE), *barrel]
    return np.column_stack([[*cone, *np.full(len(barrel), BARREL)], heights])


def triangles(orifice: float) -> np.ndarray:
    """The surface: shape (n, 3 corners, 3). Its polygons have the areas of their circles."""
    angle = 2 * np.pi / SEGMENTS * np.arange(SEGMENTS + 1)
    radius = np.sqrt(2 * np.pi / SEGMENTS / np.sin(2 * np.pi / SEGMENTS)) / 2
    circle = radius * np.column_stack([np.cos(angle), np.sin(angle)])
    circle[-1] = circle[0]
    nodes = np.array(
        [np.column_stack([d * circle, np.full(len(circle), z)]) for d, z in rings(orifice)]
    )
    a, b, c, d = nodes[:-1, :-1], nodes[:-1, 1:], nodes[1:, 1:], nodes[1:, :-1]
    faces = np.stack([np.stack([a, b, c], axis=2), np.stack([a, c, d], axis=2)], axis=2)
    return faces.reshape(-1, 3, 3)


def check(orifice: str) -> float:
    """An orifice a hopper can have. Raises SystemExit for another."""
    widest = BARREL / 2.5
    try:
        size = float(orifice)
    except ValueError:
        size = np.nan
    if not 1.4 < size <= widest:
        raise SystemExit(f"orifice {orifice}: it must be a number above 1.4, at most {widest:g}")
    return size


if __name__ == "__main__":
    for orifice in sys.argv[1:] or ORIFICES:
        write(Path(__file__).with_name(f"hopper_{orifice}.stl"), triangles(check(orifice)))
