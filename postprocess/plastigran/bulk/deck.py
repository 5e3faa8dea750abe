# SPDX-License-Identifier: GPL-2.0-or-later
"""Base classes of bulk decks: settings, checks and figures of runs."""

from __future__ import annotations

from collections.abc import Mapping
from math import sqrt
from pathlib import Path
from typing import ClassVar, Self

import attrs
import pandas as pd
from matplotlib.figure import Figure

from plastigran import laws
from plastigran.bulk.checks import LEDGER, Check, energy_input, ledger_checks
from plastigran.bulk.folder import read_derived
from plastigran.bulk.grains import Grains
from plastigran.bulk.ledger_chart import ledger_figure
from plastigran.bulk.settings import continuable, text
from plastigran.declared import declarations, number, radius_field, require, whole, word
from plastigran.materials import BODY_CONSTANTS, Material, body_constant
from plastigran.usable_laws import laws_for

#: Largest allowed balance error as a fraction of the energy input, for the decks of the bulk
#: benchmark (docs/decks/benchmark.md). Reason: the benchmark's tables state energies to 0.1 %.
BENCHMARK_BALANCE = 1e-3


@attrs.frozen
class Analysis:
    """Result of the analysis of a run.

    Attributes:
        series: Table of measured and predicted quantities, with one row per line of the log.
        checks: Results of the checks of the deck.
        figures: Figures by name.
        notes: Sentences that say which quantities could not be measured, and why.
        results: Measured numbers by name, with the unit in the name.
    """

    series: pd.DataFrame
    checks: list[Check] = attrs.field(factory=list)
    figures: dict[str, Figure] = attrs.field(factory=dict)
    notes: list[str] = attrs.field(factory=list)
    results: dict[str, float] = attrs.field(factory=dict)

    @property
    def failed(self) -> list[Check]:
        """Checks that failed."""
        return [check for check in self.checks if not check.passed]


@attrs.frozen
class Brief:
    """Short run of a deck for the tests that every deck must pass (tests/conformance/deck).

    Attributes:
        settings: Settings that make the run short.
        start: Further settings for the test that compares runs on 1 and 4 ranks. They end the
            run soon after the first impacts, because round-off grows with each impact. The test
            allows a difference of 1e-9.
        restart: Largest allowed difference between a continued and an uninterrupted run, divided by
            the largest value of the column [-]. 0 requires bitwise identical results.
    """

    settings: Mapping[str, object]
    start: Mapping[str, object]
    restart: float = 1e-10


