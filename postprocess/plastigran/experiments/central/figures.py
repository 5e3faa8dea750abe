# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures of collisions: restitution over impact speed, force over overlap."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.resources import files
from textwrap import fill

import matplotlib
import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator

from plastigran import laws
from plastigran.experiments.central import CentralImpact
from plastigran.experiments.central.arrangement import on_wall
from plastigran.experiments.collision import CollisionOutcome
from plastigran.materials import USUAL, Material
from plastigran.physics import central
from plastigran.plot.prefixes import prefix
from plastigran.plot.style import COLOURS, MARKERS, law_number, styled, subplots, title

Collisions = Mapping[CentralImpact, CollisionOutcome]

#: Loops in a panel.
LOOPS = 5


def finite_elements() -> pd.DataFrame:
    """Peak force and restitution from the paper's finite elements; see the file's head."""
    source = files("plastigran") / "data" / "finite_elements_zv02.csv"
    with source.open() as file:
        return pd.read_csv(file, comment="#")


def restitution_figure(collisions: Collisions, by_theory: bool = False) -> Figure:
    """Restitution over impact speed: points from the engine, lines from theory.

    With `by_theory` the points are theory's too. Thornton's line is its closed form; the others' is
    the energy balance of the law. The paper's finite elements are shown where all impacts are of
    their sphere.
    """
    with styled():
        curves = _curves(collisions)
        crowded = len(curves) > 6
        figure, axes = subplots(figsize=(8.6 if crowded else 6.4, 4.6))
        settings = list(dict.fromkeys(_setting(impact) for impact in collisions))
        for (law, setting, name), runs in curves.items():
            shade, style = law_number(law), settings.index(setting)
            colour, marker = COLOURS[shade], MARKERS[shade]
            speeds = [impact.speed for impact, _ in runs]
            line = np.geomspace(speeds[0] / 1.3, speeds[-1] * 1.3, 200)
            dashes = ["-", "--", ":", "-."][style % 4]
            look = {"color": colour, "mfc": colour if style else "white", "ms": 6, "lw": 1.3}
            axes.plot(line, _theory(runs[0][0], line), dashes, **look)
            found = [collision.coefficient_of_restitution for _, collision in runs]
            axes.plot(speeds, found, ls="", marker=marker, **look)
            axes.plot([], [], ls=dashes, marker=marker, label=name, **look)
        if all(_is_of_paper(impact) for impact in collisions):
            paper = finite_elements().dropna()
            axes.plot(
                paper["speed"],
                paper["coefficient_of_restitution"],
                "x",
                color="black",
                ms=8,
                mew=2,
                label="finite elements (Zhang & Vu-Quoc 2002)",
            )
        _speed_axes(axes, list(collisions))
        axes.set_ylabel("coefficient of restitution")
        axes.set_ylim(0, 1.05)
        place = {"loc": "center left", "bbox_to_anchor": (1, 0.5)} if crowded else {"loc": "best"}
        said = None if by_theory else "points: LIGGGHTS, lines: theory"
        axes.legend(title=said, fontsize="small", title_fontsize="small", **place)
        figure.suptitle(_common(collisions), fontsize=10)
    return figure


def _is_of_paper(impact: CentralImpact) -> bool:
    given = impact.material.name, impact.radius, impact.wall, impact.options
    return given == ("aluminium_zv02", 0.1, None, None)


def _setting(impact: CentralImpact) -> tuple[Material, float, str, Material | None, str | None]:
    """All of an impact but its law and speed."""
    return impact.material, impact.radius, impact.geometry, impact.wall, impact.options


def _curves(
    collisions: Collisions,
) -> dict[tuple[str, tuple, str], list[tuple[CentralImpact, CollisionOutcome]]]:
    """Impacts of one law and setting, by speed; their name says what sets them apart."""
    materials, radii, geometries, walls, _ = map(set, zip(*map(_setting, collisions), strict=True))
    chosen: dict = {}
    for impact in collisions:
        chosen.setdefault(impact.law, set()).add(impact.options)
    found: dict = {}
    for impact, collision in sorted(collisions.items(), key=lambda run: (run[0].law, run[0].speed)):
        name = [title(impact.law)]
        if len(materials) > 1:
            name.append(title(impact.material.name))
        if len(radii) > 1:
            name.append(f"{impact.radius:g} m")
        if len(geometries) > 1:
            name.append(impact.geometry.replace("_", " "))
        if len(walls) > 1 and impact.bodies == 1:
            name.append(on_wall(impact.wall_name))
        if impact.options or len(chosen[impact.law]) > 1:
            name.append(impact.options or USUAL)
        key = (impact.law, _setting(impact), ", ".join(name))
        found.setdefault(key, []).append((impact, collision))
    return found


