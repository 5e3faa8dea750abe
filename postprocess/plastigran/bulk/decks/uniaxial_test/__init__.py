# SPDX-License-Identifier: GPL-2.0-or-later
"""Deck uniaxial_test: consolidation of a powder in a mold, then strength of the free sample."""

from __future__ import annotations

from math import isnan, pi
from typing import ClassVar

import attrs
import pandas as pd

from plastigran import laws
from plastigran.bulk.checks import Check, count_check, since_first
from plastigran.bulk.deck import Analysis, Brief, GranularDeck
from plastigran.bulk.decks.uniaxial_test.figure import uniaxial_figure
from plastigran.bulk.decks.uniaxial_test.measurement import (
    TOUCH,
    Stage,
    Strength,
    free_height,
    measure_strength,
    platen_height,
    platen_work,
    stage_of,
)
from plastigran.bulk.grains import Grains
from plastigran.declared import number, require, whole, word
from plastigran.plot.style import title
from plastigran.usable_laws import laws_for

#: Laws with adhesion whose constants are settings of this deck.
ADHESIVE_LAWS = ("edinburgh_2014", "luding_2008")
#: Largest allowed relative difference between the stress at the end of consolidation and the
#: setting `consolidation_stress`.
REACHED = 0.01
#: Largest ratio of kinetic to elastic energy at which a sample counts as being at rest.
SLOW = 0.02
#: Largest allowed relative error of the work of the platen, integrated over 400 log lines. The
#: error is proportional to the square of the time between log lines.
WORK = 2e-3

#: Settings of a short run with few grains, for tests.
BRIEF = {"side": 3, "layers": 4, "options": "", "filling": 0.02, "consolidation": 0.1}
BRIEF |= {"release": 0.01, "strain": 0.05, "speed": 0.03, "timestep": 4e-6, "rows": 80}
BRIEF |= {"checkpoints": 4}


@attrs.frozen(kw_only=True)
class UniaxialTest(GranularDeck):
    """Test of a sample that is consolidated in a mold, freed, and compressed until it fails."""

    briefs: ClassVar = {
        "": Brief(
            BRIEF,
            start={"filling": 0.004, "consolidation": 1e-3, "release": 4e-4, "strain": 1e-3}
            | {"rows": 4},
            restart=1e-8,
        )
    }

    law: str = word("law between grains", sorted([*laws_for("sphere"), *ADHESIVE_LAWS]))
    stiffness_ratio: float = number(
        "unloading stiffness / loading stiffness of edinburgh_2014", "-", 1.0001, 1e6, True, True
    )
    adhesion_ratio: float = number(
        "adhesive stiffness / loading stiffness of edinburgh_2014", "-", 0, 1e6, True, True
    )
    surface_energy: float = number(
        "surface energy; its JKR pull-off force is the constant force of edinburgh_2014",
        "J/m^2",
        0,
        lower_allowed=True,
    )
    loading_stiffness: float = number("loading stiffness of luding_2008", "N/m", 0)
    unloading_stiffness: float = number("unloading stiffness of luding_2008", "N/m", 0)
    adhesive_stiffness: float = number(
        "adhesive stiffness of luding_2008", "N/m", 0, lower_allowed=True
    )
    plasticity_depth: float = number("plasticity depth of luding_2008", "-", 0)
    size_spread: float = number(
        "fraction by which half of the grains are smaller than radius, and half are larger",
        "-",
        0,
        0.5,
        True,
        True,
    )
    side: int = whole("number of cells of two grains along each side of the mold", 2)
    layers: int = whole("number of layers of cells of two grains", 2)
    volume_fraction: float = number(
        "volume fraction of grains in the initial lattice", "-", 0, 0.55
    )
    consolidation_stress: float = number(
        "stress that the platen exerts at the end of consolidation", "Pa", 0
    )
    closing_speed: float = number("speed at which the platen approaches the sample", "m/s", 0)
    speed: float = number(
        "speed of the platen during unloading and compression of the free sample", "m/s", 0
    )
    strain: float = number("largest strain of the free sample", "-", 0, 1)
    filling: float = number("time for the grains to sink in the mold", "s", 0)
    consolidation: float = number("time for the platen to reach consolidation_stress", "s", 0)
    release: float = number(
        "duration of unloading, and duration of the opening of the mold", "s", 0
    )

    def check(self) -> None:
        require(self, "rows", lower=4)
        GranularDeck.check(self)

    @property
    def grains(self) -> Grains:
        """Grains of mean radius, with the settings as constants of a law of `ADHESIVE_LAWS`."""
        grains = super().grains
        grains.options.update(self.constants.get(self.law, {}))
        return grains

    @property
    def constants(self) -> dict[str, dict[str, float]]:
        """Constants of `ADHESIVE_LAWS` for two grains of mean radius, in SI units."""
        names = [row["name"] for row in laws.LAWS["luding_2008"].parameters()]
        return {
            "edinburgh_2014": {
                "stiffness_ratio": self.stiffness_ratio,
                "adhesion_ratio": self.adhesion_ratio,
                "constant_force": -0.75 * pi * self.surface_energy * self.radius,
            },
            "luding_2008": {name: getattr(self, name) for name in names},
        }

    def analyse(self, series: pd.DataFrame) -> Analysis:
        """Analyse the test after filling; arguments as for `BulkDeck.analyse`."""
        table = self.test(series)
        strength = measure_strength(table, self.strain)
        checks = [
            count_check(table, self.derived("grains")),
            Check(
                "relative difference between stress after consolidation and consolidation_stress",
                abs(strength.consolidation / self.consolidation_stress - 1),
                REACHED,
                "the platen has reached consolidation_stress; otherwise raise consolidation",
            ),
            Check(
                "stress when the mold opens / consolidation stress",
                table["stress"][table["stage"] == Stage.UNLOADING].iloc[-1]
                / strength.consolidation,
                TOUCH,
                "the platen has left the sample; otherwise raise release",
            ),
        ]
        if self.ledger == "on":
            checks += [*self.ledger_checks(table), *energy_checks(table)]
        figures = {
            "uniaxial_test": uniaxial_figure({title(self.law): (table, strength)}),
            **self.ledger_figure(table),
        }
        return Analysis(table, checks, figures, notes(table, self.strain), results(strength))

    def test(self, series: pd.DataFrame) -> pd.DataFrame:
        """Return the log of the test, with measured quantities.

        Args:
            series: Columns step, time [s], velocity of the platen [m/s], mean force on the platen
                [N], and energy terms [J].

        Returns:
            The log with `time` [s] and energy terms counted from the end of filling, and stage (see
            `Stage`), height of the platen [m], stress [Pa], porosity in the mold and strain of the
            free sample [-].
        """
        table = since_first(series)
        ends = [self.derived(name) for name in ("consolidated", "unloaded", "freed")]
        table["stage"] = stage_of(table["step"], ends)
        table["height"] = platen_height(table, self.derived("height"))
        area = self.derived("width") ** 2
        table["stress"] = table["force"] / area
        table["porosity"] = 1 - self.derived("solid") / (area * table["height"])
        table["strain"] = 1 - table["height"] / free_height(table)
        return table

    def strength(self, series: pd.DataFrame) -> Strength:
        """Return the strength of the sample; arguments as for `analyse`."""
        return measure_strength(self.test(series), self.strain)


