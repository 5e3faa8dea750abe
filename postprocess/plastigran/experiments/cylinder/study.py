# SPDX-License-Identifier: GPL-2.0-or-later
"""Maps over radius and speed as in Katta & Polycarpou (2010, J. Tribol. 132:041402).

The contact laws compute the maps without LIGGGHTS. The laws are as published, without the energy
guard. Restitution is limited to 1, as in the paper. The maps include overlaps larger than the
radius.
"""

from __future__ import annotations

from itertools import product
from math import sqrt

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike

from plastigran import laws
from plastigran.materials import RIGID, read_material
from plastigran.physics import central
from plastigran.physics.contact_time import contact_time
from plastigran.progress import ProgressBar
from plastigran.usable_laws import laws_for

MATERIAL = "glass_kp10"
MASS = 1.59e-6  # mass of the slider [kg]
BODY_THICKNESS = 1e-4  # thickness of the glass [m]
#: Length/radius of the cylinders in the paper, and largest speed of the maps for each value [m/s].
LENGTH_RATIOS = {10.0: 1.0, 100.0: 5.0}
RADII = (1e-6, 1e-5)  # smallest and largest radius of the maps [m]

#: Impact that the paper computed with finite elements. The paper gives the residual overlap [m] and
#: the simulated time [s], which is an upper bound of the contact time.
FINITE_ELEMENTS = {"radius": 1e-5, "length_ratio": 10.0, "speed": 1.0}
FINITE_ELEMENTS_OVERLAP_RES = 0.12e-6
FINITE_ELEMENTS_TIME_BOUND = 3e-6


def impact(name: str, radius: float, speed: float, length_ratio: float) -> dict[str, object]:
    """Compute one impact by a law, and return the row of the table that `study` returns.

    Args:
        name: Name of the law.
        radius: Radius of the cylinder [m].
        speed: Impact speed [m/s].
        length_ratio: Length/radius of the cylinder [-].
    """
    material = read_material(MATERIAL)
    pair, length = laws.combine(material.body(), RIGID), length_ratio * radius
    lengths = {"cylinder_length": length, "body_thickness": BODY_THICKNESS}
    law = material.law(name, pair, **lengths, energy_guard="off")
    outcome = law.central_impact(radius, MASS, speed)
    contact_radius = law.respond(radius, outcome.overlap_max, law.State()).contact_radius
    pressure = outcome.force_max / (2 * contact_radius * length)
    *_, work = central.line_yield(pair, radius, length, BODY_THICKNESS)
    loading, total = contact_time(law, radius, MASS, speed)
    return {
        "law": name,
        "length_ratio": length_ratio,
        "radius": radius,
        "speed": speed,
        "speed_ratio": speed / sqrt(2 * work / MASS),
        "overlap_max": outcome.overlap_max,
        "overlap_res": outcome.overlap_res,
        "force_max": outcome.force_max,
        "contact_radius": contact_radius,
        "pressure_ratio": pressure / material.yield_strength,
        "loading_time": loading,
        "contact_time": total,
        "coefficient_of_restitution": min(1.0, outcome.coefficient_of_restitution),
        "in_range": outcome.in_range,
    }


def study(
    radii: ArrayLike, speeds: ArrayLike, length_ratio: float, progress: bool = False
) -> pd.DataFrame:
    """Compute impacts for all radii and speeds by both laws for cylinders, as published.

    Args:
        radii: Radii of the cylinder (N,) [m].
        speeds: Impact speeds (M,) [m/s].
        length_ratio: Length/radius of the cylinder [-].
        progress: Whether to show a progress bar.

    Returns:
        2 N M rows; columns law, length_ratio [-], radius [m], speed [m/s], speed_ratio (speed /
        yield speed), overlap_max, overlap_res [m], force_max [N], contact_radius (half width at the
        largest overlap) [m], pressure_ratio (mean pressure at the largest overlap / yield strength)
        [-], loading_time, contact_time [s], coefficient_of_restitution [-] and in_range.
    """
    axes = laws_for("cylinder"), np.asarray(radii).tolist(), np.asarray(speeds).tolist()
    bar = ProgressBar(list(product(*axes)), unit="impact", desc="study", shown=progress)
    return pd.DataFrame(impact(*case, length_ratio) for case in bar)


def maps(points: int) -> pd.DataFrame:
    """Return the table of `study` for every length ratio, with `points` radii and speeds each."""
    radii = np.linspace(*RADII, points)
    return pd.concat(
        [
            study(radii, np.linspace(fastest / points, fastest, points), ratio, progress=True)
            for ratio, fastest in LENGTH_RATIOS.items()
        ],
        ignore_index=True,
    )


def comparison() -> pd.DataFrame:
    """Return the results of each law for the impact that the paper computed by finite elements.

    Returns:
        A row for each law and one for the finite elements: overlap_res [m] and its relative error;
        contact_time [s] of the laws, and contact_time_bound [s] of the finite elements;
        coefficient_of_restitution [-] of the laws.
    """
    at = FINITE_ELEMENTS
    table = study([at["radius"]], [at["speed"]], at["length_ratio"]).set_index("law")
    columns = ["overlap_res", "contact_time", "coefficient_of_restitution"]
    table = table[columns].reindex([*table.index, "finite elements"])
    table.loc["finite elements", "overlap_res"] = FINITE_ELEMENTS_OVERLAP_RES
    table.loc["finite elements", "contact_time_bound"] = FINITE_ELEMENTS_TIME_BOUND
    table["overlap_res_error"] = table["overlap_res"] / FINITE_ELEMENTS_OVERLAP_RES - 1
    return table