def _common(collisions: Collisions) -> str:
    """What all impacts share, in words."""
    impacts = list(collisions)
    material, radius, geometry, wall, _ = map(set, zip(*map(_setting, impacts), strict=True))
    said = [f"{title(one.name)}" for one in material if len(material) == 1]
    said += [f"radius {one:g} m" for one in radius if len(radius) == 1]
    if geometry == {"two_spheres"}:
        said.append("two spheres")
    elif "two_spheres" not in geometry:
        said += [on_wall(impacts[0].wall_name)] if len(wall) == 1 else []
    return ", ".join(said)


def _theory(model: CentralImpact, speeds: np.ndarray) -> np.ndarray:
    if model.law == "thornton":
        return central.thornton_restitution(speeds / model.yield_speed())
    law, speeds = model.contact_law(), speeds * model.bodies
    impacts = law.central_impact(model.radius_eff, model.mass_eff, speeds)
    return impacts.coefficient_of_restitution


def _speed_axes(axes: Axes, impacts: list[CentralImpact]) -> None:
    axes.set_xscale("log")
    axes.set_xlabel("impact speed (m/s)")
    yielding = [impact for impact in impacts if laws.LAWS[impact.law].yields]
    yield_speeds = {impact.yield_speed() for impact in yielding}
    if len(yield_speeds) == 1:
        scale = yield_speeds.pop()
        upper = axes.secondary_xaxis("top", functions=(lambda v: v / scale, lambda q: q * scale))
        upper.set_xlabel("impact speed / yield speed")
        _plain_ticks(upper)
    _plain_ticks(axes)


def _plain_ticks(axes: Axes) -> None:
    """Few plain numbers along a logarithmic axis."""
    slowest, fastest = axes.get_xlim()
    subs = (1, 2, 5) if fastest < 100 * slowest else (1,)
    axes.xaxis.set_major_locator(LogLocator(subs=subs))
    axes.xaxis.set_major_formatter("{x:g}")
    axes.xaxis.set_minor_formatter("")


def loops_figure(collisions: Collisions) -> Figure:
    """Force over overlap, one panel a law and setting, one loop a speed: the `LOOPS`
    fastest, the rest are too small to see beside them."""
    curves = _curves(collisions)
    small, factor = prefix([collision.force_max for collision in collisions.values()])
    like = len({setting[:-1] for _, setting, _ in curves}) == 1
    with styled():
        columns = min(len(curves), 4)
        rows = -(-len(curves) // columns)
        figure, panels = subplots(
            rows,
            columns,
            figsize=(3.4 * columns + 0.4, 3.2 * rows + 0.4),
            sharex=like,
            sharey=like,
            squeeze=False,
        )
        for axes in panels.flat[len(curves) :]:
            axes.set_visible(False)
        for axes, ((_, _, name), runs) in zip(panels.flat, curves.items(), strict=False):
            shown = runs[-LOOPS:]
            shades = matplotlib.colormaps["viridis"](np.linspace(0.1, 0.85, len(shown)))
            for (impact, collision), shade in zip(shown, shades, strict=True):
                loop = impact.theoretical_loop() if collision.loop is None else collision.loop
                touching = loop[loop["overlap"] >= 0]
                axes.plot(
                    touching["overlap"] * 1e6,
                    touching["force"] * factor,
                    color=shade,
                    label=f"{impact.speed:.3g} m/s",
                )
            axes.set_title(name, fontsize=10)
        for axes in panels[:, 0]:
            axes.set_ylabel(f"normal force ({small}N)")
        lowest = panels.flat[max(len(curves) - columns, 0) : len(curves)]  # of each column
        for axes in lowest if like else panels.flat[: len(curves)]:
            axes.tick_params(labelbottom=True)
            axes.set_xlabel("overlap (µm)")
        said = None
        for axes in panels.flat[: len(curves)]:
            handles, labels = axes.get_legend_handles_labels()
            if labels != said:  # else it has the speeds of the panel before
                axes.legend(handles, labels, loc="upper left", fontsize=8)
            said = labels
        said = [_common(collisions)]
        if (speeds := max(map(len, curves.values()))) > LOOPS:
            said.append(f"the {LOOPS} fastest of {speeds} speeds")
        line = int(12 * figure.get_figwidth())  # characters, at most
        figure.suptitle(fill("; ".join(filter(None, said)), line), fontsize=10)
    return figure
