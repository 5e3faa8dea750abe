# SPDX-License-Identifier: GPL-2.0-or-later
"""Finite elements of a sphere, for the constants of `vu_quoc_zhang`."""

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

USUAL_RANGE = 41.0  # largest force / yield force, as in Vu-Quoc and Zhang's own fit
#: Further unloadings of a figure, as fractions of the largest force.
SHARES = (0.08, 0.25, 0.5, 1.0)


@attrs.frozen
class PressedSphere:
    """Sphere on a rigid plane.

    Attributes:
        pressing: Compression to the largest force, and unloading.
        fitted: Constants of `vu_quoc_zhang`.
        settings: Resolution.
    """

    pressing: Pressing
    fitted: Calibration
    settings: Settings

    def unloadings(self, progress: bool = False) -> pd.DataFrame:
        """Return unloadings also from smaller forces.

        Each is a row with `speed` [m/s], the speed of an impact with that largest force, and the
        columns
        of `Pressing.unloadings`.

        Args:
            progress: Whether to show a bar.
        """
        material, radius = self.pressing.material, self.pressing.radius
        forces = [share * self.fitted.force_max for share in SHARES]
        forces = [force for force in forces if force > self.fitted.yield_force]
        found = cached(
            press, material, radius, forces, settings=self.settings, progress=progress
        ).unloadings
        mass = HertzSphere(material, radius).mass
        return found.assign(speed=np.sqrt(2 * found["work_loading"] / mass))


def press_sphere(
    youngs_modulus: float,
    poissons_ratio: float,
    density: float,
    yield_strength: float,
    plastic_modulus: float = 0.0,
    force_ratio: float = USUAL_RANGE,
    radius: float = 0.1,
    strain: str = "small",
    progress: bool = False,
) -> PressedSphere:
    """Compress a sphere and fit C_a and K_c; `plastigran.fem.cache` keeps the result.

    Args:
        youngs_modulus: E [Pa].
        poissons_ratio: nu [-].
        density: Density [kg/m^3].
        yield_strength: sigma_Y [Pa].
        plastic_modulus: H, stress over plastic strain [Pa].
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
    metal = ElasticPlastic(
        youngs_modulus=youngs_modulus,
        poissons_ratio=poissons_ratio,
        density=density,
        hardening=LinearHardening(yield_strength, plastic_modulus),
    )
    sphere = HertzSphere(metal, radius)
    force = force_ratio * sphere.yield_force
    check_range(sphere, force)
    settings = Settings(strain=strain)
    try:
        pressing = cached(press, metal, radius, [force], settings=settings, progress=progress)
    except ArithmeticError as error:
        raise ValueError(str(error)) from None
    return PressedSphere(pressing, fit(pressing), settings)
