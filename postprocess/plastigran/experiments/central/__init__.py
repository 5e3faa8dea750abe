# SPDX-License-Identifier: GPL-2.0-or-later
"""Central impacts of spheres: on a plane, on a mesh, and of two equal spheres."""

from __future__ import annotations

from collections.abc import Callable
from math import isfinite, nan, pi
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import attrs
import numpy as np
import pandas as pd

from plastigran import laws
from plastigran.declared import Declaration, radius_field, speed_field, word
from plastigran.engine.versions import HOSTS
from plastigran.experiments.base import Experiment, combinations
from plastigran.experiments.central.arrangement import run_label
from plastigran.experiments.central.remarks import remarks
from plastigran.experiments.collision import CollisionOutcome, measure
from plastigran.experiments.fields import (
    SPHERE_OVERLAP,
    Flag,
    check_overlap,
    having_options,
    law_field,
    law_options,
    options_field,
    several,
)
from plastigran.experiments.runs import Runs
from plastigran.experiments.tables import HEADS
from plastigran.materials import (
    NO_WALL,
    RIGID,
    RIGID_WALL,
    USUAL,
    Material,
    can_adhere,
    has_surface_energy,
    law_class,
    material_field,
    surface_energy_field,
)
from plastigran.physics import central
from plastigran.physics.rebound_hardness import dented_flat
from plastigran.usable_laws import warn_of_idle_surface_energy

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Number of spheres for each geometry; 1 means a sphere and a wall. A geometry has the name of its
#: deck.
GEOMETRIES = {"sphere_wall": 1, "sphere_mesh": 1, "two_spheres": 2}
#: Geometries that the LAMMPS deck supports.
LAMMPS_GEOMETRIES = ("sphere_wall", "two_spheres")

#: Impact speeds [m/s] of `plastigran demo` and of a figure in the docs, for the sphere of Zhang &
#: Vu-Quoc (2002): aluminium_zv02, radius 0.1 m. The highest speed is 120 times the yield speed.
PAPER_SPEEDS = (0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.06, 0.1, 0.2)


