# SPDX-License-Identifier: GPL-2.0-or-later
"""Deck drum: angle of repose of a bed in a rotating drum, and work of the rotating wall."""

from __future__ import annotations

from math import atan, degrees, pi
from typing import ClassVar

import attrs
import numpy as np
import pandas as pd
from scipy.integrate import cumulative_trapezoid

from plastigran.bulk.checks import Check, count_check, dissipated, trapezia_factor
from plastigran.bulk.deck import Analysis, Brief, FlowDeck
from plastigran.bulk.decks.drum.figure import drum_figure
from plastigran.bulk.folder import SPECTRA
from plastigran.declared import number, require, word
from plastigran.engine.dumps import read_dump
from plastigran.engine.spectra import QUANTITIES, partner_spectra, read_spectra
from plastigran.plot.spectra import spectra_figure

#: Inclination at which a frictionless sphere leaves the hollow between three equal spheres
#: [degrees].
HOLLOW = degrees(atan(8**-0.5))
#: Largest allowed relative difference between the work of the wall and the work predicted from the
#: torque of gravity, if the time between log lines is at most FINE_ROWS (plastigran.bulk.checks).
#: The two works differ because friction acts on a grain half an overlap beyond the wall surface.
LEVER_ARM = 2e-3
#: Largest allowed relative difference between the work of the wall and the dissipated energy. The
#: oscillating bed stores the difference, mainly as potential energy.
STEADY = 0.05

#: Settings of a short run with few grains, for tests.
BRIEF = {"drum_radius": 0.05, "length": 0.03, "froude": 0.05, "duration": 0.05, "settling": 0}
BRIEF |= {"rows": 12, "checkpoints": 4}


@attrs.frozen(kw_only=True)
class Drum(FlowDeck):
    """Rotating drum, about half full of grains."""

    briefs: ClassVar = {"": Brief(BRIEF, start={"duration": 0.01})}

    drum_radius: float = number("radius of the shell", "m", 0)
    length: float = number("length along the axis", "m", 0)
    # At 1 and above, grains stick to the shell, because gravity is below the centrifugal force.
    froude: float = number("Froude number omega^2 R/g", "-", 0, 1)
    bed_height: float = number("initial fill level above the axis", "drum radii", -0.8, 0.8)
    duration: float = number("duration of the run", "revolutions", 0)
    settling: float = number(
        "time before the flow is measured", "revolutions", 0, lower_allowed=True
    )
    spectra: str = word("collision spectra", ("on", "off"))

    def check(self) -> None:
        largest = (1 + self.size_spread) * self.radius
        require(self, "drum_radius", lower=4 * largest)
        # The length of the shell mesh equals the drum radius.
        require(self, "length", lower=4 * largest, upper=self.drum_radius)
        if self.law == "hertz" and self.spectra == "on":
            raise ValueError(
                "spectra is on, but LIGGGHTS' own hertz has no collision spectra. Set spectra=off"
            )
        FlowDeck.check(self)

    @property
    def angular_velocity(self) -> float:
        """Angular velocity of the shell [1/s]."""
        return (self.froude * self.gravitational_acceleration / self.drum_radius) ** 0.5

    @property
    def settled(self) -> float:
        """Time at which the measurement of angle and power starts [s]."""
        return 2 * pi / self.angular_velocity * self.settling

    def analyse(self, series: pd.DataFrame) -> Analysis:
        """Analyse angle of repose and work of the wall; arguments as for `BulkDeck.analyse`."""
        series = self.with_angle(series)
        steady = series[series["time"] >= self.settled]
        dump = read_dump(self.output / "grains.dump")
        last = dump[dump["step"] == dump["step"].max()]
        checks = [count_check(series, self.derived("grains")), *self.angle_checks(steady)]
        if self.ledger == "on":
            checks += [*self.ledger_checks(series), *self.power_checks(series, steady)]
        figures = {"drum": drum_figure(series, last, self.drum_radius, self.settled)}
        if self.spectra == "on":
            table = read_spectra(self.output / SPECTRA)
            figures["collision_spectra"] = spectra_figure(
                {label: partner_spectra(table, name) for name, label in QUANTITIES.items()}
            )
        return Analysis(series, checks, {**figures, **self.ledger_figure(series)})

    def with_angle(self, series: pd.DataFrame) -> pd.DataFrame:
        """Add the revolutions, the angle of the bed and the predicted work of the wall to a series.

        Args:
            series: Columns time [s], mass of the bed [kg], coordinates x and z of its center of
                mass [m], and momentum, the angular momentum of the bed about the axis [kg m^2/s].

        Returns:
            The series with `revolutions`, `angle` and `wallwork_predicted`. The angle [degrees] is
            measured from the vertical to the line from the axis to the center of mass. The
            predicted work [J] is the work of a torque that balances the torque of gravity and
            changes the angular momentum of the bed.
        """
        torque = self.gravitational_acceleration * series["mass"] * series["x"]
        impulse = cumulative_trapezoid(torque, series["time"], initial=0)
        momentum = series["momentum"] - series["momentum"].iloc[0]
        return series.assign(
            revolutions=series["time"] / (2 * pi / self.angular_velocity),
            angle=np.degrees(np.arctan2(series["x"], -series["z"])),
            wallwork_predicted=self.angular_velocity * (impulse + momentum),
        )

    def angle_checks(self, steady: pd.DataFrame) -> list[Check]:
        """Check that the mean angle is above zero and below the largest angle that friction allows.

        Args:
            steady: Rows after settling, with the column angle [degrees].
        """
        angle = steady["angle"].mean()
        return [
            Check(
                "inclination of the bed against the direction of rotation",
                -angle,
                0,
                "the wall drags the bed, so the angle must be positive",
            ),
            Check(
                "angle of repose",
                angle,
                HOLLOW + degrees(atan(self.coefficient_of_friction)),
                "beyond this angle, grains slide out of the hollows between three other grains",
            ),
        ]

    def power_checks(self, series: pd.DataFrame, steady: pd.DataFrame) -> list[Check]:
        """Compare the work of the wall with the dissipation and with the torque of gravity.

        The comparison with the torque is omitted for decks with rolling friction, because LIGGGHTS
        computes rolling friction as if the wall did not rotate. Rolling friction then acts on the
        grains, but is missing in the work of the wall.

        Args:
            series: Columns time [s], wallwork, wallwork_predicted [J].
            steady: Rows after settling, with the further columns plastic, friction and viscous [J].
        """
        from scipy.stats import linregress  # imported here: scipy.stats is slow

        share = linregress(steady["wallwork"], dissipated(steady)).slope
        checks = [
            Check(
                "relative difference between power of the wall and dissipated power",
                abs(share - 1),
                STEADY,
                "the bed oscillates about a steady state",
            )
        ]
        if self.rolling_friction == "off":
            difference = (series["wallwork"] - series["wallwork_predicted"]).abs().max()
            trapezia = trapezia_factor(
                series["time"], 2 * self.radius, self.gravitational_acceleration
            )
            checks.append(
                Check(
                    "relative difference between the wall work and the work of the weight's torque",
                    difference / series["wallwork"].abs().max(),
                    LEVER_ARM * trapezia,
                    "limit: error of integrating the torque of gravity over the lines of the log, "
                    "plus the error of the lever arm of friction at the wall",
                )
            )
        return checks
