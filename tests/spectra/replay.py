# SPDX-License-Identifier: GPL-2.0-or-later
"""Reference for collision spectra: find impacts of a gas of smooth spheres in recorded positions.

The positions are from every step. A contact is an overlap of two spheres, or of a sphere and a
plane. The law is evaluated again along the overlaps; velocities are differences between two steps.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd

from plastigran import laws
from plastigran.engine.dumps import read_dump

# Geometry and materials of gas.in. Planes have an axis, a position [m] and an atom type.
HEIGHT = 0.036  # period along z [m]
PLANES = {"left": (0, -0.0185, 1), "right": (0, 0.0185, 1), "front": (1, -0.0185, 2)}
PLANES |= {"back": (1, 0.0185, 2)}
BODIES = {1: laws.Body(5e7, 0.3, 5e5), 2: laws.Body(3e7, 0.3, 4e5)}
LAW = laws.LAWS["thornton"]


class Motion:
    """Recorded positions of grains at every step.

    A grain keeps its index in the arrays even if LIGGGHTS renumbers it.

    Attributes:
        steps: Steps of the frames, shape (frames,).
        positions: Positions [m], shape (frames, grains, 3); NaN for a deleted grain.
        radii: Radii [m], shape (grains,).
        types: Atom types, shape (grains,).
    """

    def __init__(self, *dumps: Path) -> None:
        table = pd.concat([read_dump(path) for path in dumps]).drop_duplicates(["step", "id"])
        frames = [frame for _, frame in table.groupby("step")]
        self.steps = np.array([frame["step"].iloc[0] for frame in frames])
        count = len(frames[0])
        self.radii = frames[0]["radius"].to_numpy()
        self.types = frames[0]["type"].to_numpy()
        self.positions = np.full((len(frames), count, 3), np.nan)
        places = np.arange(count)  # grain of each row of a frame
        for k, frame in enumerate(frames):
            x = frame[["x", "y", "z"]].to_numpy()
            if len(x) != len(places):
                distance = np.linalg.norm(
                    _nearest_image(x[:, None] - self.positions[k - 1][None]), axis=-1
                )
                places = np.nanargmin(distance, axis=1)
            self.positions[k, places] = x


def _nearest_image(vectors: np.ndarray) -> np.ndarray:
    vectors = vectors.copy()
    vectors[..., 2] -= HEIGHT * np.round(vectors[..., 2] / HEIGHT)
    return vectors


def impacts(motion: Motion, timestep: float) -> pd.DataFrame:
    """Return all impacts that begin and end during the recorded motion.

    Returns:
        Rows with `begin` (first step of contact), `end` (first step without), `with`, `type`,
        `other_type`, `normal_speed` [m/s], `dissipated_energy` [J] and `largest_force` [N].
    """
    rows = []
    count = len(motion.radii)
    for i in range(count):
        for j in range(i + 1, count):
            apart = _nearest_image(motion.positions[:, i] - motion.positions[:, j])
            radii = motion.radii[[i, j]]
            types = sorted((motion.types[i], motion.types[j]))
            rows += _between(apart, radii.sum(), radii.prod() / radii.sum(), types, "particle")
        for name, (axis, place, type_) in PLANES.items():
            apart = np.zeros_like(motion.positions[:, i])
            apart[:, axis] = motion.positions[:, i, axis] - place
            radius, types = motion.radii[i], [motion.types[i], type_]
            rows += _between(apart, radius, radius, types, name)
    table = pd.DataFrame(rows)
    for edge in ("begin", "end"):
        table[edge] = motion.steps[table[edge]]
    table["normal_speed"] /= timestep
    return table


def _between(apart: np.ndarray, reach: float, radius_eff: float, types: list, name: str) -> list:
    """Return the impacts of one pair.

    Args:
        apart: Vectors between the bodies [m], shape (frames, 3).
        reach: Distance below which the bodies touch [m].
        radius_eff: Effective radius R* [m].
        types: Their two atom types.
        name: Name of the partner: `particle` or a plane.

    Returns:
        Rows as in `impacts`, with indices of frames instead of steps, and speeds in m per step.
    """
    distance = np.linalg.norm(apart, axis=1)
    touching = distance < reach
    if not touching.any():
        return []
    edges = np.diff(touching.astype(int))
    begins, ends = np.flatnonzero(edges == 1) + 1, np.flatnonzero(edges == -1) + 1
    ends = ends[ends > begins[0]] if len(begins) else ends[:0]
    law = LAW(laws.combine(BODIES[types[0]], BODIES[types[1]]))
    rows = []
    for begin, end in zip(begins, ends, strict=False):
        if np.isnan(distance[end]):
            continue  # one of the two was deleted
        moved = _nearest_image(apart[begin] - apart[begin - 1])
        path = law.follow(radius_eff, reach - distance[begin:end])
        rows.append(
            {
                "begin": begin,
                "end": end,
                "with": name,
                "type": types[0],
                "other_type": types[1],
                "normal_speed": -moved @ apart[begin] / distance[begin],
                "dissipated_energy": path["plastic_work"][-1],
                "largest_force": path["force"].max(),
            }
        )
    return rows


def spectra(found: pd.DataFrame, every: int, per_decade: int) -> pd.DataFrame:
    """Return numbers and sums of the impacts in each class of the collision spectra.

    Args:
        found: Impacts, as `impacts` returns them.
        every: Number of steps after which the deck writes a table of spectra.
        per_decade: Number of classes per decade.

    Returns:
        Columns `size` and `sum`, by last step of the table, quantity, partner, types and class.
    """
    long = found.drop(columns="begin").melt(
        ["end", "with", "type", "other_type"], var_name="quantity"
    )
    long["step"] = -(-long["end"] // every) * every
    positive = long["value"].where(long["value"] > 0)
    long["bin"] = np.floor(per_decade * np.log10(positive)).fillna(-np.inf)
    keys = ["step", "quantity", "with", "type", "other_type", "bin"]
    return long.groupby(keys)["value"].agg(["size", "sum"]).sort_index()
