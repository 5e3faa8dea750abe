# SPDX-License-Identifier: GPL-2.0-or-later
"""Oblique impacts of alumina on glass (Kharaz, Gorham & Salman 2001), by theory and by LIGGGHTS.

The impacts test friction and the tangential elasticity of the contact.
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
from plastigran.experiments.chung_ooi import TANGENTIAL_MODELS, BenchmarkImpact
from plastigran.experiments.runs import sweep
from plastigran.physics.oblique import Motion, ObliqueImpact
from plastigran.physics.partial_slip import partial_slip

GLASS = laws.Body(70e9, 0.25)
#: Quantities by name: description, and the expected accuracy of a theory.
QUANTITIES = {
    "restitution": ("tangential restitution", 0.02),
    "spin": ("spin (rad/s)", 10.0),
    "rebound_angle": ("rebound angle (°)", 1.0),
}
#: Names of the theories.
PARTIAL_SLIP, SPRING = "partial slip", "spring and slider"
#: Methods of computation in LIGGGHTS, and their tangential models.
IN_LIGGGHTS = {f"LIGGGHTS, {model}": model for model in TANGENTIAL_MODELS}
THEORIES: dict[str, Callable[[ObliqueImpact], Motion]] = {
    PARTIAL_SLIP: partial_slip,
    SPRING: ObliqueImpact.spring_slider,
}


@cache
def measured() -> pd.DataFrame:
    """Return the table of measurements: columns incident_angle [degrees], quantity, value."""
    with (files("plastigran") / "data" / "oblique_kharaz_2001.csv").open() as file:
        return pd.read_csv(file, comment="#")


def case(angle: float) -> BenchmarkImpact:
    """Return the impact of benchmark 4 of Chung & Ooi (2011) at an angle from the normal [degrees].

    In the deck of this benchmark, a sphere of alumina hits a rigid plane.
    """
    return BenchmarkImpact("4_incident_angle", "aluminium_oxide", "incident_angle", angle)


def impact(angle: float) -> ObliqueImpact:
    """Return the impact of an alumina sphere on glass at an angle from the normal [degrees]."""
    on_rigid_plane = case(angle)
    pair = laws.combine(on_rigid_plane.sphere.body(), GLASS)
    return attrs.evolve(on_rigid_plane.impact(), pair=pair)


def quantity(name: str, before: ObliqueImpact, after: Motion) -> float:
    """Return one of `QUANTITIES` of an impact.

    Args:
        name: Name of the quantity.
        before: Impact, with the velocities before it.
        after: Velocities after the impact.
    """
    if name == "restitution":
        return after.along / before.before.along
    return -after.spin if name == "spin" else degrees(atan2(after.along, after.normal))


def computed(engine: Iterable[float] | None = None) -> pd.DataFrame:
    """Compute all measured impacts by theory and by LIGGGHTS.

    Args:
        engine: Incident angles [degrees] to compute in LIGGGHTS; None for all.

    Returns:
        Table of `measured` with one more column for each method. At angles that LIGGGHTS did not
        compute, its columns contain NaN.

    Raises:
        EngineError: LIGGGHTS stopped with an error.
    """
    table = measured()
    angles = table["incident_angle"] if engine is None else list(engine)
    rows = list(zip(table["incident_angle"], table["quantity"], strict=True))
    for method, theory in THEORIES.items():
        values = [quantity(name, impact(a), theory(impact(a))) for a, name in rows]
        table = table.assign(**{method: values})
    for method, tangential in IN_LIGGGHTS.items():
        cases = [attrs.evolve(case(angle), tangential=tangential) for angle in angles]
        with TemporaryDirectory() as folder:
            runs = sweep(cases, folder, progress=False)
        after = {run.value: outcome.after for run, outcome in runs.outcomes.items()}
        values = [quantity(name, impact(a), after[a]) if a in after else np.nan for a, name in rows]
        table = table.assign(**{method: values})
    return table


def comparison(table: pd.DataFrame, name: str) -> pd.DataFrame:
    """Return measured and computed values of one of `QUANTITIES` for each incident angle.

    The table also contains the difference between the measurement and the theory of partial slip,
    in the unit of the quantity and converted to tangential restitution.

    Args:
        table: Table of `computed`.
        name: Name of the quantity.
    """
    part = table[table["quantity"] == name].reset_index(drop=True)
    columns = part[["incident_angle", "value", PARTIAL_SLIP, SPRING, *IN_LIGGGHTS]].rename(
        columns={"incident_angle": "incident angle (°)", "value": "measured"}
    )
    columns["measured − partial slip"] = (part["value"] - part[PARTIAL_SLIP]).round(4)
    if name != "restitution":
        columns["as restitution"] = _as_restitution(part, name).round(4)
    return columns


def _as_restitution(part: pd.DataFrame, name: str) -> pd.Series:
    """Convert the difference between measurement and partial slip to tangential restitution.

    The conversion uses the tangential velocities v_t before and v_t' after the impact. The angular
    momentum about the contact point is constant, so that 2/5 R w = v_t - v_t', with the radius R
    and the spin w after the impact. The tangent of the rebound angle is v_t' / normal speed.
    """
    angles = part["incident_angle"]
    if name == "spin":
        arms = [0.4 * impact(a).radius / impact(a).before.along for a in angles]
        return -(part["value"] - part[PARTIAL_SLIP]) * arms
    measured, slip = (np.tan(np.radians(part[column])) for column in ("value", PARTIAL_SLIP))
    # At incident angles up to 1 degree, the rebound angle does not determine the tangential
    # restitution.
    ratios = [impact(a).restitution() / np.tan(radians(a)) if a > 1 else np.nan for a in angles]
    return (measured - slip) * ratios


def summary(table: pd.DataFrame) -> pd.DataFrame:
    """Return the errors of each theory and of LIGGGHTS, compared with the measurements.

    Args:
        table: Table of `computed`.
    """
    rows = []
    for name, (description, bound) in QUANTITIES.items():
        part = table[table["quantity"] == name]
        for method in (PARTIAL_SLIP, SPRING, *IN_LIGGGHTS):
            error = (part[method] - part["value"]).abs().dropna()
            rows.append(
                {
                    "quantity": description,
                    "computed by": method,
                    "largest difference": float(f"{error.max():.3g}"),
                    "at (°)": part["incident_angle"][error.idxmax()],
                    "rms": float(f"{np.sqrt(np.mean(error**2)):.3g}"),
                    "bound": bound,
                    "within the bound": f"{int((error <= bound).sum())} of {len(error)}",
                }
            )
    return pd.DataFrame(rows)
