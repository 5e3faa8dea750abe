# SPDX-License-Identifier: GPL-2.0-or-later
"""Outcomes of the benchmark impacts: by theory, from a trajectory, and their differences."""

from __future__ import annotations

from math import nan

import attrs
import pandas as pd

from plastigran.experiments.collision import CollisionOutcome
from plastigran.physics import central
from plastigran.physics.oblique import Motion, ObliqueImpact


@attrs.frozen(eq=False)
class BenchmarkOutcome:
    """Measured or predicted outcome of an impact.

    Attributes:
        after: Motion of the bodies after the impact.
        collision: Normal motion of the first body; predicted by Hertz for impacts without damping.
    """

    after: Motion
    collision: CollisionOutcome


def predict(impact: ObliqueImpact) -> BenchmarkOutcome:
    """Predict an impact by theory: spring and slider (`ObliqueImpact.spring_slider`).

    The dashpot never attracts. Peaks and duration are Hertz' for impacts without damping, else NaN.
    """
    if impact.coefficient_of_restitution == 1:
        bodies = (
            impact.radius_eff,
            impact.mass_eff,
            impact.pair.youngs_modulus_eff,
            impact.before.normal,
        )
        force = float(central.hertz_force_max(*bodies))
        overlap = float(central.hertz_overlap_max(*bodies))
        duration = float(central.hertz_duration(*bodies))
    else:
        force = overlap = duration = nan
    collision = CollisionOutcome(
        closing_speed=impact.before.normal,
        coefficient_of_restitution=impact.restitution(),
        force_max=force,
        overlap_max=overlap,
        overlap_res=nan,
        contact_time=duration,
    )
    return BenchmarkOutcome(impact.spring_slider(), collision)


def compare(impact: ObliqueImpact, measured: BenchmarkOutcome) -> dict[str, object]:
    """Return columns of the results table: measured values, `*_predicted`, and `*_rigid`.

    `*_predicted` is as of `predict`; `*_rigid` is for rigid bodies that slide.
    """
    found, collision = measured.after, measured.collision
    predicted, rigid = predict(impact), impact.rigid_sliding()
    expected, theory = predicted.after, predicted.collision
    return {
        "radius": impact.radius,
        "closing_speed": impact.before.normal,
        "surface_speed_before": impact.surface_speed(impact.before),
        "slides": impact.slides(),
        "coefficient_of_restitution_set": impact.coefficient_of_restitution,
        "coefficient_of_restitution": found.normal / impact.before.normal,
        "coefficient_of_restitution_predicted": theory.coefficient_of_restitution,
        "speed_along": found.along,
        "speed_along_predicted": expected.along,
        "speed_along_rigid": rigid.along,
        "spin_after": found.spin,
        "spin_after_predicted": expected.spin,
        "spin_after_rigid": rigid.spin,
        "speed_along_other": found.along_other,
        "spin_after_other": found.spin_other,
        "surface_speed": impact.surface_speed(found),
        "surface_speed_predicted": impact.surface_speed(expected),
        "surface_speed_rigid": impact.surface_speed(rigid),
        # Change of the surface speed by friction for a body that slides throughout.
        "surface_speed_scale": 3.5
        * impact.coefficient_of_friction
        * (1 + impact.restitution())
        * impact.before.normal,
        "force_max": collision.force_max,
        "force_max_predicted": theory.force_max,
        "overlap_max": collision.overlap_max,
        "overlap_max_predicted": theory.overlap_max,
        "contact_time": collision.contact_time,
        "contact_time_predicted": theory.contact_time,
    }


def motion(trajectory: pd.DataFrame, frame: int) -> Motion:
    """Return the motion of the bodies in a frame of a trajectory: 0 the first, -1 the last.

    The normal speed is positive, closing or separating.
    """
    step = trajectory["step"].unique()[frame]
    bodies = trajectory[trajectory["step"] == step].sort_values("id")
    first = bodies.iloc[0]
    if len(bodies) == 1:
        return Motion(abs(first["vx"]), first["vy"], -first["omegaz"])
    second = bodies.iloc[1]
    normal = abs(first["vx"] - second["vx"])
    return Motion(normal, first["vy"], -first["omegaz"], second["vy"], second["omegaz"])


def agreement(table: pd.DataFrame) -> pd.DataFrame:
    """Return the largest deviations from theory by benchmark.

    Args:
        table: Results table, `Runs.table`.

    Returns:
        One row per benchmark: `impacts`; relative deviations of `coefficient_of_restitution` and,
        without damping, `force_max`, `overlap_max`, `contact_time`; deviations of the surface speed
        from the `spring_slider` and, for bodies that slide throughout, from `rigid` bodies, divided
        by the change of the surface speed of sliding bodies.
    """

    def worst(part: pd.DataFrame, name: str) -> float:
        return (part[name] / part[f"{name}_predicted"] - 1).abs().max()

    def surface(part: pd.DataFrame, against: str) -> float:
        off = (part["surface_speed"] - part[f"surface_speed_{against}"]).abs()
        return (off / part["surface_speed_scale"]).max()

    lines = {}
    for number, part in table.groupby("benchmark"):
        lines[number] = {
            "impacts": len(part),
            **{
                name: worst(part, name)
                for name in (
                    "coefficient_of_restitution",
                    "force_max",
                    "overlap_max",
                    "contact_time",
                )
            },
            "spring_slider": surface(part, "predicted"),
            "rigid": surface(part[part["slides"]], "rigid"),
        }
    return pd.DataFrame.from_dict(lines, orient="index").rename_axis("benchmark")
