# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures of the sphere of Zhang & Vu-Quoc (2002): restitution, force, radius and pressure."""

from __future__ import annotations

import matplotlib
import numpy as np
from matplotlib.figure import Figure

from plastigran import laws
from plastigran.experiments.central.curves import finite_elements
from plastigran.fem.sphere.results import first_loading_of
from plastigran.papers.zv02.computations import (
    LAWS,
    MASS,
    PAIR,
    RADIUS,
    SPHERE,
    Computed,
)
from plastigran.papers.zv02.tables import nodal_restitution
from plastigran.plot.style import COLOURS, law_colour, styled, subplots, title

GREY = "0.45"  # color of elastic results
FINITE_ELEMENTS = {"color": "k", "lw": 1.6, "label": "finite elements"}  # style of curves


def shades(forces: np.ndarray) -> np.ndarray:
    """Return one color for each of n forces, (n, 4) RGBA."""
    return matplotlib.colormaps["viridis"](np.linspace(0.05, 0.85, len(forces)))


@styled()
def restitution_figure(computed: Computed) -> Figure:
    """Draw restitution versus impact speed: laws (lines), finite elements and LIGGGHTS (points)."""
    speeds = np.geomspace(SPHERE.yield_speed, 1.2 * max(computed.impacts), 150)
    figure, axes = subplots(figsize=(7.6, 4.6))
    for name in LAWS:
        colour = law_colour(name)
        impact = laws.LAWS[name](PAIR).central_impact(RADIUS, MASS, speeds)
        axes.plot(speeds, impact.coefficient_of_restitution, color=colour, label=title(name))
        runs = [computed.run(name, v).coefficient_of_restitution for v in computed.impacts]
        axes.plot(list(computed.impacts), runs, "o", mfc="white", ms=5, color=colour)
    for speed, impact in computed.impacts.items():
        by_nodes = nodal_restitution(impact)
        axes.plot([speed, speed], [by_nodes.min(), by_nodes.max()], color="0.8", lw=5)
    axes.plot([], [], color="0.8", lw=5, label="finite elements, by mean nodal velocity (range)")
    ours = [impact.coefficient_of_restitution for impact in computed.impacts.values()]
    axes.plot(list(computed.impacts), ours, "ks", ms=6, label="finite elements, by momentum")
    paper = finite_elements().dropna()
    values = paper["coefficient_of_restitution"]
    axes.plot(paper["speed"], values, "rx", ms=9, mew=2, label="finite elements of the paper")
    axes.set(xscale="log", xlabel="impact speed (m/s)", ylabel="coefficient of restitution")
    axes.set_ylim(0.3, 1.02)
    axes.legend(title="circles: LIGGGHTS", fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5))
    return figure


@styled()
def collisions_figure(computed: Computed) -> Figure:
    """Draw force versus time during impacts, in one panel for each speed.

    The curves are finite elements with and without plastic flow, and LIGGGHTS runs with `hertz` and
    with the law of the paper.
    """
    speeds = list(computed.impacts)
    figure, panels = subplots(1, len(speeds), figsize=(2.6 * len(speeds) + 0.4, 3.4), squeeze=False)
    for axes, speed in zip(panels[0], speeds, strict=True):
        for law, colour in (("hertz", GREY), (LAWS[0], law_colour(LAWS[0]))):
            loop = computed.run(law, speed).loop
            # Select the last output before contact, while the sphere moves toward the plane.
            before = loop[loop["force"] == 0].iloc[0]
            first_touch = before["time"] - before["overlap"] / before["speed"]
            time = 1e6 * (loop["time"] - first_touch)
            axes.plot(time, loop["force"] / 1e3, "--", color=colour, label=title(law), lw=1)
        for colour, impacts, label in (
            (GREY, computed.elastic_impacts, "finite elements, elastic"),
            (COLOURS[1], computed.impacts, "finite elements, plastic"),
        ):
            if speed in impacts:
                history = impacts[speed].history
                axes.plot(1e6 * history["time"], history["force"] / 1e3, color=colour, label=label)
        axes.set_title(f"{speed:g} m/s", fontsize=10)
        axes.set_xlabel("time (µs)")
        end = 1.1e6 * max(SPHERE.duration(speed), computed.impacts[speed].contact_time)
        axes.set(xlim=(0, end), ylim=(0, None))
    panels[0, 0].set_ylabel("force (kN)")
    handles, labels = panels[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=2, fontsize=8)
    return figure


