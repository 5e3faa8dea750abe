# SPDX-License-Identifier: GPL-2.0-or-later
"""Collisions over laws, speeds and materials: run in the engine, held against theory."""

from __future__ import annotations

import os
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass
from itertools import product
from math import nan, pi, sqrt
from pathlib import Path
from typing import Any, ClassVar, Protocol

import pandas as pd
from tqdm import tqdm

from plastigran import laws
from plastigran.engine.process import run_deck
from plastigran.experiments.collision import Collision, measure
from plastigran.materials import RIGID, Material, read_material
from plastigran.physics import central

#: Decks and whether the other body is an equal sphere (else a rigid wall).
GEOMETRIES = {"sphere_wall": False, "sphere_mesh": False, "two_spheres": True}


#: Speeds that take the paper's sphere (aluminium_zv02, 0.1 m) to 120 yield speeds [m/s].
PAPER_SPEEDS = (0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.06, 0.1, 0.2)

#: Largest overlap a sphere's run is allowed, over the effective radius.
OVERLAP_LIMIT = 0.3


def laws_for(shape: str) -> list[str]:
    """Names of the laws for bodies of a shape, "sphere" or "cylinder"."""
    return sorted(name for name, law in laws.LAWS.items() if law.shape == shape)


@dataclass(frozen=True)
class Impact:
    """One central impact of spheres to run.

    Attributes:
        law: Name of the law.
        speed: Speed of each sphere [m/s].
        material: Of the spheres.
        radius: Of the spheres [m].
        geometry: Deck of `inputs/collision`, one of `GEOMETRIES`.
    """

    law: str
    speed: float
    material: Material
    radius: float
    geometry: str = "sphere_wall"

    shape: ClassVar[str] = "sphere"
    geometries: ClassVar[dict[str, bool]] = GEOMETRIES
    positive: ClassVar[tuple[str, ...]] = ("speed", "radius")
    overlap_limit: ClassVar[float] = OVERLAP_LIMIT

    def __post_init__(self) -> None:
        if self.law not in laws.LAWS:
            raise ValueError(f"no law {self.law!r}; there are {', '.join(sorted(laws.LAWS))}")
        if (meant := laws.LAWS[self.law].shape) != self.shape:
            raise ValueError(
                f"{self.law} is a law for {meant}s, this is an impact of {self.shape}s; "
                f"laws for them are {', '.join(laws_for(self.shape))}"
            )
        if self.geometry not in self.geometries:
            raise ValueError(
                f"no geometry {self.geometry!r}; there are {', '.join(self.geometries)}"
            )
        for name in self.positive:
            if not 0 < getattr(self, name) < float("inf"):
                raise ValueError(f"{name} is {getattr(self, name)}; it must be positive and finite")
        reach = self.predicted().overlap_max / self.radius_eff
        if reach > self.overlap_limit:
            raise ValueError(
                f"{self.law} at {self.speed:g} m/s would overlap by {reach:.2g} effective radii; "
                f"no contact law is good beyond {self.overlap_limit:g}"
            )

    @property
    def bodies(self) -> int:
        """Bodies that take part; their effective radius and mass are one body's over this."""
        return 2 if self.geometries[self.geometry] else 1

    @property
    def pair(self) -> laws.MaterialPair:
        body = self.material.body()
        return laws.combine(body, body if self.bodies == 2 else RIGID)

    @property
    def radius_eff(self) -> float:
        return self.radius / self.bodies

    @property
    def mass_eff(self) -> float:
        return 4 / 3 * pi * self.radius**3 * self.material.density / self.bodies

    @property
    def closing_speed(self) -> float:
        return self.speed * self.bodies

    def contact_law(self):
        """The law between the two bodies, an instance of `laws.LAWS[law]`."""
        return self.material.law(self.law, self.pair)

    def predicted(self) -> laws.Impact:
        """The impact as the law alone has it, without the engine."""
        return self.contact_law().central_impact(self.radius_eff, self.mass_eff, self.closing_speed)

    def time_step(self) -> float:
        """Recommended time step [s]."""
        return self.contact_law().recommended_time_step(
            self.radius_eff, self.mass_eff, self.closing_speed
        )

    def yield_speed(self) -> float:
        """Speed of each sphere at which the impact just reaches yield [m/s]."""
        return central.yield_speed(self.pair, self.radius_eff, self.mass_eff) / self.bodies

    def variables(self) -> dict[str, object]:
        """The impact as the deck's variables of the same names."""
        return {
            "law": self.law,
            "speed": self.speed,
            "radius": self.radius,
            **self.material.variables(),  # whatever file it came from
        }

    def run(
        self, folder: str | Path, time_step: float | None = None, gap: float = 0.0, ranks: int = 1
    ) -> Collision:
        """Run the deck in the engine and measure the collision.

        Args:
            folder: Where the engine writes.
            time_step: [s]; the recommended one by default.
            gap: Distance between the surfaces at the start [m].
            ranks: MPI ranks.

        Raises:
            EngineError: The engine stopped with an error.
            CollisionError: The trajectory holds no whole collision.
        """
        variables = {
            **self.variables(),
            "timestep": self.time_step() if time_step is None else time_step,
            "gap": gap,
        }
        run_deck(f"collision/{self.geometry}.in", variables, folder, ranks=ranks)
        return measure(Path(folder) / "trajectory.dump")

    @property
    def label(self) -> str:
        """What tells its folder from others."""
        return f"{self.geometry}_{self.material.name}_{self.law}"

    def row(self, collision: Collision) -> dict[str, object]:
        """One line of the results table; `*_predicted` is the law's own."""
        predicted, yields = self.predicted(), laws.LAWS[self.law].yields
        return {
            "geometry": self.geometry,
            "material": self.material.name,
            "law": self.law,
            "radius": self.radius,
            "speed": self.speed,
            "speed_ratio": self.speed / self.yield_speed() if yields else nan,
            "coefficient_of_restitution": collision.coefficient_of_restitution,
            "coefficient_of_restitution_predicted": predicted.coefficient_of_restitution,
            "in_range": predicted.in_range,
            "force_max": collision.force_max,
            "overlap_max": collision.overlap_max,
            "overlap_res": collision.overlap_res,
            "loading_time": collision.loading_time,
            "contact_time": collision.contact_time,
            "time_step": self.time_step(),
            "steps": round(collision.contact_time / self.time_step()),
        }


