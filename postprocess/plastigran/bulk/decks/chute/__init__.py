# SPDX-License-Identifier: GPL-2.0-or-later
"""Deck chute: steady flow down an incline, its power balance and Bagnold's velocity profile."""

from __future__ import annotations

from math import cos, radians, sin
from typing import ClassVar

import attrs
import numpy as np
import pandas as pd
from scipy.integrate import cumulative_trapezoid

from plastigran.bulk.checks import Check, count_check, dissipated, trapezia_factor
from plastigran.bulk.deck import Analysis, Brief, FlowDeck
from plastigran.bulk.decks.chute.figure import chute_figure
from plastigran.declared import number, whole
from plastigran.engine.dumps import read_dump
from plastigran.physics.bagnold import Profile, fit_profile

#: Largest allowed relative error of the work of gravity, if the time between log lines is at most
#: FINE_ROWS (plastigran.bulk.checks).
WEIGHT = 2e-3
#: Largest allowed relative difference between the dissipated power and the power of gravity. The
#: flow stores the difference, mainly as kinetic energy.
STEADY = 0.05
#: Largest allowed root-mean-square deviation from Bagnold's profile, divided by the surface speed.
PROFILE = 0.05

#: Settings of a short run with few grains, for tests.
BRIEF = {"length": 4, "width": 3, "depth": 6, "start_speed": 0.9, "angle": 26}
BRIEF |= {"duration": 0.06, "settling": 0, "rows": 12, "checkpoints": 4}


@attrs.frozen(kw_only=True)
class Chute(FlowDeck):
    """Flow of grains down a rough chute, periodic along and across the flow."""

    briefs: ClassVar = {"": Brief(BRIEF, start={"duration": 0.012})}

    angle: float = number("angle of the chute", "degrees", 0, 90)
    length: int = whole("length along the flow, in cells of two grains", 3)
    width: int = whole("width across the flow, in cells of two grains", 3)
    depth: int = whole("depth of the flow, in cells of two grains", 3)
    start_speed: float = number(
        "initial speed at the surface of a flow with Bagnold's profile",
        "m/s",
        0,
        lower_allowed=True,
    )
    size_spread: float = number(
        "fraction by which half of the grains are smaller than radius, and half are larger",
        "-",
        0,
        0.3,
        True,
        True,
    )

    def analyse(self, series: pd.DataFrame) -> Analysis:
        """Analyse velocity profile and power of the flow; arguments as for `BulkDeck.analyse`."""
        series = self.with_weight(series)
        steady = series[series["time"] >= self.settling]
        grains = read_dump(self.output / "grains.dump")
        grains = grains[grains["step"] >= steady["step"].iloc[0]]
        profile = fit_profile(grains, 2 * self.radius)
        checks = [count_check(series, self.derived("grains")), *flow_checks(steady, profile)]
        if self.ledger == "on":
            checks += [*self.ledger_checks(series), *self.power_checks(series, steady)]
        figure = chute_figure(series, grains, profile, self.settling)
        return Analysis(series, checks, {"chute": figure, **self.ledger_figure(series)})

    def with_weight(self, series: pd.DataFrame) -> pd.DataFrame:
        """Add the predicted potential energy and the power of the weight to a series.

        Args:
            series: Columns time [s], mass of the grains [kg], z and speed. z is the distance of the
                center of mass from the base [m]; speed is its velocity along the chute [m/s].

        Returns:
            The series with two further columns: `gravity_predicted`, the change of potential energy
            since the first row [J], and `weight_power`, m g v sin(angle) [W].
        """
        angle, weight = radians(self.angle), self.gravitational_acceleration * series["mass"]
        along = cumulative_trapezoid(series["speed"], series["time"], initial=0)
        up = series["z"] - series["z"].iloc[0]
        return series.assign(
            gravity_predicted=weight * (cos(angle) * up - sin(angle) * along),
            weight_power=weight * sin(angle) * series["speed"],
        )

    def power_checks(self, series: pd.DataFrame, steady: pd.DataFrame) -> list[Check]:
        """Check the work of gravity, and compare the power of gravity with the dissipated power.

        Args:
            series: Columns time [s], gravity and gravity_predicted [J].
            steady: Rows after settling, with time [s], weight_power [W], plastic, friction and
                viscous [J].
        """
        trapezia = trapezia_factor(series["time"], 2 * self.radius, self.gravitational_acceleration)
        work = series["gravity"].iloc[0] - series["gravity"]
        from scipy.stats import linregress  # imported here: scipy.stats is slow

        power = linregress(steady["time"], dissipated(steady)).slope
        return [
            Check(
                "relative difference between work of gravity and the work on the center of mass",
                (work + series["gravity_predicted"]).abs().max() / work.abs().max(),
                WEIGHT * trapezia,
                "limit: error of integrating the mean velocity over the lines of the log",
            ),
            Check(
                "relative difference between power of the weight and dissipated power",
                abs(power / steady["weight_power"].mean() - 1),
                STEADY,
                "in steady flow, friction and yielding dissipate the power of gravity",
            ),
        ]


def flow_checks(steady: pd.DataFrame, profile: Profile) -> list[Check]:
    """Check that the flow does not stop and that it has Bagnold's velocity profile.

    Args:
        steady: Rows after settling, with the column speed [m/s].
        profile: Velocity profile after settling.
    """
    smallest = steady["speed"].min()
    return [
        Check(
            "mean speed / smallest speed of the flow",
            steady["speed"].mean() / smallest if smallest > 0 else np.inf,
            3,
            "a flow that stops has no steady speed",
        ),
        Check(
            "deviation from Bagnold's profile / speed at the surface",
            profile.residual,
            PROFILE,
            "root mean square deviation; the profile holds for a dense flow of many layers",
        ),
    ]
