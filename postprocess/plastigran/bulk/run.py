# SPDX-License-Identifier: GPL-2.0-or-later
"""Run a bulk deck, check its invariants and draw its figures."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from plastigran.bulk.folder import (
    BEFORE,
    CHECKS,
    SERIES,
    all_derived,
    all_excess,
    carry_files,
    prepare_folder,
    read_series,
    rows_up_to,
    write_record,
)
from plastigran.bulk.outcome import BulkRun, open_run
from plastigran.bulk.own import planned_steps
from plastigran.bulk.plan import Plan, plan_bulk
from plastigran.engine.checkpoints import (
    ChecksumWriter,
    fetch_file_of_signal,
    files_of_signals,
    step_of,
)
from plastigran.engine.folder_lock import lock_folder
from plastigran.engine.log import LOG
from plastigran.engine.process import run_deck
from plastigran.engine.versions import versions
from plastigran.plot import style


def run_bulk(
    deck: str | Path,
    values: Mapping[str, object],
    folder: str | Path,
    ranks: int = 1,
    restart: str | Path | None = None,
    force: bool = False,
    show: bool = True,
) -> BulkRun:
    """Run a deck from its start or from the newest whole checkpoint of an earlier run.

    An input script without a class is the user's own: it runs in its own folder, from which its
    relative paths are, is told where results go where it reads ${output}, and goes on from a
    checkpoint where it has settings `start` and `checkpoint`.

    Args:
        deck: Name of a deck of `inputs/bulk`, or path of an input script.
        values: Settings given another value than the deck's, or with `restart` than the earlier
            run's.
        folder: Where results go.
        ranks: MPI ranks.
        restart: Folder of the earlier run.
        force: Overwrite an earlier run in `folder`.
        show: Show a progress bar.

    Returns:
        What the deck's class made of it, also written to `folder`, whether its checks passed or
        not; for a deck without a class its series alone.

    Raises:
        EngineError: No such deck, no whole checkpoint, or the engine stopped with an error.
        ValueError: An unknown setting, or one out of range, or `folder` holds results.
    """
    plan = plan_bulk(deck, values, folder, ranks, restart)
    made_with = versions()  # raises where there is no engine, before anything is written
    with lock_folder(plan.folder):
        prepare_folder(plan.folder, force)
        return _run(plan, made_with, show)


def _run(plan: Plan, made_with: dict[str, str], show: bool) -> BulkRun:
    """Run a plan in its folder, analyse the run and write its results."""
    source, folder, restart = plan.source, plan.folder, plan.earlier
    # The engine reads a script as it goes: run one that nobody edits meanwhile.
    script = source.copy(folder / "deck")
    record = {
        "deck": source.name,
        "own": plan.kind is None,
        "values": plan.values,
        "settings": source.settings,
        "ranks": plan.ranks,
        "restart": str(restart) if restart else None,
        "derived": all_derived(restart) if restart else {},
        "excess": all_excess(restart) if restart else {},
        "versions": made_with,
    }
    if plan.checkpoint:
        step = step_of(plan.checkpoint)
        rows_up_to(read_series(restart), step).to_csv(folder / BEFORE, index=False)
        carry_files(restart, folder, step)
    write_record(folder, record)  # last: a folder with a record can be gone on from
    left = files_of_signals(plan.working_folder)
    checksums = ChecksumWriter(folder)
    try:
        run_deck(
            script,
            plan.values | plan.places,
            folder,
            plan.ranks,
            timeout=None,
            progress=show,
            working_folder=plan.working_folder,
            planned=planned_steps(source) if plan.kind is None else 0,
            meanwhile=checksums.update,
        )
    finally:
        if (log := folder / LOG).exists():
            record["versions"]["engine"] = log.read_text(errors="replace").partition("\n")[0]
            write_record(folder, record)
            fetch_file_of_signal(plan.working_folder, left, folder)
            checksums.update()
    read_series(folder).to_csv(folder / SERIES, index=False)  # whatever comes of its analysis
    run = open_run(folder)
    write_results(run)
    return run


def write_results(run: BulkRun) -> None:
    """Write the series, checks and figures of a run into its folder."""
    run.series.to_csv(run.folder / SERIES, index=False)
    if run.analysis.checks:
        run.checks.to_csv(run.folder / CHECKS, index=False)
    for name, figure in run.figures.items():
        style.save(figure, run.folder / "figures" / name)
