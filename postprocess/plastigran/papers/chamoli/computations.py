# SPDX-License-Identifier: GPL-2.0-or-later
"""Computations of the vibrating sphere of Chamoli's thesis, by finite elements and in LIGGGHTS."""

from __future__ import annotations

from functools import partial

import attrs
import numpy as np
import pandas as pd

from plastigran.fem.cache import cached
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.settings import Settings
from plastigran.fem.sphere.vibrate import vibrate
from plastigran.fem.sphere.vibration import Vibration
from plastigran.fem.theory.hertz import HertzSphere
from plastigran.materials import Material, read_material
from plastigran.papers.base import run_impacts
from plastigran.physics.impact_modes import impact_modes
from plastigran.report.computing import compute_all

RADIUS = 0.01
HARD, SOFT = 9.3e9, 6e6  # Young's moduli, Pa
SPEEDS = (0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 5.0)
SHOWN = ((HARD, 0.1), (HARD, 5.0), (SOFT, 5.0))  # impacts shown as curves and spectra
#: Computed times of flight after the impact, divided by the travel time of a compression wave
#: through the sphere.
LONG, SHORT = 200.0, 40.0
#: Radius of the ice sphere whose restitution Bridges, Hatzes & Lin (1984) measured [m], and impact
#: speeds in the range of their measurement [m/s].
ICE_RADIUS = 0.0275
ICE_SPEEDS = (2e-4, 1e-3, 5e-3, 2e-2)
#: Fit of Bridges, Hatzes & Lin (1984) to the restitution: factor and exponent, with speed in cm/s.
ICE_RESTITUTION = (0.32, -0.234)
#: Frequencies of modes in the thesis [kHz] by type, degree and overtone: the first radial and the
#: first toroidal mode. The thesis calls this toroidal mode the oblate-prolate mode.
PAPER_MODES = {("radial", 0, 0): 143.67, ("toroidal", 1, 0): 186.49}

Impact = tuple[float, float]  # Young's modulus, Pa, and speed, m/s


@attrs.frozen
class Computed:
    """Computed data of the tables and figures of this thesis.

    Attributes:
        vibrations: Finite-element results by Young's modulus and speed.
        engine: LIGGGHTS results with its own `hertz`, one row per Young's modulus and speed.
        viscoelastic: LIGGGHTS results with `viscoelastic_hertz`, one row per speed.
        modes: Exact modes of the hard sphere that a normal impact can excite.
    """

    vibrations: dict[Impact, Vibration]
    engine: pd.DataFrame
    viscoelastic: pd.DataFrame
    modes: pd.DataFrame

    def fundamental_frequency(self, impact: Impact) -> float:
        """Return the fundamental frequency [Hz] of the sphere in an impact."""
        return self.modes["frequency"].min() * np.sqrt(impact[0] / HARD)


def compute(progress: bool, coarse: bool) -> Computed:
    """Compute impacts by finite elements and in LIGGGHTS, and the exact modes."""
    speeds = (0.1, 5.0) if coarse else SPEEDS
    settings = Settings(divisions=4) if coarse else Settings()
    impacts = [*SHOWN, *((HARD, speed) for speed in speeds if (HARD, speed) not in SHOWN)]
    computations = {}
    for impact in impacts:
        modulus, speed = impact
        flight = SHORT if coarse or impact not in SHOWN else LONG
        arguments = (sphere(modulus).material, RADIUS, speed, flight)
        computations[impact] = partial(cached, vibrate, *arguments, settings=settings)
    vibrations = compute_all(computations, progress)
    hard, ice = material(HARD), read_material("ice")
    runs = [
        run_impacts("hertz", speeds, hard, RADIUS).table.assign(youngs_modulus=HARD),
        run_impacts("hertz", SHOWN[-1][1], material(SOFT), RADIUS).table.assign(
            youngs_modulus=SOFT
        ),
    ]
    highest = 1.1 * vibrations[HARD, 5.0].modes["frequency"].max()
    return Computed(
        dict(sorted(vibrations.items(), key=lambda item: (-item[0][0], item[0][1]))),
        pd.concat(runs).set_index(["youngs_modulus", "speed"]),
        run_impacts("viscoelastic_hertz", ICE_SPEEDS, ice, ICE_RADIUS).table,
        impact_modes(HARD, hard.poissons_ratio, hard.density, RADIUS, highest),
    )


def material(youngs_modulus: float) -> Material:
    """Return the material ice with its Young's modulus replaced by a given one [Pa]."""
    return attrs.evolve(read_material("ice"), youngs_modulus=youngs_modulus)


def sphere(youngs_modulus: float) -> HertzSphere:
    """Return the finite-element sphere of ice with a given Young's modulus [Pa]."""
    ice = material(youngs_modulus)
    return HertzSphere(
        ElasticPlastic(
            youngs_modulus=ice.youngs_modulus,
            poissons_ratio=ice.poissons_ratio,
            density=ice.density,
        ),
        RADIUS,
    )


def oscillation(vibration: Vibration) -> pd.DataFrame:
    """Return the oscillation of the contact force about a smooth fit during contact.

    The fit is Hertz' force times a cubic polynomial in (approach/R)^(1/2). The polynomial describes
    the deviation from Hertz' force in a sphere of finite size. This deviation depends only on the
    approach.

    Returns:
        One row per time step in contact: time at the middle of the step [s], and relative_force,
        the difference between force and fit divided by the largest force [-].
    """
    hertz = HertzSphere(vibration.material, vibration.radius)
    history = vibration.history
    last = np.flatnonzero(history["force"])[-1]
    # Assign the force of a step to the middle of the step.
    middle = history[["time", "approach"]].rolling(2).mean().iloc[1 : last + 1]
    force = history["force"].to_numpy()[1 : last + 1]
    approach = np.maximum(middle["approach"].to_numpy(), 0)
    powers = np.sqrt(approach / vibration.radius)[:, None] ** np.arange(4)
    basis = hertz.force(1.0) * approach[:, None] ** 1.5 * powers
    fit = basis @ np.linalg.lstsq(basis, force, rcond=None)[0]
    relative_force = (force - fit) / vibration.force_max
    return pd.DataFrame({"time": middle["time"].to_numpy(), "relative_force": relative_force})
