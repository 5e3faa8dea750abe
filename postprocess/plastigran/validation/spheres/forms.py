# SPDX-License-Identifier: GPL-2.0-or-later
"""The forms of the law `universal` in yield units, for any constants: what the fit moves.

The equations are those of `contact_models/plastigran/laws/universal.h`; docs/laws/universal.md says
why they are these.
"""

from __future__ import annotations

from functools import cache
from math import pi

import attrs
import numpy as np
import pandas as pd

from plastigran import laws

NODES, WEIGHTS = np.polynomial.legendre.leggauss(12)
NODES, WEIGHTS = (NODES + 1) / 2, WEIGHTS / 2  # on 0 to 1


@attrs.frozen
class Constants:
    """All constants of the law, with the values that the fit starts from.

    Attributes:
        q_1: Of the strength, how far from yield the pressure at yield matters.
        q_2: How much hardening strengthens.
        q_3: How that slows down.
        f_1: Force far from yield: 1/f_1 F_Y t^2.
        f_2: Of the force near yield.
        f_3: The same.
        f_4: The same.
        f_5: How much less a finite sphere resists.
        c_1: a^2/(R alpha) - 1 far from yield.
        c_2: Of the contact radius near yield.
        c_3: The same.
        c_4: How much hardening keeps the contact from spreading.
        c_5: How much stiffer a finite sphere is.
        d_1: Largest share that recovery lacks of that of Hertz' contact.
        d_2: Of the recovery near yield.
        d_3: The same.
        g_1: How the unloading curve departs from Hertz'.
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
    """What the forms take of a metal, each an array (n,) or a number.

    Attributes:
        onset: p_y/sigma_Y over that at Poisson's ratio 0.3.
        hardening: (p_y/sigma_Y) H/E'.
        yield_radius: a_Y/R.
    """

    onset: np.ndarray
    hardening: np.ndarray
    yield_radius: np.ndarray

    @classmethod
    def of(cls, table: pd.DataFrame) -> Metals:
        """Those of the rows of the table of spheres (n,)."""
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
    """What a virgin contact has reached, in yield units; arrays (n,).

    Attributes:
        force: F/F_Y.
        contact_radius: a/a_Y.
        recovery: (overlap_max - overlap_res)/overlap_Y.
        work_unloading: Over F_Y overlap_Y.
    """

    force: np.ndarray
    contact_radius: np.ndarray
    recovery: np.ndarray
    work_unloading: np.ndarray


def depth(constants: Constants, metals: Metals, t: np.ndarray) -> np.ndarray:
    """S = <T - 1> at t = (overlap/overlap_Y)^(1/2) >= 1 (n,)."""
    k, s = constants, t - 1
    strength = (k.q_1 + s) / (k.q_1 + metals.onset * s)
    strength = strength + k.q_2 * metals.hardening * s / (1 + k.q_3 * s)
    return np.maximum(t / strength - 1, 0)


def peak(constants: Constants, metals: Metals, t: np.ndarray) -> Peak:
    """Force, contact radius and what unloading gives back at t >= 1 (n,)."""
    k, s = constants, depth(constants, metals, t)
    wide = (metals.yield_radius * s) ** 2 / (1 + metals.yield_radius * s)
    softening = k.f_1 * s**2 * (s + k.f_2) / ((s + k.f_3) * (s + k.f_4))
    force = t**3 / (1 + softening * (1 + k.f_5 * wide))
    widening = k.c_1 * s**2 / ((1 + k.c_4 * metals.hardening) * s**2 + k.c_2 * s + k.c_3)
    contact_radius = t * np.sqrt(1 + widening) * (1 + k.c_5 * wide)
    lacking = k.d_1 * s**2 / (s**2 + k.d_2 * s + k.d_3)
    recovery = (1 - lacking) * force / contact_radius
    work = force * recovery * unloading_work(k.g_1 * lacking)
    return Peak(force, contact_radius, recovery, work)


def unloading_work(g: np.ndarray) -> np.ndarray:
    """Integral of y^(3/2) (1 + g)/(1 + g y^(1/2)) over y from 0 to 1 (n,)."""
    g = np.asarray(g)[..., None]
    return np.sum(WEIGHTS * 2 * NODES**4 * (1 + g) / (1 + g * NODES), axis=-1)


def work_ratio(work_unloading, force, contact_radius):
    """Energy given back over that of Hertz' contact of the same force and contact radius, 3 F^2/(10
    E* a); all in yield units.
    """
    return work_unloading * contact_radius / (0.4 * force**2)


def virgin_work(constants: Constants, metals: Metals, t: np.ndarray) -> np.ndarray:
    """Work of loading over F_Y overlap_Y up to each t of an increasing grid from 1 on (n,), by
    Gauss' rule between its points.
    """
    steps = np.diff(t)
    at = t[:-1, None] + steps[:, None] * NODES
    sums = np.sum(WEIGHTS * 2 * at * peak(constants, metals, at).force, axis=1) * steps
    return 0.4 + np.concatenate([[0], np.cumsum(sums)])


def errors(constants: Constants, table: pd.DataFrame) -> pd.DataFrame:
    """How far the law is off the rows of the table, in per cent of the finite elements' value.

    Returns:
        `force` and `restitution` of the impact with the same work of loading, `contact_radius` and
        `recovery` at the same overlap; one row for each of the table's.
    """
    parts = []
    for _, rows in table.groupby("metal", sort=False):
        metals = Metals.of(rows.iloc[:1])
        grid = np.linspace(1, 1.2 * np.sqrt(rows["overlap_ratio"].max()), 2000)
        work = rows["work_loading_ratio"].to_numpy()
        impact = peak(
            constants, metals, np.interp(work, virgin_work(constants, metals, grid), grid)
        )
        pressed = peak(constants, metals, np.sqrt(rows["overlap_ratio"].to_numpy()))
        found = {
            "force": impact.force / rows["force_ratio"],
            "restitution": np.sqrt(impact.work_unloading / work)
            / rows["coefficient_of_restitution"],
            "contact_radius": pressed.contact_radius / rows["contact_radius_ratio"],
            "recovery": pressed.recovery / (rows["overlap_ratio"] - rows["overlap_res_ratio"]),
        }
        parts.append(pd.DataFrame({name: 100 * (ratio - 1) for name, ratio in found.items()}))
    return pd.concat(parts)
