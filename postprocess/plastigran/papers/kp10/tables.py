# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables of the cylinder: paper, finite elements and both cylinder laws."""

from __future__ import annotations

from math import nan

import attrs
import numpy as np
import pandas as pd

from plastigran.experiments.collision import CollisionOutcome
from plastigran.experiments.cylinder.study import FINITE_ELEMENTS_OVERLAP_RES
from plastigran.fem.cylinder.struck import Strike
from plastigran.fem.stepping.snapshot import Snapshot
from plastigran.papers.kp10.computations import KINDS, LAWS, SHOWN, Computed, Key
from plastigran.report.base import add_difference

MICRO = 1e6
#: Residual depth of the paper's finite elements at `SHOWN` with sliding [m].
OBLIQUE_OVERLAP_RES = 0.19e-6
OURS = "finite elements"
#: Quantities of finite elements and LIGGGHTS: name in tables, and factor to its unit.
QUANTITIES = {
    ("overlap_max", "overlap_max"): ("largest depth", "µm", MICRO),
    ("residual_depth", "overlap_res"): ("residual depth", "µm", MICRO),
    ("coefficient_of_restitution",) * 2: ("restitution", "-", 1.0),
    ("contact_time",) * 2: ("contact time", "µs", MICRO),
    ("force_max",) * 2: ("largest force", "N", 1.0),
}
#: Largest residual/largest depth that counts as zero. The residual depth of LIGGGHTS is
#: extrapolated from the last three of some thirty steps; an elastic contact shows this error.
NO_DENT = 1e-3
BODIES = {
    "layer": "combined elasticity, 100 µm",
    "thin": "the same, 50 µm",
    "thick": "the same, no reflected waves",
    "glass": "glass alone, 100 µm",
}


def tables(found: Computed) -> dict[str, pd.DataFrame]:
    """Return the tables by name."""
    return {
        "comparison": comparison(found),
        "normal": normal(found),
        "head_on": head_on(normal(found)),
        "oblique": oblique(found),
        "bodies": bodies(found),
    }


def comparison(found: Computed) -> pd.DataFrame:
    """Return the impact whose residual depths the paper gives, head-on and oblique."""
    straight, oblique = (found.strikes[Key(*SHOWN, kind)] for kind in ("normal", "oblique"))
    by_law = {name: found.runs[*SHOWN, name] for name in LAWS}

    def row(
        quantity: str, unit: str, paper: float, name: str, struck: Strike, factor: float = MICRO
    ):
        line = {"quantity": quantity, "unit": unit, "paper": paper}
        line[OURS] = factor * getattr(struck, name)
        # The laws do not include sliding.
        attribute = {"residual_depth": "overlap_res"}.get(name, name)
        for law, run in by_law.items():
            known = struck is straight
            line[f"LIGGGHTS, {law}"] = factor * getattr(run, attribute) if known else nan
        return line

    depths = (MICRO * FINITE_ELEMENTS_OVERLAP_RES, MICRO * OBLIQUE_OVERLAP_RES)
    rows = []
    for kind, struck, depth in zip(
        ("head-on", "oblique"), (straight, oblique), depths, strict=True
    ):
        rows += [
            row(f"{kind}: residual depth", "µm", depth, "residual_depth", struck),
            row(f"{kind}: depth at separation", "µm", nan, "overlap_res", struck),
            row(f"{kind}: largest depth", "µm", nan, "overlap_max", struck),
            row(f"{kind}: restitution", "-", nan, "coefficient_of_restitution", struck, 1.0),
            row(f"{kind}: contact time", "µs", nan, "contact_time", struck),
        ]
    alike = {"quantity": "largest depth, oblique/head-on", "unit": "-", "paper": 1.0}
    alike[OURS] = oblique.overlap_max / straight.overlap_max
    return add_difference(pd.DataFrame([*rows, alike]), OURS, "paper")


def normal(found: Computed) -> pd.DataFrame:
    """Return head-on impacts: finite elements with and without reflection, errors of the laws."""
    rows = []
    for key, struck in sorted(found.strikes.items()):
        if (key.kind, key.body, key.mesh) != ("normal", "layer", "usual"):
            continue
        runs = {law: found.runs[key.length_ratio, key.speed, law] for law in LAWS}
        thick = found.strikes[attrs.evolve(key, body="thick")]
        for (name, of_run), (quantity, unit, factor) in QUANTITIES.items():
            line = {"length/radius": key.length_ratio, "speed (m/s)": key.speed}
            line |= {"quantity": quantity, "unit": unit}
            for column, each in ((OURS, struck), ("no reflected waves", thick)):
                line[column] = factor * _shown(each, name)
            for law, run in runs.items():
                line[f"LIGGGHTS, {law}"] = factor * _shown(run, of_run)
            rows.append(line)
    table = pd.DataFrame(rows)
    for law in LAWS:
        table = add_difference(table, f"LIGGGHTS, {law}", OURS)
    return table