@styled()
def loops_figure(computed: Computed) -> Figure:
    """Draw force versus approach with unloading from several forces: finite elements and laws."""
    pressing = computed.pressing
    tops = pressing.unloadings["approach"].to_numpy()
    figure, panels = subplots(1, 2, figsize=(8.6, 3.8), width_ratios=(1, 1))
    for axes, shown in zip(panels, (tops[: len(tops) // 2 + 1], tops), strict=True):
        for name in LAWS[:4]:
            loading = np.linspace(0, shown[-1], 400)
            path = np.concatenate([loading, loading[::-1]])
            force = laws.LAWS[name](PAIR).follow(RADIUS, path)["force"]
            axes.plot(1e6 * path, force / 1e3, color=law_colour(name), lw=1, label=title(name))
        history = pressing.history[pressing.history["branch"] < 2 * len(shown)]
        axes.plot(1e6 * history["approach"], history["force"] / 1e3, **FINITE_ELEMENTS)
        axes.set(xlabel="approach (µm)", ylim=(0, None), xlim=(0, None))
    panels[0].set_ylabel("force (kN)")
    panels[0].legend(fontsize=8)
    return figure


@styled()
def contact_radius_figure(computed: Computed) -> Figure:
    """Draw contact radius versus force during loading: finite elements, laws and Hertz."""
    loading = first_loading_of(computed.pressing.history)
    force = loading["force"].to_numpy()
    overlap = np.linspace(0, 1.6 * loading["approach"].max(), 4000)
    figure, axes = subplots(figsize=(6.4, 4.2))

    def draw(force: np.ndarray, radius: np.ndarray, *line: str, **style: object) -> None:
        axes.plot(force / 1e3, 1e3 * radius, *line, **style)

    for name in LAWS:
        path = laws.LAWS[name](PAIR).follow(RADIUS, overlap)
        shown = path["force"] <= force[-1]
        style = {"color": law_colour(name), "lw": 1, "label": title(name)}
        draw(path["force"][shown], path["contact_radius"][shown], **style)
    hertz = np.array([SPHERE.contact_radius(value) for value in force])
    draw(force, hertz, ":", color="0.5", label="Hertz")
    draw(force, loading["contact_radius"], **FINITE_ELEMENTS)
    axes.set(xlabel="force (kN)", ylabel="contact radius (mm)", xlim=(0, None), ylim=(0, None))
    axes.legend(fontsize=8)
    return figure


@styled()
def pressure_figure(computed: Computed) -> Figure:
    """Draw the contact pressure versus distance from the axis at several forces.

    The left panel shows an elastic sphere with Hertz' pressure, the right panel an elastic-plastic
    sphere.
    """
    plastic, elastic = computed.pressing, computed.elastic_pressing
    strength = plastic.material.hardening.yield_strength
    forces = plastic.unloadings["force"]
    figure, (left, right) = subplots(1, 2, figsize=(8.6, 3.9), sharex=True)
    x = np.linspace(0, 1, 200)
    for axes, pressing in ((left, elastic), (right, plastic)):
        for force, shade, snapshot, radius in zip(
            forces,
            shades(forces),
            pressing.snapshots[::2],
            pressing.unloadings["contact_radius"],
            strict=True,
        ):
            inside = snapshot.radii < radius
            axes.plot(
                snapshot.radii[inside] / radius,
                snapshot.pressure[inside] / strength,
                ".-" if pressing is plastic else ".",
                color=shade,
                ms=4,
                lw=1,
                label=f"{force:g} N",
            )
            if pressing is elastic:
                peak = 1.5 * force / (np.pi * SPHERE.contact_radius(force) ** 2 * strength)
                axes.plot(x, peak * np.sqrt(1 - x**2), color=shade, lw=0.8)
        axes.set(xlabel="r/a", ylim=(0, None))
    left.set_ylabel("pressure / yield strength")
    left.set_title("elastic; lines: Hertz", fontsize=10)
    right.set_title("elastic-plastic", fontsize=10)
    right.legend(fontsize=8)
    return figure
