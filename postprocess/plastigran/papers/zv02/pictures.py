# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures and a movie of the sphere of Zhang & Vu-Quoc (2002): mesh, stress, plastic zones."""

from __future__ import annotations

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.contour import ContourSet
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from plastigran.fem.stepping.snapshot import Snapshot, at_vertices
from plastigran.papers.base import STRESS_LABEL, draw_stress
from plastigran.papers.zv02.computations import SHOWN, Computed
from plastigran.papers.zv02.figures import shades
from plastigran.plot.fields import draw_field, draw_mesh
from plastigran.plot.movie import Movie
from plastigran.plot.style import COLOURS, styled, subplots

MM = 1e3
#: Plastic strain at which the edge of the plastic zone is drawn: a hundredth of the yield strain.
ZONE_EDGE = 1e-5
#: Indices in `FORCES` of the forces that the stress figure shows.
FORCES_SHOWN = [0, 1, 3, -1]


@styled({"axes.grid": False})
def mesh_figure(computed: Computed) -> Figure:
    """Draw the finite-element mesh of the sphere, and the part of the mesh near the contact."""
    mesh = computed.mesh
    contact_radius = MM * computed.impacts[SHOWN].history["contact_radius"].max()
    figure, (whole, part) = subplots(1, 2, figsize=(7.2, 3.7), width_ratios=(1, 1.7))
    for axes in (whole, part):
        draw_mesh(axes, MM * mesh.doflocs.T, mesh.dofs.element_dofs[:8].T)
        axes.set_aspect("equal")
        axes.set_xlabel("distance from the axis (mm)")
    whole.autoscale()
    whole.set_ylabel("height (mm)")
    whole.set_title(f"{mesh.nelements} elements of eight nodes", fontsize=10)
    part.set(xlim=(0, 2.2 * contact_radius), ylim=(0, 1.65 * contact_radius))
    part.plot([0, contact_radius], [0, 0], color=COLOURS[1], lw=4, clip_on=False)
    part.set_title("near the contact; bar length: largest contact radius", fontsize=10)
    return figure


@styled({"axes.grid": False})
def mises_figure(computed: Computed) -> Figure:
    """Draw the von Mises stress at several forces and after unloading from each of these forces.

    Lengths are divided by the contact radius a at the force before unloading.
    """
    pressing = computed.pressing
    strength = pressing.material.hardening.yield_strength
    unloadings = pressing.unloadings.reset_index(drop=True)
    shown = unloadings.iloc[FORCES_SHOWN].drop_duplicates("force")
    size = (2.6 * len(shown) + 0.6, 4.4)
    figure, grid = subplots(2, len(shown), figsize=size, squeeze=False)
    for column, (number, row) in zip(grid.T, shown.iterrows(), strict=True):
        radius = row["contact_radius"]
        for axes, snapshot in zip(column, pressing.snapshots[2 * number :][:2], strict=True):
            contours = _draw_sphere(axes, snapshot, strength, 1 / radius)
            axes.set(xlim=(-2, 2), ylim=(0, 2.4), xlabel="r/a")
        column[0].set_title(f"{row['force']:g} N, a = {MM * radius:.2f} mm", fontsize=10)
        column[1].set_title("unloaded", fontsize=10)
    for axes in grid[:, 0]:
        axes.set_ylabel("height/a")
    figure.colorbar(contours, ax=grid, label=STRESS_LABEL, shrink=0.8)
    edge = Line2D([], [], color=COLOURS[1], lw=1.2, label="edge of the plastic zone")
    figure.legend(handles=[edge], loc="outside lower center", fontsize=8)
    return figure


def _draw_sphere(axes: Axes, snapshot: Snapshot, strength: float, scale: float) -> ContourSet:
    """Draw the stress with the lowest point of the sphere at height 0."""
    lowest = (snapshot.vertices + snapshot.displacement)[:, 1].min()
    return draw_stress(
        axes, snapshot, strength, origin=(0, lowest), scale=scale, zone_edge=ZONE_EDGE
    )


@styled()
def plastic_zone_figure(computed: Computed) -> Figure:
    """Draw the edge of the plastic zone at each of the forces `FORCES`."""
    pressing = computed.pressing
    forces = pressing.unloadings["force"]
    figure, axes = subplots(figsize=(6.4, 4.4))
    for force, snapshot, shade in zip(forces, pressing.snapshots[::2], shades(forces), strict=True):
        strain = at_vertices(snapshot, snapshot.plastic_strain)
        vertices, edge = MM * snapshot.vertices, [ZONE_EDGE]
        draw_field(axes, vertices, snapshot.quads, strain, edge, filled=False, colors=[shade])
        axes.plot([], [], color=shade, label=f"{force:g} N")
    reach = 2.2 * MM * pressing.unloadings["contact_radius"].max()
    axes.set(xlim=(-reach, reach), ylim=(0, 1.25 * reach))
    axes.set_aspect("equal")
    axes.set_xlabel("distance from the axis (mm)")
    axes.set_ylabel("height in the sphere (mm)")
    axes.legend(title="plastic zone at", fontsize=8)
    return figure


def collision_movie(computed: Computed) -> Movie:
    """Make a movie of an impact: von Mises stress near the contact, and force versus approach."""
    impact = computed.impacts[SHOWN]
    strength = impact.material.hardening.yield_strength
    history = impact.history
    times = [time for time in impact.snapshots if time < 1.05 * impact.contact_time]
    width = 2.2 * MM * history["contact_radius"].max()
    with styled({"axes.grid": False}):
        figure, (field, loop) = subplots(1, 2, figsize=(8, 3.8), width_ratios=(1.35, 1))
        colours = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0, 1), "viridis")
        figure.colorbar(colours, ax=field, label=STRESS_LABEL, shrink=0.8)
        (point,) = loop.plot([], [], "o", color=COLOURS[1], zorder=3)
        shown = history[history["time"] <= times[-1]]
        loop.plot(1e6 * shown["approach"], shown["force"] / 1e3, color=COLOURS[0])
        loop.set_xlabel("approach (µm)")
        loop.set_ylabel("force (kN)")

    @styled({"axes.grid": False})
    def draw(frame: int) -> None:
        time = times[frame]
        row = history.iloc[int(np.argmin(np.abs(history["time"] - time)))]
        field.clear()
        _draw_sphere(field, impact.snapshots[time], strength, MM)
        field.set(xlim=(-width, width), ylim=(0, 1.2 * width), xlabel="mm", ylabel="mm")
        field.set_title(f"{impact.speed:g} m/s, {1e6 * time:.0f} µs", fontsize=10)
        point.set_data([1e6 * row["approach"]], [row["force"] / 1e3])

    return Movie(figure, len(times), draw, rate=12)
