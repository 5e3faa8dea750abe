# SPDX-License-Identifier: GPL-2.0-or-later
"""Katta & Polycarpou 2010: a rigid cylinder on glass, finite elements beside both cylinder laws."""

from __future__ import annotations

from math import nan

import attrs
import pandas as pd

from plastigran.experiments.cylinder.study import FINITE_ELEMENTS_OVERLAP_RES
from plastigran.fem.cylinder.struck import Strike
from plastigran.papers.base import Paper, Reproduction, add_difference
from plastigran.papers.kp10.computations import (
    LAWS,
    SHOWN,
    Computed,
    Key,
    compute_finite_elements_and_runs,
)
from plastigran.papers.kp10.pictures import KINDS, depth_figure, mises_figure, restitution_figure

#: The paper's finite elements at `SHOWN`, sliding along [m].
OBLIQUE_OVERLAP_RES = 0.19e-6
OURS = "finite elements"
#: Of the finite elements and of LIGGGHTS; how it is shown, and the factor to its unit.
QUANTITIES = {
    ("overlap_max", "overlap_max"): ("largest depth", "µm", 1e6),
    ("residual_depth", "overlap_res"): ("residual depth", "µm", 1e6),
    ("coefficient_of_restitution",) * 2: ("restitution", "-", 1.0),
    ("contact_time",) * 2: ("contact time", "µs", 1e6),
    ("force_max",) * 2: ("largest force", "N", 1.0),
}
NEAR_SURFACE = 2e-8  # m, of the topmost Gauss points
NO_DENT = 1e-9  # m, and less counts as none
BODIES = {
    "layer": "both bodies' elasticity, 100 µm",
    "thin": "the same, 50 µm",
    "thick": "the same, no wave comes back",
    "glass": "glass alone, 100 µm",
}


def compute(progress: bool, coarse: bool) -> Reproduction:
    """Head-on and oblique strikes."""
    found = compute_finite_elements_and_runs(progress, coarse)
    return Reproduction(
        tables={
            "comparison": comparison(found),
            "normal": normal(found),
            "oblique": oblique(found),
            "bodies": bodies(found),
        },
        figures={
            "restitution": restitution_figure(found),
            "depth": depth_figure(found),
            "mises": mises_figure(found),
        },
    )


def comparison(found: Computed) -> pd.DataFrame:
    """The impact whose residual depths the paper gives, head-on and oblique."""
    straight, oblique = (found.strikes[Key(*SHOWN, kind)] for kind in ("normal", "oblique"))
    by_law = {name: found.runs[*SHOWN, name] for name in LAWS}

    def row(quantity: str, unit: str, paper: float, name: str, struck: Strike, factor: float = 1e6):
        line = {"quantity": quantity, "unit": unit, "paper": paper}
        line[OURS] = factor * getattr(struck, name)
        # The laws know no sliding.
        attribute = {"residual_depth": "overlap_res"}.get(name, name)
        for law, run in by_law.items():
            known = struck is straight
            line[f"LIGGGHTS, {law}"] = factor * getattr(run, attribute) if known else nan
        return line

    depths = (1e6 * FINITE_ELEMENTS_OVERLAP_RES, 1e6 * OBLIQUE_OVERLAP_RES)
    rows = []
    for kind, struck, depth in zip(
        ("head-on", "oblique"), (straight, oblique), depths, strict=True
    ):
        rows += [
            row(f"{kind}: residual depth", "µm", depth, "residual_depth", struck),
            row(f"{kind}: depth as it leaves", "µm", nan, "overlap_res", struck),
            row(f"{kind}: largest depth", "µm", nan, "overlap_max", struck),
            row(f"{kind}: restitution", "-", nan, "coefficient_of_restitution", struck, 1.0),
            row(f"{kind}: contact time", "µs", nan, "contact_time", struck),
        ]
    alike = {"quantity": "largest depth, oblique over head-on", "unit": "-", "paper": 1.0}
    alike[OURS] = oblique.overlap_max / straight.overlap_max
    return add_difference(pd.DataFrame([*rows, alike]), OURS, "paper")


