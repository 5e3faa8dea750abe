# SPDX-License-Identifier: GPL-2.0-or-later
"""Deck silo: discharge of a silo, a benchmark of Dosta et al. 2024."""

from __future__ import annotations

from math import pi, sqrt
from pathlib import Path
from typing import ClassVar

import attrs
import numpy as np
import pandas as pd

from plastigran.bulk.checks import Check
from plastigran.bulk.deck import BENCHMARK_BALANCE, Analysis, Brief, GranularDeck
from plastigran.bulk.decks.silo.figure import silo_figure
from plastigran.bulk.packing import random_packing, write_data
from plastigran.declared import number, require, whole, word

#: Radius of the barrel, and height of its top above the orifice [m]. The meshes
#: inputs/meshes/silo_*.stl have these sizes.
BARREL, TOP = 0.1, 0.3
#: Radius of the orifice [m] by name.
ORIFICES = {"large": 0.03, "small": 0.02}
#: Depth below the orifice at which grains are deleted [m].
FALL = 0.05
#: The discharge rate is measured while at least this fraction of the grains is in the silo. Later,
#: the surface is too near to the orifice.
REST = 0.1
#: Smallest number of log lines to which the discharge rate is fitted.
ROWS = 10


@attrs.frozen(kw_only=True)
class Silo(GranularDeck):
    """Grains flow out of a silo, which consists of a barrel on a 45-degree cone."""

    balance_limit: ClassVar = BENCHMARK_BALANCE
    briefs: ClassVar = {
        "": Brief(
            {"grain_count": 300, "timestep": 3e-6, "duration": 0.12, "settling": 0.05}
            | {"rows": 24, "checkpoints": 4, "volume_fraction": 0.3},
            start={"duration": 0.012, "settling": 0.005},
        )
    }

    orifice: str = word("orifice", tuple(ORIFICES))
    grain_count: int = whole("number of grains", 1)
    seed: int = whole("seed of the random grains")
    volume_fraction: float = number("volume fraction of the initial filling", "-", 0, 0.6)
    duration: float = number("duration of the run", "s", 0)
    settling: float = number(
        "time before the discharge rate is measured", "s", 0, lower_allowed=True
    )

    def check(self) -> None:
        """Check that the grains fit into the silo, and that settling ends before the run.

        Raises:
            ValueError: A condition is violated; the message names the setting.
        """
        require(self, "settling", upper=self.duration)
        if self.filling_height > TOP:
            raise ValueError(
                f"grain_count is {self.grain_count}; the filling would be "
                f"{self.filling_height:.3g} m high, and the silo is {TOP} m high. Lower grain_count"
            )
        GranularDeck.check(self)

    @property
    def filling_height(self) -> float:
        """Height of the initial surface above the orifice [m]."""
        volume = self.grain_count * 4 / 3 * pi * self.radius**3 / self.volume_fraction
        opening = ORIFICES[self.orifice]
        # The radius of the cone at a height above the orifice is that height plus the orifice
        # radius.
        height = (3 * volume / pi + opening**3) ** (1 / 3) - opening
        if height <= BARREL - opening:
            return height
        cone = pi / 3 * (BARREL**3 - opening**3)
        return BARREL - opening + (volume - cone) / (pi * BARREL**2)

    def write_inputs(self, folder: Path) -> None:
        """Write the initial positions of the grains to `grains.data`."""
        opening, height, count = ORIFICES[self.orifice], self.filling_height, self.grain_count
        radius = self.radius

        def confine(places: np.ndarray) -> np.ndarray:
            z = np.clip(places[:, 2], radius, height - radius)
            across = np.hypot(places[:, 0], places[:, 1])
            reach = np.minimum(BARREL - radius, opening + z - sqrt(2) * radius)
            inward = np.minimum(1, reach / np.maximum(across, 1e-300))
            return np.column_stack([places[:, :2] * inward[:, None], z])

        def start(random: np.random.Generator) -> np.ndarray:
            # Accept heights with a probability proportional to the area of the cross section.
            z = np.empty(0)
            while len(z) < count:
                heights = random.uniform(0, height, count)
                widths = np.minimum(BARREL, opening + heights)
                z = np.append(z, heights[random.random(count) < (widths / BARREL) ** 2])
            z = z[:count]
            distance = np.minimum(BARREL, opening + z) * np.sqrt(random.random(count))
            angle = random.uniform(0, 2 * pi, count)
            return np.column_stack([distance * np.cos(angle), distance * np.sin(angle), z])

        side = BARREL + 4 * radius
        write_data(
            folder / "grains.data",
            (-side, -side, -FALL),
            (side, side, TOP + 4 * radius),
            np.ones(count, int),
            np.full(count, radius),
            np.full(count, self.density),
            random_packing(radius, start, confine, self.seed),
            2,
        )

    def rate(self, series: pd.DataFrame) -> float | None:
        """Return the discharge rate [grains/s], or None if fewer than `ROWS` log lines are usable.

        Args:
            series: Columns time [s] and held, the number of grains in the silo.
        """
        steady = series[
            (series["time"] >= self.settling) & (series["held"] >= REST * self.grain_count)
        ]
        if len(steady) < ROWS:
            return None
        from scipy.stats import linregress  # imported here: scipy.stats is slow

        return -linregress(steady["time"], steady["held"]).slope

    def analyse(self, series: pd.DataFrame) -> Analysis:
        """Analyse the discharge; arguments as for `BulkDeck.analyse`."""
        rate = self.rate(series)
        missing = series["held"] + series["counted"] - self.grain_count
        checks = [
            Check(
                "grains neither in the silo nor counted as discharged",
                missing.abs().max(),
                0,
                "grains can leave the silo only through the orifice",
            ),
            *self.ledger_checks(series),
        ]
        note = (
            f"the discharge rate was not measured, because fewer than {ROWS} log lines lie between "
            f"settling and the time when {1 - REST:.0%} of the grains are out. Raise rows or "
            "duration"
        )
        figures = {"silo": silo_figure(series, rate, self.settling), **self.ledger_figure(series)}
        results = {} if rate is None else {"discharge rate, grains/s": rate}
        return Analysis(series, checks, figures, [note] if rate is None else [], results)
