# SPDX-License-Identifier: GPL-2.0-or-later
"""Deck cooling_gas: freely cooling granular gas, compared with mean-field theory."""

from __future__ import annotations

from math import pi
from typing import ClassVar

import attrs
import pandas as pd

from plastigran import laws
from plastigran.bulk.checks import Check, count_check
from plastigran.bulk.deck import Analysis, Brief, BulkDeck
from plastigran.bulk.decks.cooling_gas.figure import cooling_figure
from plastigran.bulk.settings import continuable
from plastigran.declared import number, whole
from plastigran.physics import central
from plastigran.physics.kinetic_theory import FREEZING, Gas, cool, law_restitution
from plastigran.plot.style import title

#: Largest allowed relative error of mean-field theory. The largest measured error is 7 %
#: (docs/decks/cooling_gas.md).
MEAN_FIELD = 0.08
#: Largest allowed statistical deviation of the temperature, in standard deviations.
DEVIATIONS = 4
#: Further model options that are allowed, because they do not change the restitution.
HARMLESS = ("tangential_damping", "energy_ledger", "overlap_limit")

#: Settings of a short run with few grains, for tests.
BRIEF = {"side": 6, "duration": 40, "rows": 40, "checkpoints": 4}


@attrs.frozen(kw_only=True)
class CoolingGas(BulkDeck):
    """Gas of smooth spheres in a periodic box, which cools by inelastic impacts."""

    briefs: ClassVar = {
        "": Brief(
            BRIEF,
            start={"side": 4, "mixing": 0.1, "duration": 1.5, "rows": 6, "checkpoints": 1},
            restart=0,
        )
    }

    side: int = whole("number of grains along a side of the box", 3)
    volume_fraction: float = number("volume fraction of the grains", "-", 0, FREEZING)
    temperature: float = number("initial variance of each velocity component", "m^2/s^2", 0)
    mixing: float = number("elastic impacts per grain before the measurement", "-", 0)
    # A continued run may change these settings, so that it ends later or has more log lines.
    duration: float = continuable(
        number("duration / mean time between impacts of a grain at the start", "-", 0)
    )
    rows: int = continuable(whole("number of log lines", 1))
    checkpoints: int = continuable(
        whole("number of restart files; the setting `rows` must be a multiple of it", 1)
    )

    def check(self) -> None:
        for name, choice in self.model_options.items():
            if name not in self.grains.options and name not in HARMLESS and choice != "off":
                names = sorted({*(o["name"] for o in laws.LAWS[self.law].options()), *HARMLESS})
                raise ValueError(
                    f"options: {name} {choice} changes the restitution or is unknown. "
                    f"Allowed with {self.law}: {', '.join(names)}"
                )
        BulkDeck.check(self)

    @property
    def count(self) -> int:
        """Number of grains."""
        return self.side**3

    @property
    def stall(self) -> float | None:
        """Square of the yield speed of two grains [m^2/s^2]; None for a law without yield."""
        speed = self.grains.yield_speed
        return None if speed is None else speed**2

    def gas(self) -> Gas:
        """Return the gas, with the restitution of the law tabulated for all relevant speeds."""
        grains, thermal = self.grains, self.temperature**0.5
        speeds = (1e-4 * thermal, 20 * thermal)
        restitution = law_restitution(grains.contact_law(), grains.radius, grains.mass, speeds)
        return Gas(grains.radius, self.volume_fraction, restitution, self.count)

    def analyse(self, series: pd.DataFrame) -> Analysis:
        """Compare the temperature with mean-field theory; arguments as for `BulkDeck.analyse`."""
        # N grains with zero mean velocity have 3(N - 1) independent velocity components.
        scale = 2 / (3 * (self.count - 1) * self.grains.mass)
        series = series.assign(temperature=scale * series["kinetic_energy"])
        gas = self.gas()
        predicted = cool(gas, self.temperature, series["time"])
        series["temperature_predicted"] = predicted["temperature"]
        series = series.assign(**predicted[["temperature_error", "collisions"]])
        ratio = series["temperature"] / series["temperature_predicted"] - 1
        elastic = gas.loss(self.temperature) < 1e-9
        stored = self.stored_share(gas)
        tolerance = stored + (not elastic) * MEAN_FIELD + DEVIATIONS * series["temperature_error"]
        gained = (series["temperature"] - series["temperature"].cummin()).max()
        checks = [
            count_check(series, self.count),
            Check(
                "mean velocity of the gas / thermal speed",
                (series["flow"] / series["temperature"] ** 0.5).max(),
                1e-9,
                "impacts conserve momentum, to round-off",
            ),
            Check(
                "temperature gained / initial temperature",
                gained / self.temperature,
                stored,
                "kinetic energy can increase only by the elastic energy of impacts in progress",
            ),
            Check(
                "relative difference of temperature from mean-field theory / tolerance",
                (abs(ratio) / tolerance).max(),
                1,
                f"tolerance: {MEAN_FIELD:g} for mean-field theory, plus {DEVIATIONS} standard "
                f"deviations of {self.count} grains",
            ),
            *self.ledger_checks(series),
        ]
        cooling_rate = gas.cooling_rate(self.temperature)
        course = cooling_figure({title(self.law): series}, self.stall, cooling_rate)
        return Analysis(series, checks, {"cooling_gas": course, **self.ledger_figure(series)})

    def stored_share(self, gas: Gas) -> float:
        """Return an upper bound of the elastic energy / kinetic energy at the start [-].

        At a given time, N s/2 pairs of the N grains are in contact. s is the collision rate of a
        grain times the duration of an elastic impact at the mean speed. An impact at the closing
        speed g has the energy m g^2/4, with the mass m of a grain. This energy is exponentially
        distributed with mean m T, where T is the granular temperature. About half of the energy is
        stored at a given time. The total kinetic energy is 3/2 N m T. The mean fraction is
        therefore s/6, with a standard deviation of s^(1/2)/(3 N^(1/2)). The bound adds `DEVIATIONS`
        standard deviations to the mean.
        """
        grains = self.grains
        modulus, speed = grains.pair.youngs_modulus_eff, (pi * self.temperature) ** 0.5
        duration = central.hertz_duration(grains.radius / 2, grains.mass / 2, modulus, speed)
        touching = float(duration * gas.collision_rate(self.temperature))
        return touching / 6 + DEVIATIONS * (touching / self.count) ** 0.5 / 3
