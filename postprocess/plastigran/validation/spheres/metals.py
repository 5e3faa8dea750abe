# SPDX-License-Identifier: GPL-2.0-or-later
"""Metals of the table of spheres; some are held out of the fit of `universal`."""

from __future__ import annotations

import attrs
import numpy as np
import pandas as pd

from plastigran import laws
from plastigran.fem.limits import SMALL_STRAIN, contact_reach
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.material.hardening import LinearHardening
from plastigran.fem.theory.hertz import HertzSphere
from plastigran.materials import RIGID

#: Plane-strain modulus [Pa] and radius [m] of every sphere. The dimensionless results do not depend
#: on them.
PLANE_MODULUS, RADIUS = 100e9, 0.01

#: Forces / yield force from which a sphere is unloaded.
FORCE_RATIOS = (1.3, 2, 3, 5, 8, 13, 22, 38, 65, 110, 190, 320, 540, 900, 1600, 2700)


@attrs.frozen
class SphereMetal:
    """Metal of the table of spheres.

    Attributes:
        yield_strength_ratio: sigma_Y/E*.
        poissons_ratio: nu.
        hardening_ratio: H/E, with the hardening slope H.
        held: Whether the metal is held out of the fit of `universal`.
        force_ratio_max: Largest force / yield force.
        strain: Kinematics, "small" or "finite".
        contact_radius_ratio_max: Largest a/R of the computation.
    """

    yield_strength_ratio: float
    poissons_ratio: float = 0.3
    hardening_ratio: float = 0.0
    held: bool = False
    force_ratio_max: float = 900.0
    strain: str = "small"
    contact_radius_ratio_max: float = SMALL_STRAIN

    @classmethod
    def of(cls, row: pd.Series) -> SphereMetal:
        """Return the metal of a row of the table of spheres."""
        return cls(row["yield_strength_ratio"], row["poissons_ratio"], row["hardening_ratio"])

    @property
    def name(self) -> str:
        """Name of the metal, which contains all its constants."""
        hardening = f"H{self.hardening_ratio:.4g}" if self.hardening_ratio else "perfect"
        finite = "-finite" if self.strain == "finite" else ""
        return f"s{self.yield_strength_ratio:g}-nu{self.poissons_ratio:g}-{hardening}{finite}"

    @property
    def youngs_modulus(self) -> float:
        """Young's modulus, Pa."""
        return PLANE_MODULUS * (1 - self.poissons_ratio**2)

    @property
    def yield_strength(self) -> float:
        """Yield strength, Pa."""
        return self.yield_strength_ratio * PLANE_MODULUS

    @property
    def material(self) -> ElasticPlastic:
        """Material for the finite elements."""
        return ElasticPlastic(
            youngs_modulus=self.youngs_modulus,
            poissons_ratio=self.poissons_ratio,
            density=7800.0,
            hardening=LinearHardening(
                self.yield_strength, self.hardening_ratio * self.youngs_modulus
            ),
        )

    @property
    def pair(self) -> laws.MaterialPair:
        """Material pair of the metal and a rigid plane, from which a contact law is made."""
        # The tangent modulus is E_t = E H/(E + H).
        tangent_modulus = self.youngs_modulus * self.hardening_ratio / (1 + self.hardening_ratio)
        body = laws.Body(
            self.youngs_modulus,
            self.poissons_ratio,
            self.yield_strength,
            tangent_modulus=tangent_modulus,
        )
        return laws.combine(body, RIGID)

    @property
    def sphere(self) -> HertzSphere:
        """Sphere of this metal, for Hertz's formulas and the yield point."""
        return HertzSphere(self.material, RADIUS)

    @property
    def forces(self) -> np.ndarray:
        """Forces from which the sphere is unloaded, N."""
        sphere = self.sphere
        forces = sphere.yield_force * np.array(FORCE_RATIOS)
        contact_radii = np.array([contact_reach(sphere, force) for force in forces])
        allowed = contact_radii <= self.contact_radius_ratio_max * RADIUS
        return forces[allowed & (np.array(FORCE_RATIOS) <= self.force_ratio_max)]


#: The held-out metals were chosen before any fit. Their strengths, Poisson's ratios and hardening
#: slopes lie between the values of the metals in the fit.
_METALS = (
    SphereMetal(1.2e-3),
    SphereMetal(8e-4, 0.35, held=True),
    SphereMetal(1.2e-3, 0.3, 1 / 20),
    SphereMetal(1.2e-3, 0.3, 1 / 50, held=True),
    SphereMetal(3e-4, force_ratio_max=2700.0),
    SphereMetal(5e-3),
    SphereMetal(1.2e-3, 0.2),
    SphereMetal(1.2e-3, 0.45),
    SphereMetal(2.5e-3, 0.3, 1 / 30, held=True),
    SphereMetal(2.5e-3),
    SphereMetal(6e-4, 0.2, held=True, force_ratio_max=2700.0),
    SphereMetal(1.2e-3, 0.3, 1 / 100),
    SphereMetal(2e-3, 0.4, held=True),
    SphereMetal(5e-3, 0.3, 1 / 20),
    SphereMetal(1e-2),
    SphereMetal(3e-4, 0.3, 1 / 30),
    SphereMetal(6e-4, 0.3, 1 / 20, held=True),
    SphereMetal(1e-2, 0.2, held=True),
    SphereMetal(2.5e-3, 0.45, 1 / 50),
    SphereMetal(5e-3, 0.2, 1 / 100, held=True),
    SphereMetal(2e-2),
    SphereMetal(1e-2, 0.3, 1 / 20, held=True),
    SphereMetal(6e-4, 0.2, 1 / 50, force_ratio_max=2700.0),
    SphereMetal(1e-3, 0.3, 1 / 100, held=True, force_ratio_max=2700.0),
    SphereMetal(6e-4, 0.45, 1 / 20),
    SphereMetal(3e-4, 0.45, force_ratio_max=2700.0),
    SphereMetal(5e-3, held=True, strain="finite", contact_radius_ratio_max=0.16),
    SphereMetal(2.5e-3, 0.3, 1 / 30, held=True, strain="finite", contact_radius_ratio_max=0.16),
)
#: Metals by name, in the order of the computation.
METALS = {metal.name: metal for metal in _METALS}
