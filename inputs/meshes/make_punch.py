# SPDX-License-Identifier: GPL-2.0-or-later
"""Writes punch.stl: one triangle at z = 0 around the circle of radius 1, a punch once scaled."""

from pathlib import Path

import numpy as np
from stl import write


def triangle() -> np.ndarray:
    """Corners of an equilateral triangle whose sides touch the unit circle, (3, 3)."""
    angles = np.radians([90, 210, 330])
    return np.column_stack([2 * np.cos(angles), 2 * np.sin(angles), np.zeros(3)])


if __name__ == "__main__":
    write(Path(__file__).with_name("punch.stl"), triangle()[None])
