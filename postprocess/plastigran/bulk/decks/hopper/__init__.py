# SPDX-License-Identifier: GPL-2.0-or-later
"""The hopper: its ledger, its grains, and its rate of discharge against Beverloo's law."""

from __future__ import annotations

from dataclasses import dataclass

import pandas as pd

from plastigran.bulk.checks import ledger_checks
from plastigran.bulk.decks import Analysis, Check
from plastigran.bulk.decks.hopper.figure import discharge_figure
from plastigran.bulk.grains import Grains, read_grains
from plastigran.bulk.settings import check_contact, check_course
from plastigran.engine.deck import Settings
from plastigran.engine.process import inputs_folder
from plastigran.physics.beverloo import Discharge, measure_discharge
from plastigran.plot.ledger import ledger_figure

#: Standard deviations by which the rates of two halves may differ.
DEVIATIONS = 4
#: Share of the rate it may change by beside, as the level sinks: 2080 grains lose 4.5 % on average
#: (docs/decks/hopper.md).
LEVEL = 0.05
#: Layers of the lattice that stand in the barrel.
LAYERS = 20


@dataclass(frozen=True)
class Case:
    """A run's hopper.

    Attributes:
        grains: Size, material and law.
        orifice: Its diameter [m].
        gravitational_acceleration: [m/s^2].
    """

    grains: Grains
    orifice: float
    gravitational_acceleration: float

    def discharge(self, series: pd.DataFrame) -> Discharge | None:
        """The steady discharge of a series that begins when the orifice opens; None without one."""
        return measure_discharge(
            series,
            self.orifice,
            2 * self.grains.radius,
            self.grains.material.density,
            self.gravitational_acceleration,
        )


def orifices() -> list[str]:
    """Those that have a mesh, in diameters of a grain."""
    names = (file.stem for file in (inputs_folder() / "meshes").glob("hopper_*.stl"))
    return sorted((name.removeprefix("hopper_") for name in names), key=float)


def read_case(settings: Settings) -> Case:
    """The case of a deck's settings. Raises ValueError naming one out of range."""
    grains = read_grains(settings)
    if settings["orifice"] not in orifices():
        raise ValueError(
            f"orifice is {settings['orifice']}; there are hoppers of {', '.join(orifices())} "
            "(inputs/meshes/make_hopper.py makes others)"
        )
    return Case(
        grains,
        float(settings["orifice"]) * 2 * grains.radius,
        settings.number("gravitational_acceleration", 0, unit="m/s^2"),
    )


def check_settings(settings: Settings) -> None:
    read_case(settings)
    check_contact(settings)
    check_course(settings)
    if settings.whole("layers", 1) > LAYERS:
        raise ValueError(f"layers is {settings['layers']}; the barrel takes {LAYERS}")
    settings.number("temperature", 0, unit="m^2/s^2")
    settings.number("filling", 0, unit="s")
    settings.number("duration", 0)


def analyse(settings: Settings, series: pd.DataFrame) -> Analysis:
    case = read_case(settings)
    series = since_opening(series)
    discharge = case.discharge(series)
    missing = series["held"] + series["counted"] - series["atoms"].iloc[0]
    checks = [
        Check(
            "grains neither in the hopper nor counted out",
            missing.abs().max(),
            0,
            "the mesh keeps those that do not pass the orifice",
        ),
        *ledger_checks(settings, series),
    ]
    figures = {"hopper": discharge_figure(series, discharge, case.grains.mass)}
    if settings["ledger"] == "on":
        figures["ledger"] = ledger_figure(series)
    if discharge:
        low, high = discharge.band
        checks += [
            Check(
                "discharge rate beyond Beverloo's law, over the nearer edge of its band",
                max(low / discharge.rate, discharge.rate / high),
                1,
                "experiments scatter: C 0.55 to 0.65, k 1 to 2",
            ),
            Check(
                "change of the rate from half to half of the steady part, over the rate",
                abs(discharge.change) / discharge.rate,
                LEVEL + DEVIATIONS * discharge.change_error / discharge.rate,
                f"the level hardly enters: {LEVEL:g}, and {DEVIATIONS} standard deviations",
            ),
        ]
    return Analysis(series, checks, figures)


def since_opening(series: pd.DataFrame) -> pd.DataFrame:
    """A run's series with its time counted from the first row, when the orifice opened."""
    return series.assign(time=series["time"] - series["time"].iloc[0])