@attrs.frozen(kw_only=True)
class BulkDeck:
    """Base class of bulk decks with their common settings, given as text or numbers.

    Attributes:
        output: Folder of the run, from which the analysis reads the log and further files.

    Raises:
        ValueError: A setting is out of range; the message names it, its value and what is allowed.
    """

    #: Short runs of the deck for tests/conformance/deck, by label.
    briefs: ClassVar[Mapping[str, Brief]] = {}
    #: Largest allowed balance error as a fraction of the energy input. If None, `ledger_limit`
    #: computes the limit from the time step.
    balance_limit: ClassVar[float | None] = None

    output: Path = attrs.field(converter=Path)
    law: str = word("law between grains", laws_for("sphere"))
    options: str = text("options of the law, as pairs NAME CHOICE")
    material: str = text("material, a file of inputs/materials")
    youngs_modulus: float = body_constant("youngs_modulus")
    poissons_ratio: float = body_constant("poissons_ratio")
    density: float = number("density of a grain", "kg/m^3", 0)
    yield_strength: float = body_constant("yield_strength")
    yield_pressure_factor: float = body_constant("yield_pressure_factor")
    tangent_modulus: float = body_constant("tangent_modulus")
    rate_coefficient: float = body_constant("rate_coefficient")
    reference_rate: float = body_constant("reference_rate")
    dissipative_constant: float = number(
        "ratio of viscous to elastic constants", "s", 0, lower_allowed=True
    )
    radius: float = radius_field("mean radius of a grain")
    timestep: float = number("time step of LIGGGHTS", "s", 0)
    seed: float = number("seed of the random grains")
    frames: int = continuable(whole("number of VTK frames"))
    contact_history: int = continuable(
        whole("1: write contact histories to the frames; 0: do not", upper=1)
    )
    rows: int = whole("number of log lines", 1)
    checkpoints: int = whole(
        "number of restart files; the setting `rows` must be a multiple of it", 1
    )
    ledger: str = word("energy balance", ("on", "off"))

    def __attrs_post_init__(self) -> None:
        self.check()

    def check(self) -> None:
        """Check conditions that involve several settings. Overriding methods must call this method.

        Raises:
            ValueError: A condition is violated; the message names the setting.
        """
        if self.rows % self.checkpoints:  # the log must have a line at the step of each checkpoint
            raise ValueError(f"checkpoints is {self.checkpoints}; it must divide rows, {self.rows}")
        if self.law == "hertz" and self.ledger == "on":
            raise ValueError(
                "ledger is on, but LIGGGHTS' own hertz has no energy balance. Set ledger=off"
            )
        if self.contact_history and not laws.LAWS[self.law].yields:
            raise ValueError(
                f"contact_history is {self.contact_history}, but {self.law} stores "
                "no contact history. Set contact_history=0"
            )
        self.grains.contact_law()  # raises an error for invalid constants

    def check_inputs(self) -> None:
        """Check before a run that all input files of the deck exist.

        Raises:
            ValueError: A file is missing.
        """

    def write_inputs(self, folder: Path) -> None:
        """Write the files that a new run reads from its folder, such as initial positions."""

    def analyse(self, series: pd.DataFrame) -> Analysis:
        """Analyse a run and return its checks, figures and results.

        Args:
            series: Table of the log from step 0. For a continued run, it includes the log of the
                earlier runs. Its columns are `step`, `time` [s] and those of the deck.

        Raises:
            ValueError: The series lacks the data for a measurement.
        """
        raise NotImplementedError

    @classmethod
    def read(cls, settings: Mapping[str, object]) -> Self:
        """Create the deck from the settings of a run, as text or numbers; ignore unknown settings.

        Raises:
            ValueError: A setting is missing or out of range.
        """
        names = [field.name for field in attrs.fields(cls)]
        if missing := [name for name in names if name not in settings]:
            raise ValueError(
                f"{cls.__name__} declares the field {missing[0]}, but the deck has no setting of "
                "that name. Add it to the deck"
            )
        return cls(**{name: settings[name] for name in names})

    @classmethod
    def continuable_settings(cls) -> frozenset[str]:
        """Return the names of the settings that a continued run may change."""
        return frozenset(f.name for f in attrs.fields(cls) if "continuable" in f.metadata)

    @property
    def model_options(self) -> dict[str, str]:
        """Return the setting `options` as a dictionary.

        Raises:
            ValueError: The setting does not consist of pairs of words.
        """
        words = self.options.split()
        if len(words) % 2:
            raise ValueError(f"options is {self.options!r}; it must be made of pairs NAME CHOICE")
        return dict(zip(words[::2], words[1::2], strict=True))

    @property
    def grains(self) -> Grains:
        """Grains and their contact law, with those `options` that belong to the law."""
        material = Material(
            self.material,
            density=self.density,
            dissipative_constant=self.dissipative_constant or None,
            **{name: getattr(self, name) for name in BODY_CONSTANTS},
        )
        names = {option["name"] for option in laws.LAWS[self.law].options()}
        options = {name: choice for name, choice in self.model_options.items() if name in names}
        return Grains(self.law, options, material, self.radius)

    def derived(self, name: str) -> float:
        """Return the VALUE that the deck printed as `derived NAME = VALUE`; see `read_derived`."""
        return read_derived(self.output, name)

    def ledger_checks(self, series: pd.DataFrame) -> list[Check]:
        """Return the checks of the energy balance; [] for a run without energy balance."""
        return ledger_checks(series, self.ledger_limit(series)) if self.ledger == "on" else []

    def ledger_limit(self, series: pd.DataFrame) -> float:
        """Return the largest allowed balance error as a fraction of the energy input [-].

        The class attribute `balance_limit` sets the limit. If it is None, the limit is `LEDGER`
        (dt/dt_r)^2, because the integrator is of second order, and at most `LEDGER`. dt is the time
        step and dt_r the recommended time step for the impact of two grains. Their impact speed is
        the rms speed that the grains would have if the energy input were kinetic energy.

        Args:
            series: Terms of inputs/energy_ledger.in [J], and the column atoms.
        """
        if self.balance_limit is not None:
            return self.balance_limit
        grains = self.grains
        speed = sqrt(2 * energy_input(series) / (series["atoms"].max() * grains.mass))
        law, radius_eff, mass_eff = grains.contact_law(), grains.radius / 2, grains.mass / 2
        recommended = float(law.recommended_timestep(radius_eff, mass_eff, speed))
        return LEDGER * min(1.0, self.timestep / recommended) ** 2

    def ledger_figure(self, series: pd.DataFrame) -> dict[str, Figure]:
        """Return the figure of the energy balance by name; {} for a run without energy balance."""
        if self.ledger == "off":
            return {}
        return {"ledger": ledger_figure(series, self.ledger_limit(series))}


