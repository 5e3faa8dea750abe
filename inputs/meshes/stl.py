# SPDX-License-Identifier: GPL-2.0-or-later
"""Write triangles as ASCII STL, for the scripts in this folder that make meshes."""

from __future__ import annotations

from pathlib import Path

import numpy as np


def write(path: Path, triangles: np.ndarray, digits: int = 9) -> None:
    """Write triangles as a solid with the name of the file.

    Args:
        path: File to write.
        triangles: Corners, shape (n, 3, 3), in counterclockwise order for a viewer toward whom the
            normal points.
        digits: Decimal places of the corners.
    """
    lines = [f"solid {path.stem}"]
    for corners in triangles:
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        lines += [f"  facet normal {_numbers(normal / np.linalg.norm(normal))}", "    outer loop"]
        lines += [f"      vertex {_numbers(corner, digits)}" for corner in corners]
        lines += ["    endloop", "  endfacet"]
    path.write_text("\n".join([*lines, f"endsolid {path.stem}", ""]))


def _numbers(vector: np.ndarray, digits: int = 9) -> str:
    # Add 0.0, which changes -0 to 0.
    return " ".join(f"{value:.7g}" for value in np.round(vector, digits) + 0.0)
