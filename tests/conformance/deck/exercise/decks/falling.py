# SPDX-License-Identifier: GPL-2.0-or-later
"""Grains fall on a floor: an exercise in adding a deck."""

from __future__ import annotations

from typing import ClassVar

import attrs
import pandas as pd
from matplotlib.figure import Figure

from plastigran.bulk.checks import Check, count_check
from plastigran.bulk.deck import Analysis, Brief, GranularDeck
from plastigran.declared import number, whole
from plastigran.plot.style import styled, subplots


@attrs.frozen(kw_only=True)
class Falling(GranularDeck):
    """A layer of grains falls on a floor and bounces."""

    briefs: ClassVar = {
        "": Brief({}, start={"duration": 0.024, "rows": 12, "checkpoints": 1}, restart=0)
    }

    side: int = whole("number of grains along each side", 2)
    height: float = number("height of the grains above the floor", "m", 0)
    duration: float = number("duration of the run", "s", 0)

    def analyse(self, series: pd.DataFrame) -> Analysis:
        fallen = series["z"].iloc[0] - series["z"]
        free = 0.5 * self.gravitational_acceleration * series["time"] ** 2
        falling = free < 0.99 * self.height
        checks = [
            count_check(series, self.derived("grains")),
            Check(
                "difference of the fall from g t^2/2, divided by the height",
                (fallen - free)[falling].abs().max() / self.height,
                1e-9,
                "the integrator is exact under a constant force, to round-off",
            ),
            *self.ledger_checks(series),
        ]
        figures = {"falling": falling_figure(series), **self.ledger_figure(series)}
        return Analysis(series.assign(fallen=fallen), checks, figures)


@styled()
def falling_figure(series: pd.DataFrame) -> Figure:
    """Draw the height of the grains versus time.

    Args:
        series: Columns time [s] and z [m].
    """
    figure, axes = subplots(figsize=(5, 3))
    axes.plot(series["time"], series["z"])
    axes.set_xlabel("time (s)")
    axes.set_ylabel("height (m)")
    return figure
