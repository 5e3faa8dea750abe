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
from plastigran.bulk.deck import Analysis, Brief, GranularDeck
from plastigran.bulk.decks.mixing_drum.figure import zones_figure
from plastigran.bulk.packing import random_packing, write_data
from plastigran.declared import number, radius_field, require, whole

#: Largest balance error / energy input.
BALANCE = 1e-3


@attrs.frozen(kw_only=True)
class MixingDrum(GranularDeck):
    """Small grains above large grains in a rotating drum with rotating end plates."""

    briefs: ClassVar = {
        "": Brief(
            {"drum_radius": 0.03, "length": 0.014, "grain_count": 250, "large_count": 60}
            | {"timestep": 2e-6, "duration": 0.04, "rows": 20, "checkpoints": 4}
            | {"volume_fraction": 0.35},
            start={"duration": 0.02},
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
    volume_fraction: float = number("volume fraction of the initial bed", "-", 0, 0.6)
    duration: float = number("duration of the run", "s", 0)

    def check(self) -> None:
        """Check that the grains fit into the drum."""
        # The mesh of the shell is as long as its radius.
        require(self, "length", lower=4 * self.large_radius, upper=self.drum_radius)
        require(self, "drum_radius", lower=4 * self.large_radius)
        if sum(self.areas) > pi * self.drum_radius**2:
            raise ValueError(
                f"grain_count is {self.grain_count} and large_count is {self.large_count}; so many "
                "grains do not fit into the drum. Lower one of them"
            )
        GranularDeck.check(self)

    @property
    def areas(self) -> tuple[float, float]:
        """Cross sections of the layers of large and of small grains [m^2]."""
        large = self.large_count * 4 / 3 * pi * self.large_radius**3
        small = self.grain_count * 4 / 3 * pi * self.radius**3
        whole_length = self.volume_fraction * self.length
        return large / whole_length, small / whole_length

    def level(self, area: float) -> float:
        """Return the height above the axis to which a cross section fills the drum [m]."""
        radius = self.drum_radius
        angle = brentq(lambda a: radius**2 / 2 * (a - sin(a)) - area, 0, 2 * pi)
        return -radius * cos(angle / 2)

    def write_inputs(self, folder: Path) -> None:
        """Write the bed to `grains.data`."""
        floor, border = -self.drum_radius, self.level(self.areas[0])
        surface = self.level(sum(self.areas))
        large = self._layer(self.large_count, self.large_radius, floor, border, int(self.seed))
        small = self._layer(self.grain_count, self.radius, border, surface, int(self.seed) + 1)
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

    def _layer(
        self, count: int, radius: float, lower: float, upper: float, seed: int
    ) -> np.ndarray:
        """Return positions of equal grains between two heights in the drum (count, 3) [m]."""
        reach = 0.98 * self.drum_radius - radius  # inside the facets of the shell
        side = self.length / 2 - radius

        def confine(places: np.ndarray, _: np.ndarray) -> np.ndarray:
            x, y, z = places.T
            z = np.clip(z, max(lower + radius, -reach), min(upper - radius, reach))
            width = np.sqrt(reach**2 - z**2)
            return np.column_stack([np.clip(x, -width, width), np.clip(y, -side, side), z])

        def start(random: np.random.Generator) -> np.ndarray:
            places = random.uniform(
                [-reach, -side, lower], [reach, side, upper], (20 * count + 1000, 3)
            )
            inside = np.hypot(places[:, 0], places[:, 2]) < reach
            return places[inside][:count]

        return random_packing(np.full(count, radius), start, confine, seed)

    def ledger_limit(self, series: pd.DataFrame) -> float:
        """Return the largest balance error as a fraction of the energy input [-]."""
        return BALANCE

    def analyse(self, series: pd.DataFrame) -> Analysis:
        """Analyse the mixing; arguments as for `BulkDeck.analyse`."""
        checks = [
            count_check(series, self.grain_count + self.large_count),
            *self.ledger_checks(series),
        ]
        figures = {"mixing_drum": zones_figure(series), **self.ledger_figure(series)}
        return Analysis(series, checks, figures)
