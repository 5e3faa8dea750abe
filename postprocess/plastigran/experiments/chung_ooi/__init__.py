# SPDX-License-Identifier: GPL-2.0-or-later
"""The eight benchmark impacts of Chung & Ooi (2011, Granular Matter 13:643), compared with theory.

Each benchmark has a deck in `inputs/collision/chung_ooi`. The file `points.csv` in the same folder
lists the impacts.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from functools import cached_property, partial
from math import cos, inf, pi, radians, sin
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import attrs
import pandas as pd

from plastigran import laws
from plastigran.declared import Declaration, number, whole, word
from plastigran.engine.deck import index_variables
from plastigran.engine.dumps import read_dump
from plastigran.engine.process import inputs_folder
from plastigran.experiments.base import Experiment
from plastigran.experiments.chung_ooi.comparison import (
    BenchmarkOutcome,
    agreement,
    compare,
    motion,
    predict,
)
from plastigran.experiments.collision import measure
from plastigran.experiments.fields import Flag, law_field
from plastigran.experiments.runs import Runs
from plastigran.materials import RIGID, Material, read_material
from plastigran.physics.oblique import Motion, ObliqueImpact

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Titles of the benchmarks, by number.
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

DEFAULT_LAW, DEFAULT_STEPS = "vu_quoc_zhang", 1000

#: Friction models: `history` of LIGGGHTS, and the tangential laws of this project.
TANGENTIAL_MODELS = ("history", *laws.TANGENTIAL_LAWS)
#: Options of the normal model `hertz` of LIGGGHTS: normal damping only, no attractive force.
HERTZ_OPTIONS = "limitForce on tangential_damping off"


def folder() -> Path:
    """Return the folder of the benchmark decks.

    Raises:
        EngineError: The folder of input scripts does not exist.
    """
    return inputs_folder() / "collision" / "chung_ooi"


@attrs.frozen
class BenchmarkImpact(Experiment):
    """One impact of a benchmark of Chung & Ooi (2011).

    Attributes:
        deck_name: Name of the deck, without `.in`; it begins with the number of the benchmark.
        material: Material of the sphere: name of a file in the folder `materials` next to the deck.
        knob: Name of the deck variable that differs between the impacts of the benchmark.
        value: Value of this deck variable, in the unit of the deck.
        modulus_ratio: Young's modulus of the second sphere / Young's modulus of the first sphere.
            The default is the value of the deck.
        law: Name of the law; `hertz` is the normal model `hertz` of LIGGGHTS.
        steps_per_contact: Number of time steps during a contact without damping.
        tangential: Name of the friction model, one of TANGENTIAL_MODELS.
    """

    deck_name: str
    material: str
    knob: str
    value: float
    modulus_ratio: float | None = number(
        "Young's modulus of the second sphere / Young's modulus of the first sphere",
        "-",
        0,
        default=None,
    )
    law: str = law_field(DEFAULT_LAW)
    steps_per_contact: int = whole(
        "number of time steps during a contact without damping", 1, default=DEFAULT_STEPS
    )
    tangential: str = word("friction model", TANGENTIAL_MODELS, default="history")

    command = "chung-ooi"
    help = "run the eight benchmark impacts of Chung & Ooi (2011) and compare them with theory"
    example = "plastigran chung-ooi --benchmark 2 7"
    flags: ClassVar = {
        "benchmark": Flag(
            tuple(TITLES),
            declaration=Declaration(
                "numbers of the impacts to run", "-", 1, 8, True, True, value_type=int
            ),
        ),
        "law": Flag(DEFAULT_LAW, many=False),
        "steps_per_contact": Flag(DEFAULT_STEPS, "steps", many=False),
        "tangential": Flag("history", many=False),
    }

    @property
    def benchmark(self) -> int:
        """Number of the benchmark, 1 to 8."""
        return int(self.deck_name.split("_")[0])

    @property
    def deck(self) -> str:
        """Path of the input script, relative to `inputs`."""
        return f"collision/chung_ooi/{self.deck_name}.in"

    def variables(self) -> dict[str, object]:
        """Return the variables whose values differ from the defaults of the deck."""
        changed = {
            "material": self.material,
            self.knob: self.value,
            "law": self.law,
            "steps_per_contact": self.steps_per_contact,
            "tangential": self.tangential,
        }
        if self.law == "hertz":
            changed["options"] = HERTZ_OPTIONS
        if self.modulus_ratio is not None:
            changed["modulus_ratio"] = self.modulus_ratio
        return changed

    @cached_property
    def settings(self) -> dict[str, str]:
        """Variables of the deck as text, with the values of this case.

        Raises:
            ValueError: The deck lacks a variable of the case.
        """
        defaults = index_variables(folder() / f"{self.deck_name}.in")
        changes = {name: str(value) for name, value in self.variables().items()}
        if unknown := changes.keys() - defaults.keys():
            raise ValueError(f"{self.deck_name}.in has no variable {', '.join(sorted(unknown))}")
        return defaults | changes

    def deck_number(self, name: str, default: float | None = None) -> float:
        """Return a variable of the deck as a number.

        If the value is ${NAME}, the result is the value of the variable NAME.

        Args:
            name: Name of the variable.
            default: Result for a deck without this variable; None to require the variable.

        Raises:
            ValueError: The deck lacks a required variable.
        """
        if name not in self.settings and default is not None:
            return default
        if name not in self.settings:
            raise ValueError(f"{self.deck_name}.in has no variable {name}")
        text = self.settings[name]
        return self.deck_number(text[2:-1]) if text.startswith("${") else float(text)

    @cached_property
    def sphere(self) -> Material:
        """Material of the sphere, read from the file next to the decks."""
        return read_material(folder() / "materials" / f"{self.material}.in")

    def before(self) -> Motion:
        """Return the motion of the bodies before the impact."""
        if "incident_angle" in self.settings:
            angle, speed = radians(self.deck_number("incident_angle")), self.deck_number("speed")
            normal, along = speed * cos(angle), speed * sin(angle)
        else:
            normal = self.deck_number("speed_normal") + self.deck_number("speed_normal_other", 0.0)
            along = self.deck_number("speed_tangential", 0.0)
        return Motion(
            normal, along, self.deck_number("spin"), spin_other=self.deck_number("spin_other", 0.0)
        )

    def impact(self) -> ObliqueImpact:
        """Return the bodies and their motion before the impact, as input of the theory."""
        body, radius = self.sphere.body(), self.deck_number("radius")
        mass = 4 / 3 * pi * radius**3 * self.sphere.density
        other, radius_other, mass_other = RIGID, inf, inf
        if "radius_ratio" in self.settings:
            modulus = body.youngs_modulus * self.deck_number("modulus_ratio")
            other = laws.Body(modulus, body.poissons_ratio)
            radius_other = radius * self.deck_number("radius_ratio")
            mass_other = (
                mass * self.deck_number("density_ratio") * self.deck_number("radius_ratio") ** 3
            )
        return ObliqueImpact(
            pair=laws.combine(body, other),
            radius=radius,
            mass=mass,
            coefficient_of_friction=self.deck_number("coefficient_of_friction"),
            coefficient_of_restitution=self.deck_number("coefficient_of_restitution"),
            before=self.before(),
            radius_other=radius_other,
            mass_other=mass_other,
        )

    @property
    def label(self) -> str:
        return f"{self.deck_name}_{self.material}"

    def predict(self) -> BenchmarkOutcome:
        return predict(self.impact())

    def measure(self, folder: Path) -> BenchmarkOutcome:
        trajectory = read_dump(Path(folder) / "trajectory.dump")
        return BenchmarkOutcome(motion(trajectory, -1), measure(trajectory))

    def facts(self) -> dict[str, object]:
        names = ("benchmark", "law", "tangential", "material", "modulus_ratio", "knob", "value")
        return {name: getattr(self, name) for name in names}

    def notes(self, measured: BenchmarkOutcome, predicted: BenchmarkOutcome) -> dict[str, object]:
        return compare(self.impact(), measured, predicted)

    @classmethod
    def cases(
        cls, benchmark: Collection[int] = tuple(TITLES), **settings: Any
    ) -> list[BenchmarkImpact]:
        """Return every impact of the benchmarks with the given numbers, ordered as `points.csv`."""
        table = pd.read_csv(folder() / "points.csv", comment="#", dtype={"values": str})
        cases = [
            cls(
                deck_name=sweep["deck"],
                material=sweep["material"],
                knob=sweep["knob"],
                value=float(value),
                modulus_ratio=None if pd.isna(sweep["modulus_ratio"]) else sweep["modulus_ratio"],
                **settings,
            )
            for sweep in table.to_dict("records")
            for value in sweep["values"].split()
        ]
        return [case for case in cases if case.benchmark in benchmark]

    @classmethod
    def tables(cls, runs: Runs) -> dict[str, pd.DataFrame]:
        """Return a table of the largest deviations from theory, and the results per benchmark."""
        parts = {
            f"benchmark_{number}": part.dropna(axis="columns", how="all")
            for number, part in runs.table.groupby("benchmark")
        }
        return {"agreement": agreement(runs.table)} | parts

    @classmethod
    def figures(cls, runs: Runs) -> dict[str, Callable[[], Figure]]:
        # Imported here, because matplotlib is slow to load.
        from plastigran.experiments.chung_ooi import figures

        return {
            f"benchmark_{number}": partial(figures.figure, number, runs.outcomes)
            for number in sorted(runs.table["benchmark"].unique())
        }

    @classmethod
    def summary(cls, runs: Runs) -> str:
        table = runs.tables["agreement"].to_string(float_format="{:.1e}".format, na_rep="")
        return f"Largest deviations from theory:\n\n{table}"
