# SPDX-License-Identifier: GPL-2.0-or-later
"""Deck ball_impact: a steel ball hits a bed of grains, a benchmark of Dosta et al. 2024."""

from __future__ import annotations

from math import ceil, pi
from pathlib import Path
from typing import ClassVar

import attrs
import numpy as np
import pandas as pd

from plastigran.bulk.checks import Check, count_check
from plastigran.bulk.deck import BENCHMARK_BALANCE, Analysis, Brief, GranularDeck
from plastigran.bulk.decks.ball_impact.figure import impact_figure
from plastigran.bulk.packing import random_packing, write_data
from plastigran.declared import number, radius_field, require, whole

#: Density of the steel ball [kg/m^3].
STEEL = 7200.0
#: Largest allowed deviation of the ball from free fall above the bed, in ball radii. The value
#: covers the round-off of about 1e5 steps.
FALL = 1e-9


@attrs.frozen(kw_only=True)
class BallImpact(GranularDeck):
    """A steel ball falls on a bed of grains in a box, and may hit the floor and rebound."""

    balance_limit: ClassVar = BENCHMARK_BALANCE
    briefs: ClassVar = {
        "": Brief(
            {"grain_count": 300, "length": 0.02, "width": 0.012, "ball_radius": 0.003}
            | {"ball_height": 0.02, "volume_fraction": 0.531}
            | {"timestep": 1e-6, "duration": 0.004, "rows": 40},
            start={"duration": 0.0015},
            # Impacts in the bed amplify round-off, so continued runs agree only to this tolerance.
            restart=1e-6,
        )
    }

    grain_count: int = whole("number of grains", 1)
    seed: int = whole("seed of the random grains")
    volume_fraction: float = number("volume fraction of the initial bed", "-", 0, 0.6)
    length: float = number("inner length of the box", "m", 0)
    width: float = number("inner width of the box", "m", 0)
    ball_radius: float = radius_field("radius of the ball")
    ball_speed: float = number("initial speed of the ball, downward", "m/s", 0)
    ball_height: float = number("initial height of the ball's center above the floor", "m", 0)
    duration: float = number("duration of the run", "s", 0)

    def check(self) -> None:
        """Check that the ball fits into the box and starts above the bed.

        Also check that the bed is at least as high as a grain.

        Raises:
            ValueError: A condition is violated; the message names the setting.
        """
        for name in ("length", "width"):
            require(self, name, lower=2 * self.ball_radius)
        fewest = ceil(2 * self.radius * self.grain_count / self.bed_height)
        require(self, "grain_count", lower=fewest)
        require(self, "ball_height", lower=self.bed_height + self.ball_radius)
        GranularDeck.check(self)

    @property
    def bed_height(self) -> float:
        """Height of the initial bed [m]."""
        volume = self.grain_count * 4 / 3 * pi * self.radius**3
        return volume / (self.volume_fraction * self.length * self.width)

    def write_inputs(self, folder: Path) -> None:
        """Write the bed and the ball to `grains.data`."""
        corner = np.array([self.length / 2, self.width / 2, self.bed_height])
        lowest = np.array([-self.length / 2, -self.width / 2, 0.0])
        positions = random_packing(
            self.radius,
            lambda random: random.uniform(lowest, corner, (self.grain_count, 3)),
            lambda places: np.clip(places, lowest + self.radius, corner - self.radius),
            self.seed,
        )
        margin = 4 * self.radius
        top = self.ball_height + self.ball_radius + margin
        write_data(
            folder / "grains.data",
            (*(lowest[:2] - margin), -margin),
            (*(corner[:2] + margin), top),
            np.append(np.ones(self.grain_count, int), 2),
            np.append(np.full(self.grain_count, self.radius), self.ball_radius),
            np.append(np.full(self.grain_count, self.density), STEEL),
            np.vstack([positions, [0, 0, self.ball_height]]),
            2,
        )

    def analyse(self, series: pd.DataFrame) -> Analysis:
        """Analyse the motion of the ball; arguments as for `BulkDeck.analyse`."""
        series = series.assign(displacement=series["ball"] - self.ball_height)
        deepest = series["ball"].idxmin()
        time, g = series["time"], self.gravitational_acceleration
        fall = -self.ball_speed * time - g * time**2 / 2
        falling = (series["ball"] > self.bed_height + self.ball_radius).cummin()
        checks = [
            count_check(series, self.grain_count + 1),
            Check(
                "deviation of the ball from free fall above the bed, in ball radii",
                (series["displacement"] - fall)[falling].abs().max() / self.ball_radius,
                FALL,
                "the integrator is exact for a constant acceleration",
            ),
            *self.ledger_checks(series),
        ]
        results = {
            "displacement of the ball at its deepest point, m": series["displacement"][deepest],
            "time of the deepest point, s": time[deepest],
            "final displacement of the ball, m": series["displacement"].iloc[-1],
        }
        figures = {
            "ball_impact": impact_figure(
                series, self.bed_height + self.ball_radius - self.ball_height
            )
        }
        return Analysis(series, checks, {**figures, **self.ledger_figure(series)}, results=results)
