# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables of the sphere of Zhang & Vu-Quoc (2002): paper, finite elements, laws and LIGGGHTS."""

from __future__ import annotations

from math import pi

import numpy as np
import pandas as pd
from scipy.optimize import brentq

from plastigran import laws as contact_laws
from plastigran.experiments.central.curves import finite_elements
from plastigran.fem.sphere.calibration import calibrate
from plastigran.fem.sphere.results import Throw
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
#: Values that the paper states, in addition to those in `data/finite_elements_zv02.csv`.
PAPER_ELASTIC_FORCE = {0.02: 716.6, 0.10: 4938.0}
PAPER_YIELD_FORCE = 36.45
PAPER_YIELD_PRESSURE_FACTOR = 1.613
PAPER_COEFFICIENTS = {"C_a": 2.33e-7, "K_c": 2.69e-4}
PAPER_LAW_RESTITUTION = {0.20: 0.4773}
COMPARED = {"force_max": "force", "coefficient_of_restitution": "restitution"}
# Upper bound of approach / radius in the search for the approach at a force. It is sufficient for
# all laws and forces.
LARGEST_APPROACH = 0.01


def onset(computed: Computed) -> pd.DataFrame:
    """Return the force and the location of first yield.

    First yield occurs in the first increment with plastic work. The location is the Gauss point
    with the largest plastic strain in the last increment.
    """
    pressing = computed.onset
    history, top = pressing.history, pressing.snapshots[0]
    force = history.loc[history["plastic_work"] > 0, "force"].iloc[0]
    pressure = (6 * force * SPHERE.modulus**2 / (pi**3 * RADIUS**2)) ** (1 / 3)
    factor = pressure / pressing.material.hardening.yield_strength
    place = top.positions[np.argmax(top.plastic_strain)]
    from_axis, depth = place / pressing.unloadings["contact_radius"].iloc[0]
    poisson = MATERIAL.poissons_ratio
    hertz_factor = contact_laws.hertz_yield_pressure_factor(poisson)
    # Find depth / contact radius of the largest von Mises stress on the axis under Hertz' pressure.
    z = np.linspace(0.2, 1, 8001)
    stress = 1.5 / (1 + z**2) - (1 + poisson) * (1 - z * np.arctan(1 / z))
    hertz_depth = z[np.argmax(stress)]
    rows = [
        ("force at yield", "N", PAPER_YIELD_FORCE, force, SPHERE.yield_force),
        (
            "largest pressure/yield strength",
            "-",
            PAPER_YIELD_PRESSURE_FACTOR,
            factor,
            hertz_factor,
        ),
        ("depth/contact radius", "-", np.nan, depth, hertz_depth),
        ("distance from the axis/contact radius", "-", np.nan, from_axis, 0.0),
    ]
    table = pd.DataFrame(rows, columns=["quantity", "unit", PAPER, FINITE_ELEMENTS, "Hertz"])
    off_hertz = f"{FINITE_ELEMENTS} vs Hertz (%)"
    differences = add_difference(table, FINITE_ELEMENTS, "Hertz")[off_hertz]
    return add_difference(table, FINITE_ELEMENTS, PAPER).assign(**{off_hertz: differences})


def elastic(computed: Computed) -> pd.DataFrame:
    """Return results of impacts without plastic flow: paper, finite elements, Hertz, LIGGGHTS."""
    rows = []
    for speed, impact in computed.elastic_impacts.items():
        force, duration = SPHERE.force(SPHERE.approach_max(speed)), SPHERE.duration(speed)
        for quantity, unit, name, factor, paper, hertz in (
            ("largest force", "N", "force_max", 1.0, PAPER_ELASTIC_FORCE.get(speed), force),
            ("duration", "µs", "contact_time", 1e6, None, duration),
            ("restitution", "-", "coefficient_of_restitution", 1.0, 1.0, 1.0),
        ):
            rows.append(
                {
                    "speed (m/s)": speed,
                    "quantity": quantity,
                    "unit": unit,
                    PAPER: paper,
                    FINITE_ELEMENTS: factor * getattr(impact, name),
                    "Hertz": factor * hertz,
                    "LIGGGHTS": factor * getattr(computed.run("hertz", speed), name),
                }
            )
    return add_difference(pd.DataFrame(rows), FINITE_ELEMENTS, PAPER)


def _impacts(computed: Computed, name: str, scale: float = 1.0) -> pd.DataFrame:
    """Return a quantity of the impacts with plastic flow, one row per speed.

    The columns are the paper (if it states the quantity), finite elements, each law by its energy
    balance, and the law of the paper in LIGGGHTS.
    """
    paper = finite_elements().set_index("speed")
    rows = []
    for speed, impact in computed.impacts.items():
        row = {"speed (m/s)": speed}
        if name in paper:
            row[PAPER] = paper[name].get(speed)
        row[FINITE_ELEMENTS] = scale * getattr(impact, name)
        row |= {law: scale * _law_outcome(law, speed, name) for law in LAWS}
        row[f"{LAWS[0]}, LIGGGHTS"] = scale * getattr(computed.run(LAWS[0], speed), name)
        rows.append(row)
    table = pd.DataFrame(rows)
    return add_difference(table, FINITE_ELEMENTS, PAPER) if PAPER in table else table


def force(computed: Computed) -> pd.DataFrame:
    """Return the largest force of each impact [N], with the columns of `_impacts`."""
    return _impacts(computed, "force_max")


def approach(computed: Computed) -> pd.DataFrame:
    """Return the largest approach of each impact [µm], with the columns of `_impacts`."""
    return _impacts(computed, "overlap_max", 1e6)


