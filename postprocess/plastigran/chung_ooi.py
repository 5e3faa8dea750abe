# SPDX-License-Identifier: GPL-2.0-or-later
"""The eight benchmark impacts of Chung & Ooi (2011, Granular Matter 13:643): run in the engine and
held against theory.

What a benchmark is stands in its deck in `inputs/collision/chung_ooi`; which impacts it takes, in
`points.csv` beside the decks.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property
from math import cos, inf, pi, radians, sin
from pathlib import Path

import pandas as pd
from tqdm import tqdm

from plastigran import laws, theory
from plastigran.collision import Collision, measure
from plastigran.dumps import read_dump
from plastigran.engine import index_variables, inputs_folder, run_deck
from plastigran.materials import RIGID, Material, read_material
from plastigran.oblique import Motion, ObliqueImpact

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
class Case:
    """One impact of one benchmark.

    Attributes:
        deck: Name of the deck, without `.in`; it begins with the benchmark's number.
        material: Of the sphere, a file of `materials` beside the deck.
        knob: The deck's variable that the benchmark sweeps.
        value: Its value, in the deck's unit.
        modulus_ratio: Young's modulus of the second sphere over the first's; None leaves it to the
            deck.
    """

    deck: str
    material: str
    knob: str
    value: float
    modulus_ratio: float | None = None

    @property
    def benchmark(self) -> int:
        return int(self.deck.split("_")[0])

    @property
    def variables(self) -> dict[str, object]:
        """What differs from the deck's defaults."""
        changed = {"material": self.material, self.knob: self.value}
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

    def run(
        self, output: str | Path, law: str = "vu_quoc_zhang", steps_per_contact: int = 1000
    ) -> pd.DataFrame:
        """Run the deck in the engine.

        Args:
            output: Where the engine writes.
            law: The model, or `hertz` for the engine's own.
            steps_per_contact: Time steps in an undamped contact.

        Returns:
            The trajectory, every step; see `read_dump`.

        Raises:
            EngineError: The engine stopped with an error.
        """
        variables = {**self.variables, "law": law, "steps_per_contact": steps_per_contact}
        if law == "hertz":
            variables["options"] = HERTZ_OPTIONS
        run_deck(f"collision/chung_ooi/{self.deck}.in", variables, output)
        return read_dump(Path(output) / "trajectory.dump")


def cases() -> list[Case]:
    """Every impact of `points.csv`, in its order."""
    table = pd.read_csv(folder() / "points.csv", comment="#", dtype={"values": str})
    return [
        Case(
            sweep["deck"],
            sweep["material"],
            sweep["knob"],
            float(value),
            None if pd.isna(sweep["modulus_ratio"]) else sweep["modulus_ratio"],
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


def row(case: Case, trajectory: pd.DataFrame) -> tuple[dict[str, object], Collision]:
    """What the engine found and what theory says, and the collision itself.

    `_theory` is the spring and slider (`ObliqueImpact.spring_slider`) with the restitution of a
    dashpot that never pulls; `_rigid` is rigid-body sliding. Peaks and duration have a theory,
    Hertz's, where nothing is damped.

    Raises:
        CollisionError: The trajectory holds no whole collision.
    """
    impact, collision = case.impact(), measure(trajectory)
    found, expected, rigid = motion(trajectory, -1), impact.spring_slider(), impact.rigid_sliding()
    hertz = (
        impact.mass_eff,
        impact.radius_eff,
        impact.pair.youngs_modulus_eff,
        impact.before.normal,
    )
    elastic = impact.coefficient_of_restitution == 1
    overlap_max = float(theory.hertz_overlap_max(*hertz)) if elastic else None
    return {
        "benchmark": case.benchmark,
        "material": case.material,
        "modulus_ratio": case.modulus_ratio,
        "knob": case.knob,
        "value": case.value,
        "radius": impact.radius,
        "closing_speed": impact.before.normal,
        "surface_speed_before": impact.surface_speed(impact.before),
        "slides": impact.slides(),
        "coefficient_of_restitution_set": impact.coefficient_of_restitution,
        "coefficient_of_restitution": found.normal / impact.before.normal,
        "coefficient_of_restitution_theory": impact.restitution(),
        "speed_along": found.along,
        "speed_along_theory": expected.along,
        "speed_along_rigid": rigid.along,
        "spin_after": found.spin,
        "spin_after_theory": expected.spin,
        "spin_after_rigid": rigid.spin,
        "speed_along_other": found.along_other,
        "spin_after_other": found.spin_other,
        "surface_speed": impact.surface_speed(found),
        "surface_speed_theory": impact.surface_speed(expected),
        "surface_speed_rigid": impact.surface_speed(rigid),
        # What friction does to the surface speed of a body that slides throughout.
        "surface_speed_scale": 3.5
        * impact.coefficient_of_friction
        * (1 + impact.restitution())
        * impact.before.normal,
        "force_max": collision.force_max,
        "force_max_theory": float(theory.hertz_force(*hertz[1:3], overlap_max))
        if elastic
        else None,
        "overlap_max": collision.overlap_max,
        "overlap_max_theory": overlap_max,
        "contact_time": collision.contact_time,
        "contact_time_theory": float(theory.hertz_duration(*hertz)) if elastic else None,
    }, collision


def run_cases(
    chosen: Iterable[Case],
    output: str | Path,
    law: str = "vu_quoc_zhang",
    steps_per_contact: int = 1000,
    jobs: int | None = None,
    progress: bool = True,
) -> tuple[pd.DataFrame, dict[Case, Collision]]:
    """Run impacts in parallel.

    Args:
        chosen: What to run, such as `cases()`.
        output: One folder a benchmark with the engine's files is made here.
        law, steps_per_contact: As `Case.run`.
        jobs: Engines at a time; all cores by default.
        progress: Show a progress bar.

    Returns:
        The table (one row an impact, in the order given; columns of `row`) and the collisions.

    Raises:
        EngineError, CollisionError: From the first impact that failed.
    """
    chosen = list(chosen)

    def one(number: int) -> tuple[dict[str, object], Collision]:
        case = chosen[number]
        place = Path(output) / case.deck / f"{number:03d}_{case.material}"
        return row(case, case.run(place, law, steps_per_contact))

    pool = ThreadPoolExecutor(jobs or os.cpu_count())
    try:
        waiting = pool.map(one, range(len(chosen)))
        done = list(
            tqdm(waiting, total=len(chosen), unit="impact", disable=None if progress else True)
        )
    finally:  # an interrupt starts no further engine
        pool.shutdown(wait=True, cancel_futures=True)
    table = pd.DataFrame([line for line, _ in done])
    return table, {case: collision for case, (_, collision) in zip(chosen, done, strict=True)}


def agreement(table: pd.DataFrame) -> pd.DataFrame:
    """Largest deviations from theory by benchmark.

    Args:
        table: As `run_cases` returns it.

    Returns:
        One row a benchmark: `impacts`; relative deviations of `coefficient_of_restitution` and,
        where nothing is damped, `force_max`, `overlap_max`, `contact_time`; deviations of the
        surface speed from the `spring_slider` and, where bodies slide throughout, from `rigid`
        bodies, over what sliding throughout changes it by.
    """

    def worst(part: pd.DataFrame, name: str) -> float:
        return (part[name] / part[f"{name}_theory"] - 1).abs().max()

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
            "spring_slider": surface(part, "theory"),
            "rigid": surface(part[part["slides"]], "rigid"),
        }
    return pd.DataFrame.from_dict(lines, orient="index").rename_axis("benchmark")
