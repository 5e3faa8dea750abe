# SPDX-License-Identifier: GPL-2.0-or-later
"""The freely cooling gas, held against the mean field of its law's own restitution."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, pi

import pandas as pd

from plastigran import laws, theory
from plastigran.bulk_decks import Analysis, Check
from plastigran.cooling_figure import cooling_figure
from plastigran.deck_source import Settings
from plastigran.figures import title
from plastigran.impact import laws_for
from plastigran.kinetic_theory import FREEZING, Gas, cool, law_restitution
from plastigran.materials import Material

#: What mean field itself may be off by: up to 7 % was found (docs/decks/cooling_gas.md).
MEAN_FIELD = 0.08
#: Statistical standard deviations allowed.
DEVIATIONS = 4
#: The model's settings that leave the restitution alone, beside the law's options.
HARMLESS = ("tangential_damping", "energy_ledger")


@dataclass(frozen=True)
class Case:
    """A run's grains and what theory needs of them.

    Attributes:
        law: Name of the law.
        options: Of the law, by name.
        material: Of the grains.
        radius: [m].
        volume_fraction: [-].
        temperature: Granular temperature at step 0 [m^2/s^2].
        count: Grains.
    """

    law: str
    options: dict[str, str]
    material: Material
    radius: float
    volume_fraction: float
    temperature: float
    count: int

    @property
    def mass(self) -> float:
        """Of a grain [kg]."""
        return 4 / 3 * pi * self.radius**3 * self.material.density

    @property
    def pair(self) -> laws.MaterialPair:
        return laws.combine(self.material.body(), self.material.body())

    @property
    def stall(self) -> float | None:
        """v_Y^2 [m^2/s^2], v_Y the yield speed of two grains; None for a law without yield."""
        if not laws.LAWS[self.law].yields or self.law == "hertz":
            return None
        return theory.yield_speed(self.pair, self.radius / 2, self.mass / 2) ** 2

    def contact_law(self):
        """The law between two grains. Raises ValueError naming a constant it cannot take."""
        return self.material.law(self.law, self.pair, **self.options)

    def gas(self) -> Gas:
        """The grains with the law's restitution, from impacts too slow to matter to the fastest."""
        law = self.contact_law()
        thermal = self.temperature**0.5
        restitution = law_restitution(law, self.radius, self.mass, (1e-4 * thermal, 20 * thermal))
        return Gas(self.radius, self.volume_fraction, restitution, self.count)


def read_case(settings: Settings) -> Case:
    """The case of a deck's settings. Raises ValueError naming one out of range."""
    name = settings["law"]
    if name not in laws_for("sphere"):
        raise ValueError(f"no law {name!r} for spheres; there are {', '.join(laws_for('sphere'))}")
    constants = {
        "youngs_modulus": settings.number("youngs_modulus", 0, unit="Pa"),
        "poissons_ratio": settings.number("poissons_ratio", -1, 0.5),
        "density": settings.number("density", 0, unit="kg/m^3"),
        "yield_strength": settings.number("yield_strength", 0, unit="Pa"),
        "yield_pressure_factor": settings.number("yield_pressure_factor", -inf),
    }
    if settings["dissipative_constant"] != "0":
        constants["dissipative_constant"] = settings.number("dissipative_constant", 0, unit="s")
    case = Case(
        name,
        law_options(name, settings["options"]),
        Material(settings["material"], **constants),
        settings.number("radius", 0, unit="m"),
        settings.number("volume_fraction", 0, FREEZING),
        settings.number("temperature", 0, unit="m^2/s^2"),
        settings.whole("side", 3) ** 3,
    )
    case.contact_law()  # raises for constants it cannot take
    return case


def law_options(law: str, text: str) -> dict[str, str]:
    """A law's options among those of a pair_style line, "NAME CHOICE ...".

    Raises:
        ValueError: One that changes restitution in a way the law does not know of.
    """
    words = text.split()
    if len(words) % 2:
        raise ValueError(f"options is {text!r}; it must be pairs, NAME CHOICE")
    given = dict(zip(words[::2], words[1::2], strict=False))
    known = {option["name"] for option in laws.LAWS[law].options()}
    for name, choice in given.items():
        if name not in known and name not in HARMLESS and choice != "off":
            raise ValueError(
                f"options: {name} {choice} changes the restitution or is unknown; {law} takes "
                f"{', '.join(sorted(known | set(HARMLESS)))}"
            )
    return {name: choice for name, choice in given.items() if name in known}


def check_settings(settings: Settings) -> None:
    read_case(settings)
    settings.number("timestep", 0, unit="s")
    settings.number("mixing", 0)
    settings.number("duration", 0)
    settings.number("seed", -inf)
    rows, checkpoints = settings.whole("rows", 1), settings.whole("checkpoints", 1)
    if rows % checkpoints:
        raise ValueError(f"checkpoints is {checkpoints}; it must divide rows, {rows}")


def analyse(settings: Settings, series: pd.DataFrame) -> Analysis:
    case = read_case(settings)
    # Without drift N grains have 3(N - 1) free velocities.
    scale = 2 / (3 * (case.count - 1) * case.mass)
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
        Check("grains lost", abs(series["atoms"] - case.count).max(), 0, "the box is periodic"),
        Check(
            "drift of the gas over its thermal speed",
            (series["drift"] / series["temperature"] ** 0.5).max(),
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
    ]
    return Analysis(
        series,
        checks,
        {"cooling_gas": cooling_figure({title(case.law): series}, case.stall, cooling_rate)},
    )


def stored_share(case: Case, gas: Gas) -> float:
    """Bound on the share of the kinetic energy that impacts under way store at the start [-].

    Of N grains N s/2 pairs touch, s the collision rate times the elastic duration of the mean
    impact. Each took m g^2/4 of 3/2 N m T, exponentially distributed about m T, and stores half of
    it or so: in the mean s/6, with a standard deviation of s^(1/2)/(3 N^(1/2)).
    """
    modulus, speed = case.pair.youngs_modulus_eff, (pi * case.temperature) ** 0.5
    duration = theory.hertz_duration(case.radius / 2, case.mass / 2, modulus, speed)
    touching = float(duration * gas.collision_rate(case.temperature))
    return touching / 6 + DEVIATIONS * (touching / case.count) ** 0.5 / 3
