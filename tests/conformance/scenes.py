# SPDX-License-Identifier: GPL-2.0-or-later
"""Bodies for the decks in `decks`: spheres, or discs in two dimensions for laws of cylinders."""

from __future__ import annotations

from math import pi
from pathlib import Path
from typing import ClassVar

import numpy as np
from attrs import evolve
from elastic_contact import NOT_HERTZIAN, mapped_sphere
from scipy.special import lambertw

from plastigran import laws
from plastigran.engine.process import run_deck
from plastigran.experiments.central import CentralImpact
from plastigran.experiments.cylinder import CylinderImpact
from plastigran.materials import RIGID, Material, read_material

GEOMETRIES = ("pair", "plane", "mesh")  # partners of the sphere in the decks
DECKS = Path(__file__).parent / "decks"
LENGTH = 1.0  # length of cylinders and thickness of bodies, as in the decks [m]


class Spheres:
    """Spheres of the aluminum of Zhang & Vu-Quoc for one law, by default of radius 0.1 m.

    Attributes:
        hertzian: Whether the elastic contact equals LIGGGHTS' own hertz.
    """

    hertzian = True
    material: Material = read_material("aluminium_zv02")
    inertia: float = 0.4  # moment of inertia / (mass radius^2)
    drift: float = 40.0  # speed that carries a collision across a border of ranks [m/s]

    def __init__(self, law_name: str, dissipative_constant: float) -> None:
        self.law_name = law_name
        self.material = evolve(self.material, dissipative_constant=dissipative_constant)

    def run(self, deck: str, folder: Path, ranks: int = 1, **variables) -> str:
        """Run a deck of the folder `decks` with these bodies.

        The law is `law_name`, unless `variables` names another one.
        """
        path = DECKS / f"{deck}.in"
        variables = {"law": self.law_name, **self.variables(), **variables}
        if "variable decks" in path.read_text():
            variables["decks"] = DECKS
        return run_deck(path, variables, folder, ranks=ranks)

    def variables(self) -> dict[str, object]:
        return {"dissipative_constant": self.material.dissipative_constant}

    def law(self, pair: laws.MaterialPair):
        return self.material.law(self.law_name, pair)

    def wall(self) -> laws.MaterialPair:
        """Return the material pair of a body and a rigid wall."""
        return laws.combine(self.material.body(), RIGID)

    def mass(self, radius: float = 0.1, density: float | None = None) -> float:
        return 4 / 3 * pi * radius**3 * (density or self.material.density)

    def impact(self, speed: float) -> CentralImpact:
        return CentralImpact(self.law_name, speed, self.material, 0.1)

    def yield_contact_radius(self) -> float:
        return 0.1 * laws.yield_radius_ratio(self.wall())

    def tangential_stiffness(self, contact_radius: np.ndarray) -> np.ndarray:
        return 8 * self.wall().shear_modulus_eff * contact_radius


class RatedSpheres(Spheres):
    """Spheres whose strength depends strongly on the strain rate of the impact."""

    rate: ClassVar = {"rate_coefficient": 1.0, "reference_rate": 0.3}
    material: Material = evolve(Spheres.material, **rate)

    def variables(self) -> dict[str, object]:
        return super().variables() | self.rate


class MappedSpheres(Spheres):
    """Spheres with the elastic contact of an elliptical indenter, as in `mdr`."""

    hertzian = False

    def elastic_force(
        self, pair: laws.MaterialPair, radius_eff: float, overlap: np.ndarray
    ) -> np.ndarray:
        return mapped_sphere(pair, radius_eff, overlap)["force"]


class Cylinders(Spheres):
    """Cylinders of 1 m length, which are discs in the two-dimensional decks.

    The yield strength of their aluminum is reduced, so that they yield at the impact speeds of the
    spheres.
    """

    hertzian = False
    material: Material = evolve(read_material("aluminium_zv02"), yield_strength=3e7)
    inertia: float = 0.5
    drift: float = 140.0

    def variables(self) -> dict[str, object]:
        material = {"yield_strength": self.material.yield_strength}
        return {**super().variables(), "shape": "cylinder", **material}

    def law(self, pair: laws.MaterialPair):
        return laws.LAWS[self.law_name](pair, cylinder_length=LENGTH, body_thickness=LENGTH)

    def elastic_force(
        self, pair: laws.MaterialPair, radius_eff: float, overlap: np.ndarray
    ) -> np.ndarray:
        """Return the force of the elastic line contact [N], with scipy's Lambert W."""
        # nu/(1 - nu) = 0.3/0.7; length and thickness are 1 m.
        z = overlap * radius_eff * np.exp(0.3 / 0.7)
        return np.pi * pair.youngs_modulus_eff * overlap / -lambertw(-z, -1).real

    def mass(self, radius: float = 0.1, density: float | None = None) -> float:
        return pi * radius**2 * (density or self.material.density)

    def impact(self, speed: float) -> CentralImpact:
        return CylinderImpact(
            self.law_name,
            speed,
            self.material,
            0.1,
            mass=self.mass(),
            length_ratio=LENGTH / 0.1,
            body_thickness=LENGTH,
        )

    def yield_contact_radius(self) -> float:
        pair = self.wall()
        return 12 * pair.yield_strength * 0.1 / (pi * pair.youngs_modulus_eff)

    def tangential_stiffness(self, contact_radius: np.ndarray) -> np.ndarray:
        pair = self.wall()
        far = 2 * np.log(2 * LENGTH / contact_radius) + 1 / (1 - pair.poissons_ratio)
        return pi * pair.youngs_modulus_eff * LENGTH / far


def scene(law_name: str, dissipative_constant: float = 3e-5) -> Spheres:
    """Return the bodies for a law. By default, the rebound speed of a viscous sphere of radius 0.1
    m is 0.8 times its impact speed."""
    name, _, rated = law_name.partition(" ")
    if rated:
        return RatedSpheres(name, dissipative_constant)
    kind = {"sphere": Spheres, "cylinder": Cylinders}[laws.LAWS[law_name].shape]
    return (MappedSpheres if law_name in NOT_HERTZIAN else kind)(law_name, dissipative_constant)
