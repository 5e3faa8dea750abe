# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables of the cylinder of Katta & Polycarpou (2010): paper, finite elements and two laws."""

from __future__ import annotations

from math import nan

import attrs
import numpy as np
import pandas as pd

from plastigran.experiments.cylinder.study import FINITE_ELEMENTS_OVERLAP_RES
from plastigran.fem.cylinder.struck import Strike
from plastigran.papers.kp10.computations import LAWS, SHOWN, Case, Computed
from plastigran.report.base import add_difference

MICRO = 1e6
#: Residual depths that the finite elements of the paper give for the impact `SHOWN` [m]: without
#: sliding ("head-on") and with sliding ("oblique").
PAPER_DEPTHS = {"head-on": FINITE_ELEMENTS_OVERLAP_RES, "oblique": 0.19e-6}
OURS = "finite elements"
#: For each quantity: attribute of finite-element results, attribute of LIGGGHTS results, unit in
#: tables, and factor from the SI unit to this unit.
QUANTITIES = {
    "residual depth": ("residual_depth", "overlap_res", "µm", MICRO),
    "depth at separation": ("overlap_res", "overlap_res", "µm", MICRO),
    "largest depth": ("overlap_max", "overlap_max", "µm", MICRO),
    "restitution": (*["coefficient_of_restitution"] * 2, "-", 1.0),
    "contact time": ("contact_time", "contact_time", "µs", MICRO),
    "largest force": ("force_max", "force_max", "N", 1.0),
}
#: Residual depth / largest depth below which the residual depth counts as zero. The residual depth
#: in LIGGGHTS is extrapolated from the last three of about thirty steps. For an elastic contact,
#: the error of this extrapolation reaches the limit.
INSIGNIFICANT = 1e-3
#: Speeds of the impacts in the table `head_on` [m/s], by length/radius: a speed just above the
#: yield speed, and the highest speed.
HEAD_ON_SPEEDS = {10: (0.4, 1.0), 100: (2.0, 5.0)}
BODIES = {
    "layer": "combined elasticity, 100 µm",
    "thin": "combined elasticity, 50 µm",
    "thick": "combined elasticity, no reflected waves",
    "glass": "glass alone, 100 µm",
}


def comparison(computed: Computed) -> pd.DataFrame:
    """Return the paper's and our results of the impact `SHOWN`, head-on and oblique."""
    strikes = {direction: computed.strikes[Case(*SHOWN, direction)] for direction in PAPER_DEPTHS}
    rows = []
    for direction, strike in strikes.items():
        for quantity, (name, run_name, unit, factor) in list(QUANTITIES.items())[:5]:
            depth = MICRO * PAPER_DEPTHS[direction] if name == "residual_depth" else nan
            row = {"quantity": f"{direction}: {quantity}", "unit": unit, "paper": depth}
            row[OURS] = factor * getattr(strike, name)
            for law in LAWS:
                run = computed.runs[*SHOWN, law]
                # Omit LIGGGHTS for oblique impacts, because the normal force of the laws does not
                # depend on sliding.
                value = nan if direction == "oblique" else factor * getattr(run, run_name)
                row[f"LIGGGHTS, {law}"] = value
            rows.append(row)
    ratio = strikes["oblique"].overlap_max / strikes["head-on"].overlap_max
    row = {"quantity": "largest depth, oblique/head-on", "unit": "-", "paper": 1.0, OURS: ratio}
    return add_difference(pd.DataFrame([*rows, row]), OURS, "paper")


def normal(computed: Computed) -> pd.DataFrame:
    """Return results of head-on impacts, by finite elements and by the laws in LIGGGHTS.

    The finite elements model a layer of 100 µm, and a body without reflected waves.
    """
    rows = []
    for case, strike in sorted(computed.strikes.items()):
        if (case.direction, case.body, case.mesh) != ("head-on", "layer", "usual"):
            continue
        thick = computed.strikes[attrs.evolve(case, body="thick")]
        for quantity in (
            "largest depth",
            "residual depth",
            "restitution",
            "contact time",
            "largest force",
        ):
            name, run_name, unit, factor = QUANTITIES[quantity]
            row = {"length/radius": case.length_ratio, "speed (m/s)": case.speed}
            row |= {"quantity": quantity, "unit": unit}
            row[OURS] = factor * _significant(strike, name)
            row["no reflected waves"] = factor * _significant(thick, name)
            for law in LAWS:
                run = computed.runs[case.length_ratio, case.speed, law]
                row[f"LIGGGHTS, {law}"] = factor * _significant(run, run_name)
            rows.append(row)
    table = pd.DataFrame(rows)
    for law in LAWS:
        table = add_difference(table, f"LIGGGHTS, {law}", OURS)
    return table


