# SPDX-License-Identifier: GPL-2.0-or-later
"""Base class of one case of an experiment: its inputs, its simulation, and its row of results."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import attrs

from plastigran.declared import declarations
from plastigran.engine.process import inputs_folder, run_deck, typed_command
from plastigran.engine.versions import HOSTS
from plastigran.experiments.tables import format_range, format_table
from plastigran.materials import Material

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@attrs.frozen
class Case:
    """One case of an experiment: one simulation with given inputs.

    The subclass `Experiment` adds studies of many cases.

    Attributes:
        command: Name of the `plastigran` command that runs the experiment.
        host: Program that runs the deck, one of `plastigran.engine.versions.HOSTS`.
        deck: Path of the input script, relative to the folder of input scripts.
        shape: Shape of the bodies, "sphere" or "cylinder".
        quantities: Attributes of the outcome that become columns of the results table.
        shown: Columns of the results table that are printed; by default all.
    """

    command: ClassVar[str] = ""
    host: ClassVar[str] = "liggghts"
    deck: ClassVar[str]
    shape: ClassVar[str] = "sphere"
    quantities: ClassVar[tuple[str, ...]] = ()
    shown: ClassVar[tuple[str, ...]] = ()

    def _inputs(self) -> dict[str, Any]:
        return {name: getattr(self, name) for name in declarations(type(self))}

    def variables(self) -> dict[str, object]:
        """Return the deck variables of this case. A material adds one variable per constant."""
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
        """Text in the folder name of this case, if it runs together with other cases."""
        return self.command or type(self).__name__

    @property
    def timestep(self) -> float | None:
        """Time step [s]; None to use the time step of the deck."""
        return None

    def predict(self) -> Any:
        """Return the outcome that theory predicts; None if the experiment has no theory."""
        return None

    def measure(self, folder: Path) -> Any:
        """Read the outcome from the files that the deck wrote to `folder`.

        Raises:
            ValueError: The files do not contain a complete outcome.
        """
        raise NotImplementedError

    def facts(self) -> dict[str, object]:
        """Return the columns of the results table that identify the case.

        They are the fields of the case, with the names of materials.
        """
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
        """Return one row of the results table of a study by theory alone.

        The row contains the columns that identify the case, and the predicted values.
        """
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

    # The class methods below describe the results of many cases; `runs` is an instance of `Runs`.

    @classmethod
    def tables(cls, runs: Any) -> dict[str, Any]:
        """Return the tables of the experiment besides the results table, by name."""
        return {}

    @classmethod
    def figures(cls, runs: Any) -> dict[str, Callable[[], Figure]]:
        """Return functions that draw the figures of the runs, by name."""
        return {}

    @classmethod
    def summary(cls, runs: Any) -> str:
        """Return text with the results table, and a warning for laws used outside their range."""
        text = [format_table(runs.table, cls.shown)]
        if "in_range" in runs.table:
            text.append(format_range(runs.table))
        return "\n".join(filter(None, text))
