# SPDX-License-Identifier: GPL-2.0-or-later
"""Every law compared with the finite-element results printed in Zhang & Vu-Quoc (2002)."""

from __future__ import annotations

from math import pi

import pandas as pd

from plastigran import laws
from plastigran.experiments.central.curves import finite_elements
from plastigran.materials import RIGID, read_material
from plastigran.validation.laws_on_spheres import yielding_laws
from plastigran.validation.tables import nearest_first

RADIUS = 0.1
QUANTITIES = {"force_max": "force", "coefficient_of_restitution": "restitution"}


def compare() -> pd.DataFrame:
    """Return the error of every law [%] in largest force and restitution at the paper's speeds.

    The law with the smallest sum of absolute errors comes first.
    """
    material = read_material("aluminium_zv02")
    pair = laws.combine(material.body(), RIGID)
    mass = 4 / 3 * pi * RADIUS**3 * material.density
    paper = finite_elements()
    rows = []
    for name in yielding_laws():
        impact = laws.LAWS[name](pair).central_impact(RADIUS, mass, paper["speed"].to_numpy())
        row: dict[str, object] = {"law": name}
        for quantity, word in QUANTITIES.items():
            errors = 100 * (getattr(impact, quantity) / paper[quantity] - 1)
            for speed, error in zip(paper["speed"], errors, strict=True):
                if pd.notna(error):
                    row[f"{word}, {speed:.2f} m/s (%)"] = error
        rows.append(row)
    return nearest_first(rows)
