# SPDX-License-Identifier: GPL-2.0-or-later
"""Deck bed_impact: spheres (shots) hit a plate, as a test of the law, or a bed of grains."""

from __future__ import annotations

from typing import ClassVar

import attrs
import numpy as np
import pandas as pd

from plastigran.bulk.checks import Check, count_check, since_first
from plastigran.bulk.deck import Analysis, Brief, GranularDeck
from plastigran.bulk.decks.bed_impact.figure import bed_figure, plate_figure
from plastigran.bulk.decks.bed_impact.measurement import (
    measure_shots,
    plastic_work_by_depth,
    read_grains_dump,
)
from plastigran.declared import number, require, whole, word

#: Largest allowed relative error of restitution, rebound speed and dissipated energy. The time
#: integration has at most this error if the time step is adequate.
INTEGRATOR = 1e-3
#: Largest allowed relative difference between the plastic work of the energy balance and its sum
#: over the grains. The two may differ only by the plastic work of the last step of pouring.
STEP = 1e-4
#: Required values of settings for the target `plate`. With them, each shot hits the plate once,
#: without gravity and without contact with other shots.
PLATE = {"shot_layers": 1, "gravitational_acceleration": 0, "bed_layers": 0, "filling": 0}


@attrs.frozen(kw_only=True)
class BedImpact(GranularDeck):
    """Shots on a target: each shot hits a plate once, or a stream of shots hits a bed of grains."""

    briefs: ClassVar = {
        "plate": Brief(
            {"side": 6, "slowest": 0.1, "duration": 0.02, "rows": 40},
            start={"duration": 0.004},
            restart=0,
        ),
        "bed": Brief(
            {"target": "bed", "side": 4, "shot_layers": 1, "bed_layers": 5, "duration": 0.02}
            | {"rows": 40},
            start={"filling": 0.002, "duration": 0.002},
            # Impacts in the bed amplify round-off, so continued runs agree only to this tolerance.
            restart=1e-6,
        ),
    }

    target: str = word("target of the shots", ("plate", "bed"))
    side: int = whole("number of shots along each side", 2)
    shot_layers: int = whole("number of layers of shots", 1)
    slowest: float = number("speed of the slowest shot", "m/s", 0)
    fastest: float = number("speed of the fastest shot", "m/s", 0)
    duration: float = number("duration from the start of the shots", "s", 0)
    bed_layers: int = whole("layers of poured grains, on a cubic lattice", 0)
    filling: float = number("time for the bed to come to rest", "s", 0, lower_allowed=True)
    gravitational_acceleration: float = number(
        "downward acceleration", "m/s^2", 0, lower_allowed=True
    )

    def check(self) -> None:
        require(self, "fastest", lower=self.slowest)
        if self.ledger != "on":
            raise ValueError(
                "ledger is off, but this deck measures plastic work with the energy balance. Set "
                "ledger=on"
            )
        if self.target == "plate":
            self._check_plate()
        else:
            require(self, "bed_layers", lower=1)
            for name in ("filling", "gravitational_acceleration"):
                require(self, name, lower_allowed=False)
        GranularDeck.check(self)

    def _check_plate(self) -> None:
        for name, needed in PLATE.items():
            if (value := getattr(self, name)) != needed:
                raise ValueError(f"{name} is {value:g}; it must be {needed} for target plate")
        for name, choice in self.model_options.items():
            if name not in self.grains.options and choice != "off":
                raise ValueError(
                    f"options: {name} {choice} changes the restitution or is "
                    "unknown. Remove it for target plate"
                )

    def shots(self, grains: pd.DataFrame) -> pd.DataFrame:
        """Return the measured speeds and the predicted rebound speed of each shot [m/s].

        The law predicts the rebound speed for a central impact on a plate.

        Args:
            grains: Table of `read_grains_dump`; the rows of the bed come first, then the rows of
                the shots.
        """
        shot = measure_shots(
            grains.iloc[int(self.derived("bed")) :], self.radius, self.gravitational_acceleration
        )
        speed = shot["impact_speed"].to_numpy()
        impact = self.grains.contact_law().central_impact(self.radius, self.grains.mass, speed)
        return shot.assign(rebound_predicted=speed * impact.coefficient_of_restitution)

    def analyse(self, series: pd.DataFrame) -> Analysis:
        """Analyse the run from the start of the shots; arguments as for `BulkDeck.analyse`."""
        table = since_first(series)  # count time and energies from the start of the shots
        grains = read_grains_dump(self.output / "grains.dump")
        shot = self.shots(grains)
        sum_over_grains, total = grains["plastic_work"].sum(), table["plastic"].iloc[-1]
        checks = [
            count_check(table, self.derived("grains")),
            *self.ledger_checks(table),
            Check(
                "difference between the plastic work of the grains and of the energy balance",
                abs(sum_over_grains - total) / max(total, 1e-300),
                STEP,
                "limit: plastic work of one time step of pouring; otherwise, both sums contain "
                "the same work",
            ),
        ]
        if self.target == "plate":
            checks += plate_checks(shot, self.grains.mass, table["plastic"] + table["viscous"])
            figure = plate_figure(shot)
        else:
            lowest_shot = grains["z_before"].iloc[int(self.derived("bed")) :].min()
            diameter = 2 * self.radius
            by_depth = plastic_work_by_depth(grains, lowest_shot - diameter, diameter)
            figure = bed_figure(shot, by_depth, diameter)
        return Analysis(table, checks, {"bed_impact": figure, **self.ledger_figure(table)})


def plate_checks(shot: pd.DataFrame, mass: float, dissipated: pd.Series) -> list[Check]:
    """Compare the shots with central impacts of the law: rebound speeds and dissipated energy.

    Args:
        shot: Columns of `measure_shots`, and `rebound_predicted` [m/s].
        mass: Mass of a shot [kg].
        dissipated: Energy dissipated by yielding and viscous damping since the start of
            the shots [J], one value per log line.
    """
    predicted, impact = shot["rebound_predicted"], shot["impact_speed"]
    quantiles = np.sort(shot["rebound_speed"]) - np.sort(predicted)
    lost = 0.5 * mass * (impact**2 - predicted**2).sum()
    reason = "limit: error of the integrator at an adequate time step"
    return [
        Check(
            "shots that have not left the plate",
            (shot["rebound_speed"] <= 0).sum(),
            0,
            "all shots hit and rebound in time; otherwise raise duration",
        ),
        Check(
            "difference between the restitution of a shot and that of the law, relative",
            (shot["rebound_speed"] / predicted - 1).abs().max(),
            INTEGRATOR,
            reason,
        ),
        Check(
            "difference of rebound speeds (quantiles) from the law, relative to the fastest impact",
            abs(quantiles).max() / impact.max(),
            INTEGRATOR,
            reason,
        ),
        Check(
            "difference of the dissipated energy from the law, relative to the impact energy",
            abs(dissipated.iloc[-1] - lost) / (0.5 * mass * (impact**2).sum()),
            INTEGRATOR,
            reason,
        ),
    ]
