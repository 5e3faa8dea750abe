# SPDX-License-Identifier: GPL-2.0-or-later
"""The rotating drum: its angle of repose, and the wall's work against the weight's lever arm."""

from __future__ import annotations

from dataclasses import dataclass
from math import atan, degrees, pi
from pathlib import Path

import numpy as np
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
from plastigran.bulk.decks.drum.figure import drum_figure
from plastigran.bulk.grains import Grains, read_grains
from plastigran.bulk.settings import check_contact, check_course, read_settling
from plastigran.engine.deck import Settings
from plastigran.engine.dumps import read_dump
from plastigran.plot.ledger import ledger_figure

#: Angle at which a sphere without friction slides out of the hollow between three others [degrees].
HOLLOW = degrees(atan(8**-0.5))
#: Share of the wall's work it may differ from the lever arm's by, with rows as close as FINE_ROWS:
#: friction takes hold of a grain half an overlap beyond the wall's surface.
LEVER_ARM = 2e-3
#: Share of it that the bed may keep, as potential energy above all, while it swings.
STEADY = 0.05


@dataclass(frozen=True)
class Case:
    """A run's drum.

    Attributes:
        grains: Size, material and law.
        radius: Of the drum [m].
        angular_velocity: [1/s].
        gravitational_acceleration: [m/s^2].
        settling: Time before angle and power are taken [s].
        rolling_friction: Whether grains have it.
    """

    grains: Grains
    radius: float
    angular_velocity: float
    gravitational_acceleration: float
    settling: float
    rolling_friction: bool

    @property
    def period(self) -> float:
        """Of a revolution [s]."""
        return 2 * pi / self.angular_velocity


def read_case(settings: Settings) -> Case:
    """The case of a deck's settings. Raises ValueError naming one out of range."""
    grains = read_grains(settings)
    spread = settings.number("size_spread", 0, 0.5, closed=True)
    largest = (1 + spread) * grains.radius
    radius = settings.number("drum_radius", 4 * largest, unit="m")
    gravitational_acceleration = settings.number("gravitational_acceleration", 0, unit="m/s^2")
    settings.number("length", 4 * largest, radius, unit="m")  # the shell's is the radius
    # From 1 on weight does not bring the grains back from the top.
    angular_velocity = (
        settings.number("froude", 0, 1) * gravitational_acceleration / radius
    ) ** 0.5
    return Case(
        grains,
        radius,
        angular_velocity,
        gravitational_acceleration,
        2 * pi / angular_velocity * read_settling(settings, "revolutions"),
        settings["rolling_friction"] != "off",
    )


def check_settings(settings: Settings) -> None:
    read_case(settings)
    check_contact(settings)
    check_course(settings)
    settings.number("bed_height", -0.8, 0.8, unit="drum radii")
    settings.number("volume_fraction", 0, 0.64)
    settings.number("temperature", 0, unit="m^2/s^2")


def analyse(settings: Settings, series: pd.DataFrame) -> Analysis:
    case = read_case(settings)
    series = add_mechanics(series, case)
    steady = series[series["time"] >= case.settling]
    checks = [count_check(series, series["atoms"].iloc[0]), *angle_checks(settings, steady)]
    figures = {"drum": drum_figure(series, last_grains(settings), case.radius, case.settling)}
    if settings["ledger"] == "on":
        checks += [*ledger_checks(settings, series), *power_checks(case, series, steady)]
        figures["ledger"] = ledger_figure(series)
    return Analysis(series, checks, figures)


def add_mechanics(series: pd.DataFrame, case: Case) -> pd.DataFrame:
    """What the centre of mass says of the bed.

    Args:
        series: Columns time [s], mass [kg], x, z [m] of its centre, and momentum, the angular one
            about the axis [kg m^2/s].
        case: The drum.

    Returns:
        The series with `revolutions`; `angle`, the lean of the bed [degrees]: that of the line from
        the axis to the centre of mass, which is normal to a segment's chord; and
        `wallwork_predicted` [J]: the wall has the torque of the weight about the axis, and changes
        the bed's angular momentum, and its work is the torque's at the drum's angular velocity.
    """
    torque = case.gravitational_acceleration * series["mass"] * series["x"]
    impulse = cumulative_trapezoid(torque, series["time"], initial=0)
    momentum = series["momentum"] - series["momentum"].iloc[0]
    return series.assign(
        revolutions=series["time"] / case.period,
        angle=np.degrees(np.arctan2(series["x"], -series["z"])),
        wallwork_predicted=case.angular_velocity * (impulse + momentum),
    )


def angle_checks(settings: Settings, steady: pd.DataFrame) -> list[Check]:
    """The mean angle lies between nothing and what friction can hold.

    Args:
        settings: The deck's.
        steady: Column angle [degrees], after settling.
    """
    friction = float(settings["coefficient_of_friction"])
    angle = steady["angle"].mean()
    return [
        Check("lean of the bed against the rotation", -angle, 0, "the wall drags it along"),
        Check(
            "angle of repose",
            angle,
            HOLLOW + degrees(atan(friction)),
            "from there on grains slide out of the hollows between three others",
        ),
    ]


def power_checks(case: Case, series: pd.DataFrame, steady: pd.DataFrame) -> list[Check]:
    """The wall's work against the weight's lever arm, and against what the bed dissipates.

    Not the first with rolling friction: LIGGGHTS takes a wall's as of one that does not turn, a
    couple on the grains without any work of the wall.

    Args:
        case: The drum.
        series: Columns time [s], wallwork, wallwork_predicted [J].
        steady: Rows after settling, with plastic, friction and viscous [J] too.
    """
    share = linregress(steady["wallwork"], dissipated(steady)).slope
    checks = [
        Check(
            "power of the wall off what the bed dissipates, over the power",
            abs(share - 1),
            STEADY,
            "the bed swings about a steady state",
        )
    ]
    if not case.rolling_friction:
        missed = (series["wallwork"] - series["wallwork_predicted"]).abs().max()
        trapezia = trapezia_factor(
            series["time"], 2 * case.grains.radius, case.gravitational_acceleration
        )
        checks.append(
            Check(
                "wall work off the weight's lever arm, over the wall work",
                missed / series["wallwork"].abs().max(),
                LEVER_ARM * trapezia,
                "m g x omega and the change of angular momentum, integrated over lines of the log",
            )
        )
    return checks


def last_grains(settings: Settings) -> pd.DataFrame:
    """Grains at the end: columns x, y, z, radius [m], vx, vy, vz [m/s]."""
    dump = read_dump(Path(settings["output"]) / "grains.dump")
    return dump[dump["step"] == dump["step"].max()]
