# SPDX-License-Identifier: GPL-2.0-or-later
"""The cylinder study of Katta & Polycarpou 2010 (J. Tribol. 132): impacts over radius and speed.

A slider of 1.59 mg carried by a rigid cylinder hits glass. The maps hold the laws as published,
without the energy guard; the restitution is cut off at 1, as the source does.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.colors import BoundaryNorm
from matplotlib.figure import Figure
from numpy.typing import ArrayLike
from scipy.special import roots_legendre
from tqdm import tqdm

from plastigran.figures import COLOURS, STYLE, plt, save, title
from plastigran.impact import CylinderImpact, laws_for
from plastigran.materials import read_material

MATERIAL = "glass_kp10"
#: Length over radius of the source's cylinders, and the fastest impact of its maps [m/s].
LENGTH_RATIOS = {10.0: 1.0, 100.0: 5.0}
RADII = (1e-6, 1e-5)  # from, to [m]

#: Finite elements of the source: cylinder of 10 um, length ratio 10, 1 m/s; residual overlap [m],
#: and the time its run took to the end of the contact [s].
FINITE_ELEMENTS = {"radius": 1e-5, "length_ratio": 10.0, "speed": 1.0}
FINITE_ELEMENTS_OVERLAP_RES = 0.12e-6
FINITE_ELEMENTS_TIME = 3e-6

_NODES, _WEIGHTS = roots_legendre(200)


@dataclass(frozen=True)
class Panel:
    """One map: column of the table, factor to its unit, title, and the edges of its shades."""

    column: str
    factor: float
    title: str
    levels: tuple[float, ...]


def contact_time(law, radius_eff: float, mass_eff: float, speed: float) -> tuple[float, float]:
    """Time to the largest overlap and to the end of the contact, from the law's energies.

    dt = d(overlap)/speed with 1/2 m* speed^2 the energy left, by Gauss-Legendre quadrature in the
    square root of the way to the largest overlap, where the speed vanishes.

    Args:
        law: An instance of a class of `plastigran.laws.LAWS`.
        radius_eff: R* [m].
        mass_eff: m* [kg].
        speed: Closing speed [m/s].

    Returns:
        Loading time and contact time [s].
    """
    impact = law.central_impact(radius_eff, mass_eff, speed)
    root = 0.5 * (1 - _NODES)  # descending: the overlaps ascend, along the virgin curve

    def time(start: float, energy) -> float:
        way = impact.overlap_max - start
        left = energy(impact.overlap_max - way * root**2)
        return float(np.sum(0.5 * _WEIGHTS * 2 * root * way / np.sqrt(2 * left / mass_eff)))

    def left_to_load(overlap: np.ndarray) -> np.ndarray:
        answer = law.follow(radius_eff, overlap, law.State())
        return 0.5 * mass_eff * speed**2 - answer["elastic_energy"] - answer["plastic_work"]

    def given_back(overlap: np.ndarray) -> np.ndarray:
        state = law.State()
        stored = law.respond(radius_eff, impact.overlap_max, state).elastic_energy
        return stored - law.follow(radius_eff, overlap, state)["elastic_energy"]

    loading = time(0.0, left_to_load)
    return loading, loading + time(impact.overlap_res, given_back)


def outcome(impact: CylinderImpact, law) -> dict[str, float]:
    """What an impact under a law (`impact.contact_law(...)`) does; SI units, see `study`."""
    found = law.central_impact(impact.radius_eff, impact.mass_eff, impact.closing_speed)
    peak = law.respond(impact.radius_eff, found.overlap_max, law.State())
    pressure = found.force_max / (2 * peak.contact_radius * impact.cylinder_length)
    loading, total = contact_time(law, impact.radius_eff, impact.mass_eff, impact.closing_speed)
    return {
        "law": impact.law,
        "length_ratio": impact.length_ratio,
        "radius": impact.radius,
        "speed": impact.speed,
        "speed_ratio": impact.speed / impact.yield_speed(),
        "overlap_max": found.overlap_max,
        "overlap_res": found.overlap_res,
        "force_max": found.force_max,
        "contact_radius": peak.contact_radius,
        "pressure_ratio": pressure / impact.material.yield_strength,
        "loading_time": loading,
        "contact_time": total,
        "coefficient_of_restitution": min(1.0, found.coefficient_of_restitution),
        "in_range": found.in_range,
    }


class _Anywhere(CylinderImpact):
    """An impact that need not fit the engine: the source's maps go beyond an overlap of R."""

    overlap_limit = np.inf


def study(
    radii: ArrayLike, speeds: ArrayLike, length_ratio: float, progress: bool = False
) -> pd.DataFrame:
    """Both laws as published over radii [m] and speeds [m/s].

    Args:
        radii: (N,) of the cylinder [m].
        speeds: (M,) of impact [m/s].
        length_ratio: Length over radius of the cylinder [-].
        progress: Show a progress bar.

    Returns:
        (2 N M,) rows; columns law, length_ratio [-], radius [m], speed [m/s], speed_ratio (over the
        yield speed), overlap_max, overlap_res [m], force_max [N], contact_radius (half-width at the
        largest overlap) [m], pressure_ratio (mean pressure there over the yield strength) [-],
        loading_time, contact_time [s], coefficient_of_restitution [-] and in_range.
    """
    material = read_material(MATERIAL)
    impacts = [
        _Anywhere(name, float(speed), material, float(radius), length_ratio=length_ratio)
        for name in laws_for("cylinder")
        for radius in np.asarray(radii)
        for speed in np.asarray(speeds)
    ]
    bar = tqdm(impacts, unit="impact", disable=None if progress else True)
    return pd.DataFrame(outcome(i, i.contact_law(energy_guard="off")) for i in bar)