def results(strength: Strength) -> dict[str, float]:
    """Return the measured values by name, for the command and the report."""
    return {
        "consolidation stress (Pa)": strength.consolidation,
        "porosity after consolidation": strength.porosity,
        "unconfined yield strength (Pa)": strength.unconfined,
        "unconfined yield strength / consolidation stress": strength.ratio,
        "strain at the unconfined yield strength": strength.failure_strain,
    }


def notes(table: pd.DataFrame, strain: float) -> list[str]:
    """Return a note if the sample was not freed, or was not compressed to the setting `strain`."""
    reached = table["strain"].iloc[-1]
    if isnan(reached):
        return [
            "the strength was not measured, because the platen still touched the sample at the end "
            "of the release. Use a larger value of the setting `release`"
        ]
    if reached >= strain:
        return []
    return [
        f"the sample was compressed to a strain of {reached:.3g}, not {strain:g}, because the "
        "sample is higher than expected. Raise strain"
    ]


def energy_checks(table: pd.DataFrame) -> list[Check]:
    """Compare the platen's work with the energy balance; check that consolidation ends at rest.

    The comparison excludes the stage in which the mold opens, because then the mold does work.
    """
    rest = table[table["stage"] == Stage.CONSOLIDATION].iloc[-1]
    moved = table["stage"] != Stage.OPENING
    balance = table["wallwork"].diff().where(moved, 0).cumsum()
    work = platen_work(table).where(moved, 0).cumsum()
    return [
        Check(
            "relative difference between the work of the platen and force times travel",
            (balance - work).abs().max() / balance.max(),
            WORK * max(1, 400 / len(table)) ** 2,
            f"limit: error of trapezoidal integration with {len(table)} rows",
        ),
        Check(
            "kinetic energy / elastic energy at the end of consolidation",
            rest["kinetic"] / rest["elastic"],
            SLOW,
            "the sample is at rest; otherwise raise consolidation",
        ),
    ]
