# SPDX-License-Identifier: GPL-2.0-or-later
"""Cases run side by side, and what came of them: table, outcomes, figures."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import contextmanager
from functools import cached_property
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

import attrs
import pandas as pd

from plastigran.engine.folder_lock import lock_folder
from plastigran.engine.versions import versions
from plastigran.experiments.record import STUDY, TABLE, add_row, materials_of, write_study
from plastigran.progress import ProgressBar

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from plastigran.experiments.base import Experiment


@attrs.frozen(slots=False, eq=False, repr=False)
class Runs:
    """What came of a sweep.

    Attributes:
        experiment: The class of its cases.
        outcomes: What was measured, by case.
        table: One row a case, in the order given; columns of `Experiment.row`.
        settings: Of the study, where it is one.
        by_theory: Whether the outcomes are theory's, made without the engine.
    """

    experiment: type[Experiment]
    outcomes: Mapping[Experiment, Any]
    table: pd.DataFrame
    settings: Mapping[str, Any] = attrs.field(factory=dict)
    by_theory: bool = False

    @property
    def cases(self) -> list[Experiment]:
        """What was run."""
        return list(self.outcomes)

    @cached_property
    def tables(self) -> dict[str, pd.DataFrame]:
        """Further tables of the experiment, by name."""
        return self.experiment.tables(self)

    @cached_property
    def figures(self) -> dict[str, Figure]:
        """Every figure, by name."""
        return {name: draw() for name, draw in self.experiment.figures(self).items()}

    def figure(self, name: str) -> Figure:
        """Draw one figure.

        Raises:
            ValueError: There is none of that name.
        """
        drawings = self.experiment.figures(self)
        if name not in drawings:
            raise ValueError(f"no figure {name!r}; there are {', '.join(drawings) or 'none'}")
        return drawings[name]()

    def write(self, folder: str | Path) -> list[Path]:
        """Write every table, as CSV, and figure, as PNG and SVG, into a folder.

        Of theory's outcomes `study.json`, too: a sweep has written its own before it began.

        Returns:
            The files, the results table first.

        Raises:
            ValueError: Of theory, two materials have one name; nothing is written.
        """
        from plastigran.plot import style  # matplotlib is slow to load

        folder = Path(folder)
        folder.mkdir(parents=True, exist_ok=True)
        if self.by_theory:
            made_with = {"plastigran": version("plastigran")}
            write_study(folder, self.cases, self.settings, made_with, by_theory=True)
        written = [folder / TABLE]
        self.table.to_csv(written[0], index=False)
        for name, table in self.tables.items():
            written.append(folder / f"{name}.csv")
            table.to_csv(written[-1], index=table.index.name is not None)
        for name, draw in self.experiment.figures(self).items():
            written += style.save(draw(), folder / name)
        return written

    def __str__(self) -> str:
        return self.experiment.summary(self)

    def __repr__(self) -> str:
        names = ", ".join(self.experiment.figures(self))
        return (
            f"<Runs of {len(self.outcomes)} {self.experiment.__name__} cases; "
            f"table: {self.table.shape[0]} rows x {self.table.shape[1]} columns; figures: {names}>"
        )


def sweep(
    cases: Iterable[Experiment],
    folder: str | Path,
    jobs: int | None = None,
    progress: bool = True,
    settings: Mapping[str, Any] | None = None,
    force: bool = False,
) -> Runs:
    """Run cases of one experiment in parallel.

    Every finished one is appended to `impacts.csv` at once, so a run cut short keeps what it has.

    Args:
        cases: What to run.
        folder: Results go to `impacts.csv` here and to one folder a case under `runs/`;
            `study.json` says what ran.
        jobs: Engines at a time, 1 or more; all cores by default.
        progress: Show a progress bar.
        settings: Of the study that the cases are of.
        force: Overwrite the results of an earlier sweep in `folder`.

    Raises:
        ValueError: There is no case, `jobs` is out of range, two materials have one name, or
            `folder` holds results or is that of a sweep that runs.
        EngineError: There is no engine.
        EngineError, ValueError: From the first case that failed; the others' rows are written
            before it is raised.
    """
    cases, folder = list(cases), Path(folder)
    if not cases:
        raise ValueError("there is no case to run")
    if jobs is not None and not (isinstance(jobs, int) and jobs >= 1):
        raise ValueError(f"jobs is {jobs!r}; it must be 1 or more")
    materials_of(cases)
    made_with = versions()  # raises where there is no engine, before anything is removed
    with claim(folder, force):
        write_study(folder, cases, settings or {}, made_with)
        return _sweep(cases, folder, jobs, progress, settings)


def case_folders(cases: Iterable[Experiment], folder: Path) -> list[Path]:
    """Where each case of a sweep runs."""
    return [folder / "runs" / f"{number:04d}_{case.label}" for number, case in enumerate(cases)]


@contextmanager
def claim(folder: Path, force: bool) -> Iterator[None]:
    """Lock a folder and remove an earlier sweep's table, record and runs from it.

    Raises:
        ValueError: It holds results and `force` is not given, or another command writes there.
    """
    with lock_folder(folder):
        if not force and any([*folder.glob(TABLE), *folder.glob("runs/*/*")]):
            raise ValueError(
                f"{folder} holds results; choose another folder (--output), or overwrite "
                "them (--force)"
            )
        for name in (TABLE, STUDY):
            (folder / name).unlink(missing_ok=True)
        for run in folder.glob("runs/[0-9]*_*"):  # as of `case_folders`
            shutil.rmtree(run)
        yield


def _sweep(
    cases: list[Experiment],
    folder: Path,
    jobs: int | None,
    progress: bool,
    settings: Mapping[str, Any] | None,
) -> Runs:
    path = folder / TABLE
    measured: dict[Experiment, Any] = {}
    rows: dict[Experiment, dict[str, object]] = {}
    failure: Exception | None = None
    pool = ThreadPoolExecutor(jobs or os.cpu_count())
    places = zip(cases, case_folders(cases, folder), strict=True)
    waiting = {pool.submit(case.run, place): case for case, place in places}
    name = cases[0].command or type(cases[0]).__name__
    bar = ProgressBar(total=len(cases), desc=name, unit="impacts", shown=progress)
    try:
        for done in as_completed(waiting):
            case = waiting[done]
            bar.update()
            try:
                measured[case] = done.result()
            except Exception as error:
                failure = failure or error
                continue
            rows[case] = case.row(measured[case])
            add_row(path, rows[case])
    finally:  # an interrupt starts no further engine
        pool.shutdown(wait=True, cancel_futures=True)
        bar.close()
    if failure:
        raise failure
    table = pd.DataFrame([rows[case] for case in cases])
    table.to_csv(path, index=False)
    outcomes = {case: measured[case] for case in cases}
    return Runs(type(cases[0]), outcomes, table, dict(settings or {}))
