# SPDX-License-Identifier: GPL-2.0-or-later
"""Base class of experiments.

A case is one simulation with given inputs (class `Case`). An experiment adds studies, which compute
many cases. docs/add_an_experiment.md shows how to write an experiment.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product
from pathlib import Path
from typing import Any, ClassVar

import attrs
import pandas as pd

from plastigran.declared import declarations
from plastigran.experiments.case import Case
from plastigran.experiments.fields import Flag, several
from plastigran.experiments.runs import Runs, sweep
from plastigran.materials import read_material
from plastigran.usable_laws import choose_laws


def combinations(values: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return every combination of values; the first name varies slowest.

    Args:
        values: One value, or an iterable of values, by name.
    """
    chosen = product(*map(several, values.values()))
    return [dict(zip(values, combination, strict=True)) for combination in chosen]


@attrs.frozen
class Experiment(Case):
    """One case of an experiment: one simulation with given inputs.

    Each experiment is a subclass, whose fields declare the inputs with units and bounds. A subclass
    must define `deck` and `measure`. A subclass with a `command` is also a command of `plastigran`.

    Attributes:
        help: Purpose of the command, in one line.
        example: Example command line; by default the command with its required flags.
        has_theory: Whether `theory` can compute the impacts without LIGGGHTS.
        flags: Settings of a study by name, which are also the flags of the command; by default the
            declared fields.
    """

    help: ClassVar[str] = ""
    example: ClassVar[str] = ""
    has_theory: ClassVar[bool] = False
    flags: ClassVar[Mapping[str, Flag]] = {}

    @classmethod
    def plan(cls, **values: Any) -> list[Experiment]:
        """Return a case for every combination of field values; the first field varies slowest.

        Equal cases appear only once.

        Args:
            values: One value, or an iterable of values, by the name of the field.

        Raises:
            ValueError: The inputs of a case are invalid; the message gives the reason.
        """
        return list(dict.fromkeys(cls(**case) for case in combinations(values)))

    @classmethod
    def all_flags(cls) -> Mapping[str, Flag]:
        """Return the settings of a study by name; a setting without default is required."""
        defaults = {field.name: field.default for field in attrs.fields(cls)}
        return cls.flags or {name: Flag(defaults[name]) for name in declarations(cls)}

    @classmethod
    def study_settings(cls, **given: Any) -> dict[str, Any]:
        """Return the values of all settings of a study, with defaults for omitted settings.

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
        """Return the cases of a study. By default, they are every combination of the settings."""
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
        """Run a study, as the `plastigran` command of the experiment does.

        Args:
            folder, jobs, progress, force: As for `plastigran.experiments.runs.sweep`.
            settings: Values of the settings in `flags`; omitted settings have their defaults.
        """
        settings = cls.study_settings(**settings)
        return sweep(cls.cases(**settings), folder, jobs, progress, settings, force)

    @classmethod
    def theory(cls, **settings: Any) -> Runs:
        """Compute a study by theory alone, without LIGGGHTS.

        Args:
            settings: As for `study`.

        Raises:
            ValueError: As for `study_settings`, or the experiment has no such theory.
        """
        if not cls.has_theory:
            raise ValueError(f"{cls.command} cannot be computed by theory alone. Use study()")
        settings = cls.study_settings(**settings)
        outcomes = {case: case.predict() for case in cls.cases(**settings)}
        table = pd.DataFrame(case.theory_row(outcome) for case, outcome in outcomes.items())
        return Runs(cls, outcomes, table, settings, by_theory=True)
