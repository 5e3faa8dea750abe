# SPDX-License-Identifier: GPL-2.0-or-later
"""Oblique impact of the rod of Ghaednia, Cermik & Marghitu (2015), compared with theory."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import attrs

from plastigran import laws
from plastigran.declared import declarations, number, speed_field, word
from plastigran.experiments.base import Experiment
from plastigran.experiments.fields import SPHERE_OVERLAP, Flag, check_overlap, law_field, several
from plastigran.experiments.rod.measurement import measure_rod
from plastigran.experiments.rod.paper import PAPER_FRICTION, PAPER_SPEEDS
from plastigran.experiments.runs import Runs
from plastigran.experiments.tables import HEADS
from plastigran.materials import Material, material_field
from plastigran.physics.rod import Rod, RodOutcome
from plastigran.physics.rod_motion import simulate
from plastigran.physics.rod_steps import simulate_in_steps

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_ROD = declarations(Rod)
_FRICTION = attrs.evolve(
    _ROD["coefficient_of_friction"],
    meaning=(
        "coefficient of friction between tip and flat, default the paper's value for the angle"
    ),
)


@attrs.frozen
class RodImpact(Experiment):
    """One impact of a rod that falls vertically.

    `tangential` selects the friction model of LIGGGHTS. mu F is the friction limit, with the
    coefficient of friction mu and the normal force F. With `history`, a spring holds the tip until
    the force of the spring reaches mu F. With `no_history`, friction is mu F as soon as the tip
    slides, as in the paper. `incremental` and `partial_slip` are the tangential laws of this
    project.

    Raises:
        ValueError: A field is out of range, LIGGGHTS does not support the combination, or the
            overlap of the tip would be too large for any law.
    """

    law: str = law_field()
    speed: float = speed_field("impact speed, downward")
    rod: Rod = attrs.field(factory=Rod)
    tangential: str = word(
        "friction model of the tip",
        ("history", "no_history", "off", *laws.TANGENTIAL_LAWS),
        default="history",
    )
    material: Material = material_field("material of the rod", "steel_gcm15")
    flat: Material = material_field("material of the flat", "iron_gcm15")
    # The default is `pair`: all laws in the paper use the effective modulus and radius of the pair.
    reading: str = word(
        "whether laws fitted to one sphere use modulus and radius of the pair or the yielding body",
        ("pair", "yielding_body"),
        default="pair",
    )
    # The default follows from the Brinell hardnesses H in the paper, 327 for the rod and 105 for
    # the flat: (2/H_rod + 2/H_flat)^-1.
    indentation_pressure: float = number(
        "indentation pressure, for the laws that use it", "Pa", 0, default=3.8971e8
    )

    command = "rod"
    help = (
        "run the oblique impacts of a rod of Ghaednia, Cermik & Marghitu (2015), with a table and "
        "figures"
    )
    example = "plastigran rod --law thornton jackson_green"
    deck = "collision/rod.in"
    flags: ClassVar = {
        "angle": Flag(tuple(PAPER_FRICTION), declaration=_ROD["angle"]),
        "coefficient_of_friction": Flag(None, declaration=_FRICTION, many=False),
        "law": Flag(("all",)),
        "reading": Flag("pair", many=False),
        "speed": Flag(PAPER_SPEEDS),
        "tangential": Flag("history", many=False),
    }
    quantities = tuple(name for name in attrs.fields_dict(RodOutcome) if name != "history")
    shown = tuple(HEADS)

    def __attrs_post_init__(self) -> None:
        if self.law == "hertz" and self.tangential == "no_history":
            raise ValueError(
                "law is hertz and tangential is no_history: this combination has no friction in "
                "LIGGGHTS without damping. Use another law or another tangential model"
            )
        overlap, radius = self.frozen().overlap_max, self.rod.tip_radius
        check_overlap(self, overlap, radius, SPHERE_OVERLAP, "tip radii")

    @property
    def pair(self) -> laws.MaterialPair:
        """Combined constants of rod and flat."""
        return laws.combine(self.material.body(), self.flat.body())

    def contact_law(self, **options: str | float):
        """Return the law between rod and flat; `options` replace `RodImpact.options`."""
        if any(row["name"] == "indentation_pressure" for row in laws.LAWS[self.law].parameters()):
            options = {"indentation_pressure": self.indentation_pressure, **options}
        return self.material.law(self.law, self.pair, **self.options | options)

    @property
    def options(self) -> dict[str, str]:
        """Options of the law, by name: `reading`, if the law has this option."""
        names = {option["name"] for option in laws.LAWS[self.law].options()}
        return {"reading": self.reading} if "reading" in names else {}

    def frozen(self) -> laws.ImpactOutcome:
        """Return the outcome of a central impact of a sphere that represents the tip.

        The sphere has the radius of the tip, and the effective mass `Rod.mass_eff` at first touch.
        """
        rod = self.rod
        return self.contact_law().central_impact(rod.tip_radius, rod.mass_eff, self.speed)

    @property
    def label(self) -> str:
        return f"rod_{self.rod.angle:g}_{self.law}_{self.speed:.3g}"

    @property
    def timestep(self) -> float:
        """Time step [s]: half of the recommended time step of the sphere at the tip.

        In the deck, this sphere has a sixth of the mass of the rod. The time step check in
        LIGGGHTS uses only the mass of this sphere.
        """
        rod = self.rod
        return 0.5 * self.contact_law().recommended_timestep(
            rod.tip_radius, rod.tip_mass, self.speed
        )

    def variables(self) -> dict[str, object]:
        names = ("law", "speed", "tangential", "indentation_pressure")
        variables: dict[str, object] = {name: getattr(self, name) for name in names}
        if self.options:
            pairs = (" ".join(option) for option in self.options.items())
            variables["options"] = " ".join(pairs)
        flat = {f"flat_{name}": value for name, value in self.flat.variables().items()}
        del flat["flat_density"]  # the deck has no density of the flat, because it does not move
        return variables | attrs.asdict(self.rod) | self.material.variables() | flat

    def predict(self) -> RodOutcome:
        """Return the outcome predicted by the equations of motion with the same friction model."""
        rod = self.rod
        if self.tangential in laws.TANGENTIAL_LAWS:
            tangential = laws.TANGENTIAL_LAWS[self.tangential](rod.coefficient_of_friction)
            return simulate_in_steps(rod, self.contact_law(), self.speed, tangential)
        if self.tangential == "off":
            rod = attrs.evolve(rod, coefficient_of_friction=0.0)
        has_spring = self.tangential not in ("no_history", "off")
        spring = self.pair.shear_modulus_eff if has_spring else None
        return simulate(rod, self.contact_law(), self.speed, spring)

    def measure(self, folder: Path) -> RodOutcome:
        return measure_rod(Path(folder) / "trajectory.dump", self.rod.gravitational_acceleration)

    def facts(self) -> dict[str, object]:
        return {
            "law": self.law,
            "reading": self.options.get("reading", ""),
            "angle": self.rod.angle,
            "coefficient_of_friction": self.rod.coefficient_of_friction,
            "speed": self.speed,
        }

    def notes(self, measured: RodOutcome, predicted: RodOutcome) -> dict[str, object]:
        return {"in_range": self.frozen().in_range, "timestep": self.timestep}

    @classmethod
    def cases(
        cls,
        angle: float | Iterable[float],
        coefficient_of_friction: float | None = None,
        **settings: Any,
    ) -> list[RodImpact]:
        """Return impacts of the paper's rod at some angles [degrees].

        The default coefficient of friction is the paper's value for the angle.

        Raises:
            ValueError: The paper gives no friction for an angle.
        """
        angle = several(angle)
        if coefficient_of_friction is None and not set(angle) <= PAPER_FRICTION.keys():
            angles = " and ".join(f"{paper_angle:g}" for paper_angle in PAPER_FRICTION)
            raise ValueError(
                f"the paper gives friction only at {angles} degrees. Give coefficient_of_friction"
            )
        frictions = PAPER_FRICTION
        if coefficient_of_friction is not None:
            frictions = dict.fromkeys(angle, coefficient_of_friction)
        return cls.plan(rod=[Rod(value, frictions[value]) for value in angle], **settings)

    @classmethod
    def figures(cls, runs: Runs) -> dict[str, Callable[[], Figure]]:
        # Imported here, because matplotlib is slow to load.
        from plastigran.experiments.rod import figures

        def motion() -> Figure:
            closest = figures.closest_to_measured(runs.outcomes)
            return figures.motion_figure(closest, runs.outcomes[closest])

        return {
            "outcome": lambda: figures.outcome_figure(runs.table),
            "deformation": lambda: figures.deformation_figure(runs.table),
            "motion": motion,
        }