def head_on(table: pd.DataFrame) -> pd.DataFrame:
    """Return the rows of table `normal` that the page shows: just beyond yield, and the fastest."""
    shown = table["speed (m/s)"].isin({0.4, 1.0}) & (table["length/radius"] == 10)
    shown |= table["speed (m/s)"].isin({2.0, 5.0}) & (table["length/radius"] == 100)
    return table[shown].reset_index(drop=True)


def _shown(outcome: Strike | CollisionOutcome, name: str) -> float:
    """Return a result in SI units; an insignificant residual depth is zero."""
    value = getattr(outcome, name)
    left = name in ("residual_depth", "overlap_res")
    return 0.0 if left and value < NO_DENT * outcome.overlap_max else value


def oblique(found: Computed) -> pd.DataFrame:
    """Return finite elements with sliding at 10 m/s and head-on, also on coarse meshes."""
    rows = []
    for key, struck in sorted(found.strikes.items()):
        if key.body != "layer" or not _has_oblique(found, key):
            continue
        history, end = struck.history, struck.snapshots["end"]
        lengths = MICRO * touched_lengths(struck)
        yielding = surface_yield(struck)
        rows.append(
            {
                "length/radius": key.length_ratio,
                "speed (m/s)": key.speed,
                "way": KINDS[key.kind] + (", coarse mesh" if key.mesh == "coarse" else ""),
                "elements (µm)": f"{lengths.min():.2f} to {lengths.max():.2f}",
                "largest depth (µm)": MICRO * struck.overlap_max,
                "residual depth (µm)": MICRO * struck.residual_depth,
                "restitution": struck.coefficient_of_restitution,
                "contact time (µs)": MICRO * struck.contact_time,
                "force at first yield (N)": struck.yield_force,
                "depth/half width at yield": struck.yield_point[1],
                "force at surface yield (N)": yielding["force"],
                "detected at depth (µm)": MICRO * yielding["plastic_top"],
                "bottom of the zone (µm)": MICRO * history["plastic_bottom"].max(),
                "largest plastic strain": end.plastic_strain.max(),
                "depth of that strain (µm)": -MICRO * end.positions[end.plastic_strain.argmax(), 1],
                "drag/force": abs(history["drag"].sum()) / history["force"].sum(),
            }
        )
    return pd.DataFrame(rows)


def surface_yield(struck: Strike) -> pd.Series:
    """Return the row of the history where the surface yields first, NaN if it does not.

    The surface yields if the shallowest yielded Gauss point is in the first layer of points.
    """
    top = surface_points(struck.snapshots["end"])
    there = struck.history[struck.history["plastic_top"].isin(-top[:, 1])]
    return there.iloc[0] if len(there) else pd.Series(nan, index=struck.history.columns)


def surface_points(snapshot: Snapshot) -> np.ndarray:
    """Return the Gauss points next to the surface y = 0, two per element along it (n, 2), m."""
    along = np.count_nonzero(snapshot.vertices[snapshot.quads, 1] == 0, axis=1) == 2
    points = snapshot.positions.reshape(len(snapshot.quads), -1, 2)[along]
    upper = np.argsort(points[:, :, 1], axis=1)[:, -2:]
    return np.take_along_axis(points, upper[:, :, None], axis=1).reshape(-1, 2)


def touched_lengths(struck: Strike) -> np.ndarray:
    """Return the lengths of the surface elements that the contact has reached (n,), m."""
    history, vertices = struck.history, struck.snapshots["end"].vertices
    reached = struck.start + history["way"], history["half_width"]
    first, last = (reached[0] - reached[1]).min(), (reached[0] + reached[1]).max()
    x = np.sort(vertices[vertices[:, 1] == 0, 0])
    return np.diff(x)[(x[1:] > first) & (x[:-1] < last)]


def _has_oblique(found: Computed, key: Key) -> bool:
    return Key(key.length_ratio, key.speed, "oblique") in found.strikes


def bodies(found: Computed) -> pd.DataFrame:
    """Return the influence of modulus and thickness of the body on the impact at `SHOWN`."""
    rows = []
    for name, said in BODIES.items():
        key = Key(*SHOWN, body=name)
        if key not in found.strikes:
            continue
        struck = found.strikes[key]
        rows.append(
            {
                "body": said,
                "paper (µm)": MICRO * FINITE_ELEMENTS_OVERLAP_RES,
                "residual depth (µm)": MICRO * struck.residual_depth,
                "depth at separation (µm)": MICRO * struck.overlap_res,
                "largest depth (µm)": MICRO * struck.overlap_max,
                "largest force (N)": struck.force_max,
                "restitution": struck.coefficient_of_restitution,
            }
        )
    return add_difference(pd.DataFrame(rows), "residual depth (µm)", "paper (µm)")
