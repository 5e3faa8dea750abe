# SPDX-License-Identifier: GPL-2.0-or-later
"""Outcomes of the benchmark impacts of Chung & Ooi (2011): measured, by theory, and compared."""

from __future__ import annotations

from math import nan

import attrs
import pandas as pd

from plastigran.experiments.collision import CollisionOutcome
from plastigran.physics import central
from plastigran.physics.oblique import Motion, ObliqueImpact


@attrs.frozen(eq=False)
class BenchmarkOutcome:
    """Measured or predicted outcome of a benchmark impact.

    Attributes:
        after: Motion of the bodies after the impact.
        collision: Normal motion of the first body. A prediction follows Hertz's theory, without
            damping.
    """

    after: Motion
    collision: CollisionOutcome


def predict(impact: ObliqueImpact) -> BenchmarkOutcome:
    """Predict an impact with a tangential spring and a slider (`ObliqueImpact.spring_slider`).

    The normal force, which includes the dashpot, is never attractive. Without damping, the largest
    force, the largest overlap and the duration follow from Hertz's theory. With damping, these
    three values are NaN.
    """
    force = overlap = duration = nan
    if impact.coefficient_of_restitution == 1:
        modulus, speed = impact.pair.youngs_modulus_eff, impact.before.normal
        bodies = impact.radius_eff, impact.mass_eff, modulus, speed
        force = float(central.hertz_force_max(*bodies))
        overlap = float(central.hertz_overlap_max(*bodies))
        duration = float(central.hertz_duration(*bodies))
    collision = CollisionOutcome(
        closing_speed=impact.before.normal,
        coefficient_of_restitution=impact.restitution(),
        force_max=force,
        overlap_max=overlap,
        overlap_res=nan,
        contact_time=duration,
    )
    return BenchmarkOutcome(impact.spring_slider(), collision)


def compare(
    impact: ObliqueImpact, measured: BenchmarkOutcome, predicted: BenchmarkOutcome
) -> dict[str, object]:
    """Return columns of the results table: measured values, and the predictions of two theories.

    The columns `*_predicted` contain the outcome `predicted`. The columns `*_rigid` contain the
    motion of rigid bodies that slide throughout the impact.
    """
    after, after_predicted, after_rigid = measured.after, predicted.after, impact.rigid_sliding()
    collision, collision_predicted = measured.collision, predicted.collision
    closing_speed, friction = impact.before.normal, impact.coefficient_of_friction
    return {
        "radius": impact.radius,
        "closing_speed": closing_speed,
        "surface_speed_before": impact.surface_speed(impact.before),
        "slides": impact.slides(),
        "coefficient_of_restitution_set": impact.coefficient_of_restitution,
        "coefficient_of_restitution": after.normal / closing_speed,
        "coefficient_of_restitution_predicted": collision_predicted.coefficient_of_restitution,
        "speed_along": after.along,
        "speed_along_predicted": after_predicted.along,
        "speed_along_rigid": after_rigid.along,
        "spin_after": after.spin,
        "spin_after_predicted": after_predicted.spin,
        "spin_after_rigid": after_rigid.spin,
        "speed_along_other": after.along_other,
        "spin_after_other": after.spin_other,
        "surface_speed": impact.surface_speed(after),
        "surface_speed_predicted": impact.surface_speed(after_predicted),
        "surface_speed_rigid": impact.surface_speed(after_rigid),
        # If the bodies slide throughout, friction changes their surface speed by this value.
        "surface_speed_scale": 3.5 * friction * (1 + impact.restitution()) * closing_speed,
        "force_max": collision.force_max,
        "force_max_predicted": collision_predicted.force_max,
        "overlap_max": collision.overlap_max,
        "overlap_max_predicted": collision_predicted.overlap_max,
        "contact_time": collision.contact_time,
        "contact_time_predicted": collision_predicted.contact_time,
    }


def motion(trajectory: pd.DataFrame, frame: int) -> Motion:
    """Return the motion of the bodies in one frame of a trajectory: 0 is the first, -1 the last.

    The normal speed is positive, whether the bodies close or separate.
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
    """Return the largest deviations from theory for each benchmark.

    Args:
        table: Results table, `Runs.table`.

    Returns:
        One row per benchmark. `impacts` is the number of impacts. `coefficient_of_restitution`,
        `force_max`, `overlap_max` and `contact_time` are relative deviations; the last three need
        impacts without damping. `spring_slider` and `rigid` are deviations of the surface speed
        from these two theories, divided by `surface_speed_scale` (see `compare`); `rigid` needs
        bodies that slide throughout.
    """

    def relative(part: pd.DataFrame, name: str) -> float:
        return (part[name] / part[f"{name}_predicted"] - 1).abs().max()

    def surface(part: pd.DataFrame, theory: str) -> float:
        difference = (part["surface_speed"] - part[f"surface_speed_{theory}"]).abs()
        return (difference / part["surface_speed_scale"]).max()

    compared = ("coefficient_of_restitution", "force_max", "overlap_max", "contact_time")
    rows = {
        number: {
            "impacts": len(part),
            **{name: relative(part, name) for name in compared},
            "spring_slider": surface(part, "predicted"),
            "rigid": surface(part[part["slides"]], "rigid"),
        }
        for number, part in table.groupby("benchmark")
    }
    return pd.DataFrame.from_dict(rows, orient="index").rename_axis("benchmark")