def residual(computed: Computed) -> pd.DataFrame:
    """Return the residual approach after each impact [µm], with the columns of `_impacts`."""
    return _impacts(computed, "overlap_res", 1e6)


def duration(computed: Computed) -> pd.DataFrame:
    """Return the duration of contact in each impact [µs], with the columns of `_impacts`."""
    return _impacts(computed, "contact_time", 1e6)


def restitution(computed: Computed) -> pd.DataFrame:
    """Return the table of `_impacts` for the restitution, with further columns.

    These columns have the restitution from the mean velocity of the mesh nodes, and the restitution
    that the paper states for its law. The nodal restitution oscillates while the sphere flies, so
    the table gives its mean and range.
    """
    table = _impacts(computed, "coefficient_of_restitution")
    by_nodes = [nodal_restitution(impact) for impact in computed.impacts.values()]
    place = table.columns.get_loc(FINITE_ELEMENTS) + 2
    table.insert(place, "by nodes, mean", [float(np.mean(values)) for values in by_nodes])
    ranges = [f"{values.min():.3f} to {values.max():.3f}" for values in by_nodes]
    table.insert(place + 1, "by nodes, range", ranges)
    in_paper = table["speed (m/s)"].map(PAPER_LAW_RESTITUTION)
    table.insert(table.columns.get_loc(LAWS[0]), "paper's law, as printed", in_paper)
    return table


def nodal_restitution(impact: Throw) -> np.ndarray:
    """Return the restitution from the mean velocity of corner nodes, at each step after contact."""
    history = impact.history
    end = history.loc[history["force"] > 0, "time"].max()
    return history.loc[history["time"] > end, "nodal_velocity"].to_numpy() / impact.speed


def pressed(computed: Computed) -> pd.DataFrame:
    """Return results of quasi-static compression: finite elements and laws."""
    # Skip the compression to the lowest force, in which the sphere hardly yields.
    unloadings = computed.pressing.unloadings.iloc[1:]
    by_law = {law: [_press_law(law, force) for force in unloadings["force"]] for law in LAWS}
    parts = []
    for quantity, unit, name, scale in (
        ("approach", "µm", "approach", 1e6),
        ("contact radius", "mm", "contact_radius", 1e3),
        ("residual approach", "µm", "residual_approach", 1e6),
        ("√(recovered work/work)", "-", "coefficient_of_restitution", 1.0),
    ):
        columns = {"quantity": quantity, "unit": unit, "force (N)": unloadings["force"]}
        columns[FINITE_ELEMENTS] = scale * unloadings[name]
        columns |= {law: [scale * row[name] for row in rows] for law, rows in by_law.items()}
        parts.append(pd.DataFrame(columns))
    return add_difference(pd.concat(parts, ignore_index=True), LAWS[0], FINITE_ELEMENTS)


def _press_law(name: str, force: float) -> dict[str, float]:
    """Return results of the law `name` for loading to `force` [N] and unloading to zero force."""
    law = contact_laws.LAWS[name](PAIR)
    overlap = brentq(
        lambda overlap: law.respond(RADIUS, overlap, law.State()).force - force,
        0,
        LARGEST_APPROACH * RADIUS,
        xtol=1e-15,
    )
    state = law.State()
    top = law.respond(RADIUS, overlap, state)
    unloading = law.follow(RADIUS, np.linspace(overlap, 0, 20001), state)["force"]
    lost = top.plastic_work / (top.plastic_work + top.elastic_energy)
    return {
        "approach": overlap,
        "contact_radius": top.contact_radius,
        "residual_approach": overlap * (1 - np.count_nonzero(unloading) / len(unloading)),
        "coefficient_of_restitution": float(np.sqrt(1 - lost)),
    }


def coefficients(computed: Computed) -> pd.DataFrame:
    """Return the constants of Vu-Quoc and Zhang's law: fitted to finite elements, and published."""
    fitted = calibrate(computed.fit)
    rows = [
        ("C_a", "m/N", PAPER_COEFFICIENTS["C_a"], fitted.contact_radius_per_force),
        ("K_c", "1/N", PAPER_COEFFICIENTS["K_c"], fitted.curvature_per_force),
    ]
    table = pd.DataFrame(rows, columns=["quantity", "unit", PAPER, FINITE_ELEMENTS])
    return add_difference(table, FINITE_ELEMENTS, PAPER)


def engine(computed: Computed) -> pd.DataFrame:
    """Return the largest differences of force and restitution between LIGGGHTS and the laws."""
    rows = []
    for law in LAWS:
        row: dict[str, object] = {"law": law}
        for name, quantity in COMPARED.items():
            ratios = [
                getattr(computed.run(law, speed), name) / _law_outcome(law, speed, name)
                for speed in computed.impacts
            ]
            off = max(abs(ratio - 1) for ratio in ratios)
            row[f"LIGGGHTS vs the law, {quantity} (%)"] = 100 * off
        rows.append(row)
    return pd.DataFrame(rows)


def laws(computed: Computed) -> pd.DataFrame:
    """Return how force and restitution of laws in LIGGGHTS differ from the finite elements [%]."""
    rows = []
    for law in LAWS:
        row: dict[str, object] = {"law": law}
        for name, quantity in COMPARED.items():
            for speed, impact in computed.impacts.items():
                ratio = getattr(computed.run(law, speed), name) / getattr(impact, name)
                row[f"{quantity}, {speed:g} m/s (%)"] = 100 * (ratio - 1)
        rows.append(row)
    return pd.DataFrame(rows)


def _law_outcome(name: str, speed: float, quantity: str) -> float:
    law = contact_laws.LAWS[name](PAIR)
    if quantity == "contact_time":
        return contact_time(law, RADIUS, MASS, speed)[1]
    return getattr(law.central_impact(RADIUS, MASS, speed), quantity)
