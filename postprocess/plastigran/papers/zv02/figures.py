# SPDX-License-Identifier: GPL-2.0-or-later
"""Curves of the sphere: restitution, impacts over time, loops, contact radius and pressure."""

from __future__ import annotations

import matplotlib
import numpy as np
from matplotlib.figure import Figure

from plastigran import laws
from plastigran.experiments.central.curves import finite_elements
from plastigran.fem.sphere.results import Pressing, virgin_loading
from plastigran.papers.zv02.computations import (
    LAWS,
    MASS,
    PAIR,
    RADIUS,
    SPHERE,
    Computed,
)
from plastigran.papers.zv02.tables import nodal_swing
from plastigran.plot.style import COLOURS, law_colour, styled, subplots, title

GREY = "0.45"  # color of elastic results


def restitution_figure(computed: Computed) -> Figure:
    """Draw restitution over impact speed: laws as lines, finite elements, LIGGGHTS, the paper."""
    speeds = np.geomspace(SPHERE.yield_speed, 1.2 * max(computed.throws), 150)
    with styled():
        figure, axes = subplots(figsize=(7.6, 4.6))
        for name in LAWS:
            colour = law_colour(name)
            impact = laws.LAWS[name](PAIR).central_impact(RADIUS, MASS, speeds)
            axes.plot(speeds, impact.coefficient_of_restitution, color=colour, label=title(name))
            table = computed.runs.table
            rows = table[table["law"] == name]
            shown = {"mfc": "white", "ms": 5, "color": colour}
            axes.plot(rows["speed"], rows["coefficient_of_restitution"], "o", **shown)
        for speed, throw in computed.throws.items():
            swing = nodal_swing(throw)
            axes.plot([speed, speed], [swing.min(), swing.max()], color="0.8", lw=5)
        axes.plot([], [], color="0.8", lw=5, label="finite elements, by nodes: after the contact")
        ours = [throw.coefficient_of_restitution for throw in computed.throws.values()]
        axes.plot(list(computed.throws), ours, "ks", ms=6, label="finite elements, by momentum")
        paper = finite_elements().dropna()
        axes.plot(
            paper["speed"],
            paper["coefficient_of_restitution"],
            "rx",
            ms=9,
            mew=2,
            label="finite elements of the paper",
        )
        axes.set(xscale="log", xlabel="impact speed (m/s)", ylabel="coefficient of restitution")
        axes.set_ylim(0.3, 1.02)
        axes.legend(
            title="circles: LIGGGHTS", fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5)
        )
    return figure


