# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures of the cylinder: restitution over speed, depth over time, von Mises stress."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from plastigran.fem.cylinder.struck import Strike
from plastigran.fem.sphere.fields import at_vertices
from plastigran.fem.stepping.snapshot import YIELDED, Snapshot
from plastigran.papers.kp10.computations import KINDS, LAWS, SHOWN, Computed, Key
from plastigran.plot.fields import draw_field
from plastigran.plot.style import COLOURS, law_colour, styled, subplots, title

MICRO = 1e6
LEVELS = np.linspace(0, 1, 11)  # von Mises stress / flow stress


def figures(found: Computed) -> dict[str, Figure]:
    """Return the figures by name."""
    return {
        "restitution": restitution_figure(found),
        "depth": depth_figure(found),
        "mises": mises_figure(found),
    }


def restitution_figure(found: Computed) -> Figure:
    """Draw restitution over speed, one panel for each length of the cylinder."""
    ratios = sorted({ratio for ratio, _, _ in found.runs})
    with styled():
        figure, grid = subplots(1, len(ratios), figsize=(4.4 * len(ratios), 3.6), squeeze=False)
        for axes, ratio in zip(grid[0], ratios, strict=True):
            for law in LAWS:
                runs = sorted(
                    (v, run)
                    for (r, v, name), run in found.runs.items()
                    if (r, name) == (ratio, law)
                )
                values = [run.coefficient_of_restitution for _, run in runs]
                axes.plot([v for v, _ in runs], values, color=law_colour(law), label=title(law))
            marks = {
                ("normal", "layer"): ("ko", "finite elements, 100 µm"),
                ("normal", "thick"): ("k^", "no reflected waves"),
                ("oblique", "layer"): ("kx", "oblique, 100 µm"),
            }
            for (kind, body), (mark, label) in marks.items():
                some = {
                    key.speed: struck.coefficient_of_restitution
                    for key, struck in found.strikes.items()
                    if key == Key(ratio, key.speed, kind, body)
                }
                axes.plot(some.keys(), some.values(), mark, mfc="none", label=label)
            axes.set(xlabel="impact speed (m/s)", title=f"length = {ratio:g} radii")
        grid[0, 0].set_ylabel("coefficient of restitution")
        grid[0, 0].legend(fontsize=8)
    return figure


def depth_figure(found: Computed) -> Figure:
    """Draw the depth of the cylinder over time, and the surface afterwards."""
    with styled():
        figure, (over_time, left) = subplots(1, 2, figsize=(9.2, 3.6))
        for (kind, label), colour in zip(KINDS.items(), COLOURS, strict=False):
            struck = found.strikes[Key(*SHOWN, kind)]
            history = struck.history
            over_time.plot(
                MICRO * history["time"], MICRO * history["approach"], color=colour, label=label
            )
            x, y = MICRO * struck.surface.T
            both = kind == "normal"  # half of it was computed
            x, y = (np.r_[-x[::-1], x], np.r_[y[::-1], y]) if both else (x, y)
            left.plot(x, y, color=colour, label=label)
        over_time.set(xlabel="time (µs)", ylabel="depth of the cylinder (µm)")
        over_time.legend(fontsize=8)
        left.set(xlabel="along the surface (µm)", ylabel="surface at rest afterwards (µm)")
    return figure


def mises_figure(found: Computed) -> Figure:
    """Draw von Mises stress / flow stress at first yield, at the largest depth and afterwards.

    Head-on and oblique.
    """
    moments = {"yield": "first yield", "deepest": "largest depth", "end": "after it has left"}
    with styled({"axes.grid": False}):
        figure, grid = subplots(3, 2, figsize=(9.2, 6.2), width_ratios=(1, 2.4), sharey=True)
        for column, (kind, label) in zip(grid.T, KINDS.items(), strict=True):
            struck = found.strikes[Key(*SHOWN, kind)]
            for axes, name in zip(column, moments, strict=True):
                contours = _draw_mises(axes, struck, struck.snapshots[name], kind == "normal")
                axes.set_title(label, fontsize=10)
        for axes, said in zip(grid[:, 0], moments.values(), strict=True):
            axes.set_ylabel(f"{said}\nheight (µm)")
        for axes in grid[-1]:
            axes.set_xlabel("along (µm)")
        figure.colorbar(contours, ax=grid, label="von Mises stress over flow stress", shrink=0.8)
    return figure


def _draw_mises(axes: Axes, struck: Strike, snapshot: Snapshot, mirror: bool) -> object:
    """Draw the stress, and the edge of the plastic zone as a line."""
    width = 2 * MICRO * struck.history["half_width"].max()
    start = struck.start
    vertices = MICRO * (snapshot.vertices + snapshot.displacement - [start, 0])
    strength = struck.case.material.hardening.yield_strength
    stress = np.minimum(at_vertices(snapshot, snapshot.mises) / strength, 1 - 1e-9)
    contours = draw_field(axes, vertices, snapshot.quads, stress, LEVELS, mirror, cmap="viridis")
    yielded = at_vertices(snapshot, snapshot.plastic_strain)
    if yielded.max() > YIELDED:
        edge = {"colors": COLOURS[1], "linewidths": 1.2}
        draw_field(axes, vertices, snapshot.quads, yielded, [YIELDED], mirror, False, **edge)
    way = MICRO * struck.history["way"].iloc[-1]
    axes.set(xlim=(-width, width + way), ylim=(-1.6 * width, 0.15 * width))
    axes.set_aspect("equal")
    return contours
