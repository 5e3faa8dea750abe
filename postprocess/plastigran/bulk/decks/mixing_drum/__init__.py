# SPDX-License-Identifier: GPL-2.0-or-later
"""Deck mixing_drum: mixing of two sizes of grains, a benchmark of Dosta et al. 2024."""

from __future__ import annotations

from math import cos, pi, sin
from pathlib import Path
from typing import ClassVar

import attrs
import numpy as np
import pandas as pd
from scipy.optimize import brentq

from plastigran.bulk.checks import count_check
from plastigran.bulk.deck import BENCHMARK_BALANCE, Analysis, Brief, GranularDeck
from plastigran.bulk.decks.mixing_drum.figure import zones_figure
from plastigran.bulk.packing import random_packing, write_data
from plastigran.declared import number, radius_field, require, whole


@attrs.frozen(kw_only=True)
class MixingDrum(GranularDeck):
    """Small grains above large grains in a rotating drum with rotating end plates."""

    balance_limit: ClassVar = BENCHMARK_BALANCE
    briefs: ClassVar = {
        "": Brief(
            {"drum_radius": 0.03, "length": 0.014, "grain_count": 250, "large_count": 60}
            | {"timestep": 2e-6, "duration": 0.04, "rows": 20, "checkpoints": 4}
            | {"volume_fraction": 0.25},
            start={"duration": 0.012},
        )
    }

    drum_radius: float = number("radius of the shell", "m", 0)
    length: float = number("length along the axis", "m", 0)
    angular_velocity: float = number("angular velocity of the drum", "rad/s", 0)
    grain_count: int = whole("number of small grains M1", 1)
    large_count: int = whole("number of large grains M2", 1)
    large_radius: float = radius_field("radius of a large grain")
    large_density: float = number("density of a large grain", "kg/m^3", 0)
    large_youngs_modulus: float = number("Young's modulus of a large grain", "Pa", 0)
    large_yield_strength: float = number("yield strength of a large grain", "Pa", 0)
    seed: int = whole("seed of the random grains")
    volume_fraction: float = number("volume fraction of the initial bed", "-", 0, 0.6)
    duration: float = number("duration of the run", "s", 0)

    def check(self) -> None:
        """Check that the grains fit into the drum and fill at least one layer of each size.

        Raises:
            ValueError: A condition is violated; the message names the setting.
        """
        # The length of the shell mesh equals the drum radius.
        require(self, "length", lower=4 * self.large_radius, upper=self.drum_radius)
        require(self, "drum_radius", lower=4 * self.large_radius)
        if sum(self.areas) > pi * self.drum_radius**2:
            raise ValueError(
                f"grain_count is {self.grain_count} and large_count is {self.large_count}; so many "
                "grains do not fit into the drum. Lower one of them"
            )
        layers = self.level(self.areas[0]), self.level(sum(self.areas))
        if layers[0] - self.large_radius <= -self._reach(self.large_radius):
            raise ValueError(
                f"large_count is {self.large_count}; it must be larger to fill one layer of grains"
            )
        if layers[1] - layers[0] <= 2 * self.radius:
            raise ValueError(
                f"grain_count is {self.grain_count}; it must be larger to fill one layer of grains"
            )
        GranularDeck.check(self)

    @property
    def areas(self) -> tuple[float, float]:
        """Cross-sectional areas of the layers of large grains and of small grains [m^2]."""
        large = self.large_count * 4 / 3 * pi * self.large_radius**3
        small = self.grain_count * 4 / 3 * pi * self.radius**3
        whole_length = self.volume_fraction * self.length
        return large / whole_length, small / whole_length

    def level(self, area: float) -> float:
        """Return the height of the bed surface above the axis [m] for a cross-sectional area."""
        radius = self.drum_radius
        angle = brentq(lambda a: radius**2 / 2 * (a - sin(a)) - area, 0, 2 * pi)
        return -radius * cos(angle / 2)

    def write_inputs(self, folder: Path) -> None:
        """Write the bed to `grains.data`."""
        floor, border = -self.drum_radius, self.level(self.areas[0])
        surface = self.level(sum(self.areas))
        large = self._layer(self.large_count, self.large_radius, floor, border, self.seed)
        small = self._layer(self.grain_count, self.radius, border, surface, self.seed + 1)
        counts = [self.grain_count, self.large_count]
        side, half = 1.3 * self.drum_radius, 0.5 * self.drum_radius + 4 * self.large_radius
        write_data(
            folder / "grains.data",
            (-side, -half, -side),
            (side, half, side),
            np.repeat([1, 2], counts),
            np.repeat([self.radius, self.large_radius], counts),
            np.repeat([self.density, self.large_density], counts),
            np.vstack([small, large]),
            3,
        )

    def _reach(self, radius: float) -> float:
        """Return the largest distance of the center of a grain from the axis [m].

        The factor 0.98 keeps grains inside the flat facets of the shell mesh.
        """
        return 0.98 * self.drum_radius - radius

    def _layer(
        self, count: int, radius: float, lower: float, upper: float, seed: int
    ) -> np.ndarray:
        """Return positions (count, 3) [m] of equal grains between two heights in the drum."""
        reach, side = self._reach(radius), self.length / 2 - radius
        bottom, top = max(lower + radius, -reach), min(upper - radius, reach)

        def confine(places: np.ndarray) -> np.ndarray:
            x, y, z = places.T
            # Move outer grains toward the axis, so that they slide along the shell. Then move
            # grains back into the layer if the first move has taken them out of it.
            inward = np.minimum(1, reach / np.maximum(np.hypot(x, z), 1e-300))
            z = np.clip(inward * z, bottom, top)
            width = np.sqrt(reach**2 - z**2)
            return np.column_stack([np.clip(inward * x, -width, width), np.clip(y, -side, side), z])

        def start(random: np.random.Generator) -> np.ndarray:
            places = np.empty((0, 3))
            while len(places) < count:
                drawn = random.uniform([-reach, -side, bottom], [reach, side, top], (count, 3))
                inside = np.hypot(drawn[:, 0], drawn[:, 2]) < reach
                places = np.vstack([places, drawn[inside]])
            return places[:count]

        return random_packing(radius, start, confine, seed)

    def analyse(self, series: pd.DataFrame) -> Analysis:
        """Analyse the mixing; arguments as for `BulkDeck.analyse`."""
        checks = [
            count_check(series, self.grain_count + self.large_count),
            *self.ledger_checks(series),
        ]
        figures = {"mixing_drum": zones_figure(series), **self.ledger_figure(series)}
        return Analysis(series, checks, figures)
