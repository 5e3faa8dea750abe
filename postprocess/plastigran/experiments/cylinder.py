# SPDX-License-Identifier: GPL-2.0-or-later
"""The cylinder study of Katta & Polycarpou 2010 (J. Tribol. 132): impacts over radius and speed.

A slider of 1.59 mg carried by a rigid cylinder hits glass. The maps hold the laws as published,
without the energy guard; the restitution is cut off at 1, as the source does.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike
from scipy.special import roots_legendre
from tqdm import tqdm

from plastigran.experiments.central import CylinderImpact, laws_for
from plastigran.materials import read_material

MATERIAL = "glass_kp10"
#: Length over radius of the source's cylinders, and the fastest impact of its maps [m/s].
LENGTH_RATIOS = {10.0: 1.0, 100.0: 5.0}
RADII = (1e-6, 1e-5)  # from, to [m]

#: Finite elements of the source: cylinder of 10 um, length ratio 10, 1 m/s; residual overlap [m],
#: and the time its whole run took, an upper bound of the contact's [s].
FINITE_ELEMENTS = {"radius": 1e-5, "length_ratio": 10.0, "speed": 1.0}
FINITE_ELEMENTS_OVERLAP_RES = 0.12e-6
FINITE_ELEMENTS_TIME_BOUND = 3e-6

_NODES, _WEIGHTS = roots_legendre(200)


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


def comparison() -> pd.DataFrame:
    """The impact the source's finite elements were run for, by each law.

    Returns:
        (3,) rows by law and for the finite elements: overlap_res [m] and its error over the finite
        elements'; contact_time [s], of the finite elements only contact_time_bound, which it is
        shorter than; coefficient_of_restitution [-] of the laws.
    """
    at = FINITE_ELEMENTS
    table = study([at["radius"]], [at["speed"]], at["length_ratio"]).set_index("law")
    columns = ["overlap_res", "contact_time", "coefficient_of_restitution"]
    table = table[columns].reindex([*table.index, "finite elements"])
    table.loc["finite elements", "overlap_res"] = FINITE_ELEMENTS_OVERLAP_RES
    table.loc["finite elements", "contact_time_bound"] = FINITE_ELEMENTS_TIME_BOUND
    table["overlap_res_error"] = table["overlap_res"] / FINITE_ELEMENTS_OVERLAP_RES - 1
    return table


def run(folder: str | Path, points: int) -> tuple[pd.DataFrame, pd.DataFrame]:
    """The whole study: maps, and the impact of the finite elements by law and in the engine.

    Each table is written as soon as it is whole.

    Args:
        folder: Where `maps.csv`, `comparison.csv` and the engine's `runs` go; made when missing.
        points: Radii and speeds along each axis of a map.

    Returns:
        The maps, as `study` has them, of every length ratio; and the comparison, with the engine's
        `*_engine` columns.
    """
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    radii = np.linspace(*RADII, points)
    maps = pd.concat(
        [
            study(radii, np.linspace(fastest / points, fastest, points), ratio, progress=True)
            for ratio, fastest in LENGTH_RATIOS.items()
        ],
        ignore_index=True,
    )
    maps.to_csv(folder / "maps.csv", index=False)

    table, at = comparison(), FINITE_ELEMENTS
    for name in laws_for("cylinder"):
        impact = CylinderImpact(name, at["speed"], read_material(MATERIAL), at["radius"])
        found = impact.run(folder / "runs" / name)
        for column in ("overlap_res", "contact_time", "coefficient_of_restitution"):
            table.loc[name, f"{column}_engine"] = getattr(found, column)
    table.to_csv(folder / "comparison.csv")
    return maps, table
