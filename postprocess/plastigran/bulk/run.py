# SPDX-License-Identifier: GPL-2.0-or-later
"""Run a bulk deck, check it and draw its figures."""

from __future__ import annotations

import shutil
from collections.abc import Mapping
from pathlib import Path
from tempfile import TemporaryDirectory

from plastigran.bulk.folder import (
    BEFORE,
    CHECKS,
    SERIES,
    all_derived,
    all_excess,
    carry_files,
    prepare_folder,
    remove_earlier_run,
    write_record,
)
from plastigran.bulk.outcome import BulkRun, open_run
from plastigran.bulk.own import planned_steps
from plastigran.bulk.plan import Plan, plan_bulk
from plastigran.bulk.series import read_series, rows_up_to
from plastigran.engine.checkpoints import (
    ChecksumWriter,
    fetch_signal_file,
    signal_files,
    step_of,
)
from plastigran.engine.folder_lock import lock_folder
from plastigran.engine.process import run_deck
from plastigran.engine.versions import HOSTS, versions
from plastigran.plot import style


def run_bulk(
    deck: str | Path,
    values: Mapping[str, object],
    folder: str | Path,
    ranks: int = 1,
    restart: str | Path | None = None,
    force: bool = False,
    show: bool = True,
    host: str | None = None,
) -> BulkRun:
    """Run a deck from its start or from the newest complete checkpoint of an earlier run.

    A user's script runs in the folder of the script, so its relative paths work. Plastigran sets
    ${output} if the script reads it. The script can continue from a checkpoint if it has the
    settings `start` and `checkpoint`.

    Args:
        deck: Name of a deck of `inputs/bulk`, or path of an input script.
        values: New values of settings of the deck, by name. With `restart`, they replace settings
            of the earlier run.
        folder: Folder of the results.
        ranks: Number of MPI ranks.
        restart: Folder of the earlier run to continue, or None.
        force: Whether to overwrite an earlier run in `folder`.
        show: Whether to show a progress bar.
        host: Program that runs the deck: liggghts or lammps. The default is the host of the earlier
            run, or liggghts for a new run.

    Returns:
        The run: table of its log (series), checks and figures. They are also written to `folder`,
        even if checks fail.

    Raises:
        EngineError: The deck or a complete checkpoint does not exist, or the host stopped with an
            error.
        ValueError: A setting is unknown or out of range, or `folder` contains results.
    """
    plan = plan_bulk(deck, values, folder, ranks, restart, host)
    software = versions(plan.host)  # raises EngineError if the host is missing
    with lock_folder(plan.folder):
        prepare_folder(plan.folder, force)
        with TemporaryDirectory(prefix="plastigran_") as inputs:
            # Compute the initial positions before removing earlier results, because the computation
            # fails if the settings do not allow a packing.
            if plan.deck_type and plan.writes_inputs:
                plan.deck_type.read(plan.source.settings).write_inputs(Path(inputs))
            remove_earlier_run(plan.folder)
            shutil.copytree(inputs, plan.folder, dirs_exist_ok=True)
        return _run(plan, software, show)


def _run(plan: Plan, software: dict[str, str], show: bool) -> BulkRun:
    """Run the host as planned, analyse the run and write the results to its folder."""
    source, folder, restart = plan.source, plan.folder, plan.earlier
    # Run a copy, because the host reads the deck while it runs, and the user may edit the original.
    script = source.copy(folder / "deck")
    record = {
        "deck": source.name,
        "own": plan.deck_type is None,
        "values": plan.values,
        "settings": source.settings,
        "ranks": plan.ranks,
        "restart": str(restart) if restart else None,
        "derived": all_derived(restart) if restart else {},
        "excess": all_excess(restart) if restart else {},
        "versions": software,
    }
    if plan.checkpoint:
        step = step_of(plan.checkpoint)
        rows_up_to(read_series(restart), step).to_csv(folder / BEFORE, index=False)
        carry_files(restart, folder, step)
    # Write the record last, because a folder with a record counts as a run that can be continued.
    write_record(folder, record)
    earlier_files = signal_files(plan.working_folder)
    log = folder / HOSTS[plan.host].log
    checksums = ChecksumWriter(folder, log)
    try:
        run_deck(
            script,
            plan.values | plan.places,
            folder,
            plan.ranks,
            timeout=None,
            progress=show,
            working_folder=plan.working_folder,
            planned=planned_steps(source) if plan.deck_type is None else 0,
            meanwhile=checksums.update,
            host=HOSTS[plan.host],
        )
    finally:
        if log.exists():
            record["versions"]["engine"] = log.read_text(errors="replace").partition("\n")[0]
            write_record(folder, record)
            fetch_signal_file(plan.working_folder, earlier_files, folder)
            checksums.update()
    # Write the series before the analysis, which may fail: series.csv marks the run as finished.
    read_series(folder).to_csv(folder / SERIES, index=False)
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