@attrs.frozen
class CentralImpact(Experiment):
    """One central impact of spheres.

    Raises:
        ValueError: A field is out of range, or the overlap would be too large for any law.
    """

    law: str = law_field()
    speed: float = speed_field("speed of each sphere")
    material: Material = material_field("material of the spheres")
    radius: float = radius_field("radius of the spheres")
    geometry: str = word("geometry of the impact", tuple(GEOMETRIES), default="sphere_wall")
    wall: Material | None = material_field("material of the plane, default rigid", None, "_other")
    options: str | None = options_field()
    surface_energy: float | None = surface_energy_field(
        "work of adhesion of the two bodies; switches on 'adhesion jkr' in laws with Hertz' "
        "elastic contact. Default for laws that require it: the value of the material"
    )
    host: str = attrs.field(
        default="liggghts",
        kw_only=True,
        validator=attrs.validators.in_(HOSTS),
        metadata={
            "declaration": Declaration(
                "program that runs the impact", choices=HOSTS, value_type=str
            )
        },
    )

    command = "impact"
    help = "run central impacts of spheres in LIGGGHTS or LAMMPS, with a table and figures"
    example = (
        "plastigran impact --law universal thornton --material steel --radius 0.005\n"
        "plastigran impact --law all --theory\n"
        "plastigran impact --law universal --options 'yielding flat' --material zirconia "
        "--wall steel\n"
        "plastigran impact --law jkr --surface-energy 0.05 --material pmma --radius 1e-5 "
        "--speeds 0.01 0.5"
    )
    has_theory = True
    geometries: ClassVar = GEOMETRIES
    overlap_ratio_max = SPHERE_OVERLAP
    flags: ClassVar = {
        "material": Flag(("aluminium_zv02",)),
        "law": Flag(("all",)),
        "speed": Flag(span=(0.001, 0.2, 9)),
        "radius": Flag(0.1),
        "geometry": Flag("sphere_wall"),
        "wall": Flag(),
        "options": Flag(many=False),
        "surface_energy": Flag(),
        "host": Flag("liggghts", many=False),
    }
    quantities = (
        "coefficient_of_restitution",
        "force_max",
        "overlap_max",
        "overlap_res",
        "loading_time",
        "contact_time",
    )
    shown = tuple(HEADS)

    def __attrs_post_init__(self) -> None:
        if self.work_of_adhesion is None:
            raise ValueError(
                f"law {self.law} needs surface_energy, which material {self.material.name} does "
                "not define. Give surface_energy, add it to the material, or use another law"
            )
        if self.host == "lammps" and self.geometry not in LAMMPS_GEOMETRIES:
            raise ValueError(
                f"geometry is {self.geometry}; in LAMMPS, it must be one of: "
                f"{', '.join(LAMMPS_GEOMETRIES)}"
            )
        if self.wall is not None and self.bodies == 2:
            raise ValueError(f"wall is {self.wall.name}, but {self.geometry} has no wall")
        check_overlap(
            self,
            self.predict().overlap_max,
            self.radius_eff,
            self.overlap_ratio_max,
            "effective radii",
        )

    @property
    def bodies(self) -> int:
        """Number of spheres, 1 or 2.

        Effective radius and mass are the radius and mass of a sphere divided by this number.
        """
        return self.geometries[self.geometry]

    @property
    def pair(self) -> laws.MaterialPair:
        """Combined constants of the two bodies in contact."""
        body = self.material.body()
        wall = body if self.bodies == 2 else RIGID
        return laws.combine(body, wall if self.wall is None else self.wall.body())

    @property
    def wall_name(self) -> str:
        """Name of the material of the wall, or one of the words in `arrangement.WALLS`."""
        if self.wall is not None:
            return self.wall.name
        return NO_WALL if self.bodies == 2 else RIGID_WALL

    @property
    def wall_yields(self) -> bool:
        """Whether the wall yields before the sphere."""
        if self.wall is None:
            return False
        return laws.combine(self.wall.body(), RIGID).yield_pressure < (
            laws.combine(self.material.body(), RIGID).yield_pressure
        )

    @property
    def law_is_of_indentation(self) -> bool:
        """Whether the law, with its options, describes a hard sphere that indents a flat."""
        needed = dented_flat(self.law).items()
        chosen = law_options(self.law, self.options).items()
        return laws.LAWS[self.law].indentation or (bool(needed) and needed <= chosen)

    @property
    def radius_eff(self) -> float:
        """Effective radius R* [m]."""
        return self.radius / self.bodies

    @property
    def mass_eff(self) -> float:
        """Effective mass m* [kg]."""
        return 4 / 3 * pi * self.radius**3 * self.material.density / self.bodies

    @property
    def closing_speed(self) -> float:
        """Closing speed of the two bodies [m/s]."""
        return self.speed * self.bodies

    def contact_law(self, **others: float | str):
        """Return the law between the two bodies.

        Args:
            others: Further constants of the law, and options that replace the options of the
                case.
        """
        given = {} if self.surface_energy is None else {"surface_energy": self.surface_energy}
        options = law_options(self.law, self.options)
        return self.material.law(self.law, self.pair, **given | options | others)

    @property
    def work_of_adhesion(self) -> float | None:
        """Work of adhesion of the two bodies [J/m^2]; NaN without adhesion.

        The value is None if the law needs a work of adhesion, but neither the case nor the material
        defines it.
        """
        if self.surface_energy is not None:
            return self.surface_energy
        return self.material.surface_energy if has_surface_energy(self.law) else nan

    @property
    def deck(self) -> str:
        """Path of the input script, relative to `inputs`."""
        return "lammps/impact.in" if self.host == "lammps" else f"collision/{self.geometry}.in"

    @property
    def label(self) -> str:
        return run_label(
            self.geometry, self.material.name, self.law, self.wall_name, self.options or USUAL
        )

    @property
    def timestep(self) -> float:
        """Recommended time step [s]."""
        return self.contact_law().recommended_timestep(
            self.radius_eff, self.mass_eff, self.closing_speed
        )

    def yield_speed(self) -> float:
        """Return the speed of each body at which the impact just reaches yield [m/s]."""
        return central.yield_speed(self.pair, self.radius_eff, self.mass_eff) / self.bodies

    def variables(self) -> dict[str, object]:
        variables = super().variables()
        del variables["host"]
        if self.surface_energy is None:
            variables["surface_energy"] = self.material.surface_energy
        if self.surface_energy is not None and self.law in laws.ADHESIVE_LAWS:
            variables["options"] = f"{self.options or ''} adhesion jkr".strip()
        if self.host == "lammps":
            # In LAMMPS, a law takes its constants and options in one list.
            law = law_class(self.law, adhesive=self.surface_energy is not None)
            names = [parameter["name"] for parameter in law.parameters()]
            given = [name for name in names if variables.get(name) is not None]
            words = [f"{name} {variables[name]}" for name in given]
            words += filter(None, [variables.pop("options")])
            return variables | {"constants": " ".join(words) or None}
        del variables["geometry"]  # the other decks have one geometry each
        return variables

    def predict(self) -> CollisionOutcome:
        """Return the outcome that the law predicts without LIGGGHTS."""
        speed = self.closing_speed
        impact = self.contact_law().central_impact(self.radius_eff, self.mass_eff, speed)
        return CollisionOutcome(
            closing_speed=speed,
            coefficient_of_restitution=impact.coefficient_of_restitution,
            force_max=impact.force_max,
            overlap_max=impact.overlap_max,
            overlap_res=impact.overlap_res,
            in_range=impact.in_range,
        )

    def theoretical_loop(self, points: int = 200) -> pd.DataFrame:
        """Return the force-overlap curve of the law: `points` rows each for loading and unloading.

        The columns are overlap [m] and force [N].
        """
        impact = self.predict()
        loading = np.linspace(0, impact.overlap_max, points)
        law = self.contact_law()
        end = -law.pull_off_distance(self.radius_eff) if law.adhesive else impact.overlap_res
        unloading = np.linspace(impact.overlap_max, end, points)
        overlaps = np.concatenate([loading, unloading])
        force = law.follow(self.radius_eff, overlaps)["force"]
        return pd.DataFrame({"overlap": overlaps, "force": force})

    def measure(self, folder: Path) -> CollisionOutcome:
        return measure(Path(folder) / "trajectory.dump")

    def facts(self) -> dict[str, object]:
        return {
            "geometry": self.geometry,
            "material": self.material.name,
            "law": self.law,
            "radius": self.radius,
            "speed": self.speed,
            "wall": self.wall_name,
            "options": self.options or USUAL,
            "surface_energy": self.work_of_adhesion,
            "speed_ratio": self.speed / self.yield_speed() if laws.LAWS[self.law].yields else nan,
        }

    def notes(self, measured: CollisionOutcome, predicted: CollisionOutcome) -> dict[str, object]:
        steps = measured.contact_time / self.timestep
        return {
            "in_range": predicted.in_range,
            "timestep": self.timestep,
            "steps": round(steps) if isfinite(steps) else nan,
        }

    @classmethod
    def plan(cls, **values: Any) -> list[CentralImpact]:
        """Return an impact for every combination of field values.

        Options apply only to laws that have them; a surface energy applies only to laws with
        adhesion or the option `adhesion jkr`.

        Raises:
            ValueError: The inputs of an impact are invalid, no law has the given options, or no law
                uses the given surface energy; the message gives the reason.

        Warns:
            UserWarning: As for `warn_of_idle_surface_energy`.
        """
        values = {name: several(value) for name, value in values.items()}
        names, texts = values.get("law", ()), filter(None, values.get("options", ()))
        given = [value for value in values.get("surface_energy", ()) if value is not None]
        if given and not any(map(can_adhere, names)):
            raise ValueError(
                f"surface_energy is {given[0]}, but {', '.join(names)} has no surface energy. "
                f"Use one of the laws {', '.join(filter(can_adhere, laws.LAWS))}"
            )
        having = {options: having_options(names, options) for options in texts}
        cases = combinations(values)
        for case in cases:
            if case["law"] not in having.get(case.get("options"), names):
                case["options"] = None
            if not can_adhere(case["law"]):
                case["surface_energy"] = None
        impacts = list(dict.fromkeys(cls(**case) for case in cases))
        if not given:
            warn_of_idle_surface_energy(names, (impact.material for impact in impacts))
        return impacts

    @classmethod
    def summary(cls, runs: Runs) -> str:
        return "\n".join([super().summary(runs), *remarks(runs)])

    @classmethod
    def figures(cls, runs: Runs) -> dict[str, Callable[[], Figure]]:
        # Imported here, because matplotlib is slow to load.
        from plastigran.experiments.central import figures

        return {
            "restitution": lambda: figures.restitution_figure(runs),
            "loops": lambda: figures.loops_figure(runs),
        }
