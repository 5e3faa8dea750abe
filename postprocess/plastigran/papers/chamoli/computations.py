# SPDX-License-Identifier: GPL-2.0-or-later
"""Results that several tables and figures share."""

from __future__ import annotations

import attrs
import numpy as np
import pandas as pd

from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.settings import Settings
from plastigran.fem.sphere.vibrate import vibrate
from plastigran.fem.sphere.vibration import Vibration
from plastigran.fem.theory.hertz import HertzSphere
from plastigran.materials import Material, read_material
from plastigran.papers.base import thrown
from plastigran.physics.impact_modes import impact_modes
from plastigran.report.computing import Computation, compute_all

RADIUS = 0.01
HARD, SOFT = 9.3e9, 6e6  # Young's moduli, Pa
SPEEDS = (0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 5.0)
SHOWN = ((HARD, 0.1), (HARD, 5.0), (SOFT, 5.0))  # impacts whose spectra and curves are shown
# flight times divided by the time of a compression wave through the sphere
LONG, SHORT = 200.0, 40.0
#: The sphere of ice whose restitution Bridges, Hatzes & Lin (1984) measured: radius [m] and speeds
#: within their range [m/s].
ICE_RADIUS = 0.0275
ICE_SPEEDS = (2e-4, 1e-3, 5e-3, 2e-2)
#: Their fit: factor and power of the speed in cm/s.
ICE_RESTITUTION = (0.32, -0.234)
#: Frequencies of the thesis [kHz] by kind, degree and overtone: the radial mode, and the first
#: toroidal one, which the thesis takes for the oblate-prolate mode.
PAPER_MODES = {("radial", 0, 0): 143.67, ("toroidal", 1, 0): 186.49}

Impact = tuple[float, float]  # Young's modulus, Pa, and speed, m/s


@attrs.frozen
class Computed:
    """Results by impact.

    Attributes:
        vibrations: Finite-element results.
        engine: Rows of LIGGGHTS' own `hertz` by Young's modulus and speed.
        viscoelastic: Rows of `viscoelastic_hertz` in LIGGGHTS.
        modes: Exact modes of the hard sphere that a normal impact can excite.
    """

    vibrations: dict[Impact, Vibration]
    engine: pd.DataFrame
    viscoelastic: pd.DataFrame
    modes: pd.DataFrame


def compute_impacts(progress: bool, coarse: bool) -> Computed:
    """Compute impacts by finite elements and in LIGGGHTS, and the exact modes."""
    speeds = (0.1, 5.0) if coarse else SPEEDS
    settings = Settings(divisions=4) if coarse else Settings()
    impacts = [*SHOWN, *((HARD, speed) for speed in speeds if (HARD, speed) not in SHOWN)]
    vibrations = compute_all(
        {
            impact: Computation(
                vibrate,
                (sphere(impact[0]).material, RADIUS, impact[1], _flight(impact, coarse)),
                settings,
            )
            for impact in impacts
        },
        progress,
    )
    hard, ice = material(HARD), read_material("ice")
    runs = [
        thrown("hertz", speeds, hard, RADIUS).table.assign(youngs_modulus=HARD),
        thrown("hertz", SHOWN[-1][1], material(SOFT), RADIUS).table.assign(youngs_modulus=SOFT),
    ]
    highest = 1.1 * vibrations[HARD, 5.0].modes["frequency"].max()
    return Computed(
        dict(sorted(vibrations.items(), key=lambda item: (-item[0][0], item[0][1]))),
        pd.concat(runs).set_index(["youngs_modulus", "speed"]),
        thrown("viscoelastic_hertz", ICE_SPEEDS, ice, ICE_RADIUS).table,
        impact_modes(HARD, hard.poissons_ratio, hard.density, RADIUS, highest),
    )


def material(youngs_modulus: float) -> Material:
    """Return ice with another Young's modulus [Pa]."""
    return attrs.evolve(read_material("ice"), youngs_modulus=youngs_modulus)


def sphere(youngs_modulus: float) -> HertzSphere:
    """Return the finite-element sphere with a Young's modulus [Pa]."""
    ice = material(youngs_modulus)
    return HertzSphere(
        ElasticPlastic(
            youngs_modulus=ice.youngs_modulus,
            poissons_ratio=ice.poissons_ratio,
            density=ice.density,
        ),
        RADIUS,
    )


def _flight(impact: Impact, coarse: bool) -> float:
    return SHORT if coarse or impact not in SHOWN else LONG


@attrs.frozen
class Oscillation:
    """Oscillation of the contact force about a smooth curve.

    Attributes:
        time: Middles of the steps of contact (n,), s.
        share: Difference from the smooth force, divided by the largest force (n,).
    """

    time: np.ndarray
    share: np.ndarray


def oscillation(vibration: Vibration) -> Oscillation:
    """Return the difference of the force from a smooth fit.

    The fit is Hertz' force times a cubic in (approach/R)^(1/2), which covers the effect of the
    finite
    size of the sphere, because that depends only on the approach.
    """
    hertz = HertzSphere(vibration.material, vibration.radius)
    history = vibration.history
    last = np.flatnonzero(history["force"])[-1]
    # The force of a step belongs to its middle.
    middle = history[["time", "approach"]].rolling(2).mean().iloc[1 : last + 1]
    force = history["force"].to_numpy()[1 : last + 1]
    approach = np.maximum(middle["approach"].to_numpy(), 0)
    powers = np.sqrt(approach / vibration.radius)[:, None] ** np.arange(4)
    basis = hertz.force(1.0) * approach[:, None] ** 1.5 * powers
    fitted = basis @ np.linalg.lstsq(basis, force, rcond=None)[0]
    return Oscillation(middle["time"].to_numpy(), (force - fitted) / vibration.force_max)
