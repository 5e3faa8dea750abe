# SPDX-License-Identifier: GPL-2.0-or-later
"""Compute the finite-element table of spheres and write it to its file.

    python -m plastigran.validation.spheres.compute [metal ...]

Metals in the cache are not computed again; every other metal takes one or two minutes. If metals
are named, the table contains only these metals.
"""

from __future__ import annotations

import sys
import warnings
from collections.abc import Sequence

import numpy as np
import pandas as pd

from plastigran.fem.cache import cached
from plastigran.fem.limits import SmallStrainWarning
from plastigran.fem.settings import Settings
from plastigran.fem.sphere.results import Pressing
from plastigran.validation.spheres import TABLE
from plastigran.validation.spheres.metals import METALS, RADIUS, SphereMetal
from plastigran.validation.spheres.release import press_and_release

#: Settings of the finite elements. The force increments are smaller than the default, because
#: backward Euler has only first-order accuracy.
SETTINGS = Settings(growth=1.04, unloading_steps=10)


def compute(metal: SphereMetal, settings: Settings = SETTINGS) -> pd.DataFrame:
    """Return the rows of the finite-element table of spheres for one metal.

    The computation is taken from the cache if possible.
    """
    forces = tuple(float(force) for force in metal.forces)
    pressing = cached(press_and_release, metal.material, RADIUS, forces, settings=settings)
    if pressing.stopped:
        print(f"{metal.name}: {pressing.stopped}", file=sys.stderr)
    return rows(metal, pressing)


def rows(metal: SphereMetal, pressing: Pressing) -> pd.DataFrame:
    """Return a row of the finite-element table of spheres for each unloading of a compression.

    The module docstring of `plastigran.validation.spheres` explains the columns.
    """
    sphere = metal.sphere
    force, overlap = sphere.yield_force, sphere.approach(sphere.yield_force)
    radius = sphere.contact_radius(force)
    unloadings = pressing.unloadings
    return pd.DataFrame(
        {
            "metal": metal.name,
            "set": "held" if metal.held else "fit",
            "yield_strength_ratio": metal.yield_strength_ratio,
            "poissons_ratio": metal.poissons_ratio,
            "hardening_ratio": metal.hardening_ratio,
            "strain": metal.strain,
            "force_ratio": unloadings["force"] / force,
            "speed_ratio": np.sqrt(unloadings["work_loading"] / (0.4 * force * overlap)),
            "coefficient_of_restitution": unloadings["coefficient_of_restitution"],
            "overlap_ratio": unloadings["approach"] / overlap,
            "overlap_res_ratio": unloadings["residual_approach"] / overlap,
            "contact_radius_ratio": unloadings["contact_radius"] / radius,
            "work_loading_ratio": unloadings["work_loading"] / (force * overlap),
            "work_unloading_ratio": unloadings["work_unloading"] / (force * overlap),
            "contact_radius_over_radius": unloadings["contact_radius"] / pressing.radius,
        }
    )


def main(names: Sequence[str]) -> None:
    """Compute the metals with these names, or all metals, and write the table of their results."""
    warnings.simplefilter("ignore", SmallStrainWarning)
    tables = []
    for name in names or METALS:
        tables.append(compute(METALS[name]))
        print(f"{name}: {len(tables[-1])} unloadings", flush=True)
    pd.concat(tables).to_csv(TABLE, index=False, float_format="%.6g", lineterminator="\n")


if __name__ == "__main__":
    main(sys.argv[1:])
