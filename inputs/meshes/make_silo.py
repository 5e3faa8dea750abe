# SPDX-License-Identifier: GPL-2.0-or-later
"""Make silo_large.stl and silo_small.stl, the silos of the benchmark of Dosta et al. 2024.

A silo is a barrel on a cone of 45 degrees, which ends in a round orifice at z = 0. Lengths are in
m.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from make_hopper import triangles
from stl import write

#: Diameter of the orifice [m] by name.
ORIFICES = {"large": 0.06, "small": 0.04}
#: Diameter of the barrel, and height of its top above the orifice [m].
BARREL, HEIGHT = 0.2, 0.3


if __name__ == "__main__":
    for name, orifice in ORIFICES.items():
        surface = triangles(orifice, BARREL, HEIGHT, np.radians(45))
        write(Path(__file__).with_name(f"silo_{name}.stl"), surface)
