# SPDX-License-Identifier: GPL-2.0-or-later
"""Write punch.stl: a triangle at z = 0 around the unit circle, which decks scale to a punch."""

from pathlib import Path

import numpy as np
from stl import write


def triangle() -> np.ndarray:
    """Return the corners (3, 3) of an equilateral triangle whose sides touch the unit circle."""
    angles = np.radians([90, 210, 330])
    return np.column_stack([2 * np.cos(angles), 2 * np.sin(angles), np.zeros(3)])


if __name__ == "__main__":
    write(Path(__file__).with_name("punch.stl"), triangle()[None])
