# SPDX-License-Identifier: GPL-2.0-or-later
"""Finite-element compression of a sphere, and the fit of the constants of `vu_quoc_zhang`."""

from __future__ import annotations

import attrs
import numpy as np
import pandas as pd

from plastigran.fem.cache import cached
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.material.hardening import LinearHardening
from plastigran.fem.settings import Settings
from plastigran.fem.sphere.calibration import Calibration, check_range
from plastigran.fem.sphere.calibration import calibrate as fit
from plastigran.fem.sphere.press import press
from plastigran.fem.sphere.results import Pressing
from plastigran.fem.theory.hertz import HertzSphere
from plastigran.materials import Material

USUAL_RANGE = 41.0  # largest force / yield force, as in the fit of Vu-Quoc and Zhang
#: Forces from which the sphere is unloaded for a figure, as fractions of the largest force.
UNLOADING_FRACTIONS = (0.08, 0.25, 0.5, 1.0)


@attrs.frozen
class PressedSphere:
    """Result of a finite-element compression of a sphere on a rigid plane.

    Attributes:
        pressing: Compression to the largest force, and unloading.
        fitted: Constants of `vu_quoc_zhang`.
        settings: Settings of the finite elements.
    """

    pressing: Pressing
    fitted: Calibration
    settings: Settings

    def unloadings(self, progress: bool = False) -> pd.DataFrame:
        """Return unloadings from the largest force and from smaller forces, one per row.

        The columns are those of `Pressing.unloadings` and `speed` [m/s]. An impact at this speed
        reaches the largest force of the row.
        """
        material, radius = self.pressing.material, self.pressing.radius
        forces = [fraction * self.fitted.force_max for fraction in UNLOADING_FRACTIONS]
        forces = [force for force in forces if force > self.fitted.yield_force]
        pressing = cached(
            press, material, radius, forces, settings=self.settings, progress=progress
        )
        mass = HertzSphere(material, radius).mass
        speed = np.sqrt(2 * pressing.unloadings["work_loading"] / mass)
        return pressing.unloadings.assign(speed=speed)


def press_sphere(
    metal: Material,
    plastic_modulus: float,
    force_ratio: float,
    radius: float,
    strain: str,
    progress: bool,
) -> PressedSphere:
    """Compress a sphere and fit the constants C_a and K_c of the law `vu_quoc_zhang`.

    `plastigran.fem.cache` stores the result.

    Args:
        metal: Material of the sphere; elastic constants, density and yield strength are used.
        plastic_modulus: Plastic modulus H, the slope of stress versus plastic strain [Pa].
        force_ratio: Largest force / yield force.
        radius: Radius of the sphere [m]; the constants do not depend on it.
        strain: "small", or "finite" for a/R above 0.1.
        progress: Whether to show a bar.

    Raises:
        ValueError: A number is out of range, the force is too small for a fit or too large for the
            mesh, or the computation cannot start.

    Warns:
        SmallStrainWarning: a/R is too large for small strain.
    """
    material = ElasticPlastic(
        youngs_modulus=metal.youngs_modulus,
        poissons_ratio=metal.poissons_ratio,
        density=metal.density,
        hardening=LinearHardening(metal.yield_strength, plastic_modulus),
    )
    sphere = HertzSphere(material, radius)
    force = force_ratio * sphere.yield_force
    check_range(sphere, force)
    settings = Settings(strain=strain)
    try:
        pressing = cached(press, material, radius, [force], settings=settings, progress=progress)
    except ArithmeticError as error:
        raise ValueError(str(error)) from None
    return PressedSphere(pressing, fit(pressing), settings)