def _significant(outcome: object, name: str) -> float:
    """Return a result in SI units; 0 for a residual depth that is below the limit `INSIGNIFICANT`.

    The limit is relative to the largest depth.
    """
    value = getattr(outcome, name)
    residual = name in ("residual_depth", "overlap_res")
    return 0.0 if residual and value < INSIGNIFICANT * outcome.overlap_max else value


def head_on(computed: Computed) -> pd.DataFrame:
    """Return the rows of the table `normal` that the page of the paper shows."""
    table = normal(computed)
    impacts = zip(table["length/radius"], table["speed (m/s)"], strict=True)
    shown = [speed in HEAD_ON_SPEEDS[ratio] for ratio, speed in impacts]
    return table[shown].reset_index(drop=True)


def oblique(computed: Computed) -> pd.DataFrame:
    """Return finite-element results of oblique impacts (sliding at 10 m/s) and head-on impacts.

    The impact `SHOWN` is also computed on a coarse mesh.
    """
    rows = []
    for case, strike in sorted(computed.strikes.items()):
        slid = Case(case.length_ratio, case.speed, "oblique") in computed.strikes
        if case.body != "layer" or not slid:
            continue
        history, end = strike.history, strike.snapshots["end"]
        lengths = MICRO * touched_lengths(strike)
        surface = surface_yield(strike)
        rows.append(
            {
                "length/radius": case.length_ratio,
                "speed (m/s)": case.speed,
                "way": case.direction + (", coarse mesh" if case.mesh == "coarse" else ""),
                "elements (µm)": f"{lengths.min():.2f} to {lengths.max():.2f}",
                "largest depth (µm)": MICRO * strike.overlap_max,
                "residual depth (µm)": MICRO * strike.residual_depth,
                "restitution": strike.coefficient_of_restitution,
                "contact time (µs)": MICRO * strike.contact_time,
                "force at first yield (N)": strike.yield_force,
                "depth/half width at yield": strike.yield_point[1],
                "force at surface yield (N)": surface["force"],
                "detected at depth (µm)": MICRO * surface["plastic_top"],
                "bottom of the plastic zone (µm)": MICRO * history["plastic_bottom"].max(),
                "largest plastic strain": end.plastic_strain.max(),
                "depth of the largest plastic strain (µm)": -MICRO
                * end.positions[end.plastic_strain.argmax(), 1],
                "drag/force": abs(history["drag"].sum()) / history["force"].sum(),
            }
        )
    return pd.DataFrame(rows)


def surface_yield(strike: Strike) -> pd.Series:
    """Return the row of the history at which the surface first yields; NaN if it does not yield.

    The surface yields if the shallowest yielded Gauss point is in the first layer of Gauss points.
    The first layer has the two Gauss points of each surface element that are closest to y = 0.
    """
    end = strike.snapshots["end"]
    at_surface = np.count_nonzero(end.vertices[end.quads, 1] == 0, axis=1) == 2
    heights = end.positions[:, 1].reshape(len(end.quads), -1)[at_surface]
    layer = -np.sort(heights, axis=1)[:, -2:]
    yielded = strike.history[strike.history["plastic_top"].isin(layer.ravel())]
    return yielded.iloc[0] if len(yielded) else pd.Series(nan, index=strike.history.columns)


def touched_lengths(strike: Strike) -> np.ndarray:
    """Return the lengths of the surface elements that came into contact (n,), m."""
    history, vertices = strike.history, strike.snapshots["end"].vertices
    middle, half_width = strike.start + history["way"], history["half_width"]
    first, last = (middle - half_width).min(), (middle + half_width).max()
    x = np.sort(vertices[vertices[:, 1] == 0, 0])
    return np.diff(x)[(x[1:] > first) & (x[:-1] < last)]


def bodies(computed: Computed) -> pd.DataFrame:
    """Return results of the impact `SHOWN` for bodies of different modulus and thickness."""
    rows = []
    for body, description in BODIES.items():
        strike = computed.strikes.get(Case(*SHOWN, body=body))
        if strike is None:  # a coarse computation lacks some bodies
            continue
        rows.append(
            {
                "body": description,
                "paper (µm)": MICRO * FINITE_ELEMENTS_OVERLAP_RES,
                "residual depth (µm)": MICRO * strike.residual_depth,
                "depth at separation (µm)": MICRO * strike.overlap_res,
                "largest depth (µm)": MICRO * strike.overlap_max,
                "largest force (N)": strike.force_max,
                "restitution": strike.coefficient_of_restitution,
            }
        )
    return add_difference(pd.DataFrame(rows), "residual depth (µm)", "paper (µm)")
