# SPDX-License-Identifier: GPL-2.0-or-later
"""The frames of a dump as arrays: a scene has hundreds, with a few particles each."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np

from plastigran.engine.dumps import read_dump

#: What a scene's dumps hold.
COLUMNS = "id type radius mass x y z vx vy vz fx fy fz"


@dataclass(frozen=True)
class Frame:
    """Particles at a step, in SI units.

    Attributes:
        step: Time step.
        ids, types: Of each particle.
        radius, mass: Of each particle [m, kg].
        place, velocity, force: Of each particle along each axis [m, m/s, N].
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
        """Without rotation, which these scenes have none of [J]."""
        return 0.5 * float(self.mass @ (self.velocity**2).sum(axis=1))


def read(path: Path) -> Iterator[Frame]:
    """The frames of a dump of COLUMNS.

    Raises:
        plastigran.engine.dumps.DumpError: It is not a whole dump.
    """
    table = read_dump(path)
    steps, values = table["step"].to_numpy(), table[COLUMNS.split()].to_numpy(float)
    borders = [0, *(np.flatnonzero(np.diff(steps)) + 1), len(steps)]
    for first, end in pairwise(borders):
        rows = values[first:end]
        yield Frame(
            int(steps[first]),
            rows[:, 0].astype(int),
            rows[:, 1].astype(int),
            rows[:, 2],
            rows[:, 3],
            *(rows[:, k : k + 3] for k in (4, 7, 10)),
        )
