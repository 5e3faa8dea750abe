# SPDX-License-Identifier: GPL-2.0-or-later
"""Duration of a central impact, computed from the energies of a contact law."""

from __future__ import annotations

import numpy as np
from scipy.special import roots_legendre

_NODES, _WEIGHTS = roots_legendre(200)


def contact_time(law, radius_eff: float, mass_eff: float, speed: float) -> tuple[float, float]:
    """Return the time to the largest overlap and the time to the end of the contact.

    The time is the integral of d(overlap)/speed, where 1/2 m* speed^2 is the remaining kinetic
    energy. The integrand is singular at the largest overlap, where the speed is zero. The variable
    of the Gauss-Legendre quadrature is therefore the square root of the distance from the largest
    overlap.

    Args:
        law: Instance of a class of `plastigran.laws.LAWS` whose force depends only on overlap.
        radius_eff: Effective radius R* [m].
        mass_eff: Effective mass m* [kg].
        speed: Closing speed [m/s].

    Returns:
        Loading time and contact time [s].
    """
    law = law.at_impact(radius_eff, speed)
    impact = law.central_impact(radius_eff, mass_eff, speed)
    root = 0.5 * (1 - _NODES)  # in descending order, so that the overlaps increase for the law

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
