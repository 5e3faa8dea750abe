# SPDX-License-Identifier: GPL-2.0-or-later
"""Die compaction: the pressure-density loop, the punch's work, Heckel's line."""

from __future__ import annotations

from math import pi

import numpy as np
import pandas as pd

from plastigran.bulk.checks import count_check, ledger_checks, since_first
from plastigran.bulk.decks import Analysis, Check
from plastigran.bulk.decks.compaction.figure import compaction_figure
from plastigran.bulk.grains import read_grains
from plastigran.bulk.settings import check_contact, check_course
from plastigran.engine.deck import Settings
from plastigran.physics.heckel import (
    TOUCH,
    Loop,
    measure_loop,
    punch_work,
)
from plastigran.plot.ledger import ledger_figure
from plastigran.plot.style import title

#: What the sum over a hundred rows of the log may miss of the punch's work; trapezia of half the
#: width miss a quarter.
HUNDRED_ROWS = 2e-3
#: Kinetic over elastic energy of a quasi-static stroke, at most.
SLOW = 0.02
#: Share of the peak pressure above which the grains are a loaded bed.
LOADED = 0.2


def check_settings(settings: Settings) -> None:
    grains = read_grains(settings)
    check_contact(settings)
    check_course(settings)
    settings.number("die_radius", 4 * grains.radius, unit="m")
    settings.whole("layers", 3)
    # Spheres stand at 0.5236 on the lattice; pressed flat they fill the die.
    settings.number("relative_density", 0.5236, 1)
    settings.number("release", 0, 1 + 1e-12)
    for name in ("duration", "filling"):
        settings.number(name, 0, unit="s")
    settings.number("gravitational_acceleration", 0, unit="m/s^2")


def analyse(settings: Settings, series: pd.DataFrame) -> Analysis:
    table = stroke(settings, series)
    loop = measure_loop(table["relative_density"], table["pressure"])
    checks = [
        count_check(table, poured(settings)),
        Check(
            "pressure left at the end, over its peak",
            table["pressure"].iloc[-1] / loop.pressure,
            TOUCH,
            "the punch has left the grains; raise release",
        ),
    ]
    strength = settings.number("yield_strength", 0, unit="Pa")
    figures = {"compaction": compaction_figure({title(settings["law"]): table}, [strength])}
    if settings["ledger"] == "on":
        checks += [*ledger_checks(settings, table), *energy_checks(table, loop)]
        figures["ledger"] = ledger_figure(table)
    return Analysis(table, checks, figures)


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


def poured(settings: Settings) -> int:
    """Grains of the lattice that find place in the die."""
    radius, die_radius = float(settings["radius"]), float(settings["die_radius"])
    spacing = 2.04 * radius
    reach = int(die_radius / spacing) + 1
    x, y = np.meshgrid(*[(np.arange(-reach, reach) + 0.5) * spacing] * 2)
    return int(np.sum(np.hypot(x, y) <= die_radius - radius)) * int(settings["layers"])


def stroke(settings: Settings, series: pd.DataFrame) -> pd.DataFrame:
    """The log of the stroke, with what is measured of it.

    Returns:
        The log with `time` [s] and the ledger from the stroke's start, and relative_density [-],
        pressure [Pa], punch_work [J], and heckel, ln(1/(1 - relative density)) [-].
    """
    radius, die_radius = float(settings["radius"]), float(settings["die_radius"])
    table = since_first(series)
    area, solid = pi * die_radius**2, table["atoms"] * 4 / 3 * pi * radius**3
    table["relative_density"] = solid / (area * table["height"])
    table["pressure"] = table["force"] / area
    table["punch_work"] = punch_work(table["height"], table["force"])
    return table
