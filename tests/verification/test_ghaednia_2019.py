# SPDX-License-Identifier: GPL-2.0-or-later
"""The force of a hardening sphere lies between Jackson and Green's law and Hertz' law."""

from __future__ import annotations

from math import exp, pi

import numpy as np
import pytest

from plastigran import laws
from plastigran.materials import RIGID

STEEL = laws.Body(2.1e11, 0.3, 3.55e8)
RADIUS = 0.01  # m
SHARES = (0.0, 1e-4, 1e-3, 1e-2, 0.05, 0.3)  # E_t/E


def bodies(share: float, other: laws.Body = RIGID) -> laws.MaterialPair:
    modulus = share * STEEL.youngs_modulus
    return laws.combine(laws.Body(2.1e11, 0.3, 3.55e8, tangent_modulus=modulus), other)


def loading(law: laws.Law, overlaps: np.ndarray, name: str) -> np.ndarray:
    return law.follow(RADIUS, overlaps)[name]


def overlaps() -> np.ndarray:
    """Return overlaps from 3 yield overlaps to 0.2 radii; the largest a/R of Jackson and Green,
    0.41, lies in this range.

    For smaller overlaps, the force of Jackson and Green exceeds that of Hertz, because it jumps at
    1.9 yield overlaps.
    """
    pressure = 1.295 * exp(0.736 * 0.3) * STEEL.yield_strength
    overlap_y = RADIUS * (pi * pressure / (2 * bodies(0).youngs_modulus_eff)) ** 2
    return np.geomspace(3 * overlap_y, 0.2 * RADIUS, 60)


@pytest.mark.parametrize("other", [RIGID, STEEL, laws.Body(5e10, 0.4)])
def test_without_hardening_it_is_jackson_and_green(other):
    """Without hardening, the law equals that of Jackson and Green to round-off.

    This also holds between two yielding bodies.
    """
    law, twin = (kind(bodies(0, other)) for kind in (laws.Ghaednia2019, laws.JacksonGreen))
    for name in ("force", "contact_radius"):
        assert loading(law, overlaps(), name) == pytest.approx(
            loading(twin, overlaps(), name), rel=1e-13
        )


def test_hardening_brings_it_to_hertz():
    """With a larger tangent modulus, force and contact radius approach those of Hertz.

    The force increases, and the contact radius decreases. While the hardness hardly changes, the
    force covers the share 1 - exp(-3.3 E_t/E) of the way to Hertz' force, as in the source.
    """
    hertz = laws.Hertz(bodies(0))
    for name, rising in (("force", True), ("contact_radius", False)):
        found = [loading(laws.Ghaednia2019(bodies(s)), overlaps(), name) for s in SHARES]
        found.append(loading(hertz, overlaps(), name))
        steps = np.diff(found, axis=0)
        assert ((steps > 0) == rising).all(), name
    small = overlaps()[:10]  # hardness changes by less than 1e-3
    soft, hard = (loading(laws.Ghaednia2019(bodies(s)), small, "force") for s in (0, 0.05))
    share = (hard - soft) / (loading(hertz, small, "force") - soft)
    assert share == pytest.approx(1 - exp(-3.3 * 0.05), rel=1e-3)


def test_hardening_gives_back_more():
    speeds = np.geomspace(0.1, 5, 6)
    for unloading in ("brake_2015", "etsion_2005"):
        found = [
            laws.Ghaednia2019(bodies(share), unloading=unloading)
            .central_impact(RADIUS, 0.033, speeds)
            .force_max
            for share in SHARES
        ]
        assert (np.diff(found, axis=0) > 0).all()
    found = [
        laws.Ghaednia2019(bodies(share)).central_impact(RADIUS, 0.033, speeds) for share in SHARES
    ]
    assert (np.diff([each.coefficient_of_restitution for each in found], axis=0) > 0).all()
