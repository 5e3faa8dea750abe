# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures of collisions: restitution over impact speed, force over overlap."""

from __future__ import annotations

from importlib.resources import files

import matplotlib
import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from plastigran import laws
from plastigran.experiments.central import CentralImpact
from plastigran.experiments.collision import CollisionOutcome
from plastigran.physics import central
from plastigran.plot.style import COLOURS, MARKERS, styled, subplots, title


def finite_elements() -> pd.DataFrame:
    """Peak force and restitution from the paper's finite elements; see the file's head."""
    source = files("plastigran") / "data" / "finite_elements_zv02.csv"
    with source.open() as file:
        return pd.read_csv(file, comment="#")


def restitution_figure(table: pd.DataFrame, impacts: list[CentralImpact]) -> Figure:
    """Restitution over impact speed: points from the engine, lines from theory.

    Thornton's line is its closed form; the others' is the energy balance of the law. The paper's
    finite elements are shown where the table holds their sphere.

    Args:
        table: Columns material, law, speed [m/s], coefficient_of_restitution.
        impacts: The impacts the table was made from.
    """
    with styled():
        law_names = sorted(table["law"].unique())
        crowded = len(law_names) > 6
        figure, axes = subplots(figsize=(8.6 if crowded else 6.4, 4.6))
        materials = sorted(table["material"].unique())
        for (material, law), points in table.groupby(["material", "law"], sort=True):
            shade = law_names.index(law)
            colour, marker = COLOURS[shade % len(COLOURS)], MARKERS[shade % len(MARKERS)]
            dashes = ["-", "--", ":", "-."][materials.index(material) % 4]
            model = next(i for i in impacts if i.law == law and i.material.name == material)
            speed = np.geomspace(points["speed"].min() / 1.3, points["speed"].max() * 1.3, 200)
            axes.plot(speed, _theory(model, speed), dashes, color=colour, lw=1.3)
            label = title(law) if len(materials) == 1 else f"{title(law)}, {title(material)}"
            axes.plot(
                points["speed"],
                points["coefficient_of_restitution"],
                marker,
                color=colour,
                mfc="white" if material == materials[0] else colour,
                ms=6,
                label=label,
            )
        if _is_paper_sphere(impacts):
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
        _speed_axes(axes, impacts)
        axes.set_ylabel("coefficient of restitution")
        axes.set_ylim(0, 1.05)
        axes.plot([], [], color="0.4", lw=1.3, label="theory")
        place = (
            {"loc": "center left", "bbox_to_anchor": (1, 0.5)} if crowded else {"loc": "lower left"}
        )
        axes.legend(title="points: LIGGGHTS", fontsize="small", **place)
    return figure


def _theory(model: CentralImpact, speeds: np.ndarray) -> np.ndarray:
    if model.law == "thornton":
        return central.thornton_restitution(speeds / model.yield_speed())
    law, speeds = model.contact_law(), speeds * model.bodies
    impacts = law.central_impact(model.radius_eff, model.mass_eff, speeds)
    return impacts.coefficient_of_restitution


def _is_paper_sphere(impacts: list[CentralImpact]) -> bool:
    return all(i.material.name == "aluminium_zv02" and i.radius == 0.1 for i in impacts)


def _speed_axes(axes: Axes, impacts: list[CentralImpact]) -> None:
    axes.set_xscale("log")
    axes.set_xlabel("impact speed (m/s)")
    yielding = [impact for impact in impacts if laws.LAWS[impact.law].yields]
    yield_speeds = {impact.yield_speed() for impact in yielding}
    if len(yield_speeds) == 1:
        scale = yield_speeds.pop()
        upper = axes.secondary_xaxis("top", functions=(lambda v: v / scale, lambda q: q * scale))
        upper.set_xlabel("impact speed / yield speed")
        upper.spines["top"].set_visible(True)


def loops_figure(collisions: dict[CentralImpact, CollisionOutcome]) -> Figure:
    """Force over overlap, one panel a law and material, one loop a speed: the five
    fastest, the rest are too small to see beside them."""
    panels_of: dict[tuple[str, str], list[tuple[CentralImpact, CollisionOutcome]]] = {}
    for impact, collision in collisions.items():
        key = (impact.law, impact.material.name)
        panels_of.setdefault(key, []).append((impact, collision))
    keys = sorted(panels_of)
    materials = {material for _, material in keys}
    with styled():
        columns = min(len(keys), 4)
        rows = -(-len(keys) // columns)
        figure, panels = subplots(
            rows,
            columns,
            figsize=(3.4 * columns + 0.4, 3.2 * rows + 0.4),
            sharex=len(materials) == 1,
            sharey=len(materials) == 1,
            squeeze=False,
        )
        for axes in panels.flat[len(keys) :]:
            axes.set_visible(False)
        for axes, (law, material) in zip(panels.flat, keys, strict=False):
            runs = sorted(panels_of[law, material], key=lambda run: run[0].speed)[-5:]
            shades = matplotlib.colormaps["viridis"](np.linspace(0.1, 0.85, len(runs)))
            for (impact, collision), shade in zip(runs, shades, strict=True):
                touching = collision.loop[collision.loop["overlap"] >= 0]
                axes.plot(
                    touching["overlap"] * 1e6,
                    touching["force"] / 1e3,
                    color=shade,
                    label=f"{impact.speed:.3g} m/s",
                )
            named = title(law) if len(materials) == 1 else f"{title(law)}, {title(material)}"
            axes.set_title(named, fontsize=10)
            axes.legend(loc="upper left", fontsize=8)
            axes.set_xlabel("overlap (µm)")
        for axes in panels[:, 0]:
            axes.set_ylabel("normal force (kN)")
        for axes in panels.flat[max(len(keys) - columns, 0) : len(keys)]:  # the lowest of a column
            axes.tick_params(labelbottom=True)
    return figure
