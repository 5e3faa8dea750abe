# SPDX-License-Identifier: GPL-2.0-or-later
"""Settings of the numerical resolution of a finite-element computation."""

from __future__ import annotations

import attrs

from plastigran.declared import number, whole, word
from plastigran.fem.contact.plane import PENALTY
from plastigran.fem.material.kinematics import KINEMATICS, SmallStrain
from plastigran.fem.mesh.block import HalfBlock
from plastigran.fem.mesh.sphere import SphereMesh
from plastigran.fem.theory.hertz import HertzSphere

# The core is the part of the mesh about the contact point in which all elements have equal size.
CORE_OVER_YIELD = 1.2  # core radius / contact radius at yield
CORE_OVER_REACH = 0.5  # largest core radius / largest contact radius


@attrs.frozen(kw_only=True)
class Settings:
    """Settings of the mesh, the load and time steps, and the penalty contact.

    With the defaults, forces are accurate to some tenths of a per cent; see docs/convergence.py.
    """

    divisions: int = whole(
        "number of elements across the core, the part with elements of equal size", 2, default=6
    )
    fineness: float = number(
        "factor that multiplies the number of rings of elements", "-", 0.1, 10, default=1.0
    )
    growth: float = number("ratio of consecutive forces beyond yield", "-", 1, 2, default=1.05)
    unloading_steps: int = whole("number of force increments of an unloading", 4, default=24)
    steps_of_contact: int = whole("number of time steps during a Hertz impact", 20, default=250)
    free_steps: int = whole("number of time steps after the end of contact", 1, default=5)
    frames: int = whole("number of field snapshots during a Hertz impact", default=0)
    penalty: float = number(
        "penalty stiffness divided by E*/h, with the length h of an element edge",
        "-",
        1,
        1e5,
        default=PENALTY,
    )
    strain: str = word("kinematics: small or finite strain", KINEMATICS, default="small")

    @property
    def kinematics(self) -> SmallStrain:
        """Relation between displacements and strains."""
        return KINEMATICS[self.strain]()

    def mesh(self, sphere: HertzSphere, reach: float, whole: bool) -> SphereMesh:
        """Return the mesh of the sphere for contact radii up to `reach`, m."""
        return SphereMesh(radius=sphere.radius, whole=whole, **self._fine_zone(sphere, reach))

    def block(self, sphere: HertzSphere, reach: float, size: float) -> HalfBlock:
        """Return the mesh of the half space under the sphere.

        `reach` is the largest contact radius, m; `size` is the radius of the meshed part, m.
        """
        return HalfBlock(size=size, **self._fine_zone(sphere, reach))

    def _fine_zone(self, sphere: HertzSphere, reach: float) -> dict[str, float]:
        core = CORE_OVER_REACH * reach
        if sphere.yielding is not None:
            core = min(core, CORE_OVER_YIELD * sphere.contact_radius(sphere.yield_force))
        return {
            "core": core,
            "reach": reach,
            "divisions": self.divisions,
            "fineness": self.fineness,
        }
