# SPDX-License-Identifier: GPL-2.0-or-later
"""The eight benchmark impacts of Chung & Ooi (2011, Granular Matter 13:643): run in the engine and
held against theory.

What a benchmark is stands in its deck in `inputs/collision/chung_ooi`; which impacts it takes, in
`points.csv` beside the decks.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import cos, inf, nan, pi, radians, sin
from pathlib import Path

import pandas as pd

from plastigran import laws
from plastigran.engine.deck import index_variables
from plastigran.engine.dumps import read_dump
from plastigran.engine.process import inputs_folder, run_deck
from plastigran.experiments.collision import Collision, measure
from plastigran.materials import RIGID, Material, read_material
from plastigran.physics import central
from plastigran.physics.oblique import Motion, ObliqueImpact

#: What the eight are, by number.
TITLES = {
    1: "Elastic normal impact of two equal spheres",
    2: "Elastic normal impact on a rigid plane",
    3: "Normal impact with different restitutions",
    4: "Oblique impact at different incident angles",
    5: "Oblique impact at different tangential speeds",
    6: "Spinning sphere on a rigid plane",
    7: "Two equal spheres spinning against each other",
    8: "Spinning sphere on a larger sphere",
}

#: What makes the engine's own hertz the model the decks ask of the others: damped, never pulling.
HERTZ_OPTIONS = "limitForce on tangential_damping off"


def folder() -> Path:
    """Where the decks are. Raises EngineError when there are no input scripts."""
    return inputs_folder() / "collision" / "chung_ooi"


@dataclass(frozen=True)
class Outcome:
    """What an impact did: the bodies' motion after it, and the collision of the first."""

    after: Motion
    collision: Collision


@dataclass(frozen=True)
class BenchmarkImpact:
    """One impact of one benchmark; `plastigran.experiments.central.sweep` runs many.

    Attributes:
        deck: Name of the deck, without `.in`; it begins with the benchmark's number.
        material: Of the sphere, a file of `materials` beside the deck.
        knob: The deck's variable that the benchmark sweeps.
        value: Its value, in the deck's unit.
        modulus_ratio: Young's modulus of the second sphere over the first's; None leaves it to the
            deck.
        law: The model, or `hertz` for the engine's own.
        steps_per_contact: Time steps in an undamped contact.
    """

    deck: str
    material: str
    knob: str
    value: float
    modulus_ratio: float | None = None
    law: str = "vu_quoc_zhang"
    steps_per_contact: int = 1000

    @property
    def benchmark(self) -> int:
        return int(self.deck.split("_")[0])

    @property
    def variables(self) -> dict[str, object]:
        """What differs from the deck's defaults."""
        changed = {
            "material": self.material,
            self.knob: self.value,
            "law": self.law,
            "steps_per_contact": self.steps_per_contact,
        }
        if self.law == "hertz":
            changed["options"] = HERTZ_OPTIONS
        if self.modulus_ratio is not None:
            changed["modulus_ratio"] = self.modulus_ratio
        return changed

    @cached_property
    def settings(self) -> dict[str, str]:
        """The deck's variables, as text, with what this case changes."""
        defaults = index_variables(folder() / f"{self.deck}.in")
        unknown = set(self.variables) - set(defaults)
        if unknown:
            raise ValueError(f"{self.deck}.in has no variable {', '.join(sorted(unknown))}")
        return defaults | {name: str(value) for name, value in self.variables.items()}

    def number(self, name: str, default: float | None = None) -> float:
        """A setting as a number; one that names another with ${} has that one's value."""
        text = self.settings.get(name)
        if text is None and default is not None:
            return default
        if text is None:
            raise ValueError(f"{self.deck}.in has no variable {name}")
        return self.number(text[2:-1]) if text.startswith("${") else float(text)

    @cached_property
    def sphere(self) -> Material:
        return read_material(folder() / "materials" / f"{self.material}.in")

    def before(self) -> Motion:
        """Motion before the impact."""
        if "incident_angle" in self.settings:
            angle, speed = radians(self.number("incident_angle")), self.number("speed")
            normal, along = speed * cos(angle), speed * sin(angle)
        else:
            normal = self.number("speed_normal") + self.number("speed_normal_other", 0.0)
            along = self.number("speed_tangential", 0.0)
        return Motion(normal, along, self.number("spin"), spin_other=self.number("spin_other", 0.0))

    def impact(self) -> ObliqueImpact:
        """The impact as theory takes it."""
        body, radius = self.sphere.body(), self.number("radius")
        mass = 4 / 3 * pi * radius**3 * self.sphere.density
        other, radius_other, mass_other = RIGID, inf, inf
        if "radius_ratio" in self.settings:
            modulus = body.youngs_modulus * self.number("modulus_ratio")
            other = laws.Material(modulus, body.poissons_ratio, 1e30, 1.61)
            radius_other = radius * self.number("radius_ratio")
            mass_other = mass * self.number("density_ratio") * self.number("radius_ratio") ** 3
        return ObliqueImpact(
            pair=laws.combine(body, other),
            radius=radius,
            mass=mass,
            coefficient_of_friction=self.number("coefficient_of_friction"),
            coefficient_of_restitution=self.number("coefficient_of_restitution"),
            before=self.before(),
            radius_other=radius_other,
            mass_other=mass_other,
        )

    @property
    def label(self) -> str:
        """What tells its folder from others."""
        return f"{self.deck}_{self.material}"

    def trajectory(self, folder: str | Path) -> pd.DataFrame:
        """Run the deck in the engine, which writes in a folder: every step, see `read_dump`.

        Raises:
            EngineError: The engine stopped with an error.
        """
        run_deck(f"collision/chung_ooi/{self.deck}.in", self.variables, folder)
        return read_dump(Path(folder) / "trajectory.dump")

    def run(self, folder: str | Path) -> Outcome:
        """Run the deck in the engine, which writes in a folder, and measure.

        Raises:
            EngineError: The engine stopped with an error.
            CollisionError: The trajectory holds no whole collision.
        """
        trajectory = self.trajectory(folder)
        return Outcome(motion(trajectory, -1), measure(trajectory))

    def row(self, outcome: Outcome) -> dict[str, object]:
        """One line of the results table: what the engine found and what theory says.

        `*_predicted` is the spring and slider (`ObliqueImpact.spring_slider`) with the restitution
        of a dashpot that never pulls; `*_rigid` is rigid-body sliding. Peaks and duration are
        predicted, by Hertz, where nothing is damped.
        """
        impact, found, collision = self.impact(), outcome.after, outcome.collision
        expected, rigid = impact.spring_slider(), impact.rigid_sliding()
        hertz = (
            impact.radius_eff,
            impact.mass_eff,
            impact.pair.youngs_modulus_eff,
            impact.before.normal,
        )
        elastic = impact.coefficient_of_restitution == 1
        return {
            "benchmark": self.benchmark,
            "law": self.law,
            "material": self.material,
            "modulus_ratio": self.modulus_ratio,
            "knob": self.knob,
            "value": self.value,
            "radius": impact.radius,
            "closing_speed": impact.before.normal,
            "surface_speed_before": impact.surface_speed(impact.before),
            "slides": impact.slides(),
            "coefficient_of_restitution_set": impact.coefficient_of_restitution,
            "coefficient_of_restitution": found.normal / impact.before.normal,
            "coefficient_of_restitution_predicted": impact.restitution(),
            "speed_along": found.along,
            "speed_along_predicted": expected.along,
            "speed_along_rigid": rigid.along,
            "spin_after": found.spin,
            "spin_after_predicted": expected.spin,
            "spin_after_rigid": rigid.spin,
            "speed_along_other": found.along_other,
            "spin_after_other": found.spin_other,
            "surface_speed": impact.surface_speed(found),
            "surface_speed_predicted": impact.surface_speed(expected),
            "surface_speed_rigid": impact.surface_speed(rigid),
            # What friction does to the surface speed of a body that slides throughout.
            "surface_speed_scale": 3.5
            * impact.coefficient_of_friction
            * (1 + impact.restitution())
            * impact.before.normal,
            "force_max": collision.force_max,
            "force_max_predicted": float(central.hertz_force_max(*hertz)) if elastic else nan,
            "overlap_max": collision.overlap_max,
            "overlap_max_predicted": float(central.hertz_overlap_max(*hertz)) if elastic else nan,
            "contact_time": collision.contact_time,
            "contact_time_predicted": float(central.hertz_duration(*hertz)) if elastic else nan,
        }


