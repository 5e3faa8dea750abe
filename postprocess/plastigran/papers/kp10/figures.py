# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures of the cylinder of Katta & Polycarpou (2010): restitution, depth and stress."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from plastigran.fem.stepping.snapshot import YIELDED
from plastigran.papers.base import STRESS_LABEL, draw_stress
from plastigran.papers.kp10.computations import LAWS, SHOWN, Case, Computed
from plastigran.plot.style import COLOURS, law_colour, styled, subplots, title

MICRO = 1e6
DIRECTIONS = ("head-on", "oblique")


@styled()
def restitution_figure(computed: Computed) -> Figure:
    """Draw the restitution versus speed in one panel for each length of the cylinder."""
    ratios = sorted({ratio for ratio, _, _ in computed.runs})
    series = {
        ("head-on", "layer"): ("ko", "finite elements, 100 µm"),
        ("head-on", "thick"): ("k^", "no reflected waves"),
        ("oblique", "layer"): ("kx", "oblique, 100 µm"),
    }
    figure, grid = subplots(1, len(ratios), figsize=(4.4 * len(ratios), 3.6), squeeze=False)
    for axes, ratio in zip(grid[0], ratios, strict=True):
        for law in LAWS:
            speeds = sorted(v for r, v, name in computed.runs if (r, name) == (ratio, law))
            values = [computed.runs[ratio, v, law].coefficient_of_restitution for v in speeds]
            axes.plot(speeds, values, color=law_colour(law), label=title(law))
        for (direction, body), (marker, label) in series.items():
            values = {
                case.speed: strike.coefficient_of_restitution
                for case, strike in computed.strikes.items()
                if case == Case(ratio, case.speed, direction, body)
            }
            axes.plot(values.keys(), values.values(), marker, mfc="none", label=label)
        axes.set(xlabel="impact speed (m/s)", title=f"length = {ratio:g} radii")
    grid[0, 0].set_ylabel("coefficient of restitution")
    grid[0, 0].legend(fontsize=8)
    return figure


@styled()
def depth_figure(computed: Computed) -> Figure:
    """Draw the depth of the cylinder versus time, and the surface after the impact."""
    figure, (over_time, surface) = subplots(1, 2, figsize=(9.2, 3.6))
    for direction, colour in zip(DIRECTIONS, COLOURS, strict=False):
        strike = computed.strikes[Case(*SHOWN, direction)]
        time, depth = (MICRO * strike.history[name] for name in ("time", "approach"))
        over_time.plot(time, depth, color=colour, label=direction)
        x, y = MICRO * strike.surface.T
        if direction == "head-on":  # mirror the surface, because only one half was computed
            x, y = np.r_[-x[::-1], x], np.r_[y[::-1], y]
        surface.plot(x, y, color=colour, label=direction)
    over_time.set(xlabel="time (µs)", ylabel="depth of the cylinder (µm)")
    over_time.legend(fontsize=8)
    surface.set(
        xlabel="position along the surface (µm)",
        ylabel="height of the surface after the impact (µm)",
    )
    return figure


@styled({"axes.grid": False})
def mises_figure(computed: Computed) -> Figure:
    """Draw von Mises stress at first yield, at the largest depth and after the impact."""
    moments = {"yield": "first yield", "deepest": "largest depth", "end": "after the impact"}
    figure, grid = subplots(3, 2, figsize=(9.2, 6.2), width_ratios=(1, 2.4), sharey=True)
    for column, direction in zip(grid.T, DIRECTIONS, strict=True):
        strike = computed.strikes[Case(*SHOWN, direction)]
        width = 2 * MICRO * strike.history["half_width"].max()
        way = MICRO * strike.history["way"].iloc[-1]
        for axes, moment in zip(column, moments, strict=True):
            contours = draw_stress(
                axes,
                strike.snapshots[moment],
                strike.case.material.hardening.yield_strength,
                origin=(strike.start, 0),
                scale=MICRO,
                zone_edge=YIELDED,
                mirror=direction == "head-on",
            )
            axes.set(xlim=(-width, width + way), ylim=(-1.6 * width, 0.15 * width))
            axes.set_title(direction, fontsize=10)
    for axes, label in zip(grid[:, 0], moments.values(), strict=True):
        axes.set_ylabel(f"{label}\nheight (µm)")
    for axes in grid[-1]:
        axes.set_xlabel("position (µm)")
    figure.colorbar(contours, ax=grid, label=STRESS_LABEL, shrink=0.8)
    return figure
