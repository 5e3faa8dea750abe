# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables of the sphere: paper, finite elements, laws and LIGGGHTS."""

from __future__ import annotations

from math import pi

import numpy as np
import pandas as pd
from scipy.optimize import brentq

from plastigran import laws
from plastigran.experiments.central.curves import finite_elements
from plastigran.fem.sphere.calibration import calibrate
from plastigran.fem.sphere.results import Pressing, Throw
from plastigran.papers.zv02.computations import (
    LAWS,
    MASS,
    MATERIAL,
    PAIR,
    RADIUS,
    SPHERE,
    Computed,
)
from plastigran.physics.contact_time import contact_time
from plastigran.report.base import add_difference

FINITE_ELEMENTS, PAPER = "finite elements", "paper"
#: Values that the paper prints, in addition to `data/finite_elements_zv02.csv`.
PAPER_ELASTIC_FORCE = {0.02: 716.6, 0.10: 4938.0}
PAPER_YIELD_FORCE = 36.45
PAPER_YIELD_PRESSURE_FACTOR = 1.613
PAPER_COEFFICIENTS = {"C_a": 2.33e-7, "K_c": 2.69e-4}
PAPER_LAW_RESTITUTION = {0.20: 0.4773}
COMPARED = {"force_max": "force", "coefficient_of_restitution": "restitution"}
LARGEST_APPROACH = 0.01  # fraction of the radius; larger than any law needs for these forces


def tables(computed: Computed) -> dict[str, pd.DataFrame]:
    """Return all tables by name."""
    paper = finite_elements().set_index("speed")
    return {
        "onset": onset(computed.onset),
        "elastic": elastic(computed),
        "force": impacts(computed, "force_max", paper["force_max"].to_dict()),
        "restitution": restitution(computed, paper["coefficient_of_restitution"].to_dict()),
        "approach": impacts(computed, "overlap_max", scale=1e6),
        "residual": impacts(computed, "overlap_res", scale=1e6),
        "duration": impacts(computed, "contact_time", scale=1e6),
        "pressed": pressed(computed.pressing),
        "coefficients": coefficients(computed.fit),
        "laws": laws_off(computed),
        "engine": engine(computed),
    }


def onset(pressing: Pressing) -> pd.DataFrame:
    """Return the load and place of first yield.

    First yield is the first increment with plastic work. The place is the point with the largest
    plastic strain at the last increment.
    """
    history = pressing.history
    first = history[history["plastic_work"] > 0].iloc[0]
    strength = pressing.material.hardening.yield_strength
    pressure = (6 * first["force"] * SPHERE.modulus**2 / (pi**3 * RADIUS**2)) ** (1 / 3)
    top = pressing.snapshots[0]
    deepest = top.positions[np.argmax(top.plastic_strain)]
    radius = pressing.unloadings["contact_radius"].iloc[0]
    factor, depth = laws.hertz_yield_pressure_factor(MATERIAL.poissons_ratio), _yield_depth()
    rows = [
        ("force at yield", "N", PAPER_YIELD_FORCE, first["force"], SPHERE.yield_force),
        (
            "largest pressure/yield strength",
            "-",
            PAPER_YIELD_PRESSURE_FACTOR,
            pressure / strength,
            factor,
        ),
        ("depth/contact radius", "-", np.nan, deepest[1] / radius, depth),
        ("distance from the axis/contact radius", "-", np.nan, deepest[0] / radius, 0.0),
    ]
    columns = ["quantity", "unit", PAPER, FINITE_ELEMENTS, "Hertz"]
    table = pd.DataFrame(rows, columns=columns)
    off_hertz = f"{FINITE_ELEMENTS} vs Hertz (%)"
    differences = add_difference(table, FINITE_ELEMENTS, "Hertz")[off_hertz]
    return add_difference(table, FINITE_ELEMENTS, PAPER).assign(**{off_hertz: differences})