def cases(law: str = "vu_quoc_zhang", steps_per_contact: int = 1000) -> list[BenchmarkImpact]:
    """Every impact of `points.csv`, in its order; law and steps as in `BenchmarkImpact`."""
    table = pd.read_csv(folder() / "points.csv", comment="#", dtype={"values": str})
    return [
        BenchmarkImpact(
            sweep["deck"],
            sweep["material"],
            sweep["knob"],
            float(value),
            None if pd.isna(sweep["modulus_ratio"]) else sweep["modulus_ratio"],
            law,
            steps_per_contact,
        )
        for sweep in table.to_dict("records")
        for value in sweep["values"].split()
    ]


def motion(trajectory: pd.DataFrame, frame: int) -> Motion:
    """Motion of the bodies in one frame of a trajectory: 0 the first, -1 the last.

    The normal speed is taken positive, closing or parting.
    """
    step = trajectory["step"].unique()[frame]
    bodies = trajectory[trajectory["step"] == step].sort_values("id")
    first = bodies.iloc[0]
    if len(bodies) == 1:
        return Motion(abs(first["vx"]), first["vy"], -first["omegaz"])
    second = bodies.iloc[1]
    normal = abs(first["vx"] - second["vx"])
    return Motion(normal, first["vy"], -first["omegaz"], second["vy"], second["omegaz"])


def agreement(table: pd.DataFrame) -> pd.DataFrame:
    """Largest deviations from theory by benchmark.

    Args:
        table: As `plastigran.experiments.central.sweep` of `cases` returns it.

    Returns:
        One row a benchmark: `impacts`; relative deviations of `coefficient_of_restitution` and,
        where nothing is damped, `force_max`, `overlap_max`, `contact_time`; deviations of the
        surface speed from the `spring_slider` and, where bodies slide throughout, from `rigid`
        bodies, over what sliding throughout changes it by.
    """

    def worst(part: pd.DataFrame, name: str) -> float:
        return (part[name] / part[f"{name}_predicted"] - 1).abs().max()

    def surface(part: pd.DataFrame, against: str) -> float:
        off = (part["surface_speed"] - part[f"surface_speed_{against}"]).abs()
        return (off / part["surface_speed_scale"]).max()

    lines = {}
    for number, part in table.groupby("benchmark"):
        lines[number] = {
            "impacts": len(part),
            **{
                name: worst(part, name)
                for name in (
                    "coefficient_of_restitution",
                    "force_max",
                    "overlap_max",
                    "contact_time",
                )
            },
            "spring_slider": surface(part, "predicted"),
            "rigid": surface(part[part["slides"]], "rigid"),
        }
    return pd.DataFrame.from_dict(lines, orient="index").rename_axis("benchmark")
