# SPDX-License-Identifier: GPL-2.0-or-later
"""Base class of experiments: inputs, run and table row of a case, and studies of many cases.

docs/add_an_experiment.md shows how to write an experiment.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import attrs
import pandas as pd

from plastigran.declared import declarations
from plastigran.engine.process import inputs_folder, run_deck, typed_command
from plastigran.engine.versions import HOSTS
from plastigran.experiments.fields import Flag, several
from plastigran.experiments.runs import Runs, sweep
from plastigran.experiments.tables import format_range, format_table
from plastigran.materials import Material, read_material
from plastigran.usable_laws import choose_laws

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def combinations(values: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return every combination of values; the first name varies slowest.

    Args:
        values: One value, or an iterable of values, by name.
    """
    chosen = product(*map(several, values.values()))
    return [dict(zip(values, combination, strict=True)) for combination in chosen]


@attrs.frozen
class Experiment:
    """One case of an experiment. The fields are its inputs, declared with units and bounds.

    A subclass must define `deck` and `measure`. A subclass with a `command` is also a command of
    `plastigran`.

    Attributes:
        command: Name of the command of the experiment.
        help: Purpose of the command, in one line.
        example: Example of the command; by default the command with its required flags.
        host: Program that runs the deck, one of `plastigran.engine.versions.HOSTS`.
        deck: Path of the input script, relative to the folder of input scripts.
        shape: Shape of the bodies, "sphere" or "cylinder".
        has_theory: Whether `theory` can compute the impacts without LIGGGHTS.
        flags: Settings of the command by name; by default the declared fields.
        quantities: Attributes of the outcome that become table columns.
        shown: Columns that are printed; by default all.
    """

    command: ClassVar[str] = ""
    help: ClassVar[str] = ""
    example: ClassVar[str] = ""
    host: ClassVar[str] = "liggghts"
    deck: ClassVar[str]
    shape: ClassVar[str] = "sphere"
    has_theory: ClassVar[bool] = False
    flags: ClassVar[Mapping[str, Flag]] = {}
    quantities: ClassVar[tuple[str, ...]] = ()
    shown: ClassVar[tuple[str, ...]] = ()

    def _inputs(self) -> dict[str, Any]:
        return {name: getattr(self, name) for name in declarations(type(self))}

    def variables(self) -> dict[str, object]:
        """Return the deck variables of this case. A material contributes its constants by name."""
        variables: dict[str, object] = {}
        for name, value in self._inputs().items():
            if isinstance(value, Material):
                suffix = attrs.fields_dict(type(self))[name].metadata["suffix"]
                variables |= value.variables(suffix)
            else:
                variables[name] = value
        return variables

    @property
    def label(self) -> str:
        """Part of the name of the folder of this case in a sweep."""
        return self.command or type(self).__name__

    @property
    def timestep(self) -> float | None:
        """Time step [s]; None to use the time step of the deck."""
        return None

    def predict(self) -> Any:
        """Return the outcome predicted by theory; None if there is no theory."""
        return None

    def measure(self, folder: Path) -> Any:
        """Read the outcome from the files that the deck wrote to `folder`.

        Raises:
            ValueError: The files do not contain a complete outcome.
        """
        raise NotImplementedError

    def facts(self) -> dict[str, object]:
        """Return the columns that identify the case: its fields, with materials by name."""
        inputs = self._inputs().items()
        return {k: v.name if isinstance(v, Material) else v for k, v in inputs}

    def notes(self, measured: Any, predicted: Any) -> dict[str, object]:
        """Return additional columns of the results table."""
        return {}

    def row(self, measured: Any) -> dict[str, object]:
        """Return one row of the results table: the case, measured values and predicted values."""
        predicted, row = self.predict(), self.facts()
        for name in self.quantities:
            row[name] = getattr(measured, name)
            if (expected := getattr(predicted, name, None)) is not None:
                row[f"{name}_predicted"] = expected
        return row | self.notes(measured, predicted)

    def theory_row(self, predicted: Any) -> dict[str, object]:
        """Return one row of the table of a study by theory alone: the case and predicted values."""
        names = (*self.quantities, "in_range")
        values = {name: getattr(predicted, name, None) for name in names}
        return self.facts() | {name: value for name, value in values.items() if value is not None}

    def _deck_variables(self, timestep: float | None = None) -> dict[str, object]:
        timestep = self.timestep if timestep is None else timestep
        return self.variables() | ({} if timestep is None else {"timestep": timestep})

    def command_line(self, folder: Path) -> str:
        """Return shell commands that run the deck with results in `folder`."""
        deck, host = inputs_folder() / self.deck, HOSTS[self.host]
        return typed_command(deck, self._deck_variables(), folder, folder, host=host)

    def run(
        self, folder: str | Path, timestep: float | None = None, ranks: int = 1, **variables: object
    ) -> Any:
        """Run the deck and measure the outcome.

        Args:
            folder: Folder of the results.
            timestep: Time step [s]; by default the time step of the case.
            ranks: Number of MPI ranks.
            variables: Further variables of the deck, such as `gap`, the initial distance between
                the surfaces [m].

        Raises:
            EngineError: The host stopped with an error.
            ValueError: The files do not contain a complete outcome.
        """
        settings = self._deck_variables(timestep) | variables
        run_deck(self.deck, settings, folder, ranks, host=HOSTS[self.host])
        return self.measure(Path(folder))

    @classmethod
    def plan(cls, **values: Any) -> list[Experiment]:
        """Return every combination of field values, each case once; the first field varies slowest.

        Args:
            values: One value, or an iterable of values, by the name of the field.

        Raises:
            ValueError: A case cannot be run; the message gives the reason.
        """
        return list(dict.fromkeys(cls(**case) for case in combinations(values)))

    @classmethod
    def all_flags(cls) -> Mapping[str, Flag]:
        """Return the settings of the study; a field without default is required."""
        defaults = {field.name: field.default for field in attrs.fields(cls)}
        return cls.flags or {name: Flag(defaults[name]) for name in declarations(cls)}

    @classmethod
    def study_settings(cls, **given: Any) -> dict[str, Any]:
        """Return the settings of a study, with defaults for omitted flags.

        Raises:
            ValueError: A setting is unknown, or a required setting is missing.
        """
        flags = cls.all_flags()
        if unknown := sorted(set(given) - set(flags)):
            raise ValueError(
                f"{cls.command} has no setting {unknown[0]!r}. Available settings: "
                f"{' '.join(flags)}"
            )
        settings = {name: flag.values() for name, flag in flags.items()} | given
        if missing := [name for name, value in settings.items() if value is attrs.NOTHING]:
            raise ValueError(f"{cls.command} needs values for {', '.join(missing)}")
        settings = {k: v for k, v in settings.items() if not isinstance(v, attrs.Factory)}
        if "law" in flags and flags["law"].many:
            defaults = {field.name: field.default for field in attrs.fields(cls)}
            materials = settings.get("material") or defaults.get("material") or ()
            bodies = map(read_material, several(materials))
            settings["law"] = choose_laws(several(settings["law"]), cls.shape, bodies)
        return settings

    @classmethod
    def cases(cls, **settings: Any) -> list[Experiment]:
        """Return the cases of a study, by default every combination of settings (`plan`)."""
        return cls.plan(**settings)

    @classmethod
    def study(
        cls,
        folder: str | Path,
        jobs: int | None = None,
        progress: bool = True,
        force: bool = False,
        **settings: Any,
    ) -> Runs:
        """Run the same study as the command of the experiment.

        Args:
            folder, jobs, progress, force: As for `sweep`.
            settings: Values of the settings in `flags`; omitted settings have their defaults.
        """
        settings = cls.study_settings(**settings)
        return sweep(cls.cases(**settings), folder, jobs, progress, settings, force)

    @classmethod
    def theory(cls, **settings: Any) -> Runs:
        """Run a study by theory alone, without LIGGGHTS.

        Args:
            settings: As for `study`.

        Raises:
            ValueError: As for `study_settings`, or theory cannot replace the runs.
        """
        if not cls.has_theory:
            raise ValueError(f"{cls.command} cannot be computed by theory alone. Use study()")
        settings = cls.study_settings(**settings)
        outcomes = {case: case.predict() for case in cls.cases(**settings)}
        table = pd.DataFrame(case.theory_row(outcome) for case, outcome in outcomes.items())
        return Runs(cls, outcomes, table, settings, by_theory=True)

    @classmethod
    def tables(cls, runs: Runs) -> dict[str, pd.DataFrame]:
        """Return further tables of the runs, by name."""
        return {}

    @classmethod
    def figures(cls, runs: Runs) -> dict[str, Callable[[], Figure]]:
        """Return functions that draw the figures of the runs, by name."""
        return {}

    @classmethod
    def summary(cls, runs: Runs) -> str:
        """Return the printed summary: the results table, and the laws used outside their range."""
        text = [format_table(runs.table, cls.shown)]
        if "in_range" in runs.table:
            text.append(format_range(runs.table))
        return "\n".join(filter(None, text))
