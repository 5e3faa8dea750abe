# SPDX-License-Identifier: GPL-2.0-or-later
"""Equations of the law `universal` in yield units, with constants that the fit varies.

`contact_models/plastigran/laws/universal.h` implements the same equations, and
docs/laws/universal.md explains them.
"""

from __future__ import annotations

from functools import cache
from math import pi

import attrs
import numpy as np
import pandas as pd

from plastigran import laws

NODES, WEIGHTS = np.polynomial.legendre.leggauss(12)
NODES, WEIGHTS = (NODES + 1) / 2, WEIGHTS / 2  # Gauss nodes and weights on [0, 1]


@attrs.frozen
class Constants:
    """Constants of the law `universal`, with the starting values of the fit.

    t is the square root of overlap/overlap_Y. "Strength" is q in `depth`; "recovery" is the overlap
    that unloading recovers.

    Attributes:
        q_1: Strength: depth from which the pressure at yield has no effect.
        q_2: Strength: effect of hardening.
        q_3: Strength: saturation of the effect of hardening.
        f_1: Force far from yield: F_Y t^2/f_1.
        f_2: Force near yield.
        f_3: Force near yield.
        f_4: Force near yield.
        f_5: Force: lower resistance of a finite sphere.
        c_1: Contact radius far from yield: a^2/(R alpha) - 1.
        c_2: Contact radius near yield.
        c_3: Contact radius near yield.
        c_4: Contact radius: reduction by hardening.
        c_5: Contact radius: higher stiffness of a finite sphere.
        d_1: Recovery: largest relative deficit compared with a Hertz contact.
        d_2: Recovery near yield.
        d_3: Recovery near yield.
        g_1: Unloading curve: deviation from a Hertz contact.
    """

    q_1: float = 6.8
    q_2: float = 0.356
    q_3: float = 0.018
    f_1: float = 0.125
    f_2: float = 12.0
    f_3: float = 8.4
    f_4: float = 1.11
    f_5: float = 3.8
    c_1: float = 1.25
    c_2: float = 5.1
    c_3: float = 4.4
    c_4: float = 3.5
    c_5: float = 7.5
    d_1: float = 0.19
    d_2: float = 0.615
    d_3: float = 0.36
    g_1: float = 3.64


@attrs.frozen(eq=False)
class Metals:
    """Parameters of one or n metals in the equations; each a number or an array (n,).

    Attributes:
        onset: Ratio p_y/sigma_Y of yield pressure and yield strength, divided by its value at
            Poisson's ratio 0.3.
        hardening: (p_y/sigma_Y) H/E', with the hardening slope H and E' = E/(1 - nu^2).
        yield_radius: a_Y/R.
    """

    onset: np.ndarray
    hardening: np.ndarray
    yield_radius: np.ndarray

    @classmethod
    def of(cls, table: pd.DataFrame) -> Metals:
        """Return the parameters of the metal of each row of the table of spheres (n,)."""
        poissons_ratio = table["poissons_ratio"].to_numpy()
        factor = np.array([_pressure_factor(value) for value in poissons_ratio])
        return cls(
            factor / _pressure_factor(0.3),
            factor * table["hardening_ratio"].to_numpy() * (1 - poissons_ratio**2),
            pi / 2 * factor * table["yield_strength_ratio"].to_numpy(),
        )


@cache
def _pressure_factor(poissons_ratio: float) -> float:
    return laws.hertz_yield_pressure_factor(poissons_ratio)


@attrs.frozen(eq=False)
class Peak:
    """State of a contact in first loading, divided by the values at yield; arrays (n,).

    Attributes:
        force: F/F_Y.
        contact_radius: a/a_Y.
        recovery: (overlap_max - overlap_res)/overlap_Y.
        work_unloading: Released energy / (F_Y overlap_Y).
    """

    force: np.ndarray
    contact_radius: np.ndarray
    recovery: np.ndarray
    work_unloading: np.ndarray