def maps_figure(table: pd.DataFrame) -> Figure:
    """Contours over speed and radius of one length ratio's `study`."""
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
    both = {"overlap_max", "pressure_ratio"}  # loading is the same in both laws
    with plt.rc_context(STYLE | {"axes.grid": False}):
        figure, grid = plt.subplots(
            2, 3, figsize=(11, 6.6), sharex=True, sharey=True, layout="constrained"
        )
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
    # The top level's own value, 1 or 2.4, is met to rounding: keep it inside.
    value = np.minimum(field(panel.column) * panel.factor, panel.levels[-1] * (1 - 1e-9))
    shown = value[deep <= 1]
    edges = np.asarray(panel.levels)
    levels = edges[np.searchsorted(edges, shown.min(), "right") - 1 :]
    levels = levels[: np.searchsorted(levels, shown.max()) + 1]
    colours = BoundaryNorm(levels, plt.get_cmap("viridis").N)
    shades = axes.contourf(speed, radius, value, levels, cmap="viridis", norm=colours)
    axes.figure.colorbar(shades, ax=axes, shrink=0.9, ticks=levels, format="%g")
    axes.contour(speed, radius, field("speed_ratio"), [1.0], colors="white", linestyles="--")
    axes.contourf(speed, radius, deep, [1, np.inf], colors=["white"])


def comparison() -> pd.DataFrame:
    """The impact the source's finite elements were run for, by each law.

    Returns:
        (3,) rows by law and for the finite elements: overlap_res [m], its error over the finite
        elements', contact_time [s] and coefficient_of_restitution [-].
    """
    at = FINITE_ELEMENTS
    table = study([at["radius"]], [at["speed"]], at["length_ratio"]).set_index("law")
    columns = ["overlap_res", "contact_time", "coefficient_of_restitution"]
    table = table[columns].reindex([*table.index, "finite elements"])
    table.loc["finite elements", "overlap_res"] = FINITE_ELEMENTS_OVERLAP_RES
    table.loc["finite elements", "contact_time"] = FINITE_ELEMENTS_TIME
    table["overlap_res_error"] = table["overlap_res"] / FINITE_ELEMENTS_OVERLAP_RES - 1
    return table


def comparison_figure() -> Figure:
    """Residual overlap and restitution over speed by both laws, with the finite elements' point."""
    at = FINITE_ELEMENTS
    table = study([at["radius"]], np.linspace(0.01, 1.2, 120) * at["speed"], at["length_ratio"])
    with plt.rc_context(STYLE):
        figure, (left, right) = plt.subplots(1, 2, figsize=(8.2, 3.4), layout="constrained")
        for colour, (law, rows) in zip(COLOURS, table.groupby("law"), strict=False):
            left.plot(rows["speed"], rows["overlap_res"] * 1e6, color=colour, label=title(law))
            right.plot(rows["speed"], rows["coefficient_of_restitution"], color=colour)
        left.plot(
            at["speed"],
            FINITE_ELEMENTS_OVERLAP_RES * 1e6,
            "kx",
            ms=8,
            mew=2,
            label="finite elements (2010)",
        )
        left.set_ylabel("residual overlap (µm)")
        left.legend(loc="upper left")
        right.set_ylabel("coefficient of restitution")
        right.set_ylim(0, 1.05)
        for axes in (left, right):
            axes.set_xlabel("impact speed (m/s)")
            axes.set_xlim(left=0)
    return figure


def run(folder: str | Path, points: int) -> tuple[pd.DataFrame, list[Path]]:
    """The whole study: maps, and the impact of the finite elements by law and in the engine.

    Args:
        folder: Where `maps.csv`, `comparison.csv` and the figures go; made when missing.
        points: Radii and speeds along each axis of a map.

    Returns:
        The comparison, with the engine's `*_engine` columns, and the files written.
    """
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    radii = np.linspace(*RADII, points)
    written, tables = [], []
    for length_ratio, fastest in LENGTH_RATIOS.items():
        speeds = np.linspace(fastest / points, fastest, points)
        tables.append(study(radii, speeds, length_ratio, progress=True))
        written += save(maps_figure(tables[-1]), folder / f"maps_{length_ratio:g}", (".png",))
    written += save(comparison_figure(), folder / "comparison", (".png",))

    table, at = comparison(), FINITE_ELEMENTS
    for name in laws_for("cylinder"):
        impact = CylinderImpact(name, at["speed"], read_material(MATERIAL), at["radius"])
        found = impact.run(folder / "runs" / name)
        for column in ("overlap_res", "contact_time", "coefficient_of_restitution"):
            table.loc[name, f"{column}_engine"] = getattr(found, column)
    for name, content in (("maps", pd.concat(tables, ignore_index=True)), ("comparison", table)):
        written.append(folder / f"{name}.csv")
        content.to_csv(written[-1], index=name == "comparison")
    return table, written
