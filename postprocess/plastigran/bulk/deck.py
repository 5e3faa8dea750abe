# SPDX-License-Identifier: GPL-2.0-or-later
"""What a bulk deck is: settings, declared once, and what to check and draw of its runs."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import ClassVar, Self

import attrs
import pandas as pd
from matplotlib.figure import Figure

from plastigran import laws
from plastigran.bulk.checks import Check, ledger_checks
from plastigran.bulk.folder import read_derived
from plastigran.bulk.grains import Grains
from plastigran.bulk.ledger_chart import ledger_figure
from plastigran.bulk.settings import continuable, text
from plastigran.declared import declaration, number, radius_field, require, whole, word
from plastigran.materials import Material
from plastigran.usable_laws import laws_for


@attrs.frozen
class Analysis:
    """What a deck makes of a run.

    Attributes:
        series: One row a line of the log, with what is measured and predicted beside it.
        checks: The deck's invariants.
        figures: By name.
        notes: Sentences on what could not be measured.
    """

    series: pd.DataFrame
    checks: list[Check] = attrs.field(factory=list)
    figures: dict[str, Figure] = attrs.field(factory=dict)
    notes: list[str] = attrs.field(factory=list)

    @property
    def failed(self) -> list[Check]:
        """The checks that have not passed."""
        return [check for check in self.checks if not check.passed]


@attrs.frozen
class Brief:
    """A short run of a deck, by which the conformance suite takes it.

    Attributes:
        settings: That make the run short.
        start: Beside them, settings that end it so soon after its first impacts that runs on
            several ranks agree to 1e-9.
        restart: Difference that a run gone on from a checkpoint may have, over the largest value of
            its column [-]: 0 where it goes on to every digit.
    """

    settings: Mapping[str, object]
    start: Mapping[str, object]
    restart: float = 1e-10


@attrs.frozen(kw_only=True)
class BulkDeck:
    """Settings of every bulk deck, made from text or numbers; a deck's class adds its own.

    Attributes:
        output: Folder of the run, for what a deck reads beside the log.

    Raises:
        ValueError: A setting is out of range; the message names it, its value and what is allowed.
    """

    #: Short runs of the deck, by a label that tells them apart.
    briefs: ClassVar[Mapping[str, Brief]] = {}

    output: Path = attrs.field(converter=Path)
    law: str = word("between two grains", laws_for("sphere"))
    options: str = text("of the model, pairs NAME CHOICE")
    material: str = text("a file of inputs/materials")
    youngs_modulus: float = number("of the grains", "Pa", 0)
    poissons_ratio: float = number("of the grains", "-", -1, 0.5, closed=True)
    density: float = number("of a grain", "kg/m^3", 0)
    yield_strength: float = number("of the grains", "Pa", 0)
    yield_pressure_factor: float = number("contact yield pressure over yield strength; 0: Hertz's")
    tangent_modulus: float = number("of stress over strain beyond yield", "Pa", 0, closed=True)
    rate_coefficient: float = number("of the yield strength", "-", 0, 1, closed=True)
    reference_rate: float = number("of strain, at which the yield strength holds", "1/s", 0)
    dissipative_constant: float = number("viscous over elastic constants", "s", 0, closed=True)
    radius: float = radius_field("of a grain, in the mean")
    timestep: float = number("of the engine", "s", 0)
    seed: float = number("another gives other grains")
    frames: int = continuable(whole("VTK files on the way"))
    contact_history: int = continuable(
        whole("1: frames tell what contacts remember, 0: not", upper=1)
    )
    rows: int = whole("lines of the log", 1)
    checkpoints: int = whole("restart files on the way, a divisor of rows", 1)
    ledger: str = word("the energy ledger", ("on", "off"))

    def __init_subclass__(cls) -> None:
        """Refuse a setting of a name that the class needs itself, such as `grains`."""
        for name in cls.__annotations__:
            hidden = getattr(super(cls, cls), name, None)
            if isinstance(hidden, property) or callable(hidden):
                raise TypeError(
                    f"{cls.__name__}: a setting cannot be called {name}; decks have one"
                )

    def __attrs_post_init__(self) -> None:
        self.check()

    def check(self) -> None:
        """Check what must hold between settings; a deck that adds to it calls this one too.

        A checkpoint is made at steps that have a line of the log: `checkpoints` divides `rows`.

        Raises:
            ValueError: It does not hold; the message names the setting.
        """
        if self.rows % self.checkpoints:
            raise ValueError(f"checkpoints is {self.checkpoints}; it must divide rows, {self.rows}")
        if self.law == "hertz" and self.ledger == "on":
            raise ValueError("ledger is on; the engine's own hertz keeps none: set ledger=off")
        if self.contact_history and not laws.LAWS[self.law].yields:
            raise ValueError(f"contact_history is {self.contact_history}; {self.law} has none")
        self.grains.contact_law()  # raises for constants it cannot take

    def check_inputs(self) -> None:
        """Before a run: what the deck reads is there. Raises ValueError for what is not."""

    def analyse(self, series: pd.DataFrame) -> Analysis:
        """What to make of a run.

        Args:
            series: The log from step 0, whatever checkpoints the run went on from: `step`, `time`
                [s], and the deck's columns.

        Raises:
            ValueError: There is nothing to measure in it.
        """
        raise NotImplementedError

    @classmethod
    def read(cls, settings: Mapping[str, object]) -> Self:
        """The deck with the settings of a run, as text or numbers; others are left out.

        Raises:
            ValueError: One is missing or out of range.
        """
        names = [field.name for field in attrs.fields(cls)]
        if missing := [name for name in names if name not in settings]:
            raise ValueError(f"{cls.__name__} declares {missing[0]}; the deck has no such setting")
        return cls(**{name: settings[name] for name in names})

    @classmethod
    def continuable_settings(cls) -> frozenset[str]:
        """Names of the settings that a run that goes on may change."""
        return frozenset(f.name for f in attrs.fields(cls) if "continuable" in f.metadata)

    @property
    def model_options(self) -> dict[str, str]:
        """The setting `options` by name. Raises ValueError when they are not pairs."""
        words = self.options.split()
        if len(words) % 2:
            raise ValueError(f"options is {self.options!r}; it must be pairs, NAME CHOICE")
        return dict(zip(words[::2], words[1::2], strict=True))

    @property
    def grains(self) -> Grains:
        """The grains, with those of the options that are the law's."""
        material = Material(
            self.material,
            youngs_modulus=self.youngs_modulus,
            poissons_ratio=self.poissons_ratio,
            density=self.density,
            yield_strength=self.yield_strength,
            yield_pressure_factor=self.yield_pressure_factor,
            tangent_modulus=self.tangent_modulus,
            rate_coefficient=self.rate_coefficient,
            reference_rate=self.reference_rate,
            dissipative_constant=self.dissipative_constant or None,
        )
        known = {option["name"] for option in laws.LAWS[self.law].options()}
        options = {name: choice for name, choice in self.model_options.items() if name in known}
        return Grains(self.law, options, material, self.radius)

    def derived(self, name: str) -> float:
        """A number the deck derives from its settings and prints, `print "derived NAME = VALUE"`.

        Raises:
            ValueError: The run in `output` has printed none of that name.
        """
        return read_derived(self.output, name)

    def ledger_checks(self, series: pd.DataFrame) -> list[Check]:
        """Checks of the energy ledger; none of a run without one."""
        return ledger_checks(series) if self.ledger == "on" else []

    def ledger_figure(self, series: pd.DataFrame) -> dict[str, Figure]:
        """Figure of the energy ledger by its name; none of a run without one."""
        if self.ledger == "off":
            return {}
        return {"ledger": ledger_figure(series)}


