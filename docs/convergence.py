#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Print the error of finite elements relative to Hertz, and the effect of each setting.

    .venv/bin/python docs/convergence.py [elastic] [press] [throw] [vibrate] [strike]

On one core, `press` takes about three minutes, `throw` about six, and the others one or two each.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence

import pandas as pd
from attrs import evolve

from plastigran.fem.cylinder.case import CylinderStrike
from plastigran.fem.cylinder.strike import strike
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.material.hardening import LinearHardening
from plastigran.fem.settings import Settings
from plastigran.fem.sphere.press import press
from plastigran.fem.sphere.throw import throw
from plastigran.fem.sphere.vibrate import vibrate
from plastigran.fem.theory.hertz import HertzSphere

#: Sphere of Zhang & Vu-Quoc 2002 (Int. J. Impact Eng. 27:317): radius [m], largest force of the
#: compression [N] and impact speed [m/s].
METAL = ElasticPlastic(
    youngs_modulus=70e9, poissons_ratio=0.3, density=2699.0, hardening=LinearHardening(100e6)
)
RADIUS, FORCE, SPEED = 0.1, 1500.0, 0.02

#: Sphere of ice of docs/papers/chamoli.md: radius [m] and impact speed [m/s].
ICE = ElasticPlastic(youngs_modulus=9.3e9, poissons_ratio=0.25, density=900.0)
ICE_RADIUS, ICE_SPEED = 0.01, 5.0
VIBRATE_VARIATIONS = {
    "divisions": (8,),
    "fineness": (2.0,),
    "steps_of_contact": (500,),
    "penalty": (15.0, 200.0),
}

#: Head-on impact of docs/papers/kp10.md, and its settings.
STRIKE = CylinderStrike(
    material=ElasticPlastic(
        youngs_modulus=79.5e9,
        poissons_ratio=0.23,
        density=2500.0,
        hardening=LinearHardening(2.41e9),
    ),
    radius=1e-5,
    length=1e-4,
    mass=1.59e-6,
    speed=1.0,
    thickness=1e-4,
)
STRIKE_SETTINGS = Settings(divisions=4, steps_of_contact=120)
STRIKE_VARIATIONS = {
    "divisions": (6,),
    "steps_of_contact": (300,),
    "penalty": (15.0, 200.0),
    "strain": ("finite",),
}


PRESS_VARIATIONS = {
    "divisions": (4, 8),
    "fineness": (0.5, 2.0),
    "growth": (1.1, 1.025),
    "unloading_steps": (12, 48),
    "penalty": (15.0, 200.0),
}
THROW_VARIATIONS = {
    "divisions": (4, 8),
    "fineness": (0.5, 2.0),
    "steps_of_contact": (125, 500),
    "penalty": (15.0, 200.0),
}

Variations = Mapping[str, Sequence[float]]


def convergence(
    measure: Callable[[Settings], Mapping[str, float]],
    variations: Variations,
    settings: Settings | None = None,
) -> pd.DataFrame:
    """Return the results of computations in which one setting at a time is changed.

    The first row has the unchanged settings. The columns are `changed` (name of the setting),
    `value`, each result, and its change from the first row in per cent, `<name>_change`.
    """
    settings = settings or Settings()
    reference = measure(settings)
    rows = [{"changed": "-", "value": float("nan"), **reference}]
    for name, values in variations.items():
        for value in values:
            changed = measure(evolve(settings, **{name: value}))
            rows.append({"changed": name, "value": value, **changed})
    table = pd.DataFrame(rows)
    for name, value in reference.items():
        table[f"{name}_change"] = 100 * (table[name] / value - 1)
    return table


def elastic_table(
    forces: Sequence[float] = (36.0, 61.0, 174.0, 496.0, 1417.0, 4048.0, 11563.0),
    settings: Settings | None = None,
) -> pd.DataFrame:
    """Return the deviation [%] of the force on an elastic sphere from Hertz' force.

    Both forces are for the same approach. Each of `forces` [N] has its own mesh.
    """
    metal = evolve(METAL, hardening=None)
    sphere = HertzSphere(metal, RADIUS)

    def off(force: float) -> float:
        pressing = press(metal, RADIUS, [force], settings or Settings(divisions=8))
        return 100 * (force / sphere.force(pressing.unloadings["approach"][0]) - 1)

    return pd.DataFrame({"force": forces, "off Hertz (%)": [off(force) for force in forces]})


def press_table(
    variations: Variations = PRESS_VARIATIONS, settings: Settings | None = None
) -> pd.DataFrame:
    """Return the effect of each setting on a quasi-static compression."""
    names = ["approach", "contact_radius", "residual_approach", "coefficient_of_restitution"]

    def measure(settings: Settings) -> dict[str, float]:
        return press(METAL, RADIUS, [FORCE], settings).unloadings.iloc[-1][names].to_dict()

    return convergence(measure, variations, settings)


def throw_table(
    variations: Variations = THROW_VARIATIONS, settings: Settings | None = None
) -> pd.DataFrame:
    """Return the effect of each setting on a dynamic impact."""
    names = ("force_max", "overlap_max", "contact_time", "coefficient_of_restitution")

    def measure(settings: Settings) -> dict[str, float]:
        result = throw(METAL, RADIUS, SPEED, settings)
        return {name: getattr(result, name) for name in names}

    return convergence(measure, variations, settings)


def tables(
    press: Variations = PRESS_VARIATIONS,
    throw: Variations = THROW_VARIATIONS,
    settings: Settings | None = None,
) -> dict[str, pd.DataFrame]:
    """Return the effects of settings by name of the computation; see `convergence`."""
    return {"press": press_table(press, settings), "throw": throw_table(throw, settings)}


def vibrate_table() -> pd.DataFrame:
    """Return the effect of each setting on the vibration after the impact."""

    def measure(settings: Settings) -> dict[str, float]:
        result = vibrate(ICE, ICE_RADIUS, ICE_SPEED, 1.0, settings)
        return {"vibration_energy": result.vibration_energy, "force_max": result.force_max}

    return convergence(measure, VIBRATE_VARIATIONS)


def strike_table() -> pd.DataFrame:
    """Return the effect of each setting on an impact of a cylinder."""
    names = ("residual_depth", "coefficient_of_restitution", "force_max")

    def measure(settings: Settings) -> dict[str, float]:
        result = strike(STRIKE, settings)
        return {name: float(getattr(result, name)) for name in names}

    return convergence(measure, STRIKE_VARIATIONS, STRIKE_SETTINGS)


PARTS = {
    "elastic": elastic_table,
    "press": press_table,
    "throw": throw_table,
    "vibrate": vibrate_table,
    "strike": strike_table,
}

if __name__ == "__main__":
    for name in sys.argv[1:] or PARTS:
        table = PARTS[name]()
        print(f"{name}\n{table.to_string(index=False, float_format='{:.4g}'.format)}\n")