def _yield_depth() -> float:
    """Return the depth/a of the largest von Mises stress on the axis under Hertz' pressure."""
    z = np.linspace(0.2, 1, 8001)
    poisson = MATERIAL.poissons_ratio
    return float(z[np.argmax(1.5 / (1 + z**2) - (1 + poisson) * (1 - z * np.arctan(1 / z)))])


def elastic(computed: Computed) -> pd.DataFrame:
    """Return the impacts without plastic flow."""
    rows = []
    for speed, throw in computed.elastic_throws.items():
        hertz = _engine_outcome(computed, "hertz", speed)
        force = SPHERE.force(SPHERE.approach_max(speed))
        rows += [
            (speed, "largest force", "N", PAPER_ELASTIC_FORCE.get(speed), throw.force_max, force,
             hertz.force_max),
            (speed, "duration", "µs", None, 1e6 * throw.contact_time, 1e6 * SPHERE.duration(speed),
             1e6 * hertz.contact_time),
            (speed, "restitution", "-", 1.0, throw.coefficient_of_restitution, 1.0,
             hertz.coefficient_of_restitution),
        ]  # fmt: skip
    columns = ["speed (m/s)", "quantity", "unit", PAPER, FINITE_ELEMENTS, "Hertz", "LIGGGHTS"]
    return add_difference(pd.DataFrame(rows, columns=columns), FINITE_ELEMENTS, PAPER)


def impacts(
    computed: Computed, name: str, paper: dict[float, float] | None = None, scale: float = 1.0
) -> pd.DataFrame:
    """Return one quantity of the impacts, one row per speed.

    Columns are the paper, finite elements, every law by its energy balance, and the paper's law in
    LIGGGHTS.

    Args:
        computed: Data.
        name: Attribute that all outcomes have.
        paper: Values of the paper by speed.
        scale: Factor to the SI unit.
    """
    rows = []
    for speed, throw in computed.throws.items():
        row = {"speed (m/s)": speed}
        if paper is not None:
            row[PAPER] = paper.get(speed)
        row[FINITE_ELEMENTS] = scale * getattr(throw, name)
        row |= {law: scale * _law_outcome(law, speed, name) for law in LAWS}
        own = _engine_outcome(computed, LAWS[0], speed)
        rows.append(row | {f"{LAWS[0]}, LIGGGHTS": scale * getattr(own, name)})
    table = pd.DataFrame(rows)
    return table if paper is None else add_difference(table, FINITE_ELEMENTS, PAPER)


def restitution(computed: Computed, paper: dict[float, float]) -> pd.DataFrame:
    """Return the restitution as `impacts`, with the restitution by the mean velocity of nodes.

    The latter oscillates while the sphere flies.
    """
    table = impacts(computed, "coefficient_of_restitution", paper)
    swings = [nodal_swing(throw) for throw in computed.throws.values()]
    place = table.columns.get_loc(FINITE_ELEMENTS) + 2
    table.insert(place, "by nodes, mean", [float(np.mean(swing)) for swing in swings])
    said = [f"{swing.min():.3f} to {swing.max():.3f}" for swing in swings]
    table.insert(place + 1, "by nodes, range", said)
    table.insert(table.columns.get_loc(LAWS[0]), "paper's law in the paper",
                 table["speed (m/s)"].map(PAPER_LAW_RESTITUTION))  # fmt: skip
    return table


def nodal_swing(throw: Throw) -> np.ndarray:
    """Return the restitution by the mean velocity of corner nodes at each step after contact."""
    free = throw.history[
        throw.history["time"] > throw.history.loc[throw.history["force"] > 0, "time"].max()
    ]
    return free["nodal_velocity"].to_numpy() / throw.speed


