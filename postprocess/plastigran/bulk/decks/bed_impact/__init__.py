# SPDX-License-Identifier: GPL-2.0-or-later
"""Shot on a plate, held against the law's own central impact, or on a bed."""

from __future__ import annotations

from math import floor, inf
from pathlib import Path

import numpy as np
import pandas as pd

from plastigran.bulk.checks import count_check, ledger_checks, since_first
from plastigran.bulk.decks import Analysis, Check
from plastigran.bulk.decks.bed_impact.figure import bed_figure, plate_figure
from plastigran.bulk.decks.bed_impact.measurement import (
    measure_shots,
    plastic_work_by_depth,
    predicted_rebound,
    read_grains_dump,
)
from plastigran.bulk.grains import Grains, read_grains, read_options
from plastigran.bulk.settings import check_contact, check_course
from plastigran.engine.deck import Settings
from plastigran.plot.ledger import ledger_figure

#: Error of the integrator at a sound time step: restitution, rebound speed and plastic work.
INTEGRATOR = 1e-3
#: Plastic work of a last step of pouring, over that of the shot.
STEP = 1e-4


def check_settings(settings: Settings) -> None:
    grains = read_grains(settings)
    check_contact(settings)
    check_course(settings)
    if settings["ledger"] != "on":
        raise ValueError("ledger is off; the plastic work of grains is part of it: set ledger=on")
    settings.whole("side", 2)
    settings.whole("shot_layers", 1)
    slowest = settings.number("slowest", 0, unit="m/s")
    settings.number("fastest", slowest, unit="m/s")
    settings.number("duration", 0, unit="s")
    if settings["target"] == "plate":
        check_plate(settings, grains)
    else:
        settings.whole("bed_layers", 1)
        settings.number("filling", 0, unit="s")
        settings.number("gravitational_acceleration", 0, unit="m/s^2")


def check_plate(settings: Settings, grains: Grains) -> None:
    """What the closed form takes. Raises ValueError for what it does not."""
    for name, needed in {
        "shot_layers": 1,
        "gravitational_acceleration": 0,
        "bed_layers": 0,
        "filling": 0,
    }.items():
        if settings.number(name, -inf) != needed:
            raise ValueError(f"{name} is {settings[name]}; it must be {needed} for target plate")
    for name, choice in read_options(settings).items():
        if name not in grains.options and choice != "off":
            raise ValueError(f"options: {name} {choice} changes the restitution or is unknown")


def analyse(settings: Settings, series: pd.DataFrame) -> Analysis:
    grains = read_grains(settings)
    table = since_first(series)  # which is when the shot begins
    everything = read_grains_dump(Path(settings["output"]) / "grains.dump")
    bed = bed_count(settings)
    gravitational_acceleration = float(settings["gravitational_acceleration"])
    shot = measure_shots(everything.iloc[bed:], grains.radius, gravitational_acceleration)
    shot["rebound_predicted"] = predicted_rebound(
        grains.contact_law(), grains.radius, grains.mass, shot["impact_speed"]
    )
    of_grains, in_all = everything["plastic_work"].sum(), table["plastic"].iloc[-1]
    checks = [
        count_check(table, bed + int(settings["side"]) ** 2 * int(settings["shot_layers"])),
        *ledger_checks(settings, table),
        Check(
            "plastic work of the grains against the ledger's, relative",
            abs(of_grains - in_all) / max(in_all, 1e-300),
            STEP,
            "the same work, summed by grain and in all but for a step of the pouring",
        ),
    ]
    if settings["target"] == "plate":
        checks += plate_checks(shot, grains.mass, table["plastic"] + table["viscous"])
        figure = plate_figure(shot)
    else:
        surface = everything["z_before"].iloc[bed:].min() - 2 * grains.radius
        by_depth = plastic_work_by_depth(everything, surface, 2 * grains.radius)
        figure = bed_figure(shot, by_depth, 2 * grains.radius)
    return Analysis(table, checks, {"bed_impact": figure, "ledger": ledger_figure(table)})


def bed_count(settings: Settings) -> int:
    """Grains of the bed, which were there before the shot: 0 for a plate."""
    if settings["target"] == "plate":
        return 0
    # In radii; the deck rounds the same quotient.
    across = floor(3 * int(settings["side"]) / 2.04)
    return across**2 * int(settings["bed_layers"])


def plate_checks(shot: pd.DataFrame, mass: float, dissipated: pd.Series) -> list[Check]:
    """Every shot against its own central impact, and all of them together.

    Args:
        shot: Columns of `measure_shots`, and `rebound_predicted` [m/s].
        mass: Of a shot [kg].
        dissipated: By yielding and viscosity so far, in all [J].
    """
    predicted, impact = shot["rebound_predicted"], shot["impact_speed"]
    quantiles = np.sort(shot["rebound_speed"]) - np.sort(predicted)
    lost = 0.5 * mass * (impact**2 - predicted**2).sum()
    reason = "the integrator's error at a sound time step"
    return [
        Check(
            "shots that have not left the plate",
            (shot["rebound_speed"] <= 0).sum(),
            0,
            "all hit and rebound in time; else raise duration",
        ),
        Check(
            "restitution of a shot against the law's, relative",
            (shot["rebound_speed"] / predicted - 1).abs().max(),
            INTEGRATOR,
            reason,
        ),
        Check(
            "quantiles of rebound speed against the image of the impacts', over the fastest",
            abs(quantiles).max() / impact.max(),
            INTEGRATOR,
            reason,
        ),
        Check(
            "energy dissipated against what the law's impacts lose, over the energy of impact",
            abs(dissipated.iloc[-1] - lost) / (0.5 * mass * (impact**2).sum()),
            INTEGRATOR,
            reason,
        ),
    ]