def normal(found: Computed) -> pd.DataFrame:
    """Head-on: finite elements, a body without far side, and what the laws are off."""
    rows = []
    for key, struck in sorted(found.strikes.items()):
        if key.kind != "normal" or key.body != "layer":
            continue
        thick = found.strikes[attrs.evolve(key, body="thick")]
        for (name, of_run), (quantity, unit, factor) in QUANTITIES.items():
            line = {"length/radius": key.length_ratio, "speed (m/s)": key.speed}
            line |= {"quantity": quantity, "unit": unit}
            for column, each in ((OURS, struck), ("no wave comes back", thick)):
                value = getattr(each, name)
                line[column] = factor * (0.0 if abs(value) < NO_DENT else value)
            for law in LAWS:
                run = found.runs[key.length_ratio, key.speed, law]
                line[f"LIGGGHTS, {law}"] = factor * getattr(run, of_run)
            rows.append(line)
    table = pd.DataFrame(rows)
    for law in LAWS:
        table = add_difference(table, f"LIGGGHTS, {law}", OURS)
    return table


def oblique(found: Computed) -> pd.DataFrame:
    """Sliding along at 10 m/s beside head-on, of finite elements."""
    rows = []
    for key, struck in sorted(found.strikes.items()):
        if key.body != "layer" or not _has_oblique(found, key):
            continue
        history, end = struck.history, struck.snapshots["end"]
        rows.append(
            {
                "length/radius": key.length_ratio,
                "speed (m/s)": key.speed,
                "way": KINDS[key.kind],
                "largest depth (µm)": 1e6 * struck.overlap_max,
                "residual depth (µm)": 1e6 * struck.residual_depth,
                "restitution": struck.coefficient_of_restitution,
                "contact time (µs)": 1e6 * struck.contact_time,
                "yields from (N)": struck.yield_force,
                "at depth over half width": struck.yield_point[1],
                "surface yields from (N)": _surface_yield(struck),
                "zone's bottom (µm)": 1e6 * history["plastic_bottom"].max(),
                "largest plastic strain": end.plastic_strain.max(),
                "its depth (µm)": -1e6 * end.positions[end.plastic_strain.argmax(), 1],
                "drag over force": -history["drag"].sum() / history["force"].sum(),
            }
        )
    return pd.DataFrame(rows)


def _surface_yield(struck: Strike) -> float:
    """Force from which the topmost Gauss points yield, N; nan if they never do."""
    top = struck.history["plastic_top"]
    there = struck.history["force"][top <= top.min() + NEAR_SURFACE]
    return float(there.iloc[0]) if top.min() < 10 * NEAR_SURFACE else nan


def _has_oblique(found: Computed, key: Key) -> bool:
    return Key(key.length_ratio, key.speed, "oblique") in found.strikes


def bodies(found: Computed) -> pd.DataFrame:
    """What the body's modulus and thickness do to the impact the paper gives the dent of."""
    rows = []
    for name, said in BODIES.items():
        key = Key(*SHOWN, body=name)
        if key not in found.strikes:
            continue
        struck = found.strikes[key]
        rows.append(
            {
                "body": said,
                "paper (µm)": 1e6 * FINITE_ELEMENTS_OVERLAP_RES,
                "residual depth (µm)": 1e6 * struck.residual_depth,
                "depth as it leaves (µm)": 1e6 * struck.overlap_res,
                "largest depth (µm)": 1e6 * struck.overlap_max,
                "largest force (N)": struck.force_max,
                "restitution": struck.coefficient_of_restitution,
            }
        )
    return add_difference(pd.DataFrame(rows), "residual depth (µm)", "paper (µm)")


PAPER = Paper(
    name="kp10",
    title="A rigid cylinder on an elastic-plastic body",
    citation="M. R. Katta & A. A. Polycarpou, J. Tribol. 132 (2010)",
    tables=("comparison", "normal", "oblique", "bodies"),
    figures=("restitution", "depth", "mises"),
    compute=compute,
)