@attrs.frozen(kw_only=True)
class GranularDeck(BulkDeck):
    """Base class of decks with friction and gravity (inputs/bulk/parts/friction.in)."""

    tangential: str = word(
        "model of sliding friction", ("off", "no_history", "history", *laws.TANGENTIAL_LAWS)
    )
    coefficient_of_friction: float = number(
        "coefficient of sliding friction", "-", 0, lower_allowed=True
    )
    rolling_friction: str = word("model of rolling friction", ("off", "cdt", "epsd2"))
    coefficient_of_rolling_friction: float = number(
        "coefficient of rolling friction", "-", 0, lower_allowed=True
    )
    coefficient_of_restitution: float = number(
        "restitution for the dashpots of viscous_damping and of LIGGGHTS' own hertz",
        "-",
        0.05,
        1,
        lower_allowed=True,
        upper_allowed=True,
    )
    gravitational_acceleration: float = number("downward acceleration", "m/s^2", 0)


@attrs.frozen(kw_only=True)
class FlowDeck(GranularDeck):
    """Base class of decks with grains of two sizes and a flow that is steady after `settling`."""

    #: Smallest number of log lines after `settling`. A straight line is fitted to them.
    steady_rows: ClassVar[int] = 10

    size_spread: float = number(
        "fraction by which half of the grains are smaller than radius, and half are larger",
        "-",
        0,
        0.5,
        True,
        True,
    )
    volume_fraction: float = number("volume fraction of the initial lattice", "-", 0, 0.64)
    temperature: float = number("initial variance of each velocity component", "m^2/s^2", 0)
    duration: float = number("duration of the run", "s", 0)
    settling: float = number("time before the flow is measured", "s", 0, lower_allowed=True)

    def check(self) -> None:
        """Check that at least `steady_rows` log lines follow the time `settling`.

        Raises:
            ValueError: The condition is violated; the message names the setting.
        """
        require(self, "settling", upper=self.duration, upper_allowed=True)
        require(self, "rows", lower=self.steady_rows)
        latest = self.duration * (1 - self.steady_rows / self.rows)
        if self.settling > latest * (1 + 1e-12):
            unit = declarations(type(self))["settling"].unit
            raise ValueError(
                f"settling is {self.settling:g}; it must be at most {latest:g} [{unit}], so "
                f"that at least {self.steady_rows} of the {self.rows} log lines follow"
            )
        GranularDeck.check(self)
