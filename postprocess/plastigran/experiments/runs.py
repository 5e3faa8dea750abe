# SPDX-License-Identifier: GPL-2.0-or-later
"""Parallel runs of the cases of an experiment, and their results: table, outcomes, figures."""

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
from plastigran.experiments.case import Case
from plastigran.experiments.record import STUDY, TABLE, add_row, materials_of, write_study
from plastigran.progress import ProgressBar

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@attrs.frozen(slots=False, eq=False, repr=False)
class Runs:
    """Results of a sweep, which runs several cases of one experiment.

    Attributes:
        experiment: Class of the cases.
        outcomes: Outcome of each case, measured or predicted.
        table: Results table: one row per case, in the given order, with the columns of `Case.row`.
        settings: Settings of the study that defined the cases; empty if there was no study.
        by_theory: Whether theory predicted the outcomes, without LIGGGHTS.
    """

    experiment: type[Case]
    outcomes: Mapping[Case, Any]
    table: pd.DataFrame
    settings: Mapping[str, Any] = attrs.field(factory=dict)
    by_theory: bool = False

    @property
    def cases(self) -> list[Case]:
        """Cases of the sweep."""
        return list(self.outcomes)

    @cached_property
    def tables(self) -> dict[str, pd.DataFrame]:
        """Tables of the experiment besides the results table, by name."""
        return self.experiment.tables(self)

    @cached_property
    def figures(self) -> dict[str, Figure]:
        """Figures by name."""
        return {name: draw() for name, draw in self.experiment.figures(self).items()}

    def figure(self, name: str) -> Figure:
        """Draw one figure.

        Raises:
            ValueError: No figure has this name.
        """
        drawings = self.experiment.figures(self)
        if name not in drawings:
            raise ValueError(
                f"no figure {name!r}. Available figures: {', '.join(drawings) or 'none'}"
            )
        return drawings[name]()

    def write(self, folder: str | Path) -> list[Path]:
        """Write every table as CSV, and every figure as PNG and SVG, into a folder.

        If theory predicted the outcomes, this method also writes the record `study.json`. A sweep
        in LIGGGHTS has written this record before its simulations.

        Returns:
            The paths of the files, the results table first.

        Raises:
            ValueError: Theory predicted the outcomes, and two different materials have the same
                name. In this case, nothing is written.
        """
        from plastigran.plot import style  # imported here, because matplotlib is slow to load

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
    cases: Iterable[Case],
    folder: str | Path,
    jobs: int | None = None,
    progress: bool = True,
    settings: Mapping[str, Any] | None = None,
    force: bool = False,
) -> Runs:
    """Run cases of one experiment in parallel.

    Each finished case adds its row to `impacts.csv` at once. An interrupted sweep thus keeps the
    results of its finished cases.

    Args:
        cases: Cases to run.
        folder: Folder of the results: the table `impacts.csv`, the record `study.json`, and `runs/`
            with a folder for each case.
        jobs: Number of LIGGGHTS processes that run at the same time, 1 or more; by default the
            number of cores.
        progress: Whether to show a progress bar.
        settings: Settings of the study that defined the cases, for the record.
        force: Whether to overwrite the results of an earlier sweep in `folder`.

    Raises:
        ValueError: `cases` is empty, `jobs` is out of range, two different materials have the same
            name, or `folder` contains results or is in use.
        EngineError: LIGGGHTS is missing.
        EngineError, ValueError: A case failed. If several cases failed, the error is that of the
            first one. The rows of all successful cases are in `impacts.csv`.
    """
    cases, folder, settings = list(cases), Path(folder), dict(settings or {})
    if not cases:
        raise ValueError("cases is empty; give one or more cases")
    if jobs is not None and not (isinstance(jobs, int) and jobs >= 1):
        raise ValueError(f"jobs is {jobs!r}; it must be 1 or more")
    materials_of(cases)
    # Check that the host exists before anything is removed; raises EngineError.
    made_with = versions(cases[0].host)
    with claim(folder, force):
        write_study(folder, cases, settings, made_with)
        outcomes, table = _run(cases, folder, jobs, progress)
    return Runs(type(cases[0]), outcomes, table, settings)


def case_folders(cases: Iterable[Case], folder: Path) -> list[Path]:
    """Return the folder of each case of a sweep."""
    return [folder / "runs" / f"{number:04d}_{case.label}" for number, case in enumerate(cases)]


@contextmanager
def claim(folder: Path, force: bool) -> Iterator[None]:
    """Lock a folder, and remove the table, record and case folders of an earlier sweep from it.

    Raises:
        ValueError: The folder contains results and `force` is False, or another command uses the
            folder.
    """
    with lock_folder(folder):
        if not force and any([*folder.glob(TABLE), *folder.glob("runs/*/*")]):
            raise ValueError(
                f"{folder} contains results. Choose another folder with --output, or overwrite "
                "them with --force"
            )
        for name in (TABLE, STUDY):
            (folder / name).unlink(missing_ok=True)
        for run in folder.glob("runs/[0-9]*_*"):  # names from `case_folders`
            shutil.rmtree(run)
        yield


def _run(
    cases: list[Case], folder: Path, jobs: int | None, progress: bool
) -> tuple[dict[Case, Any], pd.DataFrame]:
    """Run the cases; return their outcomes and the results table, both in the given order."""
    outcomes: dict[Case, Any] = {}
    rows: dict[Case, dict[str, object]] = {}
    failures: list[Exception] = []
    pool = ThreadPoolExecutor(jobs or os.cpu_count())
    folders = zip(cases, case_folders(cases, folder), strict=True)
    waiting = {pool.submit(case.run, place): case for case, place in folders}
    bar = ProgressBar(total=len(cases), desc=cases[0].command, unit="impacts", shown=progress)
    try:
        for done in as_completed(waiting):
            case = waiting[done]
            bar.update()
            try:
                outcomes[case] = done.result()
            except Exception as error:  # keep the error and let the other cases run
                failures.append(error)
                continue
            rows[case] = case.row(outcomes[case])
            add_row(folder / TABLE, rows[case])
    finally:  # after Ctrl-C, start no further simulations
        pool.shutdown(wait=True, cancel_futures=True)
        bar.close()
    if failures:
        raise failures[0]
    table = pd.DataFrame([rows[case] for case in cases])
    table.to_csv(folder / TABLE, index=False)
    return {case: outcomes[case] for case in cases}, table
