# SPDX-License-Identifier: GPL-2.0-or-later
"""Die compaction: the pressure-density loop, the punch's work, Heckel's line."""

from __future__ import annotations

from math import pi
from typing import ClassVar

import attrs
import pandas as pd

from plastigran.bulk.checks import Check, count_check, since_first
from plastigran.bulk.deck import Analysis, Brief, GranularDeck
from plastigran.bulk.decks.compaction.figure import compaction_figure
from plastigran.declared import number, require, whole
from plastigran.physics.heckel import TOUCH, Loop, measure_loop, punch_work
from plastigran.plot.style import title

#: What the sum over a hundred rows of the log may miss of the punch's work; trapezia of half the
#: width miss a quarter.
HUNDRED_ROWS = 2e-3
#: Kinetic over elastic energy of a quasi-static stroke, at most.
SLOW = 0.02
#: Share of the peak pressure above which the grains are a loaded bed.
LOADED = 0.2

#: A short run of few grains.
BRIEF = {"layers": 5, "die_radius": 0.005, "duration": 0.15, "filling": 0.1, "rows": 100}
BRIEF |= {"checkpoints": 10, "relative_density": 0.7, "release": 0.25}


@attrs.frozen(kw_only=True)
class Compaction(GranularDeck):
    """Grains in a die are pressed by a punch and released."""

    # The bed multiplies rounding a thousandfold.
    briefs: ClassVar = {
        "": Brief(
            BRIEF,
            start={"filling": 0.001, "duration": 0.004, "rows": 20, "checkpoints": 20},
            restart=1e-8,
        )
    }

    die_radius: float = number("of the die and the punch", "m", 0)
    layers: int = whole("of grains poured in, on a cubic lattice", 3)
    # Spheres stand at 0.5236 on the lattice; pressed flat they fill the die.
    relative_density: float = number("below the punch at its lowest", "-", 0.5236, 1)
    release: float = number("share of its stroke the punch goes up again", "-", 0, 1 + 1e-12)
    duration: float = number("of the stroke down and up", "s", 0)
    filling: float = number("for the grains to come to rest", "s", 0)

    def check(self) -> None:
        require(self, "die_radius", lower=4 * self.radius)
        GranularDeck.check(self)

    def analyse(self, series: pd.DataFrame) -> Analysis:
        """The punch's stroke alone; arguments as for `BulkDeck.analyse`."""
        table = self.stroke(series)
        loop = measure_loop(table["relative_density"], table["pressure"])
        checks = [
            count_check(table, self.derived("grains")),
            Check(
                "pressure left at the end, over its peak",
                table["pressure"].iloc[-1] / loop.pressure,
                TOUCH,
                "the punch has left the grains; raise release",
            ),
        ]
        if self.ledger == "on":
            checks += [*self.ledger_checks(table), *energy_checks(table, loop)]
        figure = compaction_figure({title(self.law): table}, [self.yield_strength])
        return Analysis(table, checks, {"compaction": figure, **self.ledger_figure(table)})

    def stroke(self, series: pd.DataFrame) -> pd.DataFrame:
        """The log of the stroke, with what is measured of it.

        Args:
            series: Columns time [s], height of the punch [m], force on it [N], and the ledger [J].

        Returns:
            The log with `time` [s] and the ledger from the stroke's start, and relative_density
            [-], pressure [Pa] and punch_work [J].
        """
        table = since_first(series)
        area, solid = pi * self.die_radius**2, table["atoms"] * 4 / 3 * pi * self.radius**3
        table["relative_density"] = solid / (area * table["height"])
        table["pressure"] = table["force"] / area
        table["punch_work"] = punch_work(table["height"], table["force"])
        return table


def energy_checks(table: pd.DataFrame, loop: Loop) -> list[Check]:
    """The punch's work is what the ledger says walls put in, and it is done slowly."""
    loaded = table[table["pressure"] > LOADED * loop.pressure]
    missed = (table["wallwork"] - table["punch_work"]).abs().max() / table["wallwork"].max()
    return [
        Check(
            "work of the punch against its force times travel, relative",
            missed,
            HUNDRED_ROWS * max(1, 100 / len(table)) ** 2,
            f"trapezia between {len(table)} rows",
        ),
        Check(
            "kinetic over elastic energy under load",
            (loaded["kinetic"] / loaded["elastic"]).max(),
            SLOW,
            "slow enough to be quasi-static",
        ),
    ]
