# SPDX-License-Identifier: GPL-2.0-or-later
"""What every experiment is: a case with its prediction and measurement, and a sweep of many.

docs/add_an_experiment.md shows how one is written.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import attrs
import pandas as pd

from plastigran.declared import declaration
from plastigran.engine.process import inputs_folder, run_deck, typed_command
from plastigran.experiments.fields import Flag, several
from plastigran.experiments.runs import Runs, sweep
from plastigran.experiments.tables import format_range, format_table
from plastigran.materials import Material, read_material
from plastigran.usable_laws import choose_laws

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def combinations(values: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Every combination of values, the first name's varying slowest.

    Args:
        values: By name, one or an iterable of them.
    """
    chosen = product(*map(several, values.values()))
    return [dict(zip(values, each, strict=True)) for each in chosen]


@attrs.frozen
class Experiment:
    """One case of an experiment: what is to be run. Its fields are declared quantities.

    A subclass is an experiment: it gives `deck` and `measure`, and more where it has more to say.
    One with a `command` is found, has that command and is drawn in the docs.

    Attributes:
        command: Name of its command.
        help: Of the command, in a line.
        example: Of the command, a line or several; by default it alone.
        deck: Path of its input script, in the folder of the input scripts.
        shape: Of its bodies, "sphere" or "cylinder".
        has_theory: Whether its study can be answered by theory alone, without the engine.
        flags: Settings of its study, by name; by default its declared fields.
        usual_materials: Their constants tell which laws are usable, where no flag names a material.
        quantities: Attributes of its outcome that make columns of the table.
        shown: Columns that are printed, all by default.
        docs: Settings of the study that the docs show.
        docs_figures: Names of its figures in the docs, by name in `figures`.
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

    # What one case says of itself.

    def variables(self) -> dict[str, object]:
        """The case as the deck's variables: its fields, a material's constants by their names."""
        found: dict[str, object] = {}
        for name in declaration(type(self)):
            value, said = getattr(self, name), attrs.fields_dict(type(self))[name].metadata
            material = isinstance(value, Material)
            found |= value.variables(said["suffix"]) if material else {name: value}
        return found

    @property
    def label(self) -> str:
        """Part of the name of its folder in a sweep."""
        return self.command or type(self).__name__

    @property
    def timestep(self) -> float | None:
        """Time step [s]; None leaves it to the deck."""
        return None

    def predict(self) -> Any:
        """The outcome by theory; None where there is none."""
        return None

    def measure(self, folder: Path) -> Any:
        """The outcome from the files that the deck has left in a folder.

        Raises:
            ValueError: They hold no whole outcome.
        """
        raise NotImplementedError

    def facts(self) -> dict[str, object]:
        """Columns that tell the case: its fields, a material by its name."""
        values = {name: getattr(self, name) for name in declaration(type(self))}
        return {k: v.name if isinstance(v, Material) else v for k, v in values.items()}

    def notes(self, measured: Any, predicted: Any) -> dict[str, object]:
        """Further columns."""
        return {}

    def row(self, measured: Any) -> dict[str, object]:
        """One line of the results table: the case, what was measured, and `*_predicted`."""
        predicted, line = self.predict(), self.facts()
        for name in self.quantities:
            line[name] = getattr(measured, name)
            if (expected := getattr(predicted, name, None)) is not None:
                line[f"{name}_predicted"] = expected
        return line | self.notes(measured, predicted)

    def theory_row(self, predicted: Any) -> dict[str, object]:
        """One line of the results table of theory alone: the case and what is predicted."""
        found = {name: getattr(predicted, name, None) for name in (*self.quantities, "in_range")}
        return self.facts() | {name: value for name, value in found.items() if value is not None}

    def materials(self) -> dict[str, Material]:
        """The materials of its bodies, by name."""
        values = (getattr(self, name) for name in declaration(type(self)))
        return {value.name: value for value in values if isinstance(value, Material)}

    # Running one.

    def execute(
        self, folder: str | Path, timestep: float | None = None, gap: float = 0.0, ranks: int = 1
    ) -> None:
        """Run the deck in the engine; arguments and errors as for `run`."""
        run_deck(self.deck, self._settings(timestep, gap), folder, ranks=ranks)

    def command_line(self, folder: Path) -> str:
        """What could be typed to run the deck, with results in that folder."""
        deck, settings = inputs_folder() / self.deck, self._settings(None, 0.0)
        return typed_command(deck, settings, folder, folder)

    def _settings(self, timestep: float | None, gap: float) -> dict[str, object]:
        """Of the deck, the time step and the gap among them."""
        variables, step = self.variables(), self.timestep if timestep is None else timestep
        if step is not None:
            variables["timestep"] = step
        if gap:
            variables["gap"] = gap
        return variables

    def run(
        self, folder: str | Path, timestep: float | None = None, gap: float = 0.0, ranks: int = 1
    ) -> Any:
        """Run the deck in the engine and measure.

        Args:
            folder: Where the engine writes.
            timestep: [s]; the case's own by default.
            gap: Distance between the surfaces at the start, for decks that have one [m].
            ranks: MPI ranks.

        Raises:
            EngineError: The engine stopped with an error.
            ValueError: What it left holds no whole outcome.
        """
        self.execute(folder, timestep, gap, ranks)
        return self.measure(Path(folder))

    # Running many.

    @classmethod
    def plan(cls, **values: Any) -> list[Experiment]:
        """Every combination of field values, each case once; the first field named varies slowest.

        Args:
            values: By field, one value or an iterable of them.

        Raises:
            ValueError: A case cannot be run; the message says why.
        """
        return list(dict.fromkeys(cls(**case) for case in combinations(values)))

    @classmethod
    def study_settings(cls, **given: Any) -> dict[str, Any]:
        """The settings of a study: a value for each flag, as given or by default.

        Raises:
            ValueError: There is no such setting, or one that must be given is missing.
        """
        if unknown := sorted(set(given) - set(cls.all_flags())):
            raise ValueError(
                f"{cls.command} has no setting {unknown[0]!r}; it takes {' '.join(cls.all_flags())}"
            )
        usual = {name: flag.values() for name, flag in cls.all_flags().items()}
        found = {k: value for k, value in usual.items() if not isinstance(value, attrs.Factory)}
        found |= given
        if missing := [name for name, value in found.items() if value is attrs.NOTHING]:
            raise ValueError(f"{cls.command} must be given {', '.join(missing)}")
        if "law" in found and cls.all_flags()["law"].many:
            bodies = map(read_material, several(found.get("material", cls.usual_materials)))
            found["law"] = choose_laws(several(found["law"]), cls.shape, bodies)
        return found

    @classmethod
    def cases(cls, **settings: Any) -> list[Experiment]:
        """The cases of a study; its settings are those of `flags`. By default their `plan`."""
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
        """Run what the experiment's command runs.

        Args:
            folder, jobs, progress, force: As for `sweep`.
            settings: Of `flags`; others have their defaults.
        """
        settings = cls.study_settings(**settings)
        return sweep(cls.cases(**settings), folder, jobs, progress, settings, force)

    @classmethod
    def theory(cls, **settings: Any) -> Runs:
        """What theory alone says of a study; no engine is needed.

        Args:
            settings: As for `study`.

        Raises:
            ValueError: As for `study_settings`, or the experiment has no theory of its own.
        """
        if not cls.has_theory:
            raise ValueError(f"{cls.command} has no theory that stands for its runs")
        settings = cls.study_settings(**settings)
        found = {case: case.predict() for case in cls.cases(**settings)}
        table = pd.DataFrame(case.theory_row(outcome) for case, outcome in found.items())
        return Runs(cls, found, table, settings, by_theory=True)

    @classmethod
    def all_flags(cls) -> Mapping[str, Flag]:
        """The settings of its study; a field without a default must be given."""
        defaults = {field.name: field.default for field in attrs.fields(cls)}
        return cls.flags or {name: Flag(defaults[name]) for name in declaration(cls)}

    # What came of many.

    @classmethod
    def tables(cls, runs: Runs) -> dict[str, Any]:
        """Tables made of the runs, by name."""
        return {}

    @classmethod
    def figures(cls, runs: Runs) -> dict[str, Callable[[], Figure]]:
        """Figures of the runs, by name: a function that draws each."""
        return {}

    @classmethod
    def summary(cls, runs: Runs) -> str:
        """What the command prints: the results table, and which laws left their range."""
        text = [format_table(runs.table, cls.shown)]
        if "in_range" in runs.table:
            text.append(format_range(runs.table))
        return "\n".join(filter(None, text))