def depth(constants: Constants, metals: Metals, t: np.ndarray) -> np.ndarray:
    """Return the depth S = max(t/q - 1, 0) (n,), which measures how far a contact is beyond yield.

    t = (overlap/overlap_Y)^(1/2) >= 1. The strength q describes the metal; see `Constants`.
    """
    k, s = constants, t - 1
    strength = (k.q_1 + s) / (k.q_1 + metals.onset * s)
    strength = strength + k.q_2 * metals.hardening * s / (1 + k.q_3 * s)
    return np.maximum(t / strength - 1, 0)


def peak(constants: Constants, metals: Metals, t: np.ndarray) -> Peak:
    """Return force, contact radius, recovery and released energy after loading to t (n,).

    t = (overlap/overlap_Y)^(1/2) >= 1.
    """
    k, s = constants, depth(constants, metals, t)
    finite = (metals.yield_radius * s) ** 2 / (1 + metals.yield_radius * s)
    softening = k.f_1 * s**2 * (s + k.f_2) / ((s + k.f_3) * (s + k.f_4))
    force = t**3 / (1 + softening * (1 + k.f_5 * finite))
    widening = k.c_1 * s**2 / ((1 + k.c_4 * metals.hardening) * s**2 + k.c_2 * s + k.c_3)
    contact_radius = t * np.sqrt(1 + widening) * (1 + k.c_5 * finite)
    deficit = k.d_1 * s**2 / (s**2 + k.d_2 * s + k.d_3)
    recovery = (1 - deficit) * force / contact_radius
    work = force * recovery * unloading_work(k.g_1 * deficit)
    return Peak(force, contact_radius, recovery, work)


def unloading_work(g: np.ndarray) -> np.ndarray:
    """Return the released energy / (largest force times recovery) of unloading curves (n,).

    The unloading curve is y^(3/2) (1 + g)/(1 + g y^(1/2)). The result is its integral over y from 0
    to 1.
    """
    g = np.asarray(g)[..., None]
    return np.sum(WEIGHTS * 2 * NODES**4 * (1 + g) / (1 + g * NODES), axis=-1)


def work_ratio(work_unloading, force, contact_radius):
    """Return the released energy / released energy of a Hertz contact.

    The Hertz contact has the same force F and contact radius a; it releases 3 F^2/(10 E* a). All
    arguments are in yield units.
    """
    return work_unloading * contact_radius / (0.4 * force**2)


def first_loading_work(constants: Constants, metals: Metals, t: np.ndarray) -> np.ndarray:
    """Return the loading work / (F_Y overlap_Y) at each t = (overlap/overlap_Y)^(1/2) (n,).

    The values of t increase from 1. The force is integrated by Gauss quadrature between them.
    """
    steps = np.diff(t)
    at = t[:-1, None] + steps[:, None] * NODES
    sums = np.sum(WEIGHTS * 2 * at * peak(constants, metals, at).force, axis=1) * steps
    return 0.4 + np.concatenate([[0], np.cumsum(sums)])


def errors(constants: Constants, table: pd.DataFrame) -> pd.DataFrame:
    """Return the errors of the law for each row of the table of spheres [%].

    Returns:
        Table with one row for each row of the table of spheres. The errors `force` and
        `restitution` compare impacts with the same loading work; the errors `contact_radius` and
        `recovery` compare contacts at the same overlap.
    """
    parts = []
    for _, rows in table.groupby("metal", sort=False):
        metals = Metals.of(rows.iloc[:1])
        grid = np.linspace(1, 1.2 * np.sqrt(rows["overlap_ratio"].max()), 2000)
        work = rows["work_loading_ratio"].to_numpy()
        t = np.interp(work, first_loading_work(constants, metals, grid), grid)
        impact = peak(constants, metals, t)
        restitution = np.sqrt(impact.work_unloading / work)
        static = peak(constants, metals, np.sqrt(rows["overlap_ratio"].to_numpy()))
        recovery = rows["overlap_ratio"] - rows["overlap_res_ratio"]
        ratios = {
            "force": impact.force / rows["force_ratio"],
            "restitution": restitution / rows["coefficient_of_restitution"],
            "contact_radius": static.contact_radius / rows["contact_radius_ratio"],
            "recovery": static.recovery / recovery,
        }
        parts.append(100 * (pd.DataFrame(ratios) - 1))
    return pd.concat(parts)
