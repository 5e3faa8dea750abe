# SPDX-License-Identifier: GPL-2.0-or-later
"""Writes square.stl: two triangles, |x| and |y| up to 1, at z = 0; scaled, a punch."""

from pathlib import Path

import numpy as np


def square() -> np.ndarray:
    """Corners of the two triangles, (2, 3, 3)."""
    a, b, c, d = np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)])
    return np.array([(a, b, c), (a, c, d)])


def stl(triangles: np.ndarray, name: str) -> str:
    """Triangles (n, 3, 3) as ASCII STL."""
    lines = [f"solid {name}"]
    for corners in triangles:
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        lines.append("  facet normal {:g} {:g} {:g}".format(*normal / np.linalg.norm(normal)))
        lines.append("    outer loop")
        lines += ["      vertex {:g} {:g} {:g}".format(*corner) for corner in corners]
        lines += ["    endloop", "  endfacet"]
    return "\n".join([*lines, f"endsolid {name}", ""])


if __name__ == "__main__":
    Path(__file__).with_name("square.stl").write_text(stl(square(), "square"))
