# SPDX-License-Identifier: GPL-2.0-or-later
"""Writes punch.stl: one triangle at z = 0 around the circle of radius 1, a punch once scaled."""

from pathlib import Path

import numpy as np


def triangle() -> np.ndarray:
    """Corners of an equilateral triangle whose sides touch the unit circle, (3, 3)."""
    angles = np.radians([90, 210, 330])
    return np.column_stack([2 * np.cos(angles), 2 * np.sin(angles), np.zeros(3)])


def stl(triangles: list[np.ndarray], name: str) -> str:
    """Triangles, each (3, 3), as ASCII STL."""
    lines = [f"solid {name}"]
    for corners in triangles:
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        lines.append("  facet normal " + _numbers(normal / np.linalg.norm(normal)))
        lines.append("    outer loop")
        lines += ["      vertex " + _numbers(corner) for corner in corners]
        lines += ["    endloop", "  endfacet"]
    return "\n".join([*lines, f"endsolid {name}", ""])


def _numbers(vector: np.ndarray) -> str:
    return " ".join(f"{value:.6g}" for value in np.round(vector, 9) + 0.0)


if __name__ == "__main__":
    Path(__file__).with_name("punch.stl").write_text(stl([triangle()], "punch"))
