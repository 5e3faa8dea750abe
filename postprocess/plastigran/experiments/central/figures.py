# SPDX-License-Identifier: GPL-2.0-or-later
"""Static figures of central impacts: restitution versus speed, and force versus overlap."""

from __future__ import annotations

from collections.abc import Sequence
from textwrap import fill

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator

from plastigran import laws
from plastigran.experiments.central import CentralImpact
from plastigran.experiments.central.arrangement import on_wall
from plastigran.experiments.central.curves import loop_panels, measured_panels, varied
from plastigran.experiments.record import materials_of
from plastigran.experiments.runs import Runs
from plastigran.plot.chart import Panel
from plastigran.plot.static import draw
from plastigran.plot.style import styled, subplots, title

#: Largest number of force-overlap loops in a panel.
LOOPS = 5
RESTITUTION = "coefficient_of_restitution"
#: Names of the codes that run impacts, by the setting `host`.
HOSTS = {"liggghts": "LIGGGHTS", "lammps": "LAMMPS"}


def restitution_figure(runs: Runs) -> Figure:
    """Draw restitution versus impact speed: points of LIGGGHTS or LAMMPS, and lines of theory.

    If no impact was simulated, the points are theory, too. If all spheres are the sphere of Zhang
    and Vu-Quoc (2002), the figure also shows their finite-element results.
    """
    materials = materials_of(runs.cases)
    panel = measured_panels(runs.table, materials, [RESTITUTION], "speed")[RESTITUTION]
    crowded = len({curve.name for curve in panel.curves if curve.law}) > 6
    with styled():
        figure, axes = subplots(figsize=(8.6 if crowded else 6.4, 4.6))
        draw(axes, panel)
        _speed_axes(axes, runs.cases)
        place = {"loc": "center left", "bbox_to_anchor": (1, 0.5)} if crowded else {"loc": "best"}
        heading = None if runs.by_theory else f"points: {HOSTS[runs.cases[0].host]}, lines: theory"
        axes.legend(title=heading, fontsize="small", title_fontsize="small", **place)
        figure.suptitle(_common(runs.cases), fontsize=10)
    return figure


def _common(impacts: Sequence[CentralImpact]) -> str:
    """Return the material, radius, wall and options that all impacts share, in words."""
    materials = {impact.material for impact in impacts}
    radii = {impact.radius for impact in impacts}
    geometries = {impact.geometry for impact in impacts}
    words = [title(material.name) for material in materials if len(materials) == 1]
    words += [f"radius {radius:g} m" for radius in radii if len(radii) == 1]
    if geometries == {"two_spheres"}:
        words.append("two spheres")
    elif "two_spheres" not in geometries and len({impact.wall for impact in impacts}) == 1:
        words.append(on_wall(impacts[0].wall_name))
    if len(options := {impact.options for impact in impacts}) == 1:
        words += filter(None, options)
    return ", ".join(words)


def _speed_axes(axes: Axes, impacts: Sequence[CentralImpact]) -> None:
    axes.set_xscale("log")
    yielding = [impact for impact in impacts if laws.LAWS[impact.law].yields]
    yield_speeds = {impact.yield_speed() for impact in yielding}
    if len(yield_speeds) == 1:
        scale = yield_speeds.pop()
        upper = axes.secondary_xaxis("top", functions=(lambda v: v / scale, lambda q: q * scale))
        upper.set_xlabel("impact speed / yield speed")
        _plain_ticks(upper)
    _plain_ticks(axes)


def _plain_ticks(axes: Axes) -> None:
    """Label a logarithmic x axis with few numbers, without powers of ten."""
    slowest, fastest = axes.get_xlim()
    subs = (1, 2, 5) if fastest < 100 * slowest else (1,)
    axes.xaxis.set_major_locator(LogLocator(subs=subs))
    axes.xaxis.set_major_formatter("{x:g}")
    axes.xaxis.set_minor_formatter("")


def loops_figure(runs: Runs) -> Figure:
    """Draw force versus overlap: a panel for each law and setting, a loop for each speed.

    A panel shows the `LOOPS` fastest impacts, because slower loops would be too small to see.
    """
    loops = []
    for impact, collision in runs.outcomes.items():
        loop = impact.theoretical_loop() if collision.loop is None else collision.loop
        touching = (loop["overlap"] >= 0) | (loop["force"] != 0)
        loops.append((impact.facts(), loop[touching]))
    panels = loop_panels(loops, "law", "speed", varied(runs.table), common_axes=True)
    bodies = {(case.material, case.radius, case.geometry, case.wall) for case in runs.cases}
    alike = len(bodies) == 1
    with styled():
        figure, axes = _grid(len(panels), alike)
        for place, (name, panel) in zip(axes.flat, panels.items(), strict=False):
            _draw_loops(place, name, panel)
        _label_edges(axes, len(panels), alike)
        words = [_common(runs.cases)]
        if (speeds := max(len(panel.curves) for panel in panels.values())) > LOOPS:
            words.append(f"the {LOOPS} fastest of {speeds} speeds")
        width = int(12 * figure.get_figwidth())  # width of the title in characters
        figure.suptitle(fill("; ".join(filter(None, words)), width), fontsize=10)
    return figure


def _draw_loops(axes: Axes, name: str, panel: Panel) -> None:
    curves = panel.curves[-LOOPS:]
    shades = matplotlib.colormaps["viridis"](np.linspace(0.1, 0.85, len(curves)))
    draw(axes, Panel(x=panel.x, y=panel.y, curves=curves), shades)
    axes.set_title(name, fontsize=10)


def _grid(count: int, alike: bool) -> tuple[Figure, np.ndarray]:
    columns = min(count, 4)
    rows = -(-count // columns)
    return subplots(
        rows,
        columns,
        figsize=(3.4 * columns + 0.4, 3.2 * rows + 0.4),
        sharex=alike,
        sharey=alike,
        squeeze=False,
    )


def _label_edges(axes: np.ndarray, count: int, alike: bool) -> None:
    """Label only the outer axes of a grid of panels, and omit repetitions of the same legend."""
    columns = axes.shape[1]
    previous_labels = None
    for k, place in enumerate(axes.flat):
        place.set_visible(k < count)
        if k >= count:
            continue
        if k % columns:
            place.set_ylabel("")
        if alike and k + columns < count:
            place.set_xlabel("")
        else:
            place.tick_params(labelbottom=True)
        labels = place.get_legend_handles_labels()[1]
        if labels != previous_labels:
            place.legend(loc="upper left", fontsize=8)
        previous_labels = labels