@attrs.frozen(kw_only=True)
class GranularDeck(BulkDeck):
    """Settings of decks whose grains rub and have weight: inputs/bulk/parts/friction.in."""

    tangential: str = word("friction of sliding", ("off", "no_history", "history"))
    coefficient_of_friction: float = number("of sliding", "-", 0, closed=True)
    rolling_friction: str = word("friction of rolling", ("off", "cdt", "epsd2"))
    coefficient_of_rolling_friction: float = number("of rolling", "-", 0, closed=True)
    coefficient_of_restitution: float = number(
        "of the dashpot of viscous_damping, and of the engine's own hertz", "-", 0.05, 1, True
    )
    gravitational_acceleration: float = number("downwards", "m/s^2", 0)


@attrs.frozen(kw_only=True)
class FlowDeck(GranularDeck):
    """Settings of decks whose grains, of two sizes, come to flow steadily after `settling`."""

    #: Rows of the log the steady part has at least: a line goes through them.
    steady_rows: ClassVar[int] = 10

    size_spread: float = number("half of the grains are so much smaller", "-", 0, 0.5, True)
    volume_fraction: float = number("of the lattice", "-", 0, 0.64)
    temperature: float = number("of the grains' velocities at the start", "m^2/s^2", 0)
    duration: float = number("of the run", "s", 0)
    settling: float = number("before the flow is measured", "s", 0, closed=True)

    def check(self) -> None:
        """Check that `duration` goes on after `settling` for `steady_rows` or more."""
        require(self, "settling", upper=self.duration)
        require(self, "rows", lower=self.steady_rows)
        latest = self.duration * (1 - self.steady_rows / self.rows)
        if self.settling > latest * (1 + 1e-12):
            unit = declaration(type(self))["settling"].unit
            raise ValueError(
                f"settling is {self.settling:g}; it must be {latest:g} [{unit}] or less, so that "
                f"{self.steady_rows} of {self.rows} rows are left"
            )
        GranularDeck.check(self)
