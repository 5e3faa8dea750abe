# SPDX-License-Identifier: GPL-2.0-or-later
"""A sphere of a metal pressed by finite elements, for the constants of `vu_quoc_zhang`."""

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

USUAL_RANGE = 41.0  # largest force over that at yield, as Vu-Quoc and Zhang's own fit
#: Further unloadings of a figure, over the largest force.
SHARES = (0.08, 0.25, 0.5, 1.0)


@attrs.frozen
class PressedSphere:
    """A sphere on a rigid plane.

    Attributes:
        pressing: Pressed to the largest force and let go.
        fitted: Constants of `vu_quoc_zhang`.
        settings: How fine.
    """

    pressing: Pressing
    fitted: Calibration
    settings: Settings

    def unloadings(self, progress: bool = False) -> pd.DataFrame:
        """Pressed and let go from smaller forces too: a row each, with `speed` [m/s], at which an
        impact has that largest force, and the columns of `Pressing.unloadings`.

        Args:
            progress: Show a bar.
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
    """Press a sphere and fit C_a and K_c to it; kept by `plastigran.fem.cache`.

    Args:
        youngs_modulus: E [Pa].
        poissons_ratio: nu [-].
        density: [kg/m^3].
        yield_strength: sigma_Y [Pa].
        plastic_modulus: H, stress over plastic strain [Pa].
        force_ratio: Largest force over that at yield.
        radius: Of the sphere [m]; the constants do not depend on it.
        strain: small or finite; for contacts wider than a tenth of the radius.
        progress: Show a bar.

    Raises:
        ValueError: A number is out of range, the force too small for a fit or too large for the
            mesh, or the computation cannot begin.

    Warns:
        SmallStrainWarning: The contact is too wide for small strain.
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
