# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures of the impacts of a rod: motion versus time, and outcomes versus impact speed."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from plastigran.experiments.rod import RodImpact
from plastigran.experiments.rod.paper import PAPER_RESTITUTION, MeasuredRun, paper_rods
from plastigran.physics.rod import RodOutcome
from plastigran.plot.style import (
    COLOURS,
    MARKERS,
    law_colour,
    law_number,
    styled,
    subplots,
    title,
)

MEASURED = MeasuredRun()
#: Approximate number of points that show the motion in LIGGGHTS versus time.
POINTS = 30


def closest_to_measured(impacts: dict[RodImpact, RodOutcome]) -> RodImpact:
    """Return the impact closest to the experiment in angle, then in speed, then in spin."""

    def distance(run: RodImpact) -> tuple[float, float, float]:
        return (
            abs(run.rod.angle - MEASURED.angle),
            abs(run.speed + MEASURED.velocity_before),
            abs(impacts[run].angular_velocity - MEASURED.angular_velocity),
        )

    return min(impacts, key=distance)


def motion_figure(run: RodImpact, measured: RodOutcome) -> Figure:
    """Draw forces, displacement, velocities and angular velocity versus time during contact.

    Lines are the equations of motion, points are LIGGGHTS. If `run` has the angle and speed of the
    experiment `MEASURED`, dotted lines show the values of the experiment after the impact.
    """
    predicted = run.predict().history
    points = measured.history.iloc[:: max(1, len(measured.history) // POINTS)]
    panels = {
        "force (kN)": (1e-3, {"force": "normal", "friction_force": "friction"}),
        "displacement of the center (µm)": (
            1e6,
            {"displacement_x": "along the flat", "displacement_y": "normal"},
        ),
        "velocity of the center (m/s)": (
            1,
            {"velocity_x": "along the flat", "velocity_y": "normal"},
        ),
        "angular velocity (rad/s)": (1, {"angular_velocity": "rod"}),
    }
    levels = {}
    if run.rod.angle == MEASURED.angle and run.speed == -MEASURED.velocity_before:
        levels = {
            "velocity_y": MEASURED.velocity_after,
            "angular_velocity": MEASURED.angular_velocity,
        }
    with styled():
        figure, grid = subplots(2, 2, figsize=(8.2, 6), sharex=True)
        for axes, (ylabel, (scale, columns)) in zip(grid.flat, panels.items(), strict=True):
            for colour, (column, label) in zip(COLOURS, columns.items(), strict=False):
                axes.plot(predicted["time"] * 1e6, predicted[column] * scale, color=colour)
                style = {"marker": "o", "ms": 4, "mfc": "white", "color": colour, "ls": ""}
                axes.plot(points["time"] * 1e6, points[column] * scale, label=label, **style)
                if column in levels:
                    axes.axhline(levels[column], color=colour, ls=":", label="rebound, measured")
            axes.set_ylabel(ylabel)
            axes.legend(fontsize=8)
        for axes in grid[1]:
            axes.set_xlabel("time since first touch (µs)")
        figure.suptitle(
            f"{title(run.law)}, {run.rod.angle:g}°, {run.speed:g} m/s; points: LIGGGHTS, "
            "lines: equations of motion",
            fontsize=10,
        )
    return figure


def outcome_figure(table: pd.DataFrame) -> Figure:
    """Draw tip restitution and angular velocity versus impact speed, a column for each angle.

    The star is the experiment whose velocities the paper prints. Its restitution follows from these
    velocities.

    Args:
        table: Results table, with the columns of `RodImpact.row`.
    """
    with styled():
        figure, grid = _grid(table, 2)
        for column, angle in zip(grid.T, table["angle"].unique(), strict=True):
            _curves(column[0], table, angle, "coefficient_of_restitution", 1)
            _curves(column[1], table, angle, "angular_velocity", 1)
            column[0].set_title(f"{angle:g}°", fontsize=10)
            column[0].set_ylim(0, 1.05)
            if angle in PAPER_RESTITUTION:
                column[0].axhline(PAPER_RESTITUTION[angle], color="black", ls=":")
            if angle == MEASURED.angle:
                restitution = MEASURED.coefficient_of_restitution(paper_rods()[0])
                for axes, outcome in zip(
                    column, (restitution, MEASURED.angular_velocity), strict=True
                ):
                    axes.plot(-MEASURED.velocity_before, outcome, "k*", ms=11, zorder=5)
        grid[0, 0].set_ylabel("coefficient of restitution")
        grid[1, 0].set_ylabel("angular velocity (rad/s)")
        grid[0, 0].plot([], [], ":k", label="experiments (paper)")
        grid[0, 0].plot([], [], "*k", ms=11, ls="", label="measured run (paper)")
        _legend(figure, grid)
    return figure


def deformation_figure(table: pd.DataFrame) -> Figure:
    """Draw permanent deformation versus impact speed, a column for each angle.

    Args:
        table: Results table, with the columns of `RodImpact.row`.
    """
    with styled():
        figure, grid = _grid(table, 1)
        for axes, angle in zip(grid[0], table["angle"].unique(), strict=True):
            _curves(axes, table, angle, "overlap_res", 1e6)
            axes.set_title(f"{angle:g}°", fontsize=10)
            axes.set_ylim(0, None)
        grid[0, 0].set_ylabel("permanent deformation (µm)")
        _legend(figure, grid)
    return figure


def _grid(table: pd.DataFrame, rows: int) -> tuple[Figure, np.ndarray]:
    columns = table["angle"].nunique()
    figure, grid = subplots(
        rows,
        columns,
        figsize=(3.6 * columns + 2, 3.3 * rows + 0.3),
        sharex=True,
        sharey="row",
        squeeze=False,
    )
    for axes in grid[-1]:
        axes.set_xlabel("impact speed (m/s)")
    return figure, grid


def _curves(axes: Axes, table: pd.DataFrame, angle: float, column: str, scale: float) -> None:
    """Draw points of LIGGGHTS, and lines of the equations of motion at the same speeds."""
    for law in sorted(table["law"].unique()):
        rows = table[(table["law"] == law) & (table["angle"] == angle)].sort_values("speed")
        if not rows[column].any():
            continue  # an elastic contact has no permanent deformation
        colour, marker = law_colour(law), MARKERS[law_number(law)]
        axes.plot(rows["speed"], rows[f"{column}_predicted"] * scale, color=colour, lw=1)
        style = {"ls": "", "marker": marker, "color": colour, "mfc": "white", "ms": 5}
        axes.plot(rows["speed"], rows[column] * scale, label=title(law), **style)


def _legend(figure: Figure, grid: np.ndarray) -> None:
    handles, labels = grid[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside right center", fontsize=8, title="points: LIGGGHTS")
