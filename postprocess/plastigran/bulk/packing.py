# SPDX-License-Identifier: GPL-2.0-or-later
"""Random packings of spheres that do not touch, as initial positions of bulk decks."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

#: Distance between the surfaces of two grains below which they are moved apart, in diameters.
GAP = 5e-4
#: The packing is finished when the surfaces of all pairs are at least GAP - TOLERANCE apart, in
#: diameters.
TOLERANCE = 4e-4
#: Standard deviation of the random displacement in each round of the iteration, in diameters.
JITTER = 1e-6
#: Largest number of rounds of the iteration. A packing with a volume fraction below 0.64 (random
#: close packing) needs some hundred rounds.
ROUNDS = 5000


def random_packing(
    radius: float,
    start: Callable[[np.random.Generator], np.ndarray],
    confine: Callable[[np.ndarray], np.ndarray],
    seed: int,
) -> np.ndarray:
    """Return random positions (n, 3) [m] of equal spheres that do not overlap.

    Spheres start at random positions. Then each overlapping pair moves apart by its overlap, and
    spheres outside the container move back, until no pair overlaps.

    Args:
        radius: Radius [m].
        start: Function that draws random initial positions (n, 3) [m] with a generator.
        confine: Function that moves positions (n, 3) of spheres into the container.
        seed: Seed of the generator.

    Raises:
        ValueError: Pairs still overlap after `ROUNDS` rounds, because the packing is too dense.
    """
    random = np.random.default_rng(seed)
    diameter, positions = 2 * radius, start(random)
    for _ in range(ROUNDS):
        positions = confine(positions)
        # Displace all spheres slightly. Otherwise, two spheres that were moved to the same corner
        # would have no direction in which to move apart.
        positions += random.normal(0, JITTER * diameter, positions.shape)
        tree = cKDTree(positions)
        first, second = tree.query_pairs((1 + GAP) * diameter, output_type="ndarray").T
        apart = positions[first] - positions[second]
        distance = np.linalg.norm(apart, axis=1)
        overlap = (1 + GAP) * diameter - distance
        if overlap.max(initial=0) < TOLERANCE * diameter:
            return positions
        move = (overlap / (2 * distance))[:, None] * apart
        for axis in range(3):
            positions[:, axis] += np.bincount(first, move[:, axis], len(positions))
            positions[:, axis] -= np.bincount(second, move[:, axis], len(positions))
    raise ValueError(
        f"{len(positions)} grains still overlap by {overlap.max() / diameter:.2g} diameters after "
        f"{ROUNDS} rounds. Lower volume_fraction"
    )


def write_data(
    path: Path,
    lower: tuple[float, float, float],
    upper: tuple[float, float, float],
    types: np.ndarray,
    radii: np.ndarray,
    densities: np.ndarray,
    positions: np.ndarray,
    type_count: int,
) -> None:
    """Write spheres as a data file of LIGGGHTS for `read_data`, with `atom_style granular`.

    Args:
        path: File to write.
        lower, upper: Corners of the simulation box [m].
        types: Atom types (n,).
        radii: Radii (n,) [m].
        densities: Densities (n,) [kg/m^3].
        positions: Positions (n, 3) [m].
        type_count: Number of atom types, including types without spheres.
    """
    box = zip("xyz", lower, upper, strict=True)
    lines = [
        "Spheres of a bulk deck",
        "",
        f"{len(radii)} atoms",
        f"{type_count} atom types",
        "",
        *(f"{low:.17g} {high:.17g} {axis}lo {axis}hi" for axis, low, high in box),
        "",
        "Atoms",
        "",
    ]
    table = zip(types, 2 * radii, densities, *positions.T, strict=True)
    for number, (atom_type, diameter, density, x, y, z) in enumerate(table, start=1):
        lines.append(
            f"{number} {atom_type} {diameter:.17g} {density:.17g} {x:.17g} {y:.17g} {z:.17g}"
        )
    path.write_text("\n".join(lines) + "\n")
