# SPDX-License-Identifier: GPL-2.0-or-later
"""An experiment: contact time and largest force of an elastic sphere on a rigid plane."""

from __future__ import annotations

from math import pi
from pathlib import Path

import attrs

from plastigran import laws
from plastigran.declared import number
from plastigran.experiments.base import Experiment
from plastigran.experiments.collision import measure
from plastigran.materials import RIGID, Material, material_field
from plastigran.physics import central


@attrs.frozen
class Touch:
    """Outcome of an impact: contact time [s] and largest force [N]."""

    contact_time: float
    force_max: float


@attrs.frozen
class ElasticImpact(Experiment):
    """Central impact of a sphere on a rigid plane, with LIGGGHTS' own hertz."""

    speed: float = number("impact speed", "m/s", 0)
    radius: float = number("radius of the sphere", "m", 0, default=0.01)
    material: Material = material_field("material of the sphere", "steel")

    command = "touch"
    help = "elastic impacts of a sphere, against Hertz"
    deck = "collision/sphere_wall.in"
    quantities = ("contact_time", "force_max")

    @property
    def timestep(self) -> float:
        return self.predict().contact_time / 200

    def variables(self) -> dict[str, object]:
        return super().variables() | {"law": "hertz"}

    def predict(self) -> Touch:
        modulus = laws.combine(self.material.body(), RIGID).youngs_modulus_eff
        mass = 4 / 3 * pi * self.radius**3 * self.material.density
        bodies = self.radius, mass, modulus, self.speed
        return Touch(
            float(central.hertz_duration(*bodies)), float(central.hertz_force_max(*bodies))
        )

    def measure(self, folder: Path) -> Touch:
        collision = measure(folder / "trajectory.dump")
        return Touch(collision.contact_time, collision.force_max)

    @classmethod
    def figures(cls, runs):
        def draw():
            from plastigran.plot import style

            with style.styled():
                figure, axes = style.subplots(figsize=(5, 4))
                axes.loglog(runs.table["speed"], runs.table["contact_time"], "o")
                axes.loglog(runs.table["speed"], runs.table["contact_time_predicted"])
                axes.set(xlabel="impact speed (m/s)", ylabel="contact time (s)")
            return figure

        return {"contact_time": draw}