def collisions_figure(computed: Computed) -> Figure:
    """Draw force over time, a panel for each speed.

    Finite elements with and without plastic flow, Hertz, and the paper's law in LIGGGHTS.
    """
    outcomes = {(case.law, case.speed): found for case, found in computed.runs.outcomes.items()}
    with styled():
        speeds = list(computed.throws)
        figure, panels = subplots(
            1, len(speeds), figsize=(2.6 * len(speeds) + 0.4, 3.4), squeeze=False
        )
        for axes, speed in zip(panels[0], speeds, strict=True):
            for colour, law in ((GREY, "hertz"), (law_colour(LAWS[0]), LAWS[0])):
                loop = outcomes[law, speed].loop
                before = loop[loop["force"] == 0].iloc[0]  # the sphere flies toward the plane
                touch = before["time"] - before["overlap"] / before["speed"]
                time = 1e6 * (loop["time"] - touch)
                axes.plot(time, loop["force"] / 1e3, "--", color=colour, label=title(law), lw=1)
            for colour, impacts, said in (
                (GREY, computed.elastic_throws, "finite elements, elastic"),
                (COLOURS[1], computed.throws, "finite elements, plastic"),
            ):
                if speed not in impacts:
                    continue
                history = impacts[speed].history
                axes.plot(1e6 * history["time"], history["force"] / 1e3, color=colour, label=said)
            axes.set_title(f"{speed:g} m/s", fontsize=10)
            axes.set_xlabel("time (µs)")
            end = 1.1e6 * max(SPHERE.duration(speed), computed.throws[speed].contact_time)
            axes.set(xlim=(0, end), ylim=(0, None))
        panels[0, 0].set_ylabel("force (kN)")
        handles, labels = panels[0, 0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside lower center", ncols=2, fontsize=8)
    return figure


def loops_figure(pressing: Pressing) -> Figure:
    """Draw force over approach with an unloading from each force: finite elements and laws."""
    tops = pressing.unloadings["approach"].to_numpy()
    with styled():
        figure, panels = subplots(1, 2, figsize=(8.6, 3.8), width_ratios=(1, 1))
        middle = len(tops) // 2
        for axes, shown in zip(panels, (tops[: middle + 1], tops), strict=True):
            for name in LAWS[:4]:
                law = laws.LAWS[name](PAIR)
                up = np.linspace(0, shown[-1], 400)
                path = np.concatenate([up, up[::-1]])
                force = law.follow(RADIUS, path)["force"]
                axes.plot(1e6 * path, force / 1e3, color=law_colour(name), lw=1, label=title(name))
            history = pressing.history[pressing.history["branch"] < 2 * len(shown)]
            axes.plot(
                1e6 * history["approach"],
                history["force"] / 1e3,
                "k",
                lw=1.6,
                label="finite elements",
            )
            axes.set(xlabel="approach (µm)", ylim=(0, None), xlim=(0, None))
        panels[0].set_ylabel("force (kN)")
        panels[0].legend(fontsize=8)
    return figure


def contact_radius_figure(pressing: Pressing) -> Figure:
    """Draw contact radius over force during loading: finite elements, laws and Hertz."""
    loading = virgin_loading(pressing.history)
    force = loading["force"].to_numpy()
    overlap = np.linspace(0, 1.6 * loading["approach"].max(), 4000)
    with styled():
        figure, axes = subplots(figsize=(6.4, 4.2))
        for name in LAWS:
            answer = laws.LAWS[name](PAIR).follow(RADIUS, overlap)
            shown = answer["force"] <= force[-1]
            axes.plot(
                answer["force"][shown] / 1e3,
                1e3 * answer["contact_radius"][shown],
                color=law_colour(name),
                lw=1,
                label=title(name),
            )
        hertz = [1e3 * SPHERE.contact_radius(value) for value in force]
        axes.plot(force / 1e3, hertz, ":", color="0.5", label="Hertz")
        axes.plot(
            force / 1e3, 1e3 * loading["contact_radius"], "k", lw=1.6, label="finite elements"
        )
        axes.set(xlabel="force (kN)", ylabel="contact radius (mm)", xlim=(0, None), ylim=(0, None))
        axes.legend(fontsize=8)
    return figure


def pressure_figure(pressing: Pressing, elastic: Pressing) -> Figure:
    """Draw pressure over distance from the axis at each largest force, plastic and elastic."""
    strength = pressing.material.hardening.yield_strength
    forces = pressing.unloadings["force"]
    shades = matplotlib.colormaps["viridis"](np.linspace(0.05, 0.85, len(forces)))
    with styled():
        figure, (left, right) = subplots(1, 2, figsize=(8.6, 3.9), sharex=True)
        for axes, found in ((left, elastic), (right, pressing)):
            for force, shade, snapshot, top in zip(
                forces,
                shades,
                found.snapshots[::2],
                found.unloadings["contact_radius"],
                strict=True,
            ):
                touching = snapshot.radii < top
                axes.plot(
                    snapshot.radii[touching] / top,
                    snapshot.pressure[touching] / strength,
                    ".-" if found is pressing else ".",
                    color=shade,
                    ms=4,
                    lw=1,
                    label=f"{force:g} N",
                )
                if found is elastic:
                    x = np.linspace(0, 1, 200)
                    peak = 1.5 * force / (np.pi * SPHERE.contact_radius(force) ** 2 * strength)
                    axes.plot(x, peak * np.sqrt(1 - x**2), color=shade, lw=0.8)
            axes.set(xlabel="r/a", ylim=(0, None))
        left.set_ylabel("pressure over yield strength")
        left.set_title("elastic; lines: Hertz", fontsize=10)
        right.set_title("elastic-plastic", fontsize=10)
        right.legend(fontsize=8)
    return figure
