# SPDX-License-Identifier: GPL-2.0-or-later
"""Oblique impacts of alumina on glass (Kharaz, Gorham & Salman 2001), by theory and by LIGGGHTS.

They test friction and the tangential elasticity of the contact.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import cache
from importlib.resources import files
from math import atan2, degrees, radians
from tempfile import TemporaryDirectory

import attrs
import numpy as np
import pandas as pd

from plastigran import laws
from plastigran.experiments.chung_ooi import BenchmarkImpact
from plastigran.experiments.runs import sweep
from plastigran.physics.oblique import Motion, ObliqueImpact
from plastigran.physics.partial_slip import partial_slip

GLASS = laws.Body(70e9, 0.25)
#: Quantities by name: words for each, and the expected accuracy of a theory.
QUANTITIES = {
    "restitution": ("tangential restitution", 0.02),
    "spin": ("spin (rad/s)", 10.0),
    "rebound_angle": ("rebound angle (°)", 1.0),
}
#: Methods of computation.
PARTIAL_SLIP, SPRING, ENGINE = "partial slip", "spring and slider", "LIGGGHTS"
THEORIES: dict[str, Callable[[ObliqueImpact], Motion]] = {
    PARTIAL_SLIP: partial_slip,
    SPRING: ObliqueImpact.spring_slider,
}


@cache
def measured() -> pd.DataFrame:
    """Return the measurements: columns incident_angle [degrees], quantity, value."""
    with (files("plastigran") / "data" / "oblique_kharaz_2001.csv").open() as file:
        return pd.read_csv(file, comment="#")


def case(angle: float) -> BenchmarkImpact:
    """Return the impact at an angle from the normal [degrees] for the deck of benchmark 4.

    That deck has alumina on a rigid plane.
    """
    return BenchmarkImpact("4_incident_angle", "aluminium_oxide", "incident_angle", angle)


def impact(angle: float) -> ObliqueImpact:
    """Return the impact at an angle [degrees] on glass."""
    found = case(angle)
    return attrs.evolve(found.impact(), pair=laws.combine(found.sphere.body(), GLASS))


def quantity(name: str, before: ObliqueImpact, after: Motion) -> float:
    """Return one of `QUANTITIES` of an impact."""
    if name == "restitution":
        return after.along / before.before.along
    return -after.spin if name == "spin" else degrees(atan2(after.along, after.normal))


def computed(engine: Iterable[float] | None = None) -> pd.DataFrame:
    """Return the measurements with computed values.

    Args:
        engine: Incident angles [degrees] for LIGGGHTS; None for all.

    Returns:
        As `measured`, with a column for each method; NaN at angles without a LIGGGHTS run.

    Raises:
        EngineError: LIGGGHTS stopped with an error.
    """
    table = measured()
    asked = table["incident_angle"] if engine is None else list(engine)
    with TemporaryDirectory() as folder:
        runs = sweep([case(angle) for angle in asked], folder, progress=False)
    moved = {run.value: outcome.after for run, outcome in runs.outcomes.items()}
    rows = list(zip(table["incident_angle"], table["quantity"], strict=True))
    for way, move in THEORIES.items():
        found = [_value(*row, move(impact(row[0]))) for row in rows]
        table = table.assign(**{way: found})
    return table.assign(**{ENGINE: [_value(*row, moved.get(row[0])) for row in rows]})


def _value(angle: float, name: str, after: Motion | None) -> float:
    return np.nan if after is None else quantity(name, impact(angle), after)


def comparison(table: pd.DataFrame, name: str) -> pd.DataFrame:
    """Return one of `QUANTITIES` over the incident angle: measured, computed, and difference.

    The difference is from partial slip, also given as tangential restitution.

    Args:
        table: As of `computed`.
        name: Name of the quantity.
    """
    part = table[table["quantity"] == name].reset_index(drop=True)
    off = part["value"] - part[PARTIAL_SLIP]
    found = part[["incident_angle", "value", PARTIAL_SLIP, SPRING, ENGINE]].rename(
        columns={"incident_angle": "incident angle (°)", "value": "measured"}
    )
    found["measured − partial slip"] = off.round(4)
    if name != "restitution":
        found["as restitution"] = _as_restitution(part, name).round(4)
    return found


def _as_restitution(part: pd.DataFrame, name: str) -> pd.Series:
    """Return the difference between measurement and partial slip as tangential restitution.

    The angular momentum about the contact point is constant: 2/5 R w = v_t - v_t'. The tangent of
    the rebound angle is v_t' / normal speed.
    """
    angles = part["incident_angle"]
    if name == "spin":
        arm = [0.4 * impact(a).radius / impact(a).before.along for a in angles]
        return -(part["value"] - part[PARTIAL_SLIP]) * arm
    tangents = [np.tan(np.radians(part[column])) for column in ("value", PARTIAL_SLIP)]
    # Near the normal, the angle does not determine it.
    share = [impact(a).restitution() / np.tan(radians(a)) if a > 1 else np.nan for a in angles]
    return (tangents[0] - tangents[1]) * share


def summary(table: pd.DataFrame) -> pd.DataFrame:
    """Return the error of each method of computation.

    Args:
        table: As of `computed`.
    """
    rows = []
    for name, (said, bound) in QUANTITIES.items():
        part = table[table["quantity"] == name]
        for way in (PARTIAL_SLIP, SPRING, ENGINE):
            off = (part[way] - part["value"]).abs().dropna()
            rows.append(
                {
                    "quantity": said,
                    "computed by": way,
                    "largest difference": float(f"{off.max():.3g}"),
                    "at (°)": part["incident_angle"][off.idxmax()],
                    "rms": float(f"{np.sqrt(np.mean(off**2)):.3g}"),
                    "bound": bound,
                    "within the bound": f"{int((off <= bound).sum())} of {len(off)}",
                }
            )
    return pd.DataFrame(rows)