def pressed(pressing: Pressing) -> pd.DataFrame:
    """Return the quasi-static compression: finite elements, and errors of laws."""
    said: list[tuple[str, str, str, float]] = [
        ("approach", "µm", "approach", 1e6),
        ("contact radius", "mm", "contact_radius", 1e3),
        ("residual approach", "µm", "residual_approach", 1e6),
        ("√(recovered work/work)", "-", "coefficient_of_restitution", 1.0),
    ]
    unloadings = pressing.unloadings.iloc[1:]  # the first compression hardly yields
    found = {(law, force): press_law(law, force) for law in LAWS for force in unloadings["force"]}
    rows = []
    for quantity, unit, name, scale in said:
        for _, row in unloadings.iterrows():
            values = {law: scale * found[law, row["force"]][name] for law in LAWS}
            line = {"quantity": quantity, "unit": unit, "force (N)": row["force"]}
            rows.append(line | {FINITE_ELEMENTS: scale * row[name], **values})
    table = pd.DataFrame(rows)
    return add_difference(table, LAWS[0], FINITE_ELEMENTS)


def press_law(name: str, force: float) -> dict[str, float]:
    """Return a law's response to loading to `force` [N] and unloading, as `Pressing.unloadings`."""
    law = laws.LAWS[name](PAIR)
    overlap = brentq(
        lambda reached: law.respond(RADIUS, reached, law.State()).force - force,
        0,
        LARGEST_APPROACH * RADIUS,
        xtol=1e-15,
    )
    state = law.State()
    top = law.respond(RADIUS, overlap, state)
    back = law.follow(RADIUS, np.linspace(overlap, 0, 20001), state)["force"]
    lost = top.plastic_work / (top.plastic_work + top.elastic_energy)
    return {
        "approach": overlap,
        "contact_radius": top.contact_radius,
        "residual_approach": overlap * (1 - np.count_nonzero(back) / len(back)),
        "coefficient_of_restitution": float(np.sqrt(1 - lost)),
    }


def coefficients(pressing: Pressing) -> pd.DataFrame:
    """Return the constants of Vu-Quoc and Zhang's law, fitted here and published."""
    fitted = calibrate(pressing)
    rows = [
        ("C_a", "m/N", PAPER_COEFFICIENTS["C_a"], fitted.contact_radius_per_force),
        ("K_c", "1/N", PAPER_COEFFICIENTS["K_c"], fitted.curvature_per_force),
    ]
    table = pd.DataFrame(rows, columns=["quantity", "unit", PAPER, FINITE_ELEMENTS])
    return add_difference(table, FINITE_ELEMENTS, PAPER)


def engine(computed: Computed) -> pd.DataFrame:
    """Return the largest difference between LIGGGHTS and the energy balance of the laws."""
    rows = []
    for law in LAWS:
        row: dict[str, object] = {"law": law}
        for name, said in COMPARED.items():
            ours = {v: getattr(_engine_outcome(computed, law, v), name) for v in computed.throws}
            off = [abs(ours[v] / _law_outcome(law, v, name) - 1) for v in ours]
            row[f"LIGGGHTS vs the law, {said} (%)"] = 100 * max(off)
        rows.append(row)
    return pd.DataFrame(rows)


def laws_off(computed: Computed) -> pd.DataFrame:
    """Return the differences between the laws in LIGGGHTS and the finite elements at each speed."""
    rows = []
    for law in LAWS:
        row: dict[str, object] = {"law": law}
        for name, said in COMPARED.items():
            for speed, throw in computed.throws.items():
                ours = getattr(_engine_outcome(computed, law, speed), name)
                row[f"{said}, {speed:g} m/s (%)"] = 100 * (ours / getattr(throw, name) - 1)
        rows.append(row)
    return pd.DataFrame(rows)


def _law_outcome(name: str, speed: float, quantity: str) -> float:
    law = laws.LAWS[name](PAIR)
    if quantity == "contact_time":
        return contact_time(law, RADIUS, MASS, speed)[1]
    return getattr(law.central_impact(RADIUS, MASS, speed), quantity)


def _engine_outcome(computed: Computed, law: str, speed: float):
    outcomes = computed.runs.outcomes
    return next(found for case, found in outcomes.items() if (case.law, case.speed) == (law, speed))
