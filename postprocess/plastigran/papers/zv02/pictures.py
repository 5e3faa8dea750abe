# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of the sphere: mesh, von Mises stress and plastic zones, and a movie of an impact."""

from __future__ import annotations

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from skfem import MeshQuad2

from plastigran.fem.sphere.fields import at_vertices
from plastigran.fem.sphere.results import Pressing, Throw
from plastigran.fem.stepping.snapshot import Snapshot
from plastigran.plot.fields import draw_field, draw_mesh
from plastigran.plot.movie import Movie
from plastigran.plot.style import COLOURS, styled, subplots

MM = 1e3
#: Plastic strain at the edges that are drawn: here a hundredth of the yield strain.
ZONE_EDGE = 1e-5
LEVELS = np.linspace(0, 1, 11)  # von Mises stress / flow stress


def mesh_figure(mesh: MeshQuad2, contact_radius: float) -> Figure:
    """Draw the whole mesh, and its part near the contact.

    Args:
        mesh: Mesh in m.
        contact_radius: Largest contact radius, m.
    """
    with styled({"axes.grid": False}):
        figure, (whole, part) = subplots(1, 2, figsize=(7.2, 3.7), width_ratios=(1, 1.7))
        for axes in (whole, part):
            draw_mesh(axes, MM * mesh.doflocs.T, mesh.dofs.element_dofs[:8].T)
            axes.set_aspect("equal")
            axes.set_xlabel("distance from the axis (mm)")
        whole.autoscale()
        whole.set_ylabel("height (mm)")
        whole.set_title(f"{mesh.nelements} elements of eight nodes", fontsize=10)
        width = 2.2 * MM * contact_radius
        part.set(xlim=(0, width), ylim=(0, 0.75 * width))
        part.plot([0, MM * contact_radius], [0, 0], color=COLOURS[1], lw=4, clip_on=False)
        part.set_title("about the contact, which reaches as far as the bar", fontsize=10)
    return figure


def mises_figure(pressing: Pressing, shown: tuple[float, ...]) -> Figure:
    """Draw von Mises stress / flow stress at some largest forces and after each unloading.

    Lengths are divided by the contact radius at that force.

    Args:
        pressing: Compression of a perfectly plastic sphere.
        shown: Largest forces to show, N.
    """
    strength = pressing.material.hardening.yield_strength
    forces = pressing.unloadings["force"].to_numpy()
    with styled({"axes.grid": False}):
        figure, grid = subplots(2, len(shown), figsize=(2.6 * len(shown) + 0.6, 4.4), squeeze=False)
        for column, force in zip(grid.T, shown, strict=True):
            number = int(np.argmin(np.abs(forces - force)))
            radius = pressing.unloadings["contact_radius"].iloc[number]
            for axes, snapshot in zip(
                column, pressing.snapshots[2 * number : 2 * number + 2], strict=True
            ):
                contours = _draw_mises(axes, snapshot, strength, 1 / radius)
                axes.set(xlim=(-2, 2), ylim=(0, 2.4), xlabel="r/a")
                axes.set_aspect("equal")
            column[0].set_title(f"{force:g} N, a = {MM * radius:.2f} mm", fontsize=10)
            column[1].set_title("let go", fontsize=10)
        for axes in grid[:, 0]:
            axes.set_ylabel("height/a")
        figure.colorbar(contours, ax=grid, label="von Mises stress over flow stress", shrink=0.8)
        zone = Line2D([], [], color=COLOURS[1], lw=1.2, label="edge of what has yielded")
        figure.legend(handles=[zone], loc="outside lower center", fontsize=8)
    return figure


def _draw_mises(axes: Axes, snapshot: Snapshot, strength: float, scale: float) -> object:
    """Draw the stress and the edge of the plastic zone on the deformed body."""
    vertices = snapshot.vertices + snapshot.displacement
    vertices = scale * (vertices - [0, vertices[:, 1].min()])
    stress = at_vertices(snapshot, snapshot.mises) / strength
    stress = np.minimum(stress, 1 - 1e-9)  # points at the flow stress belong to the last level
    contours = draw_field(axes, vertices, snapshot.quads, stress, LEVELS, cmap="viridis")
    yielded = at_vertices(snapshot, snapshot.plastic_strain)
    if yielded.max() > ZONE_EDGE:
        edge = {"colors": COLOURS[1], "linewidths": 1.2}
        draw_field(axes, vertices, snapshot.quads, yielded, [ZONE_EDGE], filled=False, **edge)
    return contours


def plastic_zone_figure(pressing: Pressing) -> Figure:
    """Draw the edges of the plastic zone at each largest force."""
    forces = pressing.unloadings["force"]
    with styled():
        figure, axes = subplots(figsize=(6.4, 4.4))
        shades = matplotlib.colormaps["viridis"](np.linspace(0.05, 0.85, len(forces)))
        for force, snapshot, shade in zip(forces, pressing.snapshots[::2], shades, strict=True):
            yielded = at_vertices(snapshot, snapshot.plastic_strain)
            vertices = MM * snapshot.vertices
            draw_field(
                axes, vertices, snapshot.quads, yielded, [ZONE_EDGE], filled=False, colors=[shade]
            )
            axes.plot([], [], color=shade, label=f"{force:g} N")
        reach = 2.2 * MM * pressing.unloadings["contact_radius"].max()
        axes.set(xlim=(-reach, reach), ylim=(0, 1.25 * reach))
        axes.set_aspect("equal")
        axes.set_xlabel("distance from the axis (mm)")
        axes.set_ylabel("height in the sphere (mm)")
        axes.legend(title="has yielded, at", fontsize=8)
    return figure


def collision_movie(throw: Throw) -> Movie:
    """Make a movie of von Mises stress near the contact and force over approach in an impact."""
    strength = throw.material.hardening.yield_strength
    history = throw.history
    times = [time for time in throw.snapshots if time < 1.05 * throw.contact_time]
    width = 2.2 * MM * history["contact_radius"].max()
    with styled({"axes.grid": False}):
        figure, (field, loop) = subplots(1, 2, figsize=(8, 3.8), width_ratios=(1.35, 1))
        colours = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0, 1), "viridis")
        figure.colorbar(colours, ax=field, label="von Mises stress / flow stress", shrink=0.8)
        (point,) = loop.plot([], [], "o", color=COLOURS[1], zorder=3)
        touching = history[history["time"] <= times[-1]]
        loop.plot(1e6 * touching["approach"], touching["force"] / 1e3, color=COLOURS[0])
        loop.set_xlabel("approach (µm)")
        loop.set_ylabel("force (kN)")

    def draw(number: int) -> None:
        time = times[number]
        row = history.iloc[int(np.argmin(np.abs(history["time"] - time)))]
        with styled({"axes.grid": False}):
            field.clear()
            _draw_mises(field, throw.snapshots[time], strength, MM)
            field.set(xlim=(-width, width), ylim=(0, 1.2 * width), xlabel="mm", ylabel="mm")
            field.set_aspect("equal")
            field.set_title(f"{throw.speed:g} m/s, {1e6 * time:.0f} µs", fontsize=10)
        point.set_data([1e6 * row["approach"]], [row["force"] / 1e3])

    return Movie(figure, len(times), draw, rate=12)
