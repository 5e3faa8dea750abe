# SPDX-License-Identifier: GPL-2.0-or-later
"""Base class of experiments: a case with prediction and measurement, and sweeps of cases.

docs/add_an_experiment.md shows how to write one.
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
        values: Maps a name to one value or an iterable of values.
    """
    chosen = product(*map(several, values.values()))
    return [dict(zip(values, each, strict=True)) for each in chosen]


@attrs.frozen
class Experiment:
    """One case of an experiment. Its fields are the inputs, declared with units and bounds.

    Each experiment is a subclass. It must define `deck` and `measure`. A subclass with a `command`
    is
    registered as a `plastigran` command and appears in the documentation.

    Attributes:
        command: Name of its command.
        help: Purpose of the command, in one line.
        example: Example of the command; by default the command alone.
        deck: Path of its input script in the folder of the input scripts.
        shape: Shape of the bodies, "sphere" or "cylinder".
        has_theory: Whether `theory` can run the study without LIGGGHTS.
        flags: Settings of its study by name; by default the declared fields.
        usual_materials: Materials that select the usable laws if no flag names a material.
        quantities: Attributes of the outcome that become table columns.
        shown: Columns that are printed; by default all.
        docs: Settings of the study for the documentation.
        docs_figures: File names of its figures in the documentation, by name in `figures`.
    """

    command: ClassVar[str] = ""
    help: ClassVar[str] = ""
    example: ClassVar[str] = ""
    deck: ClassVar[str]
    shape: ClassVar[str] = "sphere"
    has_theory: ClassVar[bool] = False
    flags: ClassVar[Mapping[str, Flag]] = {}
    usual_materials: ClassVar[tuple[str, ...]] = ()
    quantities: ClassVar[tuple[str, ...]] = ()
    shown: ClassVar[tuple[str, ...]] = ()
    docs: ClassVar[Mapping[str, Any]] = {}
    docs_figures: ClassVar[Mapping[str, str]] = {}

    # Description of one case.

    def variables(self) -> dict[str, object]:
        """Return the deck variables of this case. A material contributes its constants by name."""
        found: dict[str, object] = {}
        for name in declarations(type(self)):
            value, said = getattr(self, name), attrs.fields_dict(type(self))[name].metadata
            material = isinstance(value, Material)
            found |= value.variables(said["suffix"]) if material else {name: value}
        return found

    @property
    def label(self) -> str:
        """Part of the name of the folder of this case in a sweep."""
        return self.command or type(self).__name__

    @property
    def timestep(self) -> float | None:
        """Time step [s]; None to use that of the deck."""
        return None

    def predict(self) -> Any:
        """Return the outcome by theory; None without theory."""
        return None

    def measure(self, folder: Path) -> Any:
        """Read the outcome from the files that the deck wrote to `folder`.

        Raises:
            ValueError: The files do not contain a complete outcome.
        """
        raise NotImplementedError

    def facts(self) -> dict[str, object]:
        """Return the columns that identify the case: its fields, with materials by name."""
        values = {name: getattr(self, name) for name in declarations(type(self))}
        return {k: v.name if isinstance(v, Material) else v for k, v in values.items()}

    def notes(self, measured: Any, predicted: Any) -> dict[str, object]:
        """Return further columns."""
        return {}

    def row(self, measured: Any) -> dict[str, object]:
        """Return one row of the results table: the case, measured values, and `*_predicted`."""
        predicted, line = self.predict(), self.facts()
        for name in self.quantities:
            line[name] = getattr(measured, name)
            if (expected := getattr(predicted, name, None)) is not None:
                line[f"{name}_predicted"] = expected
        return line | self.notes(measured, predicted)

    def theory_row(self, predicted: Any) -> dict[str, object]:
        """Return one row of the results table of theory alone: the case and predicted values."""
        found = {name: getattr(predicted, name, None) for name in (*self.quantities, "in_range")}
        return self.facts() | {name: value for name, value in found.items() if value is not None}

    def materials(self) -> dict[str, Material]:
        """Return the materials of the bodies by name."""
        values = (getattr(self, name) for name in declarations(type(self)))
        return {value.name: value for value in values if isinstance(value, Material)}

    # Running one case.

    def execute(
        self, folder: str | Path, timestep: float | None = None, gap: float = 0.0, ranks: int = 1
    ) -> None:
        """Run the deck with LIGGGHTS; arguments and errors as for `run`."""
        run_deck(self.deck, self._settings(timestep, gap), folder, ranks=ranks)

    def command_line(self, folder: Path) -> str:
        """Return shell commands that run the deck with results in `folder`."""
        deck, settings = inputs_folder() / self.deck, self._settings(None, 0.0)
        return typed_command(deck, settings, folder, folder)

    def _settings(self, timestep: float | None, gap: float) -> dict[str, object]:
        """Return the settings of the deck, including time step and gap."""
        variables, step = self.variables(), self.timestep if timestep is None else timestep
        if step is not None:
            variables["timestep"] = step
        if gap:
            variables["gap"] = gap
        return variables

    def run(
        self, folder: str | Path, timestep: float | None = None, gap: float = 0.0, ranks: int = 1
    ) -> Any:
        """Run the deck with LIGGGHTS and measure the outcome.

        Args:
            folder: Folder of the results.
            timestep: Time step [s]; by default that of the case.
            gap: Initial distance between the surfaces [m], for decks that have it.
            ranks: Number of MPI ranks.

        Raises:
            EngineError: LIGGGHTS stopped with an error.
            ValueError: The files do not contain a complete outcome.
        """
        self.execute(folder, timestep, gap, ranks)
        return self.measure(Path(folder))

    # Running many cases.

    @classmethod
    def plan(cls, **values: Any) -> list[Experiment]:
        """Return every combination of field values, each case once; the first field varies slowest.

        Args:
            values: Maps a field to one value or an iterable of values.

        Raises:
            ValueError: A case cannot be run; the message gives the reason.
        """
        return list(dict.fromkeys(cls(**case) for case in combinations(values)))

    @classmethod
    def study_settings(cls, **given: Any) -> dict[str, Any]:
        """Return the settings of a study, with defaults for omitted flags.

        Raises:
            ValueError: A setting is unknown, or a required setting is missing.
        """
        if unknown := sorted(set(given) - set(cls.all_flags())):
            raise ValueError(
                f"{cls.command} has no setting {unknown[0]!r}; it has {' '.join(cls.all_flags())}"
            )
        usual = {name: flag.values() for name, flag in cls.all_flags().items()}
        found = {k: value for k, value in usual.items() if not isinstance(value, attrs.Factory)}
        found |= given
        if missing := [name for name, value in found.items() if value is attrs.NOTHING]:
            raise ValueError(f"{cls.command} needs {', '.join(missing)}")
        if "law" in found and cls.all_flags()["law"].many:
            bodies = map(read_material, several(found.get("material", cls.usual_materials)))
            found["law"] = choose_laws(several(found["law"]), cls.shape, bodies)
        return found

    @classmethod
    def cases(cls, **settings: Any) -> list[Experiment]:
        """Return the cases of a study with the settings of `flags`; by default their `plan`."""
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
        """Run the study of the experiment's command.

        Args:
            folder, jobs, progress, force: As for `sweep`.
            settings: Settings of `flags`; others have their defaults.
        """
        settings = cls.study_settings(**settings)
        return sweep(cls.cases(**settings), folder, jobs, progress, settings, force)

    @classmethod
    def theory(cls, **settings: Any) -> Runs:
        """Run a study by theory alone, without LIGGGHTS.

        Args:
            settings: As for `study`.

        Raises:
            ValueError: As for `study_settings`, or the experiment has no theory of its own.
        """
        if not cls.has_theory:
            raise ValueError(f"{cls.command} has no theory that can replace its runs")
        settings = cls.study_settings(**settings)
        found = {case: case.predict() for case in cls.cases(**settings)}
        table = pd.DataFrame(case.theory_row(outcome) for case, outcome in found.items())
        return Runs(cls, found, table, settings, by_theory=True)

    @classmethod
    def all_flags(cls) -> Mapping[str, Flag]:
        """Return the settings of its study; a field without default is required."""
        defaults = {field.name: field.default for field in attrs.fields(cls)}
        return cls.flags or {name: Flag(defaults[name]) for name in declarations(cls)}

    # Results of many cases.

    @classmethod
    def tables(cls, runs: Runs) -> dict[str, Any]:
        """Return further tables of the runs, by name."""
        return {}

    @classmethod
    def figures(cls, runs: Runs) -> dict[str, Callable[[], Figure]]:
        """Return functions that draw the figures of the runs, by name."""
        return {}

    @classmethod
    def summary(cls, runs: Runs) -> str:
        """Return the printed summary: the results table, and the laws used beyond their range."""
        text = [format_table(runs.table, cls.shown)]
        if "in_range" in runs.table:
            text.append(format_range(runs.table))
        return "\n".join(filter(None, text))
