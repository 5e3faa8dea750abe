# SPDX-License-Identifier: GPL-2.0-or-later
"""Events between the runs of a random scene."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

AXES = "xyz"
#: Radius of particles that are created between runs [m]; all other particles are larger.
CREATED_RADIUS = 0.04
#: Actions between two runs. `displace` moves all particles and is not possible with walls. After
#: `restart with its line`, the deck repeats the lines pair_style and pair_coeff.
ACTIONS = (
    "nothing",
    "delete",
    "create",
    "delete and create",
    "displace",
    "reset steps",
    "pair_style again",
    "restart",
    "restart with its line",
)


@dataclass(frozen=True)
class Event:
    """Event before a run of a scene.

    Attributes:
        action: One of ACTIONS.
        where: Places [m] near which particles are deleted, and at which one is created (2, 3).
        compress: Option `compress` of delete_atoms.
        shift: Displacement of all particles [m].
        steps: Number of time steps of the run that follows.
        grid: Numbers of ranks along x, y and z, which change only at restarts.
    """

    action: str
    where: np.ndarray
    compress: str
    shift: np.ndarray
    steps: int
    grid: tuple[int, int, int]


def random_events(
    random: np.random.Generator,
    positions: np.ndarray,
    radius: np.ndarray,
    low: np.ndarray,
    high: np.ndarray,
    walled: str,
    gap: float,
) -> Iterator[Event]:
    """Yield one to four events in a box with corners `low` and `high` [m].

    The particles start at `positions`, have radii `radius`, and move by several times `gap` [m] in
    all runs together.
    """
    grid = _grid(random)
    side = np.where([axis in walled for axis in AXES], 1e30, high - low)
    moved = np.zeros(3)
    for k in range(random.integers(1, 5)):
        action = str(random.choice(ACTIONS)) if k else "nothing"
        if action == "displace" and walled:
            action = "nothing"
        if action.startswith("restart"):
            grid = _grid(random)
        shift = random.uniform(-0.1, 0.1, 3) * (action == "displace")
        moved += shift
        free = _free_place(random, positions + moved, radius, low, high, side, gap)
        yield Event(
            action,
            where=np.array([random.uniform(low, high), free]),
            compress=str(random.choice(["yes", "no"])),
            shift=shift,
            steps=int(random.integers(20, 150)),
            grid=grid,
        )


def _free_place(
    random: np.random.Generator,
    positions: np.ndarray,
    radius: np.ndarray,
    low: np.ndarray,
    high: np.ndarray,
    side: np.ndarray,
    gap: float,
) -> np.ndarray:
    """Return a place for a new particle [m]: anywhere, or near another particle.

    Of up to twenty random places, the function selects the place with the largest distance from the
    initial particles. `side` is the length of the box on periodic axes, otherwise infinite.
    """
    near_another, best = random.random() < 0.5, (-np.inf, low)
    for _ in range(20):
        place = random.uniform(low, high)
        if near_another:
            near = random.integers(len(radius))
            away = random.standard_normal(3)
            away *= (radius[near] + CREATED_RADIUS + gap * random.uniform(-1, 1)) / np.linalg.norm(
                away
            )
            place = positions[near] + away
        place = place.clip(low + CREATED_RADIUS, high - CREATED_RADIUS)
        apart = positions - place
        apart -= side * np.round(apart / side)
        clearance = (np.linalg.norm(apart, axis=1) - radius - CREATED_RADIUS).min()
        best = max(best, (clearance, place), key=lambda clearance_and_place: clearance_and_place[0])
        if clearance > -gap:
            break
    return best[1]


def _grid(random: np.random.Generator) -> tuple[int, int, int]:
    grids = [(1, 1, 1), (1, 1, 1), (2, 1, 1), (1, 2, 1), (1, 1, 2), (2, 2, 1), (2, 1, 2)]
    return grids[random.integers(len(grids))]
