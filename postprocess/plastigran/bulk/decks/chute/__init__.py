# SPDX-License-Identifier: GPL-2.0-or-later
"""The chute: its steady flow, weight's power against dissipation, and Bagnold's profile."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, radians, sin
from pathlib import Path

import pandas as pd
from scipy.integrate import cumulative_trapezoid
from scipy.stats import linregress

from plastigran.bulk.checks import (
    count_check,
    dissipated,
    ledger_checks,
    trapezia_factor,
)
from plastigran.bulk.decks import Analysis, Check
from plastigran.bulk.decks.chute.figure import chute_figure
from plastigran.bulk.grains import Grains, read_grains
from plastigran.bulk.settings import check_contact, check_course, read_settling
from plastigran.engine.deck import Settings
from plastigran.engine.dumps import read_dump
from plastigran.physics.bagnold import Profile, fit_profile
from plastigran.plot.ledger import ledger_figure

#: Share of the weight's work it may be off the centre of mass's, with rows as close as FINE_ROWS.
WEIGHT = 2e-3
#: Share of the weight's power that the flow may keep, as motion above all.
STEADY = 0.05
#: Root mean square of what Bagnold's profile leaves over, over the speed at the surface.
PROFILE = 0.05


@dataclass(frozen=True)
class Case:
    """A run's chute.

    Attributes:
        grains: Size, material and law.
        angle: Of the chute [rad].
        gravitational_acceleration: [m/s^2].
        count: Grains, glued ones too.
        settling: Time before profile and powers are taken [s].
    """

    grains: Grains
    angle: float
    gravitational_acceleration: float
    count: int
    settling: float


def read_case(settings: Settings) -> Case:
    """The case of a deck's settings. Raises ValueError naming one out of range."""
    grains = read_grains(settings)
    cells = [settings.whole(name, 3) for name in ("length", "width", "depth")]
    return Case(
        grains,
        radians(settings.number("angle", 0, 90, unit="degrees")),
        settings.number("gravitational_acceleration", 0, unit="m/s^2"),
        2 * cells[0] * cells[1] * (cells[2] + 1),
        read_settling(settings, "s"),
    )


def check_settings(settings: Settings) -> None:
    read_case(settings)
    check_contact(settings)
    check_course(settings)
    settings.number("volume_fraction", 0, 0.64)
    settings.number("size_spread", 0, 0.3, closed=True)
    settings.number("start_speed", 0, unit="m/s", closed=True)
    settings.number("temperature", 0, unit="m^2/s^2")


def analyse(settings: Settings, series: pd.DataFrame) -> Analysis:
    case = read_case(settings)
    series = add_mechanics(series, case)
    steady = series[series["time"] >= case.settling]
    grains = read_dump(Path(settings["output"]) / "grains.dump")
    grains = grains[grains["step"] >= steady["step"].iloc[0]]
    profile = fit_profile(grains, 2 * case.grains.radius)
    checks = [count_check(series, case.count), *flow_checks(steady, profile)]
    figures = {"chute": chute_figure(series, grains, profile, case.settling)}
    if settings["ledger"] == "on":
        checks += [*ledger_checks(settings, series), *power_checks(case, series, steady)]
        figures["ledger"] = ledger_figure(series)
    return Analysis(series, checks, figures)


def add_mechanics(series: pd.DataFrame, case: Case) -> pd.DataFrame:
    """What weight does, from the motion of the flow's centre of mass.

    Args:
        series: Columns time [s], mass [kg], z [m] and speed [m/s] of its centre.
        case: The chute.

    Returns:
        The series with `gravity_predicted` [J], the change of the flow's potential energy, and
        `weight_power` [W], m g v sin(angle).
    """
    weight = case.gravitational_acceleration * series["mass"]
    along = cumulative_trapezoid(series["speed"], series["time"], initial=0)
    up = series["z"] - series["z"].iloc[0]
    return series.assign(
        gravity_predicted=weight * (cos(case.angle) * up - sin(case.angle) * along),
        weight_power=weight * sin(case.angle) * series["speed"],
    )


def flow_checks(steady: pd.DataFrame, profile: Profile) -> list[Check]:
    """The flow goes on, with Bagnold's profile.

    Args:
        steady: Column speed [m/s], after settling.
        profile: Of that time.
    """
    return [
        Check(
            "mean over least speed of the flow",
            steady["speed"].mean() / max(steady["speed"].min(), 1e-12),
            3,
            "a flow that stops has no steady speed",
        ),
        Check(
            "speed off Bagnold's profile, over the speed at the surface",
            profile.residual,
            PROFILE,
            "root mean square; the profile is of a dense flow deeper than its layers",
        ),
    ]


def power_checks(case: Case, series: pd.DataFrame, steady: pd.DataFrame) -> list[Check]:
    """Weight's work against speed and height, and its power against what the flow dissipates.

    Args:
        case: The chute.
        series: Columns time [s], gravity and gravity_predicted [J].
        steady: Rows after settling, with time [s], weight_power [W], plastic, friction and viscous
            [J].
    """
    trapezia = trapezia_factor(
        series["time"], 2 * case.grains.radius, case.gravitational_acceleration
    )
    given = series["gravity"].iloc[0] - series["gravity"]
    power = linregress(steady["time"], dissipated(steady)).slope
    return [
        Check(
            "weight's work off that of the centre of mass, over the work",
            (given + series["gravity_predicted"]).abs().max() / given.abs().max(),
            WEIGHT * trapezia,
            "m g (v sin(angle) t - z cos(angle)), integrated over lines of the log",
        ),
        Check(
            "power of the weight off what the flow dissipates, over the power",
            abs(power / steady["weight_power"].mean() - 1),
            STEADY,
            "in steady flow m g v sin(angle) goes into friction and yielding",
        ),
    ]
