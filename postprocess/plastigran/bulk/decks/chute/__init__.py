# SPDX-License-Identifier: GPL-2.0-or-later
"""The chute: its steady flow, weight's power against dissipation, and Bagnold's profile."""

from __future__ import annotations

from math import radians
from typing import ClassVar

import attrs
import pandas as pd
from scipy.stats import linregress

from plastigran.bulk.checks import Check, count_check, dissipated, trapezia_factor
from plastigran.bulk.deck import Analysis, Brief, FlowDeck
from plastigran.bulk.decks.chute.figure import chute_figure
from plastigran.bulk.decks.chute.measurement import add_mechanics
from plastigran.declared import number, whole
from plastigran.engine.dumps import read_dump
from plastigran.physics.bagnold import Profile, fit_profile

#: Share of the weight's work it may be off the centre of mass's, with rows as close as FINE_ROWS.
WEIGHT = 2e-3
#: Share of the weight's power that the flow may keep, as motion above all.
STEADY = 0.05
#: Root mean square of what Bagnold's profile leaves over, over the speed at the surface.
PROFILE = 0.05

#: A short run of few grains.
BRIEF = {"length": 4, "width": 3, "depth": 6, "start_speed": 0.9, "angle": 26}
BRIEF |= {"duration": 0.06, "settling": 0, "rows": 12, "checkpoints": 4}


@attrs.frozen(kw_only=True)
class Chute(FlowDeck):
    """Grains flow down a rough chute, periodic along the flow and across."""

    briefs: ClassVar = {"": Brief(BRIEF, start={"duration": 0.012})}

    angle: float = number("of the chute", "degrees", 0, 90)
    length: int = whole("along the flow, in cells of two grains", 3)
    width: int = whole("across, in cells", 3)
    depth: int = whole("of the flow, in cells", 3)
    start_speed: float = number("at the surface, with Bagnold's profile", "m/s", 0, closed=True)
    size_spread: float = number("half of the grains are so much smaller", "-", 0, 0.3, True)

    def analyse(self, series: pd.DataFrame) -> Analysis:
        """The flow's profile and powers; arguments as for `BulkDeck.analyse`."""
        series = add_mechanics(series, radians(self.angle), self.gravitational_acceleration)
        steady = series[series["time"] >= self.settling]
        grains = read_dump(self.output / "grains.dump")
        grains = grains[grains["step"] >= steady["step"].iloc[0]]
        profile = fit_profile(grains, 2 * self.radius)
        checks = [count_check(series, self.derived("grains")), *flow_checks(steady, profile)]
        if self.ledger == "on":
            checks += [*self.ledger_checks(series), *self.power_checks(series, steady)]
        figure = chute_figure(series, grains, profile, self.settling)
        return Analysis(series, checks, {"chute": figure, **self.ledger_figure(series)})

    def power_checks(self, series: pd.DataFrame, steady: pd.DataFrame) -> list[Check]:
        """Weight's work against speed and height, and its power against what the flow dissipates.

        Args:
            series: Columns time [s], gravity and gravity_predicted [J].
            steady: Rows after settling, with time [s], weight_power [W], plastic, friction and
                viscous [J].
        """
        trapezia = trapezia_factor(series["time"], 2 * self.radius, self.gravitational_acceleration)
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
