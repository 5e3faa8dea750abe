# SPDX-License-Identifier: GPL-2.0-or-later
"""Deck hopper: energy balance, number of grains, and discharge rate (Beverloo's law)."""

from __future__ import annotations

from typing import ClassVar

import attrs
import pandas as pd

from plastigran.bulk.checks import Check
from plastigran.bulk.deck import Analysis, Brief, GranularDeck
from plastigran.bulk.decks.hopper.figure import discharge_figure
from plastigran.bulk.settings import text
from plastigran.declared import number, whole
from plastigran.engine.process import inputs_folder
from plastigran.physics.beverloo import BLOCKS, STEADY_SHARE, Discharge, measure_discharge

#: Largest allowed difference between the rates of the two halves of the steady discharge, in
#: standard deviations.
DEVIATIONS = 4
#: Relative change of the discharge rate that is allowed in addition to `DEVIATIONS`, because the
#: fill level falls. The mean change with 2080 grains is 4.5 %.
LEVEL = 0.05
#: Note about a run without steady discharge.
UNMEASURED = (
    f"the discharge rate was not measured. The run ended before {STEADY_SHARE:.0%} of the "
    f"grains were out, it wrote fewer than {2 * BLOCKS} log lines until then, or its bed is too "
    "shallow. Raise duration, rows or layers"
)
#: Largest number of lattice layers that fit into the hopper.
LAYERS = 20


def orifices() -> list[str]:
    """Return the orifice diameters for which a mesh exists, in grain diameters."""
    names = (file.stem for file in (inputs_folder() / "meshes").glob("hopper_*.stl"))
    return sorted((name.removeprefix("hopper_") for name in names), key=float)


#: Settings of a short run with few grains, for tests.
BRIEF = {"orifice": 8, "layers": 2, "timestep": 2e-5, "duration": 0.5, "rows": 24}
BRIEF |= {"filling": 0.12, "checkpoints": 6}


@attrs.frozen(kw_only=True)
class Hopper(GranularDeck):
    """Filling of a hopper (a triangle mesh) with grains, and discharge through its orifice."""

    briefs: ClassVar = {
        "": Brief(BRIEF, start={"filling": 0.01, "duration": 0.01, "rows": 4, "checkpoints": 1})
    }

    orifice: str = text("orifice diameter in grain diameters, of inputs/meshes/hopper_*.stl")
    layers: int = whole("number of layers of about 200 grains", 1)
    temperature: float = number("initial variance of each velocity component", "m^2/s^2", 0)
    filling: float = number("time for the grains to come to rest", "s", 0)
    duration: float = number("duration / time to empty the hopper by Beverloo's law", "-", 0)
    beverloo_coefficient: float = number("C of Beverloo's law", "-", 0)
    empty_annulus: float = number("k of Beverloo's law", "-", 0)

    def check(self) -> None:
        if self.layers > LAYERS:
            raise ValueError(f"layers is {self.layers}; at most {LAYERS} fit into the barrel")
        GranularDeck.check(self)

    def check_inputs(self) -> None:
        if self.orifice not in orifices():
            raise ValueError(
                f"orifice is {self.orifice}; there are meshes for {', '.join(orifices())}. Choose "
                "one of these, or make a mesh with inputs/meshes/make_hopper.py"
            )

    def discharge(self, series: pd.DataFrame) -> Discharge | None:
        """Return the steady part of the discharge, or None if no part is steady."""
        orifice, diameter = float(self.orifice) * 2 * self.radius, 2 * self.radius
        bed = orifice, diameter, self.density, self.gravitational_acceleration
        return measure_discharge(series, *bed, self.beverloo_coefficient, self.empty_annulus)

    def analyse(self, series: pd.DataFrame) -> Analysis:
        """Analyse the discharge; arguments as for `BulkDeck.analyse`."""
        # Count the time from the opening of the orifice.
        series = series.assign(time=series["time"] - series["time"].iloc[0])
        discharge = self.discharge(series)
        missing = series["held"] + series["counted"] - self.derived("grains")
        checks = [
            Check(
                "grains neither in the hopper nor counted as discharged",
                missing.abs().max(),
                0,
                "grains can leave the mesh only through the orifice",
            ),
            *self.ledger_checks(series),
            *(discharge_checks(discharge) if discharge else []),
        ]
        figure = discharge_figure(series, discharge, self.grains.mass)
        figures = {"hopper": figure, **self.ledger_figure(series)}
        return Analysis(series, checks, figures, [] if discharge else [UNMEASURED])


def discharge_checks(discharge: Discharge) -> list[Check]:
    """Check that the discharge rate follows Beverloo's law and is steady."""
    low, high = discharge.band
    return [
        Check(
            "discharge rate outside the band of Beverloo's law, as a ratio to the nearer edge",
            max(low / discharge.rate, discharge.rate / high),
            1,
            "in experiments, the constants of the law are C = 0.55 to 0.65 and k = 1 to 2",
        ),
        Check(
            "relative change of the rate between the two halves of the steady discharge",
            abs(discharge.change) / discharge.rate,
            LEVEL + DEVIATIONS * discharge.change_error / discharge.rate,
            f"limit: {LEVEL:g} for the falling fill level, plus {DEVIATIONS} standard deviations",
        ),
    ]