class Case(Protocol):
    """What `sweep` runs: `Impact` is one. Hashable."""

    label: str

    def run(self, folder: Path) -> Any:
        """Run the engine in a folder and measure."""

    def row(self, measured: Any) -> dict[str, object]:
        """One line of the results table."""


@dataclass(frozen=True)
class CylinderImpact(Impact):
    """One central impact of a cylinder, a disc in a 2D deck.

    Attributes:
        law, speed, radius, geometry: As in `Impact`.
        material: Of the body that yields; the other is rigid.
        mass: Of all that moves with the cylinder [kg].
        length_ratio: Length of the cylinder over its radius [-].
        body_thickness: Of the body that yields [m].
    """

    geometry: str = "cylinder_wall"
    mass: float = 1.59e-6
    length_ratio: float = 10.0
    body_thickness: float = 1e-4

    shape: ClassVar[str] = "cylinder"
    geometries: ClassVar[dict[str, bool]] = {"cylinder_wall": False}
    positive: ClassVar[tuple[str, ...]] = (
        "speed",
        "radius",
        "mass",
        "length_ratio",
        "body_thickness",
    )
    # Beyond, the disc's centre passes the wall. The source goes as far; `in_range` is stricter.
    overlap_limit: ClassVar[float] = 1.0

    @property
    def mass_eff(self) -> float:
        return self.mass / self.bodies

    @property
    def cylinder_length(self) -> float:
        return self.length_ratio * self.radius

    def contact_law(self, **options: str):
        """The law between the two bodies; `options` are the law's own."""
        return self.material.law(
            self.law,
            self.pair,
            cylinder_length=self.cylinder_length,
            body_thickness=self.body_thickness,
            **options,
        )

    def variables(self) -> dict[str, object]:
        lengths = ("mass", "cylinder_length", "body_thickness")
        return {**super().variables(), **{name: getattr(self, name) for name in lengths}}

    def yield_speed(self) -> float:
        """Speed of each cylinder at which the mean pressure just reaches 1.5 sigma_Y [m/s]."""
        *_, work = central.line_yield(
            self.pair, self.radius_eff, self.cylinder_length, self.body_thickness
        )
        return sqrt(2 * work / self.mass_eff) / self.bodies


#: The class of impact for each shape of bodies.
IMPACTS = {kind.shape: kind for kind in (Impact, CylinderImpact)}


def plan(
    law_names: Iterable[str],
    speeds: Iterable[float],
    materials: Iterable[str],
    radius: float,
    geometry: str = "sphere_wall",
) -> list[Impact]:
    """Every combination of laws, speeds [m/s] and materials (names or paths), each once.

    Raises:
        ValueError: One of them cannot be run; the message says why.
    """
    bodies = [read_material(material) for material in materials]
    combinations = product(bodies, law_names, (float(speed) for speed in speeds))
    return list(
        dict.fromkeys(
            Impact(law, speed, material, radius, geometry) for material, law, speed in combinations
        )
    )


def sweep(
    impacts: list[Case], folder: str | Path, jobs: int | None = None, progress: bool = True
) -> tuple[pd.DataFrame, dict[Case, Any]]:
    """Run impacts in parallel.

    Every finished one is appended to `impacts.csv` at once, so a run cut short keeps what it has.

    Args:
        impacts: What to run.
        folder: Results go to `impacts.csv` here and to one folder an impact under `runs/`.
        jobs: Engines at a time; all cores by default.
        progress: Show a progress bar.

    Returns:
        The table (one row an impact, in the order given; columns of its `row`) and what was
        measured.

    Raises:
        EngineError, CollisionError: From the first impact that failed; the others' rows are
            written before it is raised.
    """
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    table_path = folder / "impacts.csv"
    table_path.unlink(missing_ok=True)

    def run(number: int, impact: Case) -> Any:
        return impact.run(folder / "runs" / f"{number:04d}_{impact.label}")

    measured: dict[Case, Any] = {}
    failure: Exception | None = None
    pool = ThreadPoolExecutor(jobs or os.cpu_count())
    waiting = {pool.submit(run, k, impact): impact for k, impact in enumerate(impacts)}
    bar = tqdm(total=len(impacts), unit="impact", disable=None if progress else True)
    try:
        for done in as_completed(waiting):
            impact = waiting[done]
            bar.update()
            try:
                measured[impact] = done.result()
            except Exception as error:
                failure = failure or error
                continue
            line = pd.DataFrame([impact.row(measured[impact])])
            line.to_csv(table_path, mode="a", header=not table_path.exists(), index=False)
    finally:  # an interrupt starts no further engine
        pool.shutdown(wait=True, cancel_futures=True)
        bar.close()
    if failure:
        raise failure
    table = pd.DataFrame([impact.row(measured[impact]) for impact in impacts])
    table.to_csv(table_path, index=False)
    return table, {impact: measured[impact] for impact in impacts}
