# SPDX-License-Identifier: GPL-2.0-or-later
"""Below yield, and for bodies that do not yield, every law equals its elastic contact."""

from __future__ import annotations

import numpy as np
import pytest
from elastic_contact import NOT_HERTZIAN, mapped_sphere
from pairs import LENGTH, RADIUS, scales
from scipy.special import lambertw

from plastigran import laws


def elastic(law_name: str, pair: laws.MaterialPair, overlap: np.ndarray) -> dict[str, np.ndarray]:
    """Return the quantities of the elastic contact of a law. The elastic contact is Hertz' contact
    for spheres, the mapped sphere for `mdr`, and a line contact with Lambert's W for cylinders.
    """
    if law_name in NOT_HERTZIAN:
        return mapped_sphere(pair, RADIUS, overlap)
    if laws.LAWS[law_name].shape == "sphere":
        return laws.Hertz(pair).follow(RADIUS, overlap, laws.Hertz.State())
    reach = LENGTH**2 * np.exp(-pair.poissons_ratio / (1 - pair.poissons_ratio)) / RADIUS
    load = overlap / -lambertw(-overlap / reach, -1).real  # F/(pi E* L)
    stiffness = np.pi * pair.youngs_modulus_eff * LENGTH
    return {
        "force": stiffness * load,
        "contact_radius": 2 * np.sqrt(load * RADIUS),
        "elastic_energy": stiffness * load**2 * (2 * np.log(reach / load) - 1) / 4,
        "plastic_work": np.zeros_like(load),
        "viscous_force": np.zeros_like(load),
        "surface_energy": np.zeros_like(load),
    }


def test_elastic_impact_returns_everything(law_name, law_between, pair):
    overlap_y, _ = scales(law_name, pair)
    law = law_between(law_name, pair)
    overlap = np.array([0.5 * overlap_y])
    expected = elastic(law_name, pair, overlap)
    answer = law.follow(RADIUS, overlap, law.State())
    assert answer["plastic_work"] == 0
    for name in ("force", "contact_radius", "elastic_energy"):
        assert answer[name] == pytest.approx(expected[name], rel=1e-13), name


def test_unyielding_bodies_are_elastic(law_name, law_between):
    """With a very high yield strength, hard impacts are elastic to round-off. For cylinders, the
    relative tolerance is 4e-14, because the law reads the line contact from a table with an error
    of 3e-14.
    """
    strong = laws.combine(laws.Body(7e10, 0.3, 1e20), laws.Body(7e10, 0.3, 1e20))
    law = law_between(law_name, strong)
    overlap = np.geomspace(1e-12, 1e-3, 50)
    expected = elastic(law_name, strong, overlap)
    exactly = 4e-14 if law.shape == "cylinder" else 1e-14
    for name, values in law.follow(RADIUS, overlap, law.State()).items():
        assert values == pytest.approx(expected[name], rel=exactly), f"{name}: no elastic range"
