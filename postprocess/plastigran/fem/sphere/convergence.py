# SPDX-License-Identifier: GPL-2.0-or-later
"""Influence of mesh, steps and penalty on a result."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import attrs
import pandas as pd

from plastigran.fem.settings import Settings
from plastigran.fem.sphere.press import press
from plastigran.fem.sphere.throw import throw

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


def convergence(
    measure: Callable[[Settings], Mapping[str, float]],
    variations: Mapping[str, Sequence[float]],
    settings: Settings | None = None,
) -> pd.DataFrame:
    """Return a measure with one setting changed at a time.

    Args:
        measure: Function that returns numbers of one computation.
        variations: Values of each setting to change.
        settings: All other settings.

    Returns:
        One row per computation, first the unchanged one: `changed`, `value`, the measured numbers,
        and their difference from the first row in per cent as `<name>_change`.
    """
    settings = settings or Settings()
    reference = measure(settings)
    rows = [{"changed": "-", "value": float("nan"), **reference}]
    for name, values in variations.items():
        for value in values:
            changed = measure(attrs.evolve(settings, **{name: value}))
            rows.append({"changed": name, "value": value, **changed})
    table = pd.DataFrame(rows)
    for name, value in reference.items():
        table[f"{name}_change"] = 100 * (table[name] / value - 1)
    return table


def press_measure(*arguments: object) -> Callable[[Settings], dict[str, float]]:
    """Return a function that measures the last unloading of `press(*arguments)`."""
    names = ("approach", "contact_radius", "residual_approach", "coefficient_of_restitution")

    def measure(settings: Settings) -> dict[str, float]:
        last = press(*arguments, settings).unloadings.iloc[-1]
        return {name: float(last[name]) for name in names}

    return measure


def throw_measure(*arguments: object) -> Callable[[Settings], dict[str, float]]:
    """Return a function that measures `throw(*arguments)`."""
    names = ("force_max", "overlap_max", "contact_time", "coefficient_of_restitution")

    def measure(settings: Settings) -> dict[str, float]:
        result = throw(*arguments, settings)
        return {name: getattr(result, name) for name in names}

    return measure
