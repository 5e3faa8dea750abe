# SPDX-License-Identifier: GPL-2.0-or-later
"""Read the frames of a dump as arrays. A scene has hundreds of frames with a few particles each."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

#: Columns of the dumps of a scene, in order.
COLUMNS = "id type radius mass x y z vx vy vz fx fy fz"


@dataclass(frozen=True)
class Frame:
    """Particles at a step, in SI units.

    Attributes:
        step: Time step number.
        ids, types: IDs and types of the particles (n,).
        radius, mass: Radii [m] and masses [kg] (n,).
        place, velocity, force: Positions [m], velocities [m/s] and forces [N] (n, 3).
    """

    step: int
    ids: np.ndarray
    types: np.ndarray
    radius: np.ndarray
    mass: np.ndarray
    place: np.ndarray
    velocity: np.ndarray
    force: np.ndarray

    @property
    def kinetic_energy(self) -> float:
        """Translational kinetic energy [J]; the particles do not rotate."""
        return 0.5 * float(self.mass @ (self.velocity**2).sum(axis=1))


def read(path: Path) -> Iterator[Frame]:
    """Yield the frames of a complete dump of COLUMNS; a frame may have no particles."""
    for text in path.read_text().split("ITEM: TIMESTEP\n")[1:]:
        head, rows = text.split(f"ITEM: ATOMS {COLUMNS}")
        values = np.array(rows.split(), float).reshape(-1, len(COLUMNS.split()))
        yield Frame(
            int(head.split(maxsplit=1)[0]),
            values[:, 0].astype(int),
            values[:, 1].astype(int),
            values[:, 2],
            values[:, 3],
            *(values[:, k : k + 3] for k in (4, 7, 10)),
        )
