# SPDX-License-Identifier: GPL-2.0-or-later
"""The freely cooling gas, held against the mean field of its law's own restitution."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import pandas as pd

from plastigran import laws
from plastigran.bulk.checks import count_check, ledger_checks
from plastigran.bulk.decks import Analysis, Check
from plastigran.bulk.decks.cooling_gas.figure import cooling_figure
from plastigran.bulk.grains import Grains, read_grains, read_options
from plastigran.bulk.settings import check_course
from plastigran.engine.deck import Settings
from plastigran.physics import central
from plastigran.physics.kinetic_theory import FREEZING, Gas, cool, law_restitution
from plastigran.plot.ledger import ledger_figure
from plastigran.plot.style import title

#: What mean field itself may be off by: up to 7 % was found (docs/decks/cooling_gas.md).
MEAN_FIELD = 0.08
#: Statistical standard deviations allowed.
DEVIATIONS = 4
#: They say when it ends and where lines of the log and checkpoints are.
CONTINUABLE = frozenset({"duration", "rows", "checkpoints"})
#: The model's settings that leave the restitution alone, beside the law's options.
HARMLESS = ("tangential_damping", "energy_ledger", "overlap_limit")


@dataclass(frozen=True)
class Case:
    """A run's grains and what theory needs of them.

    Attributes:
        grains: Size, material and law.
        volume_fraction: [-].
        temperature: Granular temperature at step 0 [m^2/s^2].
        count: Grains.
    """

    grains: Grains
    volume_fraction: float
    temperature: float
    count: int

    @property
    def stall(self) -> float | None:
        """v_Y^2 [m^2/s^2], v_Y the yield speed of two grains; None for a law without yield."""
        speed = self.grains.yield_speed
        return None if speed is None else speed**2

    def gas(self) -> Gas:
        """The grains with the law's restitution, from impacts too slow to matter to the fastest."""
        grains, thermal = self.grains, self.temperature**0.5
        speeds = (1e-4 * thermal, 20 * thermal)
        restitution = law_restitution(grains.contact_law(), grains.radius, grains.mass, speeds)
        return Gas(grains.radius, self.volume_fraction, restitution, self.count)


def read_case(settings: Settings) -> Case:
    """The case of a deck's settings. Raises ValueError naming one out of range."""
    grains = read_grains(settings)
    for name, choice in read_options(settings).items():
        if name not in grains.options and name not in HARMLESS and choice != "off":
            known = sorted({*(o["name"] for o in laws.LAWS[grains.law].options()), *HARMLESS})
            raise ValueError(
                f"options: {name} {choice} changes the restitution or is unknown; {grains.law} "
                f"takes {', '.join(known)}"
            )
    return Case(
        grains,
        settings.number("volume_fraction", 0, FREEZING),
        settings.number("temperature", 0, unit="m^2/s^2"),
        settings.whole("side", 3) ** 3,
    )


def check_settings(settings: Settings) -> None:
    read_case(settings)
    settings.number("mixing", 0)
    settings.number("duration", 0)
    check_course(settings)


def analyse(settings: Settings, series: pd.DataFrame) -> Analysis:
    case = read_case(settings)
    # Without drift N grains have 3(N - 1) free velocities.
    scale = 2 / (3 * (case.count - 1) * case.grains.mass)
    series = series.assign(temperature=scale * series["kinetic_energy"])
    gas = case.gas()
    predicted = cool(gas, case.temperature, series["time"])
    series["temperature_predicted"] = predicted["temperature"]
    series["temperature_error"] = predicted["temperature_error"]
    series["collisions"] = predicted["collisions"]
    ratio = series["temperature"] / series["temperature_predicted"] - 1
    cooling_rate = gas.cooling_rate(case.temperature)
    elastic = gas.loss(case.temperature) < 1e-9
    stored = stored_share(case, gas)
    tolerance = stored + (not elastic) * MEAN_FIELD + DEVIATIONS * series["temperature_error"]
    checks = [
        count_check(series, case.count),
        Check(
            "mean velocity of the gas over its thermal speed",
            (series["flow"] / series["temperature"] ** 0.5).max(),
            1e-9,
            "impacts conserve momentum, to rounding",
        ),
        Check(
            "temperature gained, of that at the start",
            (series["temperature"] - series["temperature"].cummin()).max() / case.temperature,
            stored,
            "energy only moves in and out of impacts under way",
        ),
        Check(
            "temperature against mean field, relative, in tolerances",
            (abs(ratio) / tolerance).max(),
            1,
            f"{MEAN_FIELD:g} for mean field, {DEVIATIONS} standard deviations of {case.count} "
            "grains",
        ),
        *ledger_checks(settings, series),
    ]
    course = cooling_figure({title(case.grains.law): series}, case.stall, cooling_rate)
    figures = {"cooling_gas": course}
    if settings["ledger"] == "on":
        figures["ledger"] = ledger_figure(series)
    return Analysis(series, checks, figures)


def stored_share(case: Case, gas: Gas) -> float:
    """Bound on the share of the kinetic energy that impacts under way store at the start [-].

    Of N grains N s/2 pairs touch, s the collision rate times the elastic duration of the mean
    impact. Each took m g^2/4 of 3/2 N m T, exponentially distributed about m T, and stores half of
    it or so: in the mean s/6, with a standard deviation of s^(1/2)/(3 N^(1/2)).
    """
    grains = case.grains
    modulus, speed = grains.pair.youngs_modulus_eff, (pi * case.temperature) ** 0.5
    duration = central.hertz_duration(grains.radius / 2, grains.mass / 2, modulus, speed)
    touching = float(duration * gas.collision_rate(case.temperature))
    return touching / 6 + DEVIATIONS * (touching / case.count) ** 0.5 / 3
