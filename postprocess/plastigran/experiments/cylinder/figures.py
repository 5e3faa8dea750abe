# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures of the cylinder study: maps over radius and speed, and a comparison for one impact."""

from __future__ import annotations

from dataclasses import dataclass

import matplotlib
import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.colors import BoundaryNorm
from matplotlib.figure import Figure

from plastigran.experiments.cylinder.study import (
    FINITE_ELEMENTS,
    FINITE_ELEMENTS_OVERLAP_RES,
    study,
)
from plastigran.plot.style import law_colour, styled, subplots, title


@dataclass(frozen=True)
class Panel:
    """Contour map of one column of the table that `study` returns.

    `factor` converts the values from SI units to the unit in the title. `levels` are the contour
    levels in this unit.
    """

    column: str
    factor: float
    title: str
    levels: tuple[float, ...]


def maps_figure(table: pd.DataFrame) -> Figure:
    """Draw contour maps of the results of `study` by speed and radius, for one length ratio."""
    curved, straight = "katta_polycarpou", "lim_stronge"
    pressures, shares = tuple(np.arange(13) / 5), tuple(0.2 + np.arange(17) / 20)
    times = (0, 0.4, 0.5, 0.6, 0.8, 1, 1.25, 1.5, 1.75, 2, 2.5, 3, 4, 5, 6, 8)
    depths = (0, 0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1, 1.5, 2, 3)
    panels = [
        (curved, Panel("overlap_max", 1e6, "largest overlap (µm)", depths)),
        (curved, Panel("pressure_ratio", 1, "mean pressure / yield strength", pressures)),
        (curved, Panel("contact_time", 1e6, "contact time (µs)", times)),
        (curved, Panel("overlap_res", 1e6, "residual overlap (µm)", depths)),
        (straight, Panel("overlap_res", 1e6, "residual overlap (µm)", depths)),
        (curved, Panel("coefficient_of_restitution", 1, "coefficient of restitution", shares)),
    ]
    both = {"overlap_max", "pressure_ratio"}  # both laws have the same loading curve
    with styled({"axes.grid": False}):
        figure, grid = subplots(2, 3, figsize=(11, 6.6), sharex=True, sharey=True)
        for axes, (law, panel) in zip(grid.flat, panels, strict=True):
            _contours(axes, table[table["law"] == law], panel)
            whose = "both laws" if panel.column in both else title(law)
            axes.set_title(f"{panel.title}\n{whose}", fontsize=10)
        for axes in grid[1]:
            axes.set_xlabel("impact speed (m/s)")
        for axes in grid[:, 0]:
            axes.set_ylabel("radius (µm)")
        ratio = table["length_ratio"].iloc[0]
        figure.suptitle(
            f"length = {ratio:g} radii; dashed: yield; blank: overlap beyond the radius",
            fontsize=11,
        )
    return figure


def _contours(axes: Axes, table: pd.DataFrame, panel: Panel) -> None:
    def field(column: str) -> np.ndarray:
        return table.pivot(index="radius", columns="speed", values=column).to_numpy()

    speed, radius = np.unique(table["speed"]), np.unique(table["radius"]) * 1e6
    deep = field("overlap_max") / (radius[:, None] * 1e-6)
    # Limit the values to the highest contour level, because round-off may exceed this level.
    value = np.minimum(field(panel.column) * panel.factor, panel.levels[-1] * (1 - 1e-9))
    shown = value[deep <= 1]
    edges = np.asarray(panel.levels)
    levels = edges[np.searchsorted(edges, shown.min(), "right") - 1 :]
    levels = levels[: np.searchsorted(levels, shown.max()) + 1]
    colours = BoundaryNorm(levels, matplotlib.colormaps["viridis"].N)
    shades = axes.contourf(speed, radius, value, levels, cmap="viridis", norm=colours)
    axes.figure.colorbar(shades, ax=axes, shrink=0.9, ticks=levels, format="%g")
    axes.contour(speed, radius, field("speed_ratio"), [1.0], colors="white", linestyles="--")
    axes.contourf(speed, radius, deep, [1, np.inf], colors=["white"])


def comparison_figure() -> Figure:
    """Draw residual overlap and restitution versus speed for both laws, and the finite elements."""
    at = FINITE_ELEMENTS
    table = study([at["radius"]], np.linspace(0.01, 1.2, 120) * at["speed"], at["length_ratio"])
    with styled():
        figure, (left, right) = subplots(1, 2, figsize=(8.2, 3.4))
        for law, rows in table.groupby("law"):
            colour = law_colour(law)
            left.plot(rows["speed"], rows["overlap_res"] * 1e6, color=colour, label=title(law))
            right.plot(rows["speed"], rows["coefficient_of_restitution"], color=colour)
        overlap = FINITE_ELEMENTS_OVERLAP_RES * 1e6
        left.plot(at["speed"], overlap, "kx", ms=8, mew=2, label="finite elements (2010)")
        left.set_ylabel("residual overlap (µm)")
        left.legend(loc="upper left")
        right.set_ylabel("coefficient of restitution")
        right.set_ylim(0, 1.05)
        for axes in (left, right):
            axes.set_xlabel("impact speed (m/s)")
            axes.set_xlim(left=0)
    return figure
