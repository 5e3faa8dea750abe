# SPDX-License-Identifier: GPL-2.0-or-later
"""What is done to a random scene between its runs."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

AXES = "xyz"
#: Radius of particles that are created between runs, the least of all [m].
CREATED_RADIUS = 0.04
#: What may be done between two runs; `displace` moves all together and so needs no walls.
EVENTS = (
    "go on",
    "delete",
    "create",
    "delete and create",
    "displace",
    "steps anew",
    "pair_style again",
    "restart",
    "restart with its line",
)


@dataclass(frozen=True)
class Event:
    """What is done before a run.

    Attributes:
        kind: One of EVENTS.
        where: Near the first place particles are deleted, at the second one is created [m].
        compress: The word of delete_atoms.
        shift: Of all particles [m].
        steps: Time steps of the run after it.
        grid: Ranks along x, y and z; it changes at restarts alone.
    """

    kind: str
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

    The particles start at `positions` with `radius` and move by some gaps `gap` [m] until the end.
    """
    grid = _grid(random)
    side = np.where([axis in walled for axis in AXES], 1e30, high - low)
    moved = np.zeros(3)
    for k in range(random.integers(1, 5)):
        kind = str(random.choice(EVENTS)) if k else "go on"
        if kind == "displace" and walled:
            kind = "go on"
        if kind.startswith("restart"):
            grid = _grid(random)
        shift = random.uniform(-0.1, 0.1, 3) * (kind == "displace")
        moved += shift
        free = _free_place(random, positions + moved, radius, low, high, side, gap)
        yield Event(
            kind,
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
    """Return where to create a particle [m]: anywhere, or beside another.

    Of twenty tries, the place farthest from touching a particle of the start is chosen. `side` is
    the length of the box on periodic axes, otherwise infinite.
    """
    beside, best = random.random() < 0.5, (-np.inf, low)
    for _ in range(20):
        place = random.uniform(low, high)
        if beside:
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
        best = max(best, (clearance, place), key=lambda found: found[0])
        if clearance > -gap:
            break
    return best[1]


def _grid(random: np.random.Generator) -> tuple[int, int, int]:
    grids = [(1, 1, 1), (1, 1, 1), (2, 1, 1), (1, 2, 1), (1, 1, 2), (2, 2, 1), (2, 1, 2)]
    return grids[random.integers(len(grids))]
