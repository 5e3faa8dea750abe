# SPDX-License-Identifier: GPL-2.0-or-later
"""The hopper: its ledger, its grains, and its rate of discharge against Beverloo's law."""

from __future__ import annotations

from math import inf, pi

import pandas as pd

from plastigran.beverloo import Discharge, measure_discharge
from plastigran.bulk_checks import ledger_checks
from plastigran.bulk_decks import Analysis, Check
from plastigran.deck_source import Settings
from plastigran.engine import inputs_folder
from plastigran.hopper_figure import discharge_figure
from plastigran.impact import laws_for
from plastigran.ledger_figure import ledger_figure


def orifices() -> list[str]:
    """Those that have a mesh, in diameters of a grain."""
    names = (file.stem for file in (inputs_folder() / "meshes").glob("hopper_*.stl"))
    return sorted((name.removeprefix("hopper_") for name in names), key=float)


def grain_mass(settings: Settings) -> float:
    """Of a grain [kg]."""
    return 4 / 3 * pi * float(settings["radius"]) ** 3 * float(settings["density"])


def discharge_of(settings: Settings, series: pd.DataFrame) -> Discharge | None:
    """The steady discharge of a run; None where it has none."""
    diameter = 2 * float(settings["radius"])
    orifice = float(settings["orifice"]) * diameter
    return measure_discharge(series, orifice, diameter, float(settings["density"]))


def check_settings(settings: Settings) -> None:
    if settings["law"] not in (known := laws_for("sphere")):
        raise ValueError(f"no law {settings['law']!r} for spheres; there are {', '.join(known)}")
    if settings["ledger"] not in ("on", "off"):
        raise ValueError(f"ledger is {settings['ledger']!r}; it must be on or off")
    if settings["law"] == "hertz" and settings["ledger"] == "on":
        raise ValueError("ledger is on; law hertz is the engine's own and needs ledger=off")
    if settings["orifice"] not in orifices():
        raise ValueError(
            f"orifice is {settings['orifice']}; there are hoppers of {', '.join(orifices())} "
            "(inputs/meshes/make_hopper.py makes others)"
        )
    settings.whole("layers", 1)
    settings.number("layers", 0, 21)  # the lattice stands in the barrel
    settings.number("radius", 0, unit="m")
    settings.number("density", 0, unit="kg/m^3")
    settings.number("coefficient_of_friction", -1e-300)
    settings.number("coefficient_of_restitution", 0, 1 + 1e-12)
    settings.number("timestep", 0, unit="s")
    settings.number("temperature", 0, unit="m^2/s^2")
    settings.number("settling", 0, unit="s")
    settings.number("duration", 0)
    settings.number("seed", -inf)
    settings.whole("frames", 0)
    rows, checkpoints = settings.whole("rows", 1), settings.whole("checkpoints", 1)
    if rows % checkpoints:
        raise ValueError(f"checkpoints is {checkpoints}; it must divide rows, {rows}")


def analyse(settings: Settings, series: pd.DataFrame) -> Analysis:
    discharge = discharge_of(settings, series)
    missing = series["held"] + series["counted"] - series["atoms"].iloc[0]
    checks = [
        Check(
            "grains neither in the hopper nor counted out",
            missing.abs().max(),
            0,
            "the mesh keeps those that do not pass the orifice",
        )
    ]
    figures = {"hopper": discharge_figure(series, discharge, grain_mass(settings))}
    if settings["ledger"] == "on":
        checks += ledger_checks(series)
        figures["ledger"] = ledger_figure(series)
    if discharge:
        low, high = discharge.band
        checks.append(
            Check(
                "discharge rate beyond Beverloo's law, over the nearer edge of its band",
                max(low / discharge.rate, discharge.rate / high),
                1,
                "experiments with spheres scatter: C 0.55 to 0.65, k 1 to 2",
            )
        )
    return Analysis(series, checks, figures)
