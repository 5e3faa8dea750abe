# SPDX-License-Identifier: GPL-2.0-or-later
"""Deck compaction: pressure-density loop in a die, work of the punch, Heckel's line."""

from __future__ import annotations

from math import pi
from typing import ClassVar

import attrs
import pandas as pd
from scipy.integrate import cumulative_trapezoid

from plastigran.bulk.checks import Check, count_check, since_first
from plastigran.bulk.deck import Analysis, Brief, GranularDeck
from plastigran.bulk.decks.compaction.figure import compaction_figure
from plastigran.declared import number, require, whole
from plastigran.plot.style import title

#: Largest allowed relative error of the work of the punch, integrated over 100 log lines. The error
#: is proportional to the square of the time between log lines.
HUNDRED_ROWS = 2e-3
#: Largest ratio of kinetic to elastic energy at which a stroke counts as quasi-static.
SLOW = 0.02
#: Pressure / peak pressure below which the punch counts as not touching the bed. It may still touch
#: single grains that protrude from the bed.
TOUCH = 0.01
#: Pressure / peak pressure above which the bed counts as loaded.
LOADED = 0.2

#: Settings of a short run with few grains, for tests.
BRIEF = {"layers": 5, "die_radius": 0.005, "duration": 0.15, "filling": 0.1, "rows": 100}
BRIEF |= {"checkpoints": 10, "relative_density": 0.7, "release": 0.25}


@attrs.frozen(kw_only=True)
class Compaction(GranularDeck):
    """Compression of grains in a die by a punch, which then moves up again."""

    # Contacts in the bed amplify round-off, so continued runs agree only to this tolerance.
    briefs: ClassVar = {
        "": Brief(
            BRIEF,
            start={"filling": 0.001, "duration": 0.004, "rows": 20, "checkpoints": 20},
            restart=1e-8,
        )
    }

    die_radius: float = number("radius of the die and the punch", "m", 0)
    layers: int = whole("layers of poured grains, on a cubic lattice", 3)
    # The lower bound is the relative density of spheres on a simple cubic lattice. At the upper
    # bound, flattened grains would fill the die without pores.
    relative_density: float = number(
        "relative density below the punch at its lowest point", "-", 0.5236, 1
    )
    release: float = number(
        "fraction of the stroke by which the punch moves up again", "-", 0, 1 + 1e-12
    )
    duration: float = number("duration of the stroke down and up", "s", 0)
    filling: float = number("time for the grains to come to rest", "s", 0)

    def check(self) -> None:
        require(self, "die_radius", lower=4 * self.radius)
        GranularDeck.check(self)

    def analyse(self, series: pd.DataFrame) -> Analysis:
        """Analyse the stroke of the punch; arguments as for `BulkDeck.analyse`."""
        table = self.stroke(series)
        peak = table["pressure"].max()
        if not peak > 0:
            raise ValueError(
                f"the highest pressure is {peak:g} Pa, so the punch does not touch the grains. "
                "Raise relative_density"
            )
        checks = [
            count_check(table, self.derived("grains")),
            Check(
                "pressure at the end / peak pressure",
                table["pressure"].iloc[-1] / peak,
                TOUCH,
                "the punch has left the grains; otherwise raise release",
            ),
        ]
        if self.ledger == "on":
            checks += [*self.ledger_checks(table), *energy_checks(table)]
        figure = compaction_figure({title(self.law): table}, [self.yield_strength])
        return Analysis(table, checks, {"compaction": figure, **self.ledger_figure(table)})

    def stroke(self, series: pd.DataFrame) -> pd.DataFrame:
        """Return the log of the stroke of the punch, with measured quantities.

        Args:
            series: Columns time [s], height of the punch [m], force on the punch [N], and energy
                terms [J].

        Returns:
            The log with `time` [s] and energy terms counted from the start of the stroke, and
            relative_density [-], pressure [Pa] and punch_work [J].
        """
        table = since_first(series)
        area, solid = pi * self.die_radius**2, table["atoms"] * 4 / 3 * pi * self.radius**3
        table["relative_density"] = solid / (area * table["height"])
        table["pressure"] = table["force"] / area
        table["punch_work"] = -cumulative_trapezoid(table["force"], table["height"], initial=0)
        return table


def energy_checks(table: pd.DataFrame) -> list[Check]:
    """Check the work of the punch, and that the stroke is quasi-static."""
    loaded = table[table["pressure"] > LOADED * table["pressure"].max()]
    difference = (table["wallwork"] - table["punch_work"]).abs().max() / table["wallwork"].max()
    return [
        Check(
            "relative difference between the work of the punch and force times travel",
            difference,
            HUNDRED_ROWS * max(1, 100 / len(table)) ** 2,
            f"limit: error of trapezoidal integration with {len(table)} rows",
        ),
        Check(
            "kinetic energy / elastic energy under load",
            (loaded["kinetic"] / loaded["elastic"]).max(),
            SLOW,
            "limit for a quasi-static stroke",
        ),
    ]
